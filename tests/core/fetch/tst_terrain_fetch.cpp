// Terrain of an area, fetched from a server on 127.0.0.1 with the layout of the public bucket.
#include "core/terrain/terrain_reader.h"
#include "tests/core/fetch/bucket.h"

#include <QFile>
#include <QTest>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

using namespace vp;
using namespace vp::fetch;
using namespace vp::fetch::test;
using vp::test::FileServer;

namespace {

const geo::GeoBox kInOneTile{{46.2, 8.3}, {46.4, 8.6}};

QByteArray bytesOf(const std::string& path) {
  QFile file(QString::fromStdString(path));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Requests for tiles, without the list.
int tileRequests(const FileServer& server) {
  const auto requests = server.requests();
  return static_cast<int>(std::count_if(requests.begin(), requests.end(), [](const auto& r) { return r.path.ends_with(".tif"); }));
}

}  // namespace

class TestTerrainFetch : public QObject {
  Q_OBJECT

private slots:
  void init() {
    for (const char* name : {"http_proxy", "https_proxy", "HTTP_PROXY", "HTTPS_PROXY", "all_proxy", "ALL_PROXY"}) {
      qunsetenv(name);
    }
  }

  void estimate_ofAnArea_tellsTilesAndBytesAndFetchesNothing() {
    FileServer server;
    stock(server, {{46, 8}, {46, 9}});
    QTemporaryDir folder;
    const Result<TerrainEstimate> estimate = estimateTerrain(requestFor(server, folder, {{46.2, 8.5}, {46.4, 9.5}}), Job{});
    QVERIFY2(estimate.has_value(), estimate ? "" : estimate.error().message().c_str());
    QCOMPARE(estimate->tiles.size(), std::size_t{2});
    QCOMPARE(estimate->count(TileState::OnServer), 2);
    QCOMPARE(estimate->bytesToFetch, static_cast<std::uint64_t>(2 * tileBytes({46, 8}, 60, 60, &wavyHeight).size()));
    QVERIFY(estimate->inWords().starts_with("2 tiles: 0 on this machine, 2 to fetch ("));
    QVERIFY(filesUnder(folder.path().toStdString()).empty());
    QVERIFY(server.bytesSent() < 3000);
  }

  void fetch_insideATile_copiesPostsUnchanged() {
    FileServer server;
    stock(server, {{46, 8}});
    QTemporaryDir folder;
    const std::string output = folder.filePath("area.tif").toStdString();
    const Result<FetchedTerrain> fetched = fetchAll(requestFor(server, folder, kInOneTile), output);
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
    QCOMPARE(fetched->files, std::vector<std::string>{output});
    QVERIFY(fetched->notes.empty());
    const RasterFacts facts = factsOf(output);
    QVERIFY(facts.west < 8.3 && facts.west + facts.stepX * (facts.columns - 1) > 8.6);
    QVERIFY(facts.north > 46.4 && facts.north - facts.stepY * (facts.rows - 1) < 46.2);
    QVERIFY(facts.columns <= 22 && facts.rows <= 16);
    for (int r = 0; r < facts.rows; ++r) {
      for (int c = 0; c < facts.columns; ++c) {
        const double latitude = facts.north - r * facts.stepY;
        const double longitude = facts.west + c * facts.stepX;
        QCOMPARE(postAt(output, latitude, longitude), wavyHeight(latitude, longitude));
      }
    }
    const Result<terrain::TerrainInfo> info = terrain::inspectTerrain({output});
    QVERIFY(info.has_value());
    const std::vector<std::string> names = filesUnder(folder.filePath("cache").toStdString());
    const std::string name = nameOf({46, 8}) + ".tif";
    QCOMPARE(names, (std::vector<std::string>{name, name + ".sha256", name + ".source"}));
  }

  void fetch_again_needsNoNetworkAndGivesTheSame() {
    FileServer server;
    stock(server, {{46, 8}});
    QTemporaryDir folder;
    const std::string first = folder.filePath("first.tif").toStdString();
    const std::string second = folder.filePath("second.tif").toStdString();
    const TerrainRequest request = requestFor(server, folder, kInOneTile);
    QVERIFY(fetchAll(request, first).has_value());
    server.stop();
    const Result<FetchedTerrain> fetched = fetchAll(request, second);
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
    QCOMPARE(bytesOf(first), bytesOf(second));
  }

