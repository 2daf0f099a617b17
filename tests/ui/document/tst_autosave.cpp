// Unsaved work outlives the process: kill -9 in the middle of writing, several windows, several starts.
#include "ui/document/autosave.h"
#include "ui/document/mission_document.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp;
using document::Autosave;
using document::MissionDocument;

class TestAutosave : public QObject {
  Q_OBJECT

private slots:
  void init() {
    temporary_ = std::make_unique<QTemporaryDir>();
    folder_ = temporary_->filePath("made/when/needed");
  }

  void killedProcess_leavesItsWorkWhole() {
    for (int round = 0; round < 5; ++round) {
      QProcess victim;
      startVictim(victim);
      QVERIFY(!Autosave::takeOrphan(folder_).has_value());  // it lives
      victim.kill();                                        // SIGKILL: nothing of it runs any more
      QVERIFY(victim.waitForFinished());
      const auto found = Autosave::takeOrphan(folder_);
      QVERIFY(found.has_value());
      MissionDocument document;
      const Result<void> restored = document.restore(found->data);
      QVERIFY2(restored, restored ? "" : restored.error().message().c_str());
      QCOMPARE(document.title(), QStringLiteral("work of the victim"));
      QCOMPARE(document.mission().targets.size(), std::size_t(50));
      const std::string batch = document.mission().targets.front().name;
      for (const mission::Target& target : document.mission().targets) {
        QVERIFY(target.name.starts_with(batch.substr(0, batch.find('.') + 1)));  // of one copy, not mixed
      }
      QVERIFY(document.isModified());
      Autosave::discard(*found);
      QVERIFY(!Autosave::takeOrphan(folder_).has_value());
    }
  }

  void foundWork_isOfferedToOneWindowOnly() {
    QProcess victim;
    startVictim(victim);
    victim.kill();
    QVERIFY(victim.waitForFinished());
    auto first = Autosave::takeOrphan(folder_);
    QVERIFY(first.has_value());
    QVERIFY(!Autosave::takeOrphan(folder_).has_value());
    first.reset();  // closed without a decision: it is offered again
    QVERIFY(Autosave::takeOrphan(folder_).has_value());
  }

  void foundWork_takenOver_isNeverThereTwice() {
    QProcess victim;
    startVictim(victim);
    victim.kill();
    QVERIFY(victim.waitForFinished());
    const auto found = Autosave::takeOrphan(folder_);
    QVERIFY(found.has_value());
    Autosave mine(folder_);
    QVERIFY(mine.takeOver(*found));
    QCOMPARE(QDir(folder_).entryList({"*.recovery"}, QDir::Files), QStringList(QFileInfo(mine.file()).fileName()));
    QVERIFY(!Autosave::takeOrphan(folder_).has_value());
  }

  void processKilledWithoutUnsavedWork_leavesNoLockForEver() {
    QProcess victim;
    startVictim(victim);
    victim.kill();
    QVERIFY(victim.waitForFinished());
    for (const QString& name : QDir(folder_).entryList({"*.recovery"}, QDir::Files)) {
      QVERIFY(QFile::remove(QDir(folder_).filePath(name)));
    }
    QCOMPARE(QDir(folder_).entryList({"*.lock"}, QDir::Files).size(), 1);
    QVERIFY(!Autosave::takeOrphan(folder_).has_value());
    QCOMPARE(QDir(folder_).entryList(QDir::Files | QDir::Hidden).size(), 0);
  }

  void workOfSeveral_isFoundOneByOne() {
    for (int i = 0; i < 2; ++i) {
      QProcess victim;
      startVictim(victim);
      victim.kill();
      QVERIFY(victim.waitForFinished());
    }
    const auto first = Autosave::takeOrphan(folder_);
    const auto second = Autosave::takeOrphan(folder_);
    QVERIFY(first && second && first->file != second->file);
    QVERIFY(!Autosave::takeOrphan(folder_).has_value());
  }

  void windowsOfOneProcess_doNotDisturbEachOther() {
    Autosave one(folder_);
    Autosave two(folder_);
    QVERIFY(one.write("one") && two.write("two"));
    QVERIFY(one.file() != two.file());
    QVERIFY(!Autosave::takeOrphan(folder_).has_value());
    one.remove();
    QVERIFY(!QFile::exists(one.file()) && QFile::exists(two.file()));
  }

  void windowThatEndsWithItsWorkSaved_leavesNothing() {
    {
      Autosave autosave(folder_);
      QVERIFY(autosave.write("work"));
      autosave.remove();
    }
    QCOMPARE(QDir(folder_).entryList(QDir::Files | QDir::Hidden).size(), 0);
  }

  void slowWriter_doesNotBringBackWhatWasSaved() {
    Autosave autosave(folder_);
    const unsigned ticket = autosave.ticket();
    autosave.remove();  // saved while the worker was still gathering
    QVERIFY(!autosave.write("stale", ticket));
    QVERIFY(!QFile::exists(autosave.file()));
    QVERIFY(autosave.write("new", autosave.ticket()));
  }

  void emptyOrUnreadable_isPassedOverAndKept() {
    QVERIFY(QDir().mkpath(folder_));
    QFile empty(QDir(folder_).filePath("1-a.recovery"));
    QVERIFY(empty.open(QIODevice::WriteOnly));
    empty.close();
    QVERIFY(!Autosave::takeOrphan(folder_).has_value());
    QVERIFY(empty.exists());
  }

  void folderThatCannotBeMade_failsWithoutHarm() {
    QFile blocking(temporary_->filePath("file"));
    QVERIFY(blocking.open(QIODevice::WriteOnly));
    Autosave autosave(temporary_->filePath("file/sub"));
    QVERIFY(!autosave.write("work"));
    QVERIFY(!Autosave::takeOrphan(temporary_->filePath("file/sub")).has_value());
  }

private:
  void startVictim(QProcess& victim) const {
    victim.start(QStringLiteral(VOLPLANE_BIN_DIR "/autosave_victim"), {folder_});
    QVERIFY(victim.waitForStarted());
    QVERIFY(victim.waitForReadyRead());
  }

  std::unique_ptr<QTemporaryDir> temporary_;
  QString folder_;
};

QTEST_GUILESS_MAIN(TestAutosave)
#include "tst_autosave.moc"
