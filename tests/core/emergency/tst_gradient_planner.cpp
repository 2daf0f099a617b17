// The contingency planner of [3] on problems whose answer is known, and on the cases of its section 6.3 where the census is there.
#include "core/emergency/contingency.h"
#include "core/emergency/gradient_planner.h"
#include "core/emergency/landing_outcome.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/dubins.h"
#include "core/risk/people_under.h"
#include "core/safety/landing_check.h"
#include "tests/support/contingency_cases.h"
#include "tests/support/data_folder.h"
#include "tests/support/descent_check.h"
#include "tests/support/landing_cases.h"
#include "tests/support/path_check.h"

#include <QTest>

#include <chrono>
#include <cmath>
#include <stop_token>

using namespace vp;
using namespace vp::emergency;

namespace {

constexpr double kPi = Angle::kPi;
constexpr double kSteepest = 7.0;  // degrees; best glide of the Cessna of [1] is 4.9

mission::Mission paperMission() {
  mission::Mission mission = test::landingMission();
  mission.aircraft.steepestDescent = Angle::degrees(kSteepest);
  return mission;
}

/// One runway at the origin, landing to the east.
LandingRequest request(const std::shared_ptr<const terrain::ElevationGrid>& grid, const geo::Pose& pose, double altitude,
                       mission::Mission mission = paperMission()) {
  const mission::SiteInFrame site = test::placedSite("ZZZZ/09", {0.0, 0.0, 0.0}, 0.0);
  mission.sites = {site.site};
  return test::landingRequest(mission, {site}, grid, pose, altitude);
}

std::shared_ptr<const terrain::ElevationGrid> plain(double side = 40000.0) {
  return test::makeGrid(side, 200.0, [](double, double) { return 0.0; });
}

mission::PopulationArea town(const std::vector<geo::Point>& ring, double perSquareKm) {
  const geo::LocalFrame frame(test::kLandingOrigin);
  mission::PopulationArea area;
  area.name = "town";
  area.perSquareKm = perSquareKm;
  area.parts.emplace_back();
  for (const geo::Point& corner : ring) {
    area.parts.back().outline.push_back(frame.toLatLon(corner));
  }
  return area;
}

std::shared_ptr<const risk::LegRisk> peopleOf(const LandingRequest& request, const std::vector<mission::PopulationArea>& areas) {
  Result<risk::Population> population = risk::Population::from(areas, geo::LocalFrame(test::kLandingOrigin));
  return std::make_shared<const risk::PeopleUnder>(std::make_shared<const risk::Population>(std::move(population.value())),
                                                   request.world->glide.airspeed(), 1524.0);
}

/// Both the oracle of descent_check.h and the checker say so.
bool isSafe(const LandingRequest& request, const mission::LandingPath& path) {
  const std::string fault = test::descentFault(request, path);
  if (!fault.empty()) {
    qWarning("%s", fault.c_str());
  }
  const safety::LandingReport report =
      safety::checkLanding({*request.mission, request.world->sites, request.frameOrigin, request.world->terrain.grid()}, path);
  for (const safety::Finding& finding : report.findings) {
    if (finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown) {
      qWarning("%s: %s", finding.rule.c_str(), finding.text.c_str());
    }
  }
  return fault.empty() && report.isSafe();
}

double altitudeLost(const mission::LandingPath& path) {
  return path.altitude - path.legs.back().endAltitude;
}

}  // namespace

class TestGradientPlanner : public QObject {
  Q_OBJECT

private slots:
  void flatGround_exactHeight_isTheShortestWay() {
    // as much height as the shortest way loses at the optimal slope: nothing longer fits, and what is found is no longer than the range allows
    for (const double course : {0.0, 90.0, 200.0}) {
      const geo::Pose pose{-6000.0, 2500.0, Angle::degrees(course).radians()};
      LandingRequest one = request(plain(), pose, 1e4);
      const double radius = searchRadius(*one.world, {});
      const double length = flight::shortestDubins(pose, {0.0, 0.0, 0.0}, radius).length();
      one.altitude = 100.0 + length * 0.5 * (one.world->glide.straightLoss() + std::tan(Angle::degrees(kSteepest).radians()));
      const LandingAnswer answer = GradientPlanner().plan(one);
      QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
      QVERIFY(isSafe(one, *answer.path));
      const double longest = (one.altitude - 100.0) / one.world->glide.straightLoss();
      QVERIFY(lengthOf(*answer.path) >= length - 1e-6 && lengthOf(*answer.path) <= longest);
      QVERIFY(std::abs(altitudeLost(*answer.path) - (one.altitude - 100.0)) < 0.01);
    }
  }