  void fetch_overFourTiles_joinsThemWithoutSeam() {
    FileServer server;
    stock(server, {{46, 8}, {46, 9}, {47, 8}, {47, 9}});
    QTemporaryDir folder;
    const std::string output = folder.filePath("area.tif").toStdString();
    const Result<FetchedTerrain> fetched = fetchAll(requestFor(server, folder, {{46.9, 8.9}, {47.1, 9.1}}), output);
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
    QCOMPARE(fetched->files.size(), std::size_t{1});
    const RasterFacts facts = factsOf(output);
    QVERIFY(facts.rows >= 13 && facts.columns >= 13);
    for (int r = 0; r < facts.rows; ++r) {
      for (int c = 0; c < facts.columns; ++c) {
        const double latitude = facts.north - r * facts.stepY;
        const double longitude = facts.west + c * facts.stepX;
        QCOMPARE(postAt(output, latitude, longitude), wavyHeight(latitude, longitude));
      }
    }
  }

  void tileThatTheListLacks_isSeaMarkedAndTold() {
    FileServer server;
    stock(server, {{46, 8}}, 3600, 3600);
    QTemporaryDir folder;
    const std::string output = folder.filePath("area.tif").toStdString();
    const TerrainRequest request = requestFor(server, folder, {{46.49, 8.99}, {46.51, 9.01}});
    const Result<FetchedTerrain> fetched = fetchAll(request, output);
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
    QCOMPARE(fetched->files.size(), std::size_t{1});
    QCOMPARE(postAt(output, 46.5, 9.0), 0.0F);
    QCOMPARE(postAt(output, 46.5, 9.005), 0.0F);
    QCOMPARE(postAt(output, 46.5, 9.0 - 1.0 / 3600.0), wavyHeight(46.5, 9.0 - 1.0 / 3600.0));
    QCOMPARE(fetched->notes.size(), std::size_t{1});
    QVERIFY2(fetched->notes.front().find("N46E009: taken as sea") != std::string::npos, fetched->notes.front().c_str());
    QCOMPARE(factsOf(output).sea, std::string("N46E009"));
    const std::string sea = folder.filePath("cache").toStdString() + "/terrain/" + server.address().substr(7, 9) + "_" + server.address().substr(17) +
                            "/" + nameOf({46, 9}) + ".tif";
    QCOMPARE(factsOf(sea).kind, std::string("ocean"));
    QCOMPARE(factsOf(sea).columns, 3600);
    server.stop();  // and the sea is remembered
    const Result<FetchedTerrain> again = fetchAll(request, output);
    QVERIFY(again.has_value());
    QCOMPARE(again->notes, fetched->notes);
  }

  void tileThatTheListLacksAndTheServerHas_isFetched() {
    FileServer server;
    stock(server, {{46, 8}, {46, 9}});
    server.put("/tileList.txt", nameOf({46, 8}) + "\n");  // cut short, or older than the tiles
    QTemporaryDir folder;
    const std::string output = folder.filePath("area.tif").toStdString();
    const Result<FetchedTerrain> fetched = fetchAll(requestFor(server, folder, {{46.4, 8.9}, {46.6, 9.1}}), output);
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
    QVERIFY(fetched->notes.empty());
    QCOMPARE(postAt(output, 46.5, 9.05), wavyHeight(46.5, 9.05));
  }

  void tileThatIsNotPublished_isUnknownAndNotSea() {
    FileServer server;
    stock(server, {{40, 42}}, 60, 60);
    QTemporaryDir folder;
    const std::string output = folder.filePath("area.tif").toStdString();
    const Result<FetchedTerrain> fetched = fetchAll(requestFor(server, folder, {{40.4, 43.9}, {40.6, 44.1}}), output);
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
    QVERIFY(postAt(output, 40.5, 44.0) < -30000.0F);
    QVERIFY2(fetched->notes.front().find("nothing is known there") != std::string::npos, fetched->notes.front().c_str());
  }

  void serverWithoutList_isBelievedAboutSeaOnlyIfItHasATileNearby() {
    FileServer server;
    stock(server, {{46, 8}});
    server.remove("/tileList.txt");
    QTemporaryDir folder;
    const Result<TerrainEstimate> mixed = estimateTerrain(requestFor(server, folder, {{46.4, 8.9}, {46.6, 9.1}}), Job{});
    QVERIFY2(mixed.has_value(), mixed ? "" : mixed.error().message().c_str());
    QCOMPARE(mixed->count(TileState::Ocean), 1);
    const Result<TerrainEstimate> alone = estimateTerrain(requestFor(server, folder, {{46.4, 12.1}, {46.6, 12.2}}), Job{});
    QVERIFY(!alone.has_value());
    QVERIFY2(alone.error().what.find("the address is wrong") != std::string::npos, alone.error().what.c_str());
  }

