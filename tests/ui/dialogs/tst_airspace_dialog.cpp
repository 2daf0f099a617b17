// The airspace dialog: classes with their airspaces, a choice for each, and rules that the checker and the planner read the same way.
#include "ui/dialogs/airspace_dialog.h"
#include "ui/dialogs/field_tools.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

using namespace vp;
using dialogs::AirspaceDialog;
using mission::AirspaceUse;

namespace {

std::vector<mission::Airspace> someAirspaces() {
  return {{"BERN 1", "C", {}, {mission::AirspaceLimit::Kind::Msl, 1500.0}, {}},
          {"BERN 1", "C", {mission::AirspaceLimit::Kind::Msl, 1500.0}, {mission::AirspaceLimit::Kind::FlightLevel, 3048.0}, {}},
          {"BERN 2", "C", {}, {}, {}},
          {"", "R", {}, {}, {}}};
}

void take(QComboBox* box, AirspaceUse use) {
  QVERIFY(box != nullptr);
  dialogs::choose(box, static_cast<int>(use));
}

}  // namespace

class TestAirspaceDialog : public QObject {
  Q_OBJECT

private slots:
  void classesAndNames_areListedOnce() {
    AirspaceDialog dialog(someAirspaces(), {}, {}, {});
    const auto* tree = dialog.findChild<QTreeWidget*>(QStringLiteral("airspaceRules"));
    QCOMPARE(tree->topLevelItemCount(), 2);
    QCOMPARE(tree->topLevelItem(0)->childCount(), 2);
    QVERIFY2(tree->topLevelItem(0)->text(0).startsWith(QStringLiteral("Class C: 3")), qPrintable(tree->topLevelItem(0)->text(0)));
    QVERIFY(tree->topLevelItem(0)->child(0)->text(1).contains(QStringLiteral("FL 100")));
    QVERIFY(dialog.choiceOf(QStringLiteral("E")) == nullptr);
    QVERIFY(dialog.choiceOf(QStringLiteral("R"), QStringLiteral("none")) == nullptr);
  }

  void choices_becomeRules() {
    mission::AirspaceSettings settings{{"a.txt"}, {{"C", "", AirspaceUse::Warn}, {"D", "", AirspaceUse::Hide}}, AirspaceUse::Show};
    AirspaceDialog dialog(someAirspaces(), {}, settings, {});
    QVERIFY(dialog.result() == settings);
    QCOMPARE(dialog.choiceOf(QStringLiteral("C"))->currentText(), QStringLiteral("Warn when entered"));
    QCOMPARE(dialog.choiceOf(QStringLiteral("D"))->currentText(), QStringLiteral("Hide"));  // of the rule alone: nothing of it is shown
    take(dialog.choiceOf(QStringLiteral("C")), AirspaceUse::Forbid);
    take(dialog.choiceOf(QStringLiteral("C"), QStringLiteral("BERN 2")), AirspaceUse::Show);
    take(dialog.findChild<QComboBox*>(QStringLiteral("otherwise")), AirspaceUse::Warn);
    const mission::AirspaceSettings& result = dialog.result();
    QCOMPARE(result.files, settings.files);
    QCOMPARE(mission::useOf(someAirspaces()[0], result), AirspaceUse::Forbid);
    QCOMPARE(mission::useOf(someAirspaces()[2], result), AirspaceUse::Show);
    QCOMPARE(mission::useOf(someAirspaces()[3], result), AirspaceUse::Warn);
    dialogs::choose(dialog.choiceOf(QStringLiteral("C"), QStringLiteral("BERN 2")), -1);  // as its class
    QCOMPARE(mission::useOf(someAirspaces()[2], dialog.result()), AirspaceUse::Forbid);
    dialogs::choose(dialog.choiceOf(QStringLiteral("C")), -1);
    QCOMPARE(mission::useOf(someAirspaces()[0], dialog.result()), AirspaceUse::Warn);
  }

  /// With all the rest hidden, a class without a rule of its own could not be reached any more.
  void hiddenAndFarClasses_canBeRuledOn() {
    const mission::AirspaceSettings settings{{"a.txt"}, {{"C", "", AirspaceUse::Warn}}, AirspaceUse::Hide};
    AirspaceDialog dialog(someAirspaces(), {"C", "G", "R"}, settings, {});
    const auto* tree = dialog.findChild<QTreeWidget*>(QStringLiteral("airspaceRules"));
    QCOMPARE(tree->topLevelItemCount(), 3);
    QCOMPARE(tree->topLevelItem(1)->text(0), QStringLiteral("Class G: none near this terrain"));
    take(dialog.choiceOf(QStringLiteral("R")), AirspaceUse::Forbid);
    take(dialog.choiceOf(QStringLiteral("G")), AirspaceUse::Show);
    QCOMPARE(mission::useOf(someAirspaces()[3], dialog.result()), AirspaceUse::Forbid);
    QCOMPARE(mission::useOf({"", "G", {}, {}, {}}, dialog.result()), AirspaceUse::Show);
    QCOMPARE(mission::useOf({"", "D", {}, {}, {}}, dialog.result()), AirspaceUse::Hide);
  }

  void rulesOnNames_areOpenAndKeptWithoutTheirAirspace() {
    mission::AirspaceSettings settings{{}, {{"", "BERN 2", AirspaceUse::Forbid}, {"", "GONE", AirspaceUse::Hide}}, AirspaceUse::Show};
    AirspaceDialog dialog(someAirspaces(), {}, settings, {});
    const auto* tree = dialog.findChild<QTreeWidget*>(QStringLiteral("airspaceRules"));
    QVERIFY(tree->topLevelItem(0)->isExpanded() && !tree->topLevelItem(1)->isExpanded());
    QCOMPARE(tree->topLevelItem(2)->text(0), QStringLiteral("GONE (not shown)"));
    QVERIFY(dialog.result() == settings);
  }

  void nothingLoaded_saysHowToAddAirspaces() {
    AirspaceDialog dialog({}, {}, {}, {});
    bool says = false;
    for (const QLabel* label : dialog.findChildren<QLabel*>()) {
      says = says || label->text().startsWith(QStringLiteral("No airspaces yet"));
    }
    QVERIFY(says);
    QSignalSpy asked(&dialog, &AirspaceDialog::addFilesRequested);
    for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
      if (button->text().contains(QStringLiteral("Add airspace"))) {
        button->click();
      }
    }
    QCOMPARE(asked.count(), 1);
  }
};

QTEST_MAIN(TestAirspaceDialog)
#include "tst_airspace_dialog.moc"