  void noRunwayInReach_comesDownBesideTheTown() {
    // 400 m over a plain, 15 km from the runway; a town everywhere but to the south, the longest glide is straight on over it
    LandingRequest one = request(plain(), {-15000.0, 0.0, 0.0}, 400.0);
    const LandingAnswer farthest = GradientPlanner().plan(one);
    QVERIFY(!farthest.reachesRunway() && farthest.path);
    one.risk = peopleOf(one, {town({{-19500.0, -1200.0}, {-8500.0, -1200.0}, {-8500.0, 6000.0}, {-19500.0, 6000.0}}, 3000.0)});
    const LandingAnswer answer = GradientPlanner().plan(one);
    QVERIFY(!answer.reachesRunway() && answer.path);
    const auto endOf = [](const mission::LandingPath& path) {
      geo::Pose end = path.start;
      for (const mission::LandingLeg& leg : path.legs) {
        end = flight::endOf(end, leg.piece);
      }
      return end.point();
    };
    QVERIFY(endOf(*farthest.path).y > -100.0);
    QVERIFY2(endOf(*answer.path).y < -1200.0, qPrintable(QString::number(endOf(*answer.path).y)));
    QVERIFY(reachOf(*answer.path) >= 0.5 * reachOf(*farthest.path) - 1.0);
    QVERIFY2(answer.notes.back().find("least risk to people") != std::string::npos, answer.notes.back().c_str());
  }

  void townInTheWay_isFlownAround() {
    // a town between here and the runway, fields to both sides, height to spare: a way without anybody under it exists
    LandingRequest one = request(plain(), {-9000.0, 0.0, 0.0}, 1400.0);
    one.risk = peopleOf(one, {town({{-6500.0, -1200.0}, {-3500.0, -1200.0}, {-3500.0, 1200.0}, {-6500.0, 1200.0}}, 3000.0)});
    const LandingAnswer straight = DubinsPlanner().plan(one);
    const LandingAnswer answer = GradientPlanner().plan(one);
    QVERIFY2(answer.reachesRunway() && straight.reachesRunway(), answer.whyNot.c_str());
    QVERIFY(isSafe(one, *answer.path) && isSafe(one, *straight.path));
    QVERIFY2(riskOf(one, *answer.path) < 1e-9, qPrintable(QString::number(riskOf(one, *answer.path))));
    QVERIFY(riskOf(one, *answer.path) <= riskOf(one, *straight.path));
  }

  void townEverywhere_butOneCorridor_isCrossedThere() {
    // two towns from edge to edge with a corridor 1.5 km wide to the north of the straight way
    LandingRequest one = request(plain(), {-9000.0, 0.0, 0.0}, 1500.0);
    one.risk = peopleOf(one, {town({{-6000.0, 3500.0}, {-4000.0, 3500.0}, {-4000.0, 19000.0}, {-6000.0, 19000.0}}, 3000.0),
                              town({{-6000.0, -19000.0}, {-4000.0, -19000.0}, {-4000.0, 2000.0}, {-6000.0, 2000.0}}, 3000.0)});
    const LandingAnswer answer = GradientPlanner().plan(one);
    QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
    QVERIFY(isSafe(one, *answer.path));
    QVERIFY2(riskOf(one, *answer.path) < 1e-9, qPrintable(QString::number(riskOf(one, *answer.path))));
  }

