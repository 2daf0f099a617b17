// The export dialog: what it shows before anything is written.
#include "ui/dialogs/export_dialog.h"

#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTemporaryDir>
#include <QtTest>

using namespace vp::dialogs;

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
};

QTEST_MAIN(TestExportDialog)
#include "tst_export_dialog.moc"
