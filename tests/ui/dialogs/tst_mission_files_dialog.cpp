// The list of a mission's files: what it shows and what it asks for.
#include "ui/dialogs/mission_files_dialog.h"

#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace vp;
using dialogs::MissionFilesDialog;

class TestMissionFilesDialog : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;

  std::string made(const char* name) {
    QFile file(folder_.filePath(QLatin1String(name)));
    if (!file.open(QIODevice::WriteOnly)) {
      qFatal("cannot write %s", name);
    }
    file.write(QByteArray(2048, 'x'));
    return file.fileName().toStdString();
  }
  mission::Mission mission() {
    mission::Mission m;
    m.terrain = {made("north.tif"), folder_.filePath("gone.tif").toStdString()};
    m.airfields = {{made("airports.csv"), made("runways.csv")}, {made("club.cup"), {}}};
    return m;
  }

private slots:
  void files_areListedTerrainFirst_missingOnesNamed() {
    MissionFilesDialog dialog;
    dialog.setMission(mission());
    QCOMPARE(dialog.list().rowCount(), 4);
    QCOMPARE(dialog.list().item(0, 0)->text(), QStringLiteral("north.tif"));
    QVERIFY(dialog.list().item(1, 2)->text().contains(QStringLiteral("not there")));
    QVERIFY(!dialog.list().item(0, 2)->text().contains(QStringLiteral("not there")));
    QCOMPARE(dialog.list().item(2, 0)->text(), QStringLiteral("airports.csv + runways.csv"));
    QCOMPARE(dialog.list().item(3, 3)->text(), folder_.path());
  }

  void remove_asksForTheFileThatIsMarked() {
    MissionFilesDialog dialog;
    dialog.setMission(mission());
    dialog.show();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    QSignalSpy terrain(&dialog, &MissionFilesDialog::terrainRemoveRequested);
    QSignalSpy airfields(&dialog, &MissionFilesDialog::airfieldsRemoveRequested);
    dialog.list().setCurrentCell(1, 0);
    dialog.findChild<QPushButton*>(QStringLiteral("removeFile"))->click();
    QCOMPARE(terrain.count(), 1);
    QCOMPARE(terrain[0][0].toInt(), 1);
    dialog.list().setCurrentCell(3, 0);
    dialog.list().setFocus();
    QTest::keyClick(&dialog.list(), Qt::Key_Delete);
    QCOMPARE(airfields.count(), 1);
    QCOMPARE(airfields[0][0].toInt(), 1);
  }

  void noFiles_saysWhatToDo_andRemovesNothing() {
    MissionFilesDialog dialog;
    dialog.setMission({});
    dialog.show();
    QVERIFY(QTest::qWaitForWindowActive(&dialog));
    dialog.list().setFocus();
    QVERIFY(!dialog.findChild<QPushButton*>(QStringLiteral("removeFile"))->isEnabled());
    bool says = false;
    for (const QLabel* label : dialog.findChildren<QLabel*>()) {
      says = says || label->text().contains(QStringLiteral("No files yet"));
    }
    QVERIFY(says);
    const QSignalSpy terrain(&dialog, &MissionFilesDialog::terrainRemoveRequested);
    QTest::keyClick(&dialog.list(), Qt::Key_Delete);
    QCOMPARE(terrain.count(), 0);
  }

  void removedElsewhere_keepsTheMarkNearWhereItWas() {
    MissionFilesDialog dialog;
    mission::Mission m = mission();
    dialog.setMission(m);
    dialog.list().setCurrentCell(3, 0);
    m.airfields.pop_back();
    dialog.setMission(m);
    QCOMPARE(dialog.list().currentRow(), 2);
  }
};

QTEST_MAIN(TestMissionFilesDialog)
#include "tst_mission_files_dialog.moc"
