// What goes wrong between a server, a network and a disk ends in a sentence, and leaves nothing half-written behind.
#include "tests/core/fetch/bucket.h"

#include <QFile>
#include <QTest>

#include <csignal>
#include <memory>
#include <sys/resource.h>

using namespace vp;
using namespace vp::fetch;
using namespace vp::fetch::test;
using vp::test::FileServer;

namespace {

const geo::GeoBox kArea{{46.2, 8.3}, {46.4, 8.6}};
const std::string kPath = "/" + nameOf({46, 8}) + "/" + nameOf({46, 8}) + ".tif";

/// Limits how long files of this process may become, as a full disk does.
class ShortFiles {
public:
  explicit ShortFiles(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit less{bytes, before_.rlim_max};
    std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &less);
  }
  ~ShortFiles() { setrlimit(RLIMIT_FSIZE, &before_); }
  ShortFiles(const ShortFiles&) = delete;
  ShortFiles& operator=(const ShortFiles&) = delete;

private:
  rlimit before_{};
};

}  // namespace

class TestFetchFailures : public QObject {
  Q_OBJECT

private slots:
  void init() {
    for (const char* name : {"http_proxy", "https_proxy", "HTTP_PROXY", "HTTPS_PROXY", "all_proxy", "ALL_PROXY"}) {
      qunsetenv(name);
    }
    server_ = std::make_unique<FileServer>();
    folder_ = std::make_unique<QTemporaryDir>();
    stock(*server_, {{46, 8}}, 300, 300);  // 360 kB
    output_ = folder_->filePath("area.tif").toStdString();
  }

