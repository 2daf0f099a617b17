// The ways from and to a home runway: over every runway of a mission, judged by the checker; and what the checker finds when they are tampered with.
#include "core/formats/aircraft_file.h"
#include "core/safety/checker.h"
#include "core/tour/home_path.h"
#include "core/tour/home_site.h"
#include "core/tour/planner.h"
#include "core/tour/replan.h"
#include "tests/support/quick_plan.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <set>

using namespace vp;

namespace {

tour::PlanInput inputOf(const formats::LoadedMission& loaded) {
  return {loaded.mission, loaded.frame, loaded.terrain, loaded.terrainFiles, loaded.sites, loaded.targets, "test", "LKH", 1};
}

formats::LoadedMission load(const char* name, const char* aircraft) {
  mission::Mission mission = test::quickMission(std::string(VOLPLANE_SOURCE_DIR "/maps/") + name + ".vpm");
  if (aircraft != nullptr) {
    mission.aircraft = formats::findAircraft(aircraft, ".").value();
  }
  mission.planner.refine = mission::Refine::None;
  return formats::loadMission(mission, "", Job{}).value();
}

Result<mission::Plan> planFrom(formats::LoadedMission& loaded, const std::string& takeoff, const std::string& landing) {
  loaded.mission.home = mission::HomeBase{takeoff, landing};
  return tour::planTour(inputOf(loaded), Job{});
}

safety::SafetyReport judged(const mission::Plan& plan, const terrain::ElevationGrid& terrain) {
  std::vector<std::string> checksums;
  for (const mission::TerrainReference& file : plan.terrain) {
    checksums.push_back(file.sha256);
  }
  return safety::check({plan, terrain, checksums}, Job{}).value();
}

std::set<std::string> rulesBroken(const safety::SafetyReport& report) {
  std::set<std::string> rules;
  for (const safety::Finding& finding : report.findings) {
    if (finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown) {
      rules.insert(finding.rule);
    }
  }
  return rules;
}

QByteArray textsOf(const safety::SafetyReport& report) {
  QByteArray texts;
  for (const safety::Finding& finding : report.findings) {
    texts += "\n" + QByteArray::fromStdString(finding.rule + ": " + finding.text);
  }
  return texts;
}

using Tamper = std::function<void(mission::Plan&)>;

}  // namespace

Q_DECLARE_METATYPE(Tamper)

