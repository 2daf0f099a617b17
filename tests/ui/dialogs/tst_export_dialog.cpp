// The export dialog: what it shows before anything is written.
#include "ui/dialogs/export_dialog.h"
#include "ui/dialogs/export_review.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace vp::dialogs;

namespace {

/// What the review ends with when it is shown and the Return key is pressed where the focus then is; -1 if it stays open.
int resultOfReturn(vp::dialogs::ExportReview& review, int tabs = 0) {
  int result = -1;
  QObject::connect(&review, &QDialog::finished, &review, [&result](int code) { result = code; });
  review.show();
  review.activateWindow();
  if (!QTest::qWaitForWindowActive(&review)) {
    return -2;
  }
  for (int i = 0; i < tabs; ++i) {
    QTest::keyClick(review.focusWidget(), Qt::Key_Tab);
  }
  QTest::keyClick(review.focusWidget() != nullptr ? review.focusWidget() : &review, Qt::Key_Return);
  return result;
}

}  // namespace

class TestExportDialog : public QObject {
  Q_OBJECT
private slots:
  void chosenFormats_areNamedWithWhatTheyLose() {
    QTemporaryDir folder;
    ExportDialog dialog(QStringLiteral("Alps: \u00FCber"), folder.path(), {QStringLiteral("fms"), QStringLiteral("fms3"), QStringLiteral("gpx")});
    QCOMPARE(dialog.formats(), (QStringList{"fms", "fms3", "gpx"}));
    QVERIFY2(dialog.preview().contains(QStringLiteral("Alps- \u00FCber.fms: ")), qPrintable(dialog.preview()));
    QVERIFY(dialog.preview().contains(QStringLiteral("Alps- \u00FCber-fms3.fms: ")));
    QVERIFY(dialog.preview().contains("rounded up to whole feet"));
    QVERIFY(!dialog.preview().contains("is there"));
    if (const QString pictures = qEnvironmentVariable("VOLPLANE_TEST_PICTURES"); !pictures.isEmpty()) {
      dialog.grab().save(pictures + QStringLiteral("/export-dialog.png"));
    }
  }