  void server_misbehaving_isToldInASentence_data() {
    QTest::addColumn<std::function<void(FileServer&)>>("wrong");
    QTest::addColumn<QString>("sentence");
    using Wrong = std::function<void(FileServer&)>;
    const auto manners = [](const std::function<void(FileServer::Manners&)>& change) { return Wrong([change](FileServer& s) { s.behave(change); }); };
    QTest::newRow("no range requests") << manners([](auto& m) { m.ranges = false; }) << "HTTP range requests";
    QTest::newRow("sends another part than asked for") << manners([](auto& m) {
      m.cutAfter = 100'000;
      m.wrongPart = true;
    }) << "HTTP range requests";
    QTest::newRow("gone") << Wrong([](FileServer& s) { s.stop(); }) << "no server answers there";
    QTest::newRow("refuses") << manners([](auto& m) { m.status = 403; }) << "refuses access";
    QTest::newRow("overloaded") << manners([](auto& m) { m.status = 503; }) << "HTTP 503";
    QTest::newRow("lists a tile and lacks it") << Wrong([](FileServer& s) { s.remove(kPath); }) << "lists this tile and does not have it";
    QTest::newRow("a web page for a list") << Wrong([](FileServer& s) { s.put("/tileList.txt", "<html>log in</html>"); }) << "names none";
    QTest::newRow("a web page for a tile") << Wrong([](FileServer& s) { s.put(kPath, "<!DOCTYPE html><html>log in</html>"); })
                                           << "no GeoTIFF but a web page";
    QTest::newRow("binary nonsense") << Wrong([](FileServer& s) { s.put(kPath, std::string(5000, '\x07')); }) << "no GeoTIFF";
    QTest::newRow("begins like a GeoTIFF") << Wrong([](FileServer& s) { s.put(kPath, std::string("II*\0", 4) + std::string(5000, '\x07')); })
                                           << "no GeoTIFF";
    QTest::newRow("cut short at the source") << Wrong([](FileServer& s) {
      s.put(kPath, tileBytes({46, 8}, 300, 300, &wavyHeight).substr(0, 200'000));
    }) << "choose another server";
    QTest::newRow("another tile under this name") << Wrong([](FileServer& s) {
      s.put(kPath, tileBytes({46, 9}, 300, 300, &wavyHeight));
    }) << "lies elsewhere than tile N46E008";
    QTest::newRow("empty") << Wrong([](FileServer& s) { s.put(kPath, ""); }) << "the file on the server is empty";
    QTest::newRow("silent") << manners([](auto& m) { m.holdAfter = 0; }) << "breaks off again and again";
    QTest::newRow("changes between parts") << manners([](auto& m) {
      m.cutAfter = 100'000;
      m.etagOf = [n = std::make_shared<int>(0)](const std::string& path) { return path == kPath && ++*n > 3 ? "new" : "old"; };
    }) << "was changed while it was fetched";
  }
  void server_misbehaving_isToldInASentence() {
    QFETCH(std::function<void(FileServer&)>, wrong);
    QFETCH(QString, sentence);
    wrong(*server_);
    const Result<FetchedTerrain> fetched = fetchAll(requestFor(*server_, *folder_, kArea), output_);
    QVERIFY(!fetched.has_value());
    QCOMPARE(fetched.error().code, Errc::BadFile);
    QVERIFY2(QString::fromStdString(fetched.error().what).contains(sentence), fetched.error().message().c_str());
    QVERIFY2(QString::fromStdString(fetched.error().where).startsWith("http://127.0.0.1"), fetched.error().where.c_str());
    for (const std::string& file : filesUnder(folder_->path().toStdString())) {
      QVERIFY2(file.ends_with(".part") || file.ends_with(".part.source"), file.c_str());
    }
  }

  void serverWithoutVersions_isAccepted() {
    server_->behave([](FileServer::Manners& m) { m.etags = false; });
    const Result<FetchedTerrain> fetched = fetchAll(requestFor(*server_, *folder_, kArea), output_);
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
  }

  void damagedCache_isFetchedAgainAndTold() {
    const TerrainRequest request = requestFor(*server_, *folder_, kArea);
    QVERIFY(fetchAll(request, output_).has_value());
    damageTile();
    const Result<FetchedTerrain> again = fetchAll(request, output_);
    QVERIFY2(again.has_value(), again ? "" : again.error().message().c_str());
    QCOMPARE(again->notes.size(), std::size_t{1});
    QVERIFY2(again->notes.front().find("checksum did not fit") != std::string::npos, again->notes.front().c_str());
    QCOMPARE(postAt(output_, 46.3, 8.4), wavyHeight(46.3, 8.4));
  }

  void damagedCache_withoutNetwork_isNotUsed() {
    const TerrainRequest request = requestFor(*server_, *folder_, kArea);
    QVERIFY(fetchAll(request, output_).has_value());
    damageTile();
    server_->stop();
    QVERIFY(QFile::remove(QString::fromStdString(output_)));
    const Result<FetchedTerrain> again = fetchAll(request, output_);
    QVERIFY(!again.has_value());
    QVERIFY2(again.error().what.find("its checksum does not fit") != std::string::npos, again.error().what.c_str());
    QVERIFY(!QFile::exists(QString::fromStdString(output_)));
  }

  void fullDisk_whileFetching_keepsThePartAndSaysSo() {
    const TerrainRequest request = requestFor(*server_, *folder_, kArea);
    {
      const ShortFiles limit(100'000);
      const Result<FetchedTerrain> fetched = fetchAll(request, output_);
      QVERIFY(!fetched.has_value());
      QCOMPARE(fetched.error().code, Errc::OutputFailed);
      QVERIFY2(fetched.error().what.find("larger than the system allows") != std::string::npos, fetched.error().what.c_str());
    }
    QVERIFY(!QFile::exists(QString::fromStdString(output_)));
    const Result<FetchedTerrain> again = fetchAll(request, output_);
    QVERIFY2(again.has_value(), again ? "" : again.error().message().c_str());
    QCOMPARE(postAt(output_, 46.3, 8.4), wavyHeight(46.3, 8.4));
  }

  void fullDisk_whileJoining_leavesNothing() {
    const TerrainRequest request = requestFor(*server_, *folder_, kArea);
    QVERIFY(fetchAll(request, output_).has_value());
    const QString other = folder_->filePath("other.tif");
    {
      const ShortFiles limit(1000);
      const Result<FetchedTerrain> fetched = fetchAll(request, other.toStdString());
      QVERIFY(!fetched.has_value());
      QCOMPARE(fetched.error().code, Errc::OutputFailed);
    }
    QVERIFY(!QFile::exists(other));
    for (const std::string& file : filesUnder(folder_->path().toStdString())) {
      QVERIFY2(!file.starts_with(".volplane"), file.c_str());
    }
  }

  void outputThatCannotBe_isToldInASentence() {
    const TerrainRequest request = requestFor(*server_, *folder_, kArea);
    const Result<FetchedTerrain> noFolder = fetchAll(request, folder_->filePath("no/such/area.tif").toStdString());
    QVERIFY(!noFolder.has_value());
    QCOMPARE(noFolder.error().code, Errc::OutputFailed);
    QVERIFY2(noFolder.error().what.find("no such folder") != std::string::npos, noFolder.error().what.c_str());
    const Result<FetchedTerrain> aFolder = fetchAll(request, folder_->path().toStdString());
    QVERIFY(!aFolder.has_value());
    QVERIFY2(aFolder.error().what.find("a folder has this name") != std::string::npos, aFolder.error().what.c_str());
  }

  void cacheThatCannotBe_isToldInASentence() {
    TerrainRequest request = requestFor(*server_, *folder_, kArea);
    QFile file(folder_->filePath("file"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    request.cache = folder_->filePath("file").toStdString();  // a file in the folder's place
    const Result<FetchedTerrain> fetched = fetchAll(request, output_);
    QVERIFY(!fetched.has_value());
    QCOMPARE(fetched.error().code, Errc::OutputFailed);
    QVERIFY2(fetched.error().what.find("the folder cannot be made") != std::string::npos, fetched.error().what.c_str());
  }

  void stoppedBeforeItBegan_writesNothing() {
    std::stop_source stop;
    stop.request_stop();
    const Result<FetchedTerrain> fetched = fetchAll(requestFor(*server_, *folder_, kArea), output_, Job(stop.get_token()));
    QVERIFY(!fetched.has_value());
    QCOMPARE(fetched.error().code, Errc::Cancelled);
    QVERIFY(filesUnder(folder_->path().toStdString()).empty());
  }

private:
  void damageTile() {
    const TerrainRequest request = requestFor(*server_, *folder_, kArea);
    const Result<TerrainEstimate> estimate = estimateTerrain(request, Job{});
    QFile file(QString::fromStdString(estimate->folder + "/" + nameOf({46, 8}) + ".tif"));
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.seek(200'000));
    file.write("damaged");
  }

  std::unique_ptr<FileServer> server_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::string output_;
};

QTEST_GUILESS_MAIN(TestFetchFailures)
#include "tst_fetch_failures.moc"
