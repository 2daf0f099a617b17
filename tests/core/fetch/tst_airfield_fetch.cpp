// OurAirports' tables, fetched from a server on 127.0.0.1.
#include "core/fetch/airfield_fetch.h"
#include "tests/support/file_server.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp;
using namespace vp::fetch;
using vp::test::FileServer;

namespace {

const std::string kAirports =
    "\"id\",\"ident\",\"type\",\"name\",\"latitude_deg\",\"longitude_deg\",\"elevation_ft\",\"gps_code\",\"iata_code\",\"local_code\"\n"
    "1,\"LSZS\",\"medium_airport\",\"Samedan\",46.534,9.884,5600,\"LSZS\",\"SMV\",\n"
    "2,\"SMV\",\"closed\",\"named like a code\",10.0,11.0,,,,\n"
    "3,\"XX01\",\"small_airport\",\"field\",47.0,8.0,1000,,\"ABC\",\"LOC1\"\n";
const std::string kRunways =
    "\"id\",\"airport_ref\",\"airport_ident\",\"length_ft\",\"width_ft\",\"surface\",\"lighted\",\"closed\",\"le_ident\",\"le_latitude_deg\",\"le_"
    "longitude_deg\","
    "\"le_elevation_ft\",\"le_heading_degT\",\"le_displaced_threshold_ft\",\"he_ident\",\"he_latitude_deg\",\"he_longitude_deg\",\"he_elevation_ft\","
    "\"he_heading_degT\",\"he_displaced_threshold_ft\"\n"
    "1,1,\"LSZS\",5900,131,\"ASP\",1,0,\"03\",46.5265,9.8735,5581,29,,\"21\",46.5415,9.8855,5600,209,\n";

QByteArray bytesOf(const std::string& path) {
  QFile file(QString::fromStdString(path));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestAirfieldFetch : public QObject {
  Q_OBJECT

private slots:
  void init() {
    for (const char* name : {"http_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY"}) {
      qunsetenv(name);
    }
    server_ = std::make_unique<FileServer>();
    server_->put("/airports.csv", kAirports);
    server_->put("/runways.csv", kRunways);
    folder_ = std::make_unique<QTemporaryDir>();
    request_ = {server_->address(), folder_->path().toStdString(), {2, 1}};
  }

  void update_bringsBothTables() {
    QVERIFY(!cachedAirfields(request_)->has_value());
    QCOMPARE(*airfieldBytes(request_, Job{}), kAirports.size() + kRunways.size());
    const Result<AirfieldFiles> files = updateAirfields(request_, Job{});
    QVERIFY2(files.has_value(), files ? "" : files.error().message().c_str());
    QCOMPARE(files->sites, std::size_t{2});
    QCOMPARE(bytesOf(files->airports), QByteArray::fromStdString(kAirports));
    QCOMPARE(bytesOf(files->runways), QByteArray::fromStdString(kRunways));
    QVERIFY(files->fetched.starts_with("20") && files->fetched.ends_with("Z"));
    QCOMPARE((*cachedAirfields(request_))->airports, files->airports);
  }

  void update_withNothingNew_fetchesNothing() {
    QVERIFY(updateAirfields(request_, Job{}).has_value());
    const std::uint64_t before = server_->bytesSent();
    QCOMPARE(*airfieldBytes(request_, Job{}), std::uint64_t{0});
    const Result<AirfieldFiles> again = updateAirfields(request_, Job{});
    QVERIFY(again.has_value() && again->wasUpToDate);
    QVERIFY(server_->bytesSent() - before < 1500);
    server_->put("/airports.csv", kAirports + "4,\"NEW\",\"small_airport\",\"n\",1.0,2.0,3,,,\n");
    const Result<AirfieldFiles> newer = updateAirfields(request_, Job{});
    QVERIFY(newer.has_value() && !newer->wasUpToDate);
    QVERIFY(bytesOf(newer->airports).contains("NEW"));
  }

  void update_withBadTables_keepsTheOldOnes_data() {
    QTest::addColumn<QByteArray>("airports");
    QTest::addColumn<QByteArray>("runways");
    QTest::addColumn<QString>("sentence");
    const auto good = QByteArray::fromStdString(kAirports);
    const auto goodRunways = QByteArray::fromStdString(kRunways);
    QTest::newRow("a web page") << QByteArray("<html>please log in, ident</html>") << goodRunways << "no table of OurAirports";
    QTest::newRow("a missing column") << QByteArray(good).replace("elevation_ft", "height") << goodRunways << "elevation_ft";
    QTest::newRow("cut within a quote") << good.left(good.size() - 40) + "\"" << goodRunways << "no table of OurAirports";
    QTest::newRow("tables exchanged") << goodRunways << good << "no table of OurAirports";
    QTest::newRow("no landing site") << good << goodRunways.left(goodRunways.indexOf('\n') + 1) << "no landing site";
  }
  void update_withBadTables_keepsTheOldOnes() {
    QFETCH(QByteArray, airports);
    QFETCH(QByteArray, runways);
    QFETCH(QString, sentence);
    const Result<AirfieldFiles> old = updateAirfields(request_, Job{});
    QVERIFY(old.has_value());
    server_->put("/airports.csv", airports.toStdString());
    server_->put("/runways.csv", runways.toStdString());
    const Result<AirfieldFiles> bad = updateAirfields(request_, Job{});
    QVERIFY(!bad.has_value());
    QVERIFY2(QString::fromStdString(bad.error().what).contains(sentence), bad.error().message().c_str());
    QCOMPARE(bytesOf(old->airports), QByteArray::fromStdString(kAirports));
    QCOMPARE(bytesOf(old->runways), QByteArray::fromStdString(kRunways));
    const QDir folder(QFileInfo(QString::fromStdString(old->airports)).path());
    for (const QString& name : folder.entryList(QDir::Files | QDir::Hidden)) {
      QVERIFY2(!name.endsWith(".part"), qPrintable(name));
    }
  }

  void update_withoutServer_saysSo() {
    server_->stop();
    const Result<AirfieldFiles> files = updateAirfields(request_, Job{});
    QVERIFY(!files.has_value());
    QVERIFY2(files.error().what.find("no server answers there") != std::string::npos, files.error().what.c_str());
  }

  void placeOfAirfield_findsItByItsCodes_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<double>("latitude");
    QTest::newRow("ident") << "lszs" << 46.534;
    QTest::newRow("ident goes before IATA") << "SMV" << 10.0;
    QTest::newRow("IATA") << "ABC" << 47.0;
    QTest::newRow("local") << " loc1 " << 47.0;
  }
  void placeOfAirfield_findsItByItsCodes() {
    QFETCH(QString, code);
    const Result<AirfieldFiles> files = updateAirfields(request_, Job{});
    const Result<geo::LatLon> place = placeOfAirfield(files->airports, code.toStdString());
    QVERIFY2(place.has_value(), place ? "" : place.error().message().c_str());
    QTEST(place->latitude_deg, "latitude");
    QVERIFY(!placeOfAirfield(files->airports, "NOPE").has_value());
    QVERIFY(!placeOfAirfield(files->airports, "").has_value());
    QCOMPARE(placeOfAirfield(files->runways, "LSZS").error().code, Errc::BadFormat);
  }

private:
  std::unique_ptr<FileServer> server_;
  std::unique_ptr<QTemporaryDir> folder_;
  AirfieldRequest request_;
};

QTEST_GUILESS_MAIN(TestAirfieldFetch)
#include "tst_airfield_fetch.moc"