  void wallWithOneGap_isPassedThere() {
    // a ridge of 900 m from edge to edge, 400 m thick, with a gap 3 km wide that is 3 km north of the straight way
    const auto grid =
        test::makeGrid(40000.0, 100.0, [](double x, double y) { return std::abs(x + 6000.0) <= 200.0 && (y < 2000.0 || y > 5000.0) ? 900.0 : 0.0; });
    LandingRequest one = request(grid, {-10000.0, 0.0, 0.0}, 1250.0);
    const LandingAnswer answer = GradientPlanner().plan(one);
    QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
    QVERIFY(isSafe(one, *answer.path));
    bool isInGap = false;
    std::vector<flight::Piece> pieces;
    for (const mission::LandingLeg& leg : answer.path->legs) {
      pieces.push_back(leg.piece);
    }
    for (const test::FlownPoint& point : test::fly(answer.path->start, pieces, 20.0)) {
      isInGap = isInGap || (std::abs(point.x + 6000.0) <= 200.0 && point.y > 2000.0 && point.y < 5000.0);
    }
    QVERIFY(isInGap);
  }

  void highUp_losesHeightInCirclesOverFields() {
    // above the crossover altitude: circles over the field, none over the town
    LandingRequest one = request(plain(), {-8000.0, 0.0, 0.0}, 3200.0);
    one.risk = peopleOf(one, {town({{-12000.0, -12000.0}, {12000.0, -12000.0}, {12000.0, 2000.0}, {-12000.0, 2000.0}}, 3000.0),
                              town({{-12000.0, 2000.0}, {12000.0, 2000.0}, {12000.0, 12000.0}, {-12000.0, 12000.0}}, 10.0)});
    const Result<landing::Approach> approach = landing::approachTo(*one.world, 0);
    const GradientOptions options;
    const auto* const people = dynamic_cast<const risk::PeopleUnder*>(one.risk.get());
    const HoldingAreas holds(*people->population(), searchRadius(*one.world, options));
    QVERIFY(!holds.all().empty());
    Contingency contingency(one, *approach, options, &holds);
    const BestDescent& best = contingency.search({}, Countdown(one));
    QVERIFY(best.path().has_value());
    QVERIFY(contingency.isHolding());
    QVERIFY(isSafe(one, *best.path()));
    const double circle = 2.0 * kPi * searchRadius(*one.world, options);
    int circles = 0;
    geo::Pose pose = best.path()->start;
    for (const mission::LandingLeg& leg : best.path()->legs) {
      if (leg.piece.turn == flight::Turn::Left && leg.piece.length > 0.999 * circle) {
        ++circles;
        // its centre lies in the thinly populated half
        QVERIFY(pose.y + leg.piece.radius * std::cos(pose.heading) > 2000.0);
      }
      pose = flight::endOf(pose, leg.piece);
    }
    QVERIFY(circles >= 1);
  }

  void transition_searchesFromTheCrossoverAltitude() {
    // just above it: the way to any hold comes below before it is there
    LandingRequest one = request(plain(), {-9000.0, 0.0, 0.0}, 1530.0);
    one.risk = peopleOf(one, {town({{2000.0, -12000.0}, {12000.0, -12000.0}, {12000.0, 12000.0}, {2000.0, 12000.0}}, 10.0)});
    const Result<landing::Approach> approach = landing::approachTo(*one.world, 0);
    const GradientOptions options;
    const HoldingAreas holds(*dynamic_cast<const risk::PeopleUnder*>(one.risk.get())->population(), searchRadius(*one.world, options));
    QVERIFY(!holds.all().empty());
    Contingency contingency(one, *approach, options, &holds);
    const BestDescent& best = contingency.search({}, Countdown(one));
    QVERIFY(best.path().has_value() && !contingency.isHolding());
    QVERIFY(isSafe(one, *best.path()));
  }

  void wind_everyPathVerifies() {
    mission::Mission windy = paperMission();
    windy.wind = {{geo::HeightMsl(), {310.0, 0.0, 5.0, 5.0}}};
    for (const double course : {0.0, 120.0, 240.0}) {
      LandingRequest one = request(plain(), {-5000.0, 2000.0, Angle::degrees(course).radians()}, 1300.0, windy);
      const LandingAnswer answer = GradientPlanner().plan(one);
      QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
      QVERIFY(isSafe(one, *answer.path));
    }
  }

  void withoutSteepestDescent_surplusIsSaid() {
    LandingRequest one = request(plain(), {-5000.0, 0.0, 0.0}, 1450.0, test::landingMission());
    const LandingAnswer answer = GradientPlanner().plan(one);
    QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
    QVERIFY(isSafe(one, *answer.path));
    QVERIFY(answer.heightInHand >= 0.0);
  }

