// Two programs on one mission: the second learns who has it; the lock of a dead one is no obstacle.
#include "tests/support/faults.h"
#include "ui/document/document_lock.h"

#include <QFileInfo>
#include <QProcess>
#include <QSysInfo>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp::test;
using vp::document::DocumentLock;
using Outcome = DocumentLock::Outcome;

class TestDocumentLock : public QObject {
  Q_OBJECT

  std::unique_ptr<QTemporaryDir> folder_;
  QString mission_;

  void startHolder(QProcess& holder) const {
    holder.start(QStringLiteral(VOLPLANE_BIN_DIR "/lock_holder"), {mission_});
    QVERIFY(holder.waitForStarted());
    QVERIFY(holder.waitForReadyRead());
    QCOMPARE(holder.readAllStandardOutput().trimmed(), QByteArray("held"));
  }
  [[nodiscard]] QByteArray lockText() const {
    QFile file(DocumentLock::lockFileOf(mission_));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  }

private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    mission_ = folder_->filePath(QStringLiteral("survey.vpm"));
  }

  void missionThatNobodyHas_isLockedAndFreedAgain() {
    {
      DocumentLock lock;
      QVERIFY(lock.take(mission_) == Outcome::Held);
      QVERIFY(QFile::exists(folder_->filePath(QStringLiteral(".survey.vpm.lock"))));
      QVERIFY(lock.take(folder_->filePath(QStringLiteral("other.vpm"))) == Outcome::Held);
      QVERIFY2(!QFile::exists(folder_->filePath(QStringLiteral(".survey.vpm.lock"))), "let go of when the next one is taken");
    }
    QVERIFY(contentsOf(folder_->path()).isEmpty());
  }

  void livingProcess_isNamed() {
    QProcess holder;
    startHolder(holder);
    DocumentLock lock;
    QVERIFY(lock.take(mission_) == Outcome::Busy);
    QCOMPARE(lock.owner().process, holder.processId());
    QCOMPARE(lock.owner().host, QSysInfo::machineHostName());
    QCOMPARE(lock.owner().user, QFileInfo(folder_->path()).owner());
    const qint64 age = lock.owner().since.secsTo(QDateTime::currentDateTime());
    QVERIFY2(age >= -1 && age < 600, qPrintable(QString::number(age)));
    const QString text = lock.owner().text();
    QVERIFY2(text.contains(QString::number(holder.processId())) && text.contains(QSysInfo::machineHostName()) && text.contains(lock.owner().user),
             qPrintable(text));
    holder.kill();
    holder.waitForFinished();
  }

  void killedProcess_isNoObstacle() {
    QProcess holder;
    startHolder(holder);
    holder.kill();
    QVERIFY(holder.waitForFinished());
    QVERIFY2(!lockText().isEmpty(), "a kill leaves the file");
    DocumentLock lock;
    QVERIFY(lock.take(mission_) == Outcome::Held);
    QCOMPARE(lockText().split('\n').front(), QByteArray::number(QCoreApplication::applicationPid()));
  }

  void processOfAnotherComputer_isNamed_becauseNobodyCanTellWhetherItLives() {
    {
      DocumentLock lock;
      QVERIFY(lock.take(mission_) == Outcome::Held);
      QList<QByteArray> lines = lockText().split('\n');
      lock.release();
      QVERIFY(lines.size() >= 3);
      lines[0] = "4711";
      for (qsizetype i = 2; i < lines.size(); ++i) {
        lines[i] = i == 2 ? "kestrel" : lines[i].isEmpty() ? "" : "0123456789";  // computer and its start
      }
      QFile file(DocumentLock::lockFileOf(mission_));
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(lines.join('\n'));
    }
    DocumentLock lock;
    QVERIFY(lock.take(mission_) == Outcome::Busy);
    QVERIFY2(lock.owner().text().contains(QStringLiteral("on kestrel")), qPrintable(lock.owner().text()));
    QVERIFY(lock.owner().text().contains(QStringLiteral("process 4711")));
  }

  void lockFileOfAProcessKilledWhileMakingIt_isNoObstacle() {
    QFile file(DocumentLock::lockFileOf(mission_));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-300), QFileDevice::FileModificationTime));
    file.close();
    DocumentLock lock;
    QVERIFY(lock.take(mission_) == Outcome::Held);
    QVERIFY(!lockText().isEmpty());
  }

  void secondWindowOfThisProcess_isNotStopped_andLeavesTheLock() {
    DocumentLock first;
    QVERIFY(first.take(mission_) == Outcome::Held);
    {
      DocumentLock second;
      QVERIFY(second.take(mission_) == Outcome::Held);
    }
    QVERIFY(!lockText().isEmpty());
  }

  void folderThatMayNotBeWritten_isOpenedWithoutALock() {
    SmallDisk disk(folder_->filePath(QStringLiteral("disk")));
    disk.makeReadOnly();
    DocumentLock lock;
    QVERIFY(lock.take(disk.path(QStringLiteral("survey.vpm"))) == Outcome::Without);
    disk.makeWritable();
    disk.fill();
    QVERIFY(lock.take(disk.path(QStringLiteral("survey.vpm"))) != Outcome::Busy);
  }
};

QTEST_GUILESS_MAIN(TestDocumentLock)
#include "tst_document_lock.moc"
