// Which landing sites a mission is left with, and why the others do not count.
#include "core/formats/mission_loader.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <filesystem>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

mission::LandingSite runway(const char* id, double longitude, double length, mission::Surface surface) {
  mission::LandingSite site;
  site.id = id;
  site.airportIdent = id;
  site.touchdown = {46.5, longitude};
  site.landingCourse = Angle::degrees(90.0);
  site.elevation = geo::HeightMsl::fromMetres(100.0);
  site.surface = surface;
  if (length > 0.0) {
    site.length = Length::fromSi(length);
  }
  return site;
}

}  // namespace

class TestMissionLoader : public QObject {
  Q_OBJECT
  Folder folder_;

  /// Flat ground at 100 m under four runways; the aircraft lands in 381 m.
  mission::Mission flat() {
    std::string raster = "ncols 40\nnrows 40\nxllcorner 9.88\nyllcorner 46.48\ncellsize 0.001\n";
    for (int row = 0; row < 40; ++row) {
      for (int column = 0; column < 40; ++column) {
        raster += "100 ";
      }
      raster += "\n";
    }
    folder_.write(
        "flat.prj",
        R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])");
    mission::Mission mission;
    mission.terrain = {folder_.write("flat.asc", raster)};
    mission.aircraft = samples::sampleAircraft();
    mission.sites = {runway("HARD", 9.89, 400.0, mission::Surface::Hard), runway("GRASS", 9.895, 400.0, mission::Surface::Grass),
                     runway("SHORT", 9.90, 380.0, mission::Surface::Hard), runway("UNKNOWN", 9.905, 0.0, mission::Surface::Unknown)};
    mission.targets = {{"T", {46.5, 9.9}, 100.0, mission::HeightReference::AboveGround}};
    return mission;
  }

private slots:
  void terrainReplacedWhileItIsRead_isRefused() {
    const mission::Mission mission = flat();
    const std::string& file = mission.terrain.front();
    mission::Plan plan;
    plan.terrain = {{file, ""}};
    plan.frameOrigin = {46.5, 9.9};
    plan.terrainCell = 100.0;
    std::vector<std::string> checksums;
    QVERIFY(readPlanTerrain(plan, "", checksums, Job{}).has_value());
    bool isReplaced = false;
    const Job job(std::stop_token(), [&](double /*fraction*/, std::string_view /*text*/) {
      if (!isReplaced) {  // once the old one is open: a copy takes its name, as long and with the same heights
        const std::string copy = folder_.write("copy", samples::readBytes(file));
        std::filesystem::rename(copy, file);
        isReplaced = true;
      }
    });
    const auto read = readPlanTerrain(plan, "", checksums, job);
    QVERIFY(isReplaced);
    QVERIFY(!read);
    VP_CONTAINS(read.error().message(), {"flat.asc", "was changed while it was read", "try again"});
    isReplaced = false;
    const auto loaded = loadTerrain(mission.terrain, "", job);
    QVERIFY(isReplaced && !loaded);
    VP_CONTAINS(loaded.error().message(), {"flat.asc", "was changed while it was read"});
  }

  void runwaysTooShort_areLeftOutWithTheirFigures() {
    const mission::Mission mission = flat();
    const auto terrain = loadTerrain(mission.terrain, "", Job{});
    QVERIFY2(terrain, terrain ? "" : terrain.error().message().c_str());
    const auto sites = loadSites(mission, "", *terrain, true, Job{});
    QVERIFY2(sites, sites ? "" : sites.error().message().c_str());
    QCOMPARE(sites->usable.size(), std::size_t{2});
    QCOMPARE(sites->usable[0].site.id, std::string("HARD"));
    QCOMPARE(sites->usable[1].site.id, std::string("UNKNOWN"));
    QCOMPARE(sites->leftOut.size(), std::size_t{2});
    QCOMPARE(sites->tooShort, std::string("1 too short to be landed on that day: 400 m long, 520 m needed (GRASS)"));
    QCOMPARE(sites->notes.back(), std::string("1 too short to be landed on that day: 380 m long, 385 m needed (SHORT)"));
    QVERIFY(sites->tooWindy.empty());
  }

  void theHotDay_takesMore() {
    mission::Mission mission = flat();
    mission.atmosphere = air::Atmosphere{30.0, 990.0};
    const auto loaded = loadMission(mission, "", Job{});
    QVERIFY2(loaded, loaded ? "" : loaded.error().message().c_str());
    QCOMPARE(loaded->sites.size(), std::size_t{1});
    QCOMPARE(loaded->sites.front().site.id, std::string("UNKNOWN"));
  }

  void aProfileWithoutLandingDistance_landsEverywhere() {
    mission::Mission mission = flat();
    mission.aircraft.landingDistance.reset();
    QCOMPARE(loadMission(mission, "", Job{})->sites.size(), std::size_t{4});
  }

  void noRunwayLongEnough_saysSo() {
    mission::Mission mission = flat();
    mission.sites.pop_back();
    mission.sites.erase(mission.sites.begin());
    const auto loaded = loadMission(mission, "", Job{});
    QVERIFY(!loaded);
    QCOMPARE(loaded.error().code, Errc::NoLandingSite);
    VP_CONTAINS(loaded.error().message(), {"every runway inside the terrain is too short", "400 m long, 520 m needed (GRASS)"});
  }
};

QTEST_APPLESS_MAIN(TestMissionLoader)
#include "tst_mission_loader.moc"