  void areaAcrossAParallelWhereSpacingChanges_hasNoGapAndLosesNoHeight() {
    FileServer server;
    stock(server, {{49, 8}}, 150, 120);
    server.put("/" + nameOf({50, 8}) + "/" + nameOf({50, 8}) + ".tif", tileBytes({50, 8}, 100, 120, &wavyHeight));
    server.put("/tileList.txt", nameOf({49, 8}) + "\n" + nameOf({50, 8}) + "\n");
    QTemporaryDir folder;
    const std::string output = folder.filePath("area.tif").toStdString();
    const Result<FetchedTerrain> fetched = fetchAll(requestFor(server, folder, {{49.8, 8.3}, {50.2, 8.7}}), output);
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
    QCOMPARE(fetched->files.size(), std::size_t{2});
    const RasterFacts north = factsOf(fetched->files[0]);
    QVERIFY(north.north - (north.rows - 1) * north.stepY < 49.9);  // continued over the southern tile
    for (int c = 1; c < north.columns - 1; ++c) {
      const double longitude = north.west + c * north.stepX;
      const double latitude = 50.0 - (c % 3) / 120.0;
      const float seam = postAt(fetched->files[0], latitude, longitude);
      for (int fine = 0; fine < 150; ++fine) {
        const double place = 8.0 + fine / 150.0;
        if (std::abs(place - longitude) < north.stepX - 1e-9) {
          QVERIFY(seam >= wavyHeight(latitude, place));
        }
      }
      QCOMPARE(postAt(fetched->files[0], 50.0 + 1.0 / 120.0, longitude), wavyHeight(50.0 + 1.0 / 120.0, longitude));
    }
    const geo::LocalFrame frame({50.0, 8.5});
    const Result<terrain::ElevationGrid> grid = terrain::readTerrain(fetched->files, frame, {500.0, 40'000'000}, Job{});
    QVERIFY(grid.has_value());
    for (double y = -15'000.0; y < 15'000.0; y += 100.0) {
      QVERIFY(grid->isKnownAt({10.0, y}));
    }
  }