  void withoutSteepestDescent_townIsFlownAround() {
    // no choice of slopes: only a way of the right length loses the height
    LandingRequest one = request(plain(), {-9000.0, 0.0, 0.0}, 1200.0, test::landingMission());
    one.risk = peopleOf(one, {town({{-6500.0, -1200.0}, {-3500.0, -1200.0}, {-3500.0, 1200.0}, {-6500.0, 1200.0}}, 3000.0)});
    const LandingAnswer answer = GradientPlanner().plan(one);
    QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
    QVERIFY(isSafe(one, *answer.path));
    QVERIFY2(riskOf(one, *answer.path) < 1e-9, qPrintable(QString::number(riskOf(one, *answer.path))));
    QVERIFY2(answer.heightInHand < 15.0, qPrintable(QString::number(answer.heightInHand)));
  }

  void outOfRange_endsWithoutRunway() {
    const LandingRequest one = request(plain(), {-15000.0, 0.0, 0.0}, 800.0);
    for (const LandingAnswer& answer : {GradientPlanner().plan(one), DubinsPlanner().plan(one)}) {
      QVERIFY(!answer.reachesRunway() && !answer.whyNot.empty() && answer.missing > 0.0);
      QVERIFY(answer.path && answer.path->site == -1);
    }
  }

  void sameRequest_sameAnswer() {
    LandingRequest one = request(plain(), {-9000.0, 0.0, 0.0}, 1400.0);
    one.risk = peopleOf(one, {town({{-6500.0, -1200.0}, {-3500.0, -1200.0}, {-3500.0, 1200.0}, {-6500.0, 1200.0}}, 3000.0)});
    const LandingAnswer first = GradientPlanner().plan(one);
    QCOMPARE(*GradientPlanner().plan(one).path, *first.path);
    one.threads = 2;
    QCOMPARE(*GradientPlanner().plan(one).path, *first.path);
  }

  void stopped_returnsTheFallbackAtOnce() {
    LandingRequest one = request(plain(), {-9000.0, 0.0, 0.0}, 1400.0);
    one.risk = peopleOf(one, {town({{-6500.0, -1200.0}, {-3500.0, -1200.0}, {-3500.0, 1200.0}, {-6500.0, 1200.0}}, 3000.0)});
    std::stop_source stop;
    stop.request_stop();
    one.job = Job(stop.get_token());
    const auto start = std::chrono::steady_clock::now();
    const LandingAnswer answer = GradientPlanner().plan(one);
    QVERIFY(std::chrono::steady_clock::now() - start < std::chrono::milliseconds(100));
    QVERIFY(answer.reachesRunway());  // Algorithm 2: there is always the fallback
    QVERIFY(!answer.notes.empty() && answer.notes.front().starts_with("Fallback"));
    QVERIFY(isSafe(one, *answer.path));
  }

  void suffolk_allCasesAreSolved_andNoWorseThanDubins() {
    const QString data = test::dataFolder();
    if (data.isEmpty()) {
      QSKIP("no folder with real data (VOLPLANE_DATA)");
    }
    const auto setting = test::contingencySetting((data + "/census/suffolk_tracts_pop.geojson").toStdString());
    QVERIFY2(setting.has_value(), setting ? "" : setting.error().message().c_str());
    const GradientOptions options;
    const auto holds = std::make_shared<const HoldingAreas>(*setting->population, searchRadius(*setting->world, options));
    const GradientPlanner planner(options, holds);
    int cases = 0;
    for (const test::ContingencyCase& each : test::contingencyCases(*setting)) {
      LandingRequest one = test::requestOf(*setting, each);
      one.deadline = 10.0;
      one.risk = std::make_shared<const risk::PeopleUnder>(setting->population, setting->world->glide.airspeed(), options.crossover.si());
      const LandingAnswer direct = DubinsPlanner(options).plan(one);
      const LandingAnswer answer = planner.plan(one);
      QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
      QVERIFY(isSafe(one, *answer.path));
      QVERIFY(!direct.reachesRunway() || riskOf(one, *answer.path) <= riskOf(one, *direct.path) + 1e-9);
      ++cases;
    }
    QCOMPARE(cases, 108);
  }
};

QTEST_APPLESS_MAIN(TestGradientPlanner)
#include "tst_gradient_planner.moc"
