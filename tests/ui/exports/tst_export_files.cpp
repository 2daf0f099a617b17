// Prepared exports on the disk: all files or none, folders included.
#include "tests/support/cli_run.h"
#include "ui/exports/export_files.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <unistd.h>

using namespace vp;
using test::readAll;
using test::writeAll;

namespace {

exports::PreparedExport twoFiles() {
  exports::PreparedExport prepared;
  for (const char* name : {"gpx", "csv"}) {
    exports::ExportFile file;
    file.format = formats::findExportFormat(name);
    file.bytes = std::string("new ") + name;
    prepared.files.push_back(file);
  }
  return prepared;
}

/// The rights of a user who owns nothing, where the process may take and give them back.
class OtherUser {
public:
  OtherUser() : own_(geteuid()) { isOther_ = own_ != 0 || seteuid(kNobody) == 0; }
  ~OtherUser() { (void)!seteuid(own_); }
  OtherUser(const OtherUser&) = delete;
  OtherUser& operator=(const OtherUser&) = delete;
  [[nodiscard]] bool isOther() const { return isOther_; }

private:
  static constexpr uid_t kNobody = 65534;
  uid_t own_;
  bool isOther_ = false;
};

}  // namespace

class TestExportFiles : public QObject {
  Q_OBJECT

private slots:
  void init() { folder_ = std::make_unique<QTemporaryDir>(); }

  void write_intoMissingFolders_makesThem() {
    const QString folder = at("season/june/");
    const auto written = write(folder);
    QVERIFY2(written, written ? "" : written.error().message().c_str());
    QCOMPARE(*written, (std::vector<std::string>{"", ""}));
    QCOMPARE(readAll(folder + "tour.gpx"), QByteArray("new gpx"));
    QCOMPARE(readAll(folder + "tour.csv"), QByteArray("new csv"));
  }

  void write_withAFileInTheWayOfTheFolder_saysSoAndMakesNothing() {
    QVERIFY(writeAll(at("season"), "mine"));
    const auto written = write(at("season/june"));
    QVERIFY(!written);
    const std::string said = written.error().message();
    QVERIFY2(said.find("a file has the name " + at("season").toStdString() + ";") != std::string::npos, said.c_str());
    QCOMPARE(names(), QStringList{"season"});
    QCOMPARE(readAll(at("season")), QByteArray("mine"));
  }

  void write_withoutPermissionForTheFolder_saysSoAndMakesNothing() {
    QCOMPARE(chmod(folder_->path().toLocal8Bit().constData(), 0555), 0);
    std::string said;
    {
      const OtherUser other;
      QVERIFY(other.isOther());
      const auto written = write(at("season/june"));
      QVERIFY(!written);
      said = written.error().message();
    }
    QCOMPARE(chmod(folder_->path().toLocal8Bit().constData(), 0755), 0);
    QVERIFY2(said.find("no permission") != std::string::npos, said.c_str());
    QCOMPARE(names(), QStringList());
  }

  void write_whenALaterFileFails_leavesEverythingAsItWas() {
    QVERIFY(writeAll(at("tour.gpx"), "old"));
    QVERIFY(writeAll(at("tour.gpx~"), "older"));
    QVERIFY(QDir(folder_->path()).mkpath("tour.csv"));  // a folder where the second file is to go
    const QStringList before = names();
    const auto written = write(folder_->path());
    QVERIFY(!written);
    QCOMPARE(names(), before);
    QCOMPARE(readAll(at("tour.gpx")), QByteArray("old"));
    QCOMPARE(readAll(at("tour.gpx~")), QByteArray("older"));
  }

  void write_whenALaterFileFailsInNewFolders_removesThem() {
    const auto prepared = twoFiles();
    const QString folder = at("season/june");
    const auto written =
        exports::writeExports(prepared, {(folder + "/tour.gpx").toStdString(), (folder + "/none/tour.csv").toStdString()}, folder.toStdString());
    QVERIFY(!written);
    QCOMPARE(names(), QStringList());
  }

  void write_overFiles_keepsThemAsCopies() {
    QVERIFY(writeAll(at("tour.csv"), "old"));
    const auto written = write(folder_->path());
    QVERIFY(written);
    QCOMPARE(*written, (std::vector<std::string>{"", at("tour.csv~").toStdString()}));
    QCOMPARE(readAll(at("tour.csv~")), QByteArray("old"));
    QCOMPARE(readAll(at("tour.csv")), QByteArray("new csv"));
  }

private:
  [[nodiscard]] QString at(const QString& name) const { return folder_->filePath(name); }
  [[nodiscard]] QStringList names() const {
    return QDir(folder_->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
  }
  [[nodiscard]] static Result<std::vector<std::string>> write(const QString& folder) {
    const auto prepared = twoFiles();
    return exports::writeExports(prepared, exports::pathsOf(prepared, folder.toStdString(), "", "tour"), folder.toStdString());
  }

  std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(TestExportFiles)
#include "tst_export_files.moc"
