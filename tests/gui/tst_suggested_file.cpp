// Files of a mission are suggested where the user finds them and where they can be written: an account that no desktop has set up has no Documents.
#include "app/gui/suggested_file.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace vp;

class TestSuggestedFile : public QObject {
  Q_OBJECT

private slots:
  void init() {
    home_ = std::make_unique<QTemporaryDir>();
    qputenv("HOME", QFile::encodeName(home_->path()));
    qunsetenv("XDG_CONFIG_HOME");
  }

  void newMission_goesToTheDocuments() {
    QVERIFY(QDir(home_->path()).mkdir(QStringLiteral("Documents")));
    QCOMPARE(gui::suggestedFolder(document::MissionDocument()), home_->filePath(QStringLiteral("Documents")));
  }

  void newMission_goesHome_withoutDocuments() {
    QCOMPARE(gui::suggestedFolder(document::MissionDocument()), home_->path());
    QVERIFY(QFileInfo(gui::suggestedFolder(document::MissionDocument())).isWritable());
  }

  void name_isThatOfTheMission_withoutSlashes() {
    document::MissionDocument mission;
    mission.edit(QStringLiteral("Name"), [](mission::Mission& m) { m.name = "Alps 1/2"; });
    QCOMPARE(gui::suggestedName(mission), QStringLiteral("Alps 1-2"));
  }

private:
  std::unique_ptr<QTemporaryDir> home_;
};

QTEST_GUILESS_MAIN(TestSuggestedFile)
#include "tst_suggested_file.moc"