  void brokenConnection_isTakenUpWhereItBroke() {
    FileServer server;
    stock(server, {{46, 8}}, 300, 300);  // 360 kB
    server.behave([](FileServer::Manners& manners) { manners.cutAfter = 100'000; });
    QTemporaryDir folder;
    const std::string output = folder.filePath("area.tif").toStdString();
    const Result<FetchedTerrain> fetched = fetchAll(requestFor(server, folder, kInOneTile), output);
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
    const auto requests = server.requests();
    QVERIFY(std::any_of(requests.begin(), requests.end(), [](const auto& r) { return r.range.starts_with("bytes=100000-"); }));
    QVERIFY(server.bytesSent() < 420'000);
    QCOMPARE(postAt(output, 46.3, 8.4), wavyHeight(46.3, 8.4));
  }

  void stoppedFetch_goesOnWhereItStopped() {
    FileServer server;
    stock(server, {{46, 8}}, 1300, 1300);  // 6.8 MB: two blocks
    QTemporaryDir folder;
    const std::string output = folder.filePath("area.tif").toStdString();
    const TerrainRequest request = requestFor(server, folder, kInOneTile);
    const Result<TerrainEstimate> estimate = estimateTerrain(request, Job{});
    QVERIFY(estimate.has_value());
    std::stop_source stop;
    const Job job(stop.get_token(), [&](double fraction, std::string_view) {
      if (fraction > 0.6) {
        stop.request_stop();
      }
    });
    const Result<FetchedTerrain> stopped = fetchTerrain(request, *estimate, output, job);
    QVERIFY(!stopped.has_value());
    QCOMPARE(stopped.error().code, Errc::Cancelled);
    QVERIFY(!QFile::exists(QString::fromStdString(output)));
    const std::string name = nameOf({46, 8}) + ".tif.part";
    QCOMPARE(filesUnder(folder.path().toStdString()), (std::vector<std::string>{name, name + ".source"}));
    const Result<TerrainEstimate> rest = estimateTerrain(request, Job{});
    QVERIFY(rest.has_value());
    QCOMPARE(rest->tiles.front().have, std::uint64_t{4u << 20});
    const std::size_t before = server.requests().size();
    QVERIFY(fetchTerrain(request, *rest, output, Job{}).has_value());
    const auto requests = server.requests();
    QCOMPARE(requests.size() - before, std::size_t{2});  // is it still the same, and the rest
    QVERIFY(requests.back().range.starts_with("bytes=4194304-"));
    QCOMPARE(postAt(output, 46.3, 8.4), wavyHeight(46.3, 8.4));
  }

  void stoppedFetch_ofAFileThatChangedSince_beginsAnew() {
    FileServer server;
    stock(server, {{46, 8}}, 1300, 1300);
    QTemporaryDir folder;
    const std::string output = folder.filePath("area.tif").toStdString();
    const TerrainRequest request = requestFor(server, folder, kInOneTile);
    std::stop_source stop;
    const Job job(stop.get_token(), [&](double fraction, std::string_view) {
      if (fraction > 0.6) {
        stop.request_stop();
      }
    });
    QVERIFY(!fetchTerrain(request, *estimateTerrain(request, Job{}), output, job).has_value());
    server.put("/" + nameOf({46, 8}) + "/" + nameOf({46, 8}) + ".tif", tileBytes({46, 8}, 1300, 1300, [](double, double) { return 7.0F; }));
    QVERIFY(fetchAll(request, output).has_value());
    const RasterFacts facts = factsOf(output);
    QCOMPARE(postAt(output, facts.north, facts.west), 7.0F);
  }

  void stop_whileTheServerIsSilent_isHeard() {
    FileServer server;
    stock(server, {{46, 8}}, 300, 300);
    QTemporaryDir folder;
    TerrainRequest request = requestFor(server, folder, kInOneTile);
    request.patience = {2, 60};
    const std::string output = folder.filePath("area.tif").toStdString();
    const Result<TerrainEstimate> estimate = estimateTerrain(request, Job{});
    QVERIFY(estimate.has_value());
    server.behave([](FileServer::Manners& manners) { manners.holdAfter = 1000; });
    std::stop_source stop;
    Result<FetchedTerrain> fetched = fail(Errc::Internal, "not run");
    std::thread worker([&] { fetched = fetchTerrain(request, *estimate, output, Job(stop.get_token())); });
    server.waitUntilHolding();
    stop.request_stop();
    worker.join();
    QVERIFY(!fetched.has_value());
    QCOMPARE(fetched.error().code, Errc::Cancelled);
    QVERIFY(!QFile::exists(QString::fromStdString(output)));
  }

  void twoAtOnce_fetchATileOnce() {
    FileServer server;
    stock(server, {{46, 8}}, 300, 300);
    QTemporaryDir folder;
    const TerrainRequest request = requestFor(server, folder, kInOneTile);
    const Result<TerrainEstimate> estimate = estimateTerrain(request, Job{});
    QVERIFY(estimate.has_value());
    const int before = tileRequests(server);
    server.behave([](FileServer::Manners& manners) { manners.holdAfter = 1000; });
    Result<FetchedTerrain> first = fail(Errc::Internal, "not run");
    Result<FetchedTerrain> second = first;
    TerrainRequest patient = request;
    patient.patience = {5, 120};
    std::thread one([&] { first = fetchTerrain(patient, *estimate, folder.filePath("one.tif").toStdString(), Job{}); });
    server.waitUntilHolding();
    const Job tells(std::stop_token(), [&](double, std::string_view text) {
      if (text.find("waiting for another program") != std::string_view::npos) {
        server.release();
      }
    });
    std::thread two([&] { second = fetchTerrain(patient, *estimate, folder.filePath("two.tif").toStdString(), tells); });
    one.join();
    two.join();
    QVERIFY2(first.has_value(), first ? "" : first.error().message().c_str());
    QVERIFY2(second.has_value(), second ? "" : second.error().message().c_str());
    QCOMPARE(tileRequests(server) - before, 2);  // first byte and the rest, once
    QCOMPARE(bytesOf(folder.filePath("one.tif").toStdString()), bytesOf(folder.filePath("two.tif").toStdString()));
  }

  void proxyOfTheEnvironment_isUsed() {
    FileServer proxy;
    stock(proxy, {{46, 8}});
    qputenv("http_proxy", proxy.address().c_str());
    qunsetenv("no_proxy");
    qunsetenv("NO_PROXY");
    QTemporaryDir folder;
    TerrainRequest request = requestFor(proxy, folder, kInOneTile);
    request.server = "http://terrain.invalid";
    const Result<FetchedTerrain> fetched = fetchAll(request, folder.filePath("area.tif").toStdString());
    qunsetenv("http_proxy");
    QVERIFY2(fetched.has_value(), fetched ? "" : fetched.error().message().c_str());
    QVERIFY(proxy.requests().front().path.starts_with("http://terrain.invalid/"));
  }

  void request_asksForPlainBytes() {
    FileServer server;
    stock(server, {{46, 8}});
    QTemporaryDir folder;
    QVERIFY(fetchAll(requestFor(server, folder, kInOneTile), folder.filePath("area.tif").toStdString()).has_value());
    for (const FileServer::Request& request : server.requests()) {
      QVERIFY2(request.head.find("gzip") == std::string::npos, request.head.c_str());  // parts of packed answers could not be joined
      QVERIFY2(!request.range.empty(), request.head.c_str());
    }
  }
};

QTEST_GUILESS_MAIN(TestTerrainFetch)
#include "tst_terrain_fetch.moc"
