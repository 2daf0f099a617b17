// The wind dialog: what is typed, read from text, kept to the last bit, and refused.
#include "tests/support/mountain.h"
#include "ui/dialogs/wind_dialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>

using namespace vp;

namespace {

constexpr double kKnot = 1852.0 / 3600.0;
const style::Units kAviation(style::UnitSystem::Aviation);

std::vector<air::WindLayer> twoLayers() {
  return {{geo::HeightMsl::fromMetres(612.345), {251.5, 12.25, 5.4321, 9.8765}}, {geo::HeightMsl::fromMetres(1800.0), {290.0, 0.0, 12.0, 12.0}}};
}

template <typename Widget>
Widget* childOf(dialogs::WindDialog& dialog, const char* name) {
  return dialog.findChild<Widget*>(QLatin1String(name));
}

QDoubleSpinBox* boxAt(dialogs::WindDialog& dialog, int row, int column) {
  return qobject_cast<QDoubleSpinBox*>(childOf<QTableWidget>(dialog, "windTable")->cellWidget(row, column));
}

bool mayAccept(dialogs::WindDialog& dialog) {
  return dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->isEnabled();
}

}  // namespace

class TestWindDialog : public QObject {
  Q_OBJECT

private slots:
  void untouched_isKeptToTheLastBit() {
    dialogs::WindDialog dialog(twoLayers(), test::paperCessna(), kAviation);
    QVERIFY(dialog.result() == twoLayers());
    QVERIFY(mayAccept(dialog));
  }

  void aChangedBox_changesNothingElse() {
    dialogs::WindDialog dialog(twoLayers(), test::paperCessna(), kAviation);
    boxAt(dialog, 0, 1)->setValue(270.0);
    std::vector<air::WindLayer> expected = twoLayers();
    expected[0].wind.from_deg = 270.0;
    QVERIFY(dialog.result() == expected);
  }

  void text_fillsTheTable() {
    dialogs::WindDialog dialog({}, test::paperCessna(), kAviation);
    childOf<QLineEdit>(dialog, "windText")->setText(QStringLiteral("270±20/15±5kt"));
    childOf<QPushButton>(dialog, "readWind")->click();
    QCOMPARE(dialog.result().size(), std::size_t(1));
    const air::WindSector wind = dialog.result().front().wind;
    QVERIFY(wind.from_deg == 270.0 && wind.spread_deg == 20.0);
    QVERIFY(std::abs(wind.leastSpeed - 10.0 * kKnot) < 1e-9 && std::abs(wind.mostSpeed - 20.0 * kKnot) < 1e-9);
    QVERIFY(childOf<QLabel>(dialog, "windSummary")->text().contains(QLatin1String("250")));
  }

  void unreadableText_leavesTheTableAndSaysWhy() {
    dialogs::WindDialog dialog(twoLayers(), test::paperCessna(), kAviation);
    childOf<QLineEdit>(dialog, "windText")->setText(QStringLiteral("a breeze"));
    childOf<QPushButton>(dialog, "readWind")->click();
    QVERIFY(dialog.result() == twoLayers());
    QVERIFY(childOf<QLabel>(dialog, "windNotes")->text().contains(QLatin1String("breeze"), Qt::CaseInsensitive));
  }

  void windOfTheGlidingSpeed_isRefusedWithTheLimit() {
    dialogs::WindDialog dialog(twoLayers(), test::paperCessna(), kAviation);
    boxAt(dialog, 1, 3)->setValue(70.0);
    QVERIFY(!mayAccept(dialog));
    QVERIFY2(childOf<QLabel>(dialog, "windSummary")->text().contains(QLatin1String("gliding speed of 64.9 kt")), qPrintable(childOf<QLabel>(dialog, "windSummary")->text()));
    boxAt(dialog, 1, 3)->setValue(30.0);
    QVERIFY(mayAccept(dialog));
  }

  void layers_areAddedSortedAndRemoved() {
    dialogs::WindDialog dialog({}, test::paperCessna(), kAviation);
    childOf<QPushButton>(dialog, "addLayer")->click();
    boxAt(dialog, 0, 3)->setValue(15.0);
    boxAt(dialog, 0, 0)->setValue(6000.0);
    childOf<QPushButton>(dialog, "addLayer")->click();
    QCOMPARE(boxAt(dialog, 1, 0)->value(), 9000.0);
    boxAt(dialog, 1, 0)->setValue(6000.0);
    QVERIFY(!mayAccept(dialog));  // two at one altitude
    boxAt(dialog, 1, 0)->setValue(2000.0);
    QVERIFY(mayAccept(dialog));
    QVERIFY(dialog.result().front().altitude < dialog.result().back().altitude);
    childOf<QPushButton>(dialog, "stillAir")->click();
    QVERIFY(dialog.result().empty() && mayAccept(dialog));
  }

  void everyText_fits() {
    dialogs::WindDialog dialog(twoLayers(), test::paperCessna(), style::Units(style::UnitSystem::Metric));
    dialog.show();
    QVERIFY(QTest::qWaitForWindowExposed(&dialog));
    const QTableWidget* table = childOf<QTableWidget>(dialog, "windTable");
    for (int column = 0; column < table->columnCount(); ++column) {
      const QDoubleSpinBox* box = boxAt(dialog, 0, column);
      QVERIFY(box->sizeHint().width() <= table->columnWidth(column));
    }
    if (const QString folder = qEnvironmentVariable("VOLPLANE_TEST_PICTURES"); !folder.isEmpty()) {
      dialog.grab().save(folder + QStringLiteral("/wind-dialog.png"));
    }
  }
};

QTEST_MAIN(TestWindDialog)
#include "tst_wind_dialog.moc"
