#include "core/formats/atomic_file.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

std::size_t filesIn(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

unsigned modeOf(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777u : 0u;
}

}  // namespace

class TestAtomicFile : public QObject {
  Q_OBJECT
private slots:
  void write_makesTheFileAndLeavesNothingElse() {
    const Folder folder;
    const std::string bytes("a\0b\n", 4);
    QVERIFY(writeFileAtomically(folder.path("x.fms"), bytes));
    QCOMPARE(samples::readBytes(folder.path("x.fms")), bytes);
    QCOMPARE(filesIn(folder.path()), std::size_t{1});
    const mode_t mask = umask(022);
    umask(mask);
    QCOMPARE(modeOf(folder.path("x.fms")), 0666u & ~static_cast<unsigned>(mask));
  }

  void write_overAFile_keepsItsPermissions() {
    const Folder folder;
    const std::string path = folder.write("x", "old");
    QCOMPARE(chmod(path.c_str(), 0640), 0);
    QVERIFY(writeFileAtomically(path, "new"));
    QCOMPARE(samples::readBytes(path), std::string("new"));
    QCOMPARE(modeOf(path), 0640u);
  }

  void write_throughALink_changesTheFileBehindIt() {
    const Folder folder;
    const std::string path = folder.write("real", "old");
    std::filesystem::create_symlink("real", folder.path("link"));
    QVERIFY(writeFileAtomically(folder.path("link"), "new"));
    QVERIFY(std::filesystem::is_symlink(folder.path("link")));
    QCOMPARE(samples::readBytes(path), std::string("new"));
  }

  void write_toBadPlaces_saysWhyAndWritesNothing() {
    const Folder folder;
    folder.write("file", "x");
    const auto refused = [&](const std::string& path, const std::vector<std::string>& parts) {
      const auto written = writeFileAtomically(path, "new");
      if (written || written.error().code != Errc::OutputFailed) {
        return std::string("was not refused: ") + path;
      }
      return samples::lacking(written.error().message(), parts);
    };
    QCOMPARE(refused(folder.path("none/x"), {"none/x", "no such folder", "create it first"}), std::string());
    QCOMPARE(refused(folder.path(), {folder.path(), "a folder has this name"}), std::string());
    QCOMPARE(refused(folder.path("sub/"), {"names a folder"}), std::string());
    QCOMPARE(refused(folder.path("file/x"), {"no such folder"}), std::string());
    QCOMPARE(refused(folder.path(std::string(300, 'n')), {"too long"}), std::string());
    QCOMPARE(refused("", {"no file name"}), std::string());
    QCOMPARE(filesIn(folder.path()), std::size_t{1});
  }

  void write_toFullDisk_saysSo() {
    if (!std::filesystem::exists("/dev/full")) {
      QSKIP("this system has no /dev/full");
    }
    const auto written = writeFileAtomically("/dev/full", "bytes");
    QVERIFY(!written);
    VP_CONTAINS(written.error().message(), {"/dev/full", "disk is full"});
  }

  void write_thatFailsHalfWay_keepsTheOldFileAndRemovesTheTemporary() {
    const Folder folder;
    const std::string path = folder.write("x", "old");
    rlimit old{};
    QCOMPARE(getrlimit(RLIMIT_FSIZE, &old), 0);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = old;
    small.rlim_cur = 1000;
    QCOMPARE(setrlimit(RLIMIT_FSIZE, &small), 0);
    const auto written = writeFileAtomically(path, std::string(100000, 'x'));
    setrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, handler);
    QVERIFY(!written);
    QCOMPARE(written.error().code, Errc::OutputFailed);
    QCOMPARE(samples::readBytes(path), std::string("old"));
    QCOMPARE(filesIn(folder.path()), std::size_t{1});
  }

  void write_withoutPermission_saysSo() {
    const Folder folder;
    const std::string path = folder.write("x", "old");
    chmod(path.c_str(), 0444);
    if (access(path.c_str(), W_OK) == 0) {
      QSKIP("this user may write everywhere");
    }
    const auto written = writeFileAtomically(path, "new");
    QVERIFY(!written);
    VP_CONTAINS(written.error().message(), {"write-protected"});
    chmod(folder.path().c_str(), 0555);
    const auto other = writeFileAtomically(folder.path("y"), "new");
    chmod(folder.path().c_str(), 0755);
    QVERIFY(!other);
    VP_CONTAINS(other.error().message(), {"no permission"});
  }
};

QTEST_APPLESS_MAIN(TestAtomicFile)
#include "tst_atomic_file.moc"
