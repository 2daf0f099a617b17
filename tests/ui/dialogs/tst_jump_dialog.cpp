// Jump to: what counts as a place, and the one sentence for what does not.
#include "tests/support/planned_tour.h"
#include "ui/dialogs/jump_dialog.h"

#include <QLabel>
#include <QLineEdit>
#include <QTest>

using namespace vp;
using dialogs::findPlace;
using dialogs::FoundPlace;
using dialogs::JumpDialog;

class TestJumpDialog : public QObject {
  Q_OBJECT

  document::Situation situation_;

private slots:
  void initTestCase() { situation_ = test::plannedSituation(); }

  void position_inAnyNotation_isFound_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("decimal degrees") << QStringLiteral("47.0025 -24.9925");
    QTest::newRow("with letters") << QStringLiteral("47.0025N 24.9925W");
    QTest::newRow("degrees and minutes") << QStringLiteral("47°00.15′ N 24°59.55′ W");
    QTest::newRow("degrees, minutes, seconds") << QStringLiteral("N47 00 09 W24 59 33");
    QTest::newRow("longitude first, letters say so") << QStringLiteral("W24 59 33 N47 00 09");
  }
  void position_inAnyNotation_isFound() {
    QFETCH(QString, text);
    const FoundPlace found = findPlace(situation_, text);
    QVERIFY2(found.point.has_value(), qPrintable(found.problem));
    QVERIFY(geo::distance(*found.point, situation_.terrain->frame.toPoint({47.0025, -24.9925})) < 0.5);
    QCOMPARE(found.target, -1);
  }

  void names_areFoundInAnyCase() {
    const FoundPlace target = findPlace(situation_, QStringLiteral("  t03 "));
    QCOMPARE(target.target, 2);
    QVERIFY(geo::distance(*target.point, (*situation_.targets)[2].point) < 1e-9);
    const document::ShownSite& site = situation_.sites->front();
    const QString ident = QString::fromStdString(site.site.site.airportIdent);
    for (const QString& text :
         {ident.toLower(), QString::fromStdString(site.site.site.id), QString::fromStdString(site.site.site.id).replace('/', ' ')}) {
      const FoundPlace found = findPlace(situation_, text);
      QVERIFY2(found.point.has_value(), qPrintable(found.problem));
      QVERIFY(geo::distance(*found.point, site.site.pose.point()) < 1e-9);
    }
  }

  void nonsense_getsOneSentence_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("says");
    QTest::newRow("nothing") << QString() << QStringLiteral("Type a position");
    QTest::newRow("a word") << QStringLiteral("Atlantis") << QStringLiteral("“Atlantis” is no target or airfield");
    QTest::newRow("half a position") << QStringLiteral("47.0025") << QStringLiteral("not a position");
    QTest::newRow("no such latitude") << QStringLiteral("97 -25") << QStringLiteral("not a position");
    QTest::newRow("outside the terrain") << QStringLiteral("48 -25") << QStringLiteral("outside the terrain");
  }
  void nonsense_getsOneSentence() {
    QFETCH(QString, text);
    QFETCH(QString, says);
    const FoundPlace found = findPlace(situation_, text);
    QVERIFY(!found.point);
    QVERIFY2(found.problem.contains(says), qPrintable(found.problem));
    QVERIFY(found.problem.endsWith(QLatin1Char('.')));
    JumpDialog dialog(situation_);
    dialog.show();
    auto* line = dialog.findChild<QLineEdit*>(QStringLiteral("jumpText"));
    line->setText(text);
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY2(dialog.isVisible(), "it stays open");
    QCOMPARE(dialog.findChild<QLabel*>(QStringLiteral("jumpProblem"))->text(), found.problem);
    QTest::keyClicks(line, QStringLiteral("4"));
    QVERIFY2(dialog.findChild<QLabel*>(QStringLiteral("jumpProblem"))->text().isEmpty(), "gone when it is typed on");
  }

  void withoutTerrain_saysWhatIsMissing() {
    const FoundPlace found = findPlace({}, QStringLiteral("47.0025 -24.9925"));
    QVERIFY(!found.point);
    QVERIFY(found.problem.contains(QStringLiteral("add a terrain file")));
  }

  void goodText_enter_closesWithThePlace() {
    JumpDialog dialog(situation_);
    dialog.show();
    auto* line = dialog.findChild<QLineEdit*>(QStringLiteral("jumpText"));
    QTest::keyClicks(line, QStringLiteral("47.0025 -24.9925"));
    QTest::keyClick(line, Qt::Key_Return);
    QCOMPARE(dialog.result(), static_cast<int>(QDialog::Accepted));
    QVERIFY(dialog.found().point.has_value());
  }
};

QTEST_MAIN(TestJumpDialog)
#include "tst_jump_dialog.moc"