class TestHomePath : public QObject {
  Q_OBJECT

private slots:
  void everyRunway_ofAMission_givesACertifiedFlight_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("aircraft");
    QTest::newRow("mountain, steep climber") << "mountain-n5"
                                             << "cessna172-elasp";
    QTest::newRow("alps, real climber") << "alpine-n10"
                                        << "cessna172-operational";
  }
  void everyRunway_ofAMission_givesACertifiedFlight() {
    QFETCH(QString, name);
    QFETCH(QString, aircraft);
    formats::LoadedMission loaded = load(qPrintable(name), qPrintable(aircraft));
    tour::Planner planner;  // keeps the roadmap from runway to runway
    std::size_t flown = 0;
    for (std::size_t s = 0; s<loaded.sites.size(); s += loaded.sites.size()> 8 ? 5 : 1) {
      const std::string& id = loaded.sites[s].site.id;
      const std::string& other = loaded.sites[(s + 1) % loaded.sites.size()].site.id;
      loaded.mission.home = mission::HomeBase{id, other};
      const Result<mission::Plan> plan = planner.plan(inputOf(loaded), Job{});
      QVERIFY2(plan, plan ? "" : plan.error().message().c_str());
      const safety::SafetyReport report = judged(*plan, *loaded.terrain);
      QVERIFY2(report.isSafe(), textsOf(report).constData());
      QVERIFY(report.certificate->statement.find("taking off from " + id) != std::string::npos);
      QVERIFY(report.certificate->statement.find("above the threshold of " + other) != std::string::npos);
      QVERIFY(plan->departure && plan->arrival);
      // No glide is promised on the ground, and none is given away: the height at which it begins is no more than what a turn back to the runway
      // takes, with room for the coarse steps.
      const mission::HomePath& out = *plan->departure;
      QVERIFY(out.guaranteed > 0);
      const double height = out.points[static_cast<std::size_t>(out.guaranteed)].altitude - loaded.sites[s].site.elevation.metres();
      QVERIFY2(height > 100.0 && height < 100.0 + 300.0, qPrintable(QString::number(height)));
      ++flown;
    }
    QVERIFY(flown >= 5);
  }

  void unknownRunway_isRefusedWithThoseThereAre() {
    formats::LoadedMission loaded = load("mountain-n5", nullptr);
    const Result<mission::Plan> plan = planFrom(loaded, "MTSW/13", "nowhere");
    QVERIFY(!plan);
    QVERIFY(plan.error().code == Errc::OutOfRange);
    QVERIFY2(plan.error().message().find("home nowhere") != std::string::npos, plan.error().message().c_str());
    QVERIFY2(plan.error().message().find("MTSW/31") != std::string::npos, plan.error().message().c_str());
  }

  void tourItself_isTheSameWithAndWithoutHome() {
    formats::LoadedMission loaded = load("mountain-n5", nullptr);
    const Result<mission::Plan> without = tour::planTour(inputOf(loaded), Job{});
    const Result<mission::Plan> with = planFrom(loaded, "MTSW/13", "MTSW/31");
    QVERIFY(without && with);
    QVERIFY(!without->departure && !without->arrival);
    QCOMPARE(with->metrics.cost, without->metrics.cost);
  }

  void tampered_flight_breaksTheRule_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Tamper>("tamper");
    const auto row = [](const char* name, const char* rule, Tamper tamper) { QTest::newRow(name) << QString(rule) << tamper; };
    row("no departure", "home.data", [](mission::Plan& p) { p.departure.reset(); });
    row("no arrival", "home.data", [](mission::Plan& p) { p.arrival.reset(); });
    row("not asked for", "home.data", [](mission::Plan& p) { p.mission.home.reset(); });
    row("another runway", "home.data", [](mission::Plan& p) { p.mission.home->takeoff = "MTNE/12"; });
    row("promised from beyond the end", "home.data", [](mission::Plan& p) { p.departure->guaranteed = 1'000'000; });
    row("joins another point", "home.join", [](mission::Plan& p) { ++p.departure->join; });
    row("leaves another point", "home.join", [](mission::Plan& p) { --p.arrival->join; });
    row("starts above the runway", "home.runway", [](mission::Plan& p) { p.departure->points.front().altitude += 0.5; });
    row("promised earlier than there is a glide", "plan.index", [](mission::Plan& p) { --p.departure->guaranteed; });
    row("glide of the next point claimed one point earlier", "glide.site", [](mission::Plan& p) {
      const auto first = static_cast<std::size_t>(p.departure->guaranteed--);
      p.departure->points[first - 1].witness = p.departure->points[first].witness;
    });
    row("climb steeper than the aircraft", "tour.climb", [](mission::Plan& p) { p.mission.aircraft.maxClimb = p.mission.aircraft.maxClimb * 0.5; });
    row("turn tighter than the aircraft", "tour.radius", [](mission::Plan& p) { p.departure->points.front().onward.radius *= 0.5; });
    row("gap in the climb", "tour.gap", [](mission::Plan& p) { p.departure->points[2].pose.x += 1.0; });
    row("arrival below the glide", "glide.clearance", [](mission::Plan& p) { p.arrival->points.back().altitude -= 50.0; });
    row("forbidden airspace over the climb-out", "airspace.tour", [](mission::Plan& p) {
      const geo::LocalFrame frame(p.frameOrigin);
      const geo::Point at = p.departure->points[1].pose.point();
      std::vector<geo::LatLon> outline;
      for (const geo::Point& corner : {geo::Point{-20.0, -20.0}, {20.0, -20.0}, {20.0, 20.0}, {-20.0, 20.0}}) {
        outline.push_back(frame.toLatLon({at.x + corner.x, at.y + corner.y}));
      }
      p.airspaces = {{"CTR", "D", {mission::AirspaceLimit::Kind::Surface, 0.0}, {mission::AirspaceLimit::Kind::Msl, 200.0}, outline}};
      p.mission.airspace.rules = {{"D", "", mission::AirspaceUse::Forbid}};
    });
    row("number that is none", "plan.number", [](mission::Plan& p) { p.departure->points[1].altitude = std::nan(""); });
    row("promise of no glide in the arrival", "plan.index", [](mission::Plan& p) { p.arrival->points[1].witness = {}; });
  }
  void tampered_flight_breaksTheRule() {
    QFETCH(QString, rule);
    QFETCH(Tamper, tamper);
    formats::LoadedMission loaded = load("mountain-n5", nullptr);
    Result<mission::Plan> plan = planFrom(loaded, "MTSW/13", "MTSW/31");
    QVERIFY(plan);
    QVERIFY(judged(*plan, *loaded.terrain).isSafe());
    tamper(*plan);
    const safety::SafetyReport report = judged(*plan, *loaded.terrain);
    QVERIFY(!report.isSafe());
    QVERIFY2(rulesBroken(report).contains(rule.toStdString()), textsOf(report).constData());
  }

  void forbiddenAirspaceBesideTheRunway_isClimbedOutOnTheOtherSide() {
    formats::LoadedMission loaded = load("mountain-n5", nullptr);
    const Result<mission::Plan> free = planFrom(loaded, "MTSW/13", "MTSW/31");
    QVERIFY(free);
    const geo::Pose end = tour::departureEnd(free->sites[static_cast<std::size_t>(free->departure->site)]);
    const double side = free->departure->points.front().onward.turn == flight::Turn::Left ? 1.0 : -1.0;
    const geo::Point centre{end.x - side * 60.0 * std::sin(end.heading), end.y + side * 60.0 * std::cos(end.heading)};
    tour::PlanInput input = inputOf(loaded);
    const auto forbid = [&](geo::Point at, double half, double ceiling) {
      std::vector<geo::LatLon> outline;
      for (const geo::Point& corner : {geo::Point{-half, -half}, {half, -half}, {half, half}, {-half, half}}) {
        outline.push_back(input.frame.toLatLon({at.x + corner.x, at.y + corner.y}));
      }
      input.airspaces = {{"CTR", "D", {mission::AirspaceLimit::Kind::Surface, 0.0}, {mission::AirspaceLimit::Kind::Msl, ceiling}, outline}};
      input.mission.airspace.rules = {{"D", "", mission::AirspaceUse::Forbid}};
    };
    forbid(centre, 10.0, 5000.0);
    const Result<mission::Plan> plan = tour::planTour(input, Job{});
    QVERIFY2(plan, plan ? "" : plan.error().message().c_str());
    QVERIFY2(judged(*plan, *loaded.terrain).isSafe(), textsOf(judged(*plan, *loaded.terrain)).constData());
    forbid(end.point(), 100.0, 5000.0);
    const Result<mission::Plan> inside = tour::planTour(input, Job{});
    QVERIFY(!inside);
    QVERIFY2(inside.error().what.find("home MTSW/13 lies inside CTR (class D, the surface to 5000 m MSL)") == 0, inside.error().what.c_str());
  }

  void hillInTheClimbOut_isFound() {
    formats::LoadedMission loaded = load("alpine-n10", "cessna172-operational");
    const Result<mission::Plan> plan = planFrom(loaded, "VA01/21", "VA01/21");
    QVERIFY(plan);
    const mission::HomePath& out = *plan->departure;
    double flown = 0.0;
    std::size_t at = 0;
    while (flown < 1200.0) {
      flown += out.points[at++].onward.length;
    }
    QVERIFY(static_cast<int>(at) + 1 < out.guaranteed);
    const terrain::ElevationGrid& old = *loaded.terrain;
    std::vector<float> heights = old.values();
    const geo::Point place = out.points[at].pose.point();
    const auto cell =
        static_cast<std::size_t>(old.rowOf(place.y)) * static_cast<std::size_t>(old.columns()) + static_cast<std::size_t>(old.columnOf(place.x));
    heights[cell] = static_cast<float>(out.points[at].altitude + 1.0);
    const terrain::ElevationGrid hill(old.originX(), old.originY(), old.cellSize(), old.columns(), old.rows(), heights);
    const std::set<std::string> rules = rulesBroken(judged(*plan, hill));
    QVERIFY(rules.contains("home.clearance"));
  }
};

QTEST_APPLESS_MAIN(TestHomePath)
#include "tst_home_path.moc"
