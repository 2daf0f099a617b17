// Files that are written under another name first: a killed process leaves none for ever, a living one loses none.
#include "core/formats/atomic_file.h"
#include "core/formats/temporary_file.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <atomic>
#include <csignal>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

std::size_t filesIn(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

/// A child that holds a half-written file in the folder until it is killed.
pid_t startWriter(const std::string& folder) {
  int ready[2];
  if (pipe(ready) != 0) {
    return -1;
  }
  const pid_t child = fork();
  if (child == 0) {
    int code = 0;
    const auto file = TemporaryFile::create(folder, "tmp", code);
    const bool isWritten = file && write(file->descriptor(), "half", 4) == 4;
    (void)!write(ready[1], isWritten ? "y" : "n", 1);
    for (;;) {
      pause();
    }
  }
  char answer = 'n';
  const bool isReady = read(ready[0], &answer, 1) == 1 && answer == 'y';
  close(ready[0]);
  close(ready[1]);
  return isReady ? child : -1;
}

void killAndWait(pid_t child) {
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

}  // namespace

class TestTemporaryFile : public QObject {
  Q_OBJECT
private slots:
  void ofAKilledProcess_isRemovedByTheNextWriter() {
    const Folder folder;
    const pid_t child = startWriter(folder.path());
    QVERIFY(child > 0);
    QCOMPARE(filesIn(folder.path()), std::size_t{1});
    killAndWait(child);
    QCOMPARE(filesIn(folder.path()), std::size_t{1});
    QVERIFY(writeFileAtomically(folder.path("x.vpm"), "mission"));
    QCOMPARE(filesIn(folder.path()), std::size_t{1});
    QCOMPARE(samples::readBytes(folder.path("x.vpm")), std::string("mission"));
  }

  void ofALivingProcess_isLeftAlone() {
    const Folder folder;
    const pid_t child = startWriter(folder.path());
    QVERIFY(child > 0);
    QCOMPARE(removeAbandonedFiles(folder.path()), 0);
    QVERIFY(writeFileAtomically(folder.path("x.vpm"), "mission"));
    const std::size_t both = filesIn(folder.path());
    killAndWait(child);
    QCOMPARE(both, std::size_t{2});
    QCOMPARE(removeAbandonedFiles(folder.path()), 1);
  }

  void whatOthersHaveThere_isNeverRemoved() {
    const Folder folder;
    folder.write(".volplane-notes", "mine");
    folder.write("volplane-1-0.tmp", "mine");
    folder.write("x.tmp", "mine");
    std::filesystem::create_directory(folder.path(".volplane-1-1.tmp"));
    std::filesystem::create_symlink("x.tmp", folder.path(".volplane-1-2.tmp"));
    QCOMPARE(removeAbandonedFiles(folder.path()), 0);
    QCOMPARE(filesIn(folder.path()), std::size_t{5});
  }

  void twoFiles_ofWhichOneCannotBeWritten_bothStayAsTheyWere() {
    const Folder folder;
    const std::string plan = folder.write("x.vpp", "old plan");
    const auto written = writeFilesAtomically({{plan, "new plan"}, {folder.path("none/x.vpm"), "new mission"}});
    QVERIFY(!written);
    VP_CONTAINS(written.error().message(), {"none/x.vpm", "no such folder"});
    QCOMPARE(samples::readBytes(plan), std::string("old plan"));
    QCOMPARE(filesIn(folder.path()), std::size_t{1});
  }

  void manyAtOnce_inOneFolder_allAppear() {
    const Folder folder;
    constexpr int kWriters = 8;
    std::vector<std::thread> writers;
    std::atomic<int> good = 0;
    for (int i = 0; i < kWriters; ++i) {
      writers.emplace_back([&, i] {
        for (int round = 0; round < 20; ++round) {
          good += writeFileAtomically(folder.path(std::to_string(i)), std::string(1000, static_cast<char>('a' + round))).has_value() ? 1 : 0;
        }
      });
    }
    for (std::thread& writer : writers) {
      writer.join();
    }
    QCOMPARE(good.load(), kWriters * 20);
    QCOMPARE(filesIn(folder.path()), std::size_t{kWriters});
  }
};

QTEST_APPLESS_MAIN(TestTemporaryFile)
#include "tst_temporary_file.moc"