  void fileThatIsThere_isSaidToBeKept() {
    QTemporaryDir folder;
    QFile file(folder.filePath("x.gpx"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    ExportDialog dialog(QStringLiteral("x"), folder.path(), {QStringLiteral("gpx")});
    QVERIFY2(dialog.preview().contains("x.gpx (is there; the old one is kept as x.gpx~)"), qPrintable(dialog.preview()));
    dialog.findChild<QLineEdit*>("exportPattern")->setText("{mission}-{format}");
    QVERIFY2(dialog.preview().startsWith("x-gpx.gpx:"), qPrintable(dialog.preview()));
  }

  void nothingChosenOrNoFolder_cannotBeExported() {
    QTemporaryDir folder;
    ExportDialog dialog(QStringLiteral("x"), folder.path(), {});
    auto* button = dialog.findChild<QPushButton*>("exportNow");
    QVERIFY(!button->isEnabled());
    auto* list = dialog.findChild<QListWidget*>("exportFormats");
    QCOMPARE(list->count(), 15);
    list->item(0)->setCheckState(Qt::Checked);
    QVERIFY(button->isEnabled());
    dialog.findChild<QLineEdit*>("exportFolder")->setText(folder.filePath("nowhere"));
    QVERIFY(!button->isEnabled());
    QVERIFY(dialog.preview().contains("no folder"));
  }

  void review_showsTheLossOfMargin_whateverTheRemarks() {
    vp::exports::PreparedExport prepared;
    vp::exports::CheckedRoute route;
    route.isVerified = true;
    route.margins = {{"tour.glide", "m", 12.345, 7.0}, {"tour.climb", "deg", 1.25, 1.25}};
    prepared.routes.push_back(route);
    prepared.remarks = {{false, "a note"}};
    ExportReview review(prepared, vp::style::Units(vp::style::UnitSystem::Metric));
    const auto* table = review.findChild<QTableWidget*>("exportMargins");
    QCOMPARE(table->rowCount(), 2);
    QCOMPARE(table->item(0, 0)->text(), QString("tour above what the glide needs"));
    QCOMPARE(table->item(0, 2)->text(), QString("+12 m"));
    QCOMPARE(table->item(0, 3)->text(), QString("+7 m"));
    QCOMPARE(table->item(0, 4)->text(), QString::fromUtf8("\u22126 m"));  // 5.345 m, rounded up
    QCOMPARE(table->item(1, 4)->text(), QString("none"));
    QVERIFY(review.findChild<QLabel*>("exportWarnings") == nullptr);
    QVERIFY(review.findChild<QPushButton*>("exportWrite")->isDefault());
    if (const QString pictures = qEnvironmentVariable("VOLPLANE_TEST_PICTURES"); !pictures.isEmpty()) {
      review.grab().save(pictures + QStringLiteral("/export-review.png"));
    }
  }

  void review_withWarnings_asksAndDoesNotWriteByItself() {
    vp::exports::PreparedExport prepared;
    prepared.routes.emplace_back();
    prepared.remarks = {{true, "flown from waypoint to waypoint the route is NOT SAFE"}, {false, "a note"}};
    ExportReview review(prepared, vp::style::Units(vp::style::UnitSystem::Metric));
    QVERIFY(review.findChild<QLabel*>("exportWarnings")->text().contains("NOT SAFE"));
    QVERIFY(review.findChild<QTableWidget*>("exportMargins")->item(0, 0)->text().contains("not known"));
    QVERIFY(!review.findChild<QPushButton*>("exportWrite")->isDefault());
    review.findChild<QPushButton*>("exportWrite")->click();
    QCOMPARE(review.result(), static_cast<int>(QDialog::Accepted));
  }

  void returnKey_writesOnlyWhatNeedsNoWarning_data() {
    QTest::addColumn<bool>("warns");
    QTest::addColumn<bool>("isVerified");
    QTest::newRow("not safe") << true << false;
    QTest::newRow("verified, with a warning") << true << true;
    QTest::newRow("nothing to ask") << false << true;
  }

  void returnKey_writesOnlyWhatNeedsNoWarning() {
    QFETCH(const bool, warns);
    QFETCH(const bool, isVerified);
    vp::exports::PreparedExport prepared;
    prepared.isVerified = isVerified;
    prepared.routes.emplace_back().isVerified = isVerified;
    prepared.remarks = {{warns, "what the pilot is to know"}, {false, "a note"}};
    constexpr int kWidgets = 4;  // table, notes and two buttons: from each of them
    for (int tabs = 0; tabs <= kWidgets; ++tabs) {
      ExportReview review(prepared, vp::style::Units(vp::style::UnitSystem::Metric));
      const int result = resultOfReturn(review, tabs);
      if (warns) {
        QVERIFY2(result == QDialog::Rejected || result == -1, qPrintable(QStringLiteral("result %1 after %2 tabs").arg(result).arg(tabs)));
      }
      if (tabs == 0) {
        QCOMPARE(result, static_cast<int>(warns ? QDialog::Rejected : QDialog::Accepted));
      }
    }
  }

  void warnings_leaveTheFocusOnCancel() {
    vp::exports::PreparedExport prepared;
    prepared.routes.emplace_back();
    prepared.remarks = {{true, "flown from waypoint to waypoint the route is NOT SAFE"}};
    ExportReview review(prepared, vp::style::Units(vp::style::UnitSystem::Metric));
    review.show();
    QVERIFY(QTest::qWaitForWindowActive(&review));
    auto* cancel = review.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Cancel);
    QVERIFY(cancel->hasFocus());
    QVERIFY(cancel->isDefault());
    QVERIFY(!review.findChild<QPushButton*>("exportWrite")->autoDefault());
  }
};

QTEST_MAIN(TestExportDialog)
#include "tst_export_dialog.moc"
