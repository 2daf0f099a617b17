// The planners of [4] on problems whose best way is known: closed-form Dubins over flat ground, walls of weather with one gap, a corridor, thin
// places, layers to fly under and over, a wall of ground with a gap; seeds, stops, deadlines.
#include "core/emergency/landing_outcome.h"
#include "core/emergency/planners.h"
#include "core/emergency/verified_answer.h"
#include "core/emergency/weather/weather_planner.h"
#include "core/emergency/weather/weather_roadmap.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "tests/support/landing_optima.h"
#include "tests/support/weather_cases.h"

#include <QTest>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <thread>

using namespace vp;
using namespace vp::emergency;

namespace {

const std::vector<std::string> kAll{"straight", "vg", "tg", "lvg", "hrm", "prm", "vprm", "dlvg", "dprm", "dvprm"};

void rowsOf(const std::vector<std::string>& planners) {
  QTest::addColumn<QString>("planner");
  for (const std::string& planner : planners) {
    QTest::newRow(planner.c_str()) << QString::fromStdString(planner);
  }
}

/// The planner's answer, judged: a path that the checker refuses fails the test.
LandingAnswer planned(const QString& planner, const LandingRequest& request) {
  LandingAnswer answer = makePlanner(planner.toStdString())->plan(request);
  if (answer.path) {
    answer = verifiedAnswer(request, std::move(answer));
    if (!answer.verified) {
      qWarning("%s: %s", qPrintable(planner), answer.whyNot.c_str());
    }
  }
  return answer;
}

double termOf(const LandingAnswer& answer, const std::string& name) {
  for (const CostTerm& term : answer.terms) {
    if (term.name == name) {
      return term.value;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// Height that a path has lost at the gate.
double lostBy(const LandingRequest& request, const LandingAnswer& answer) {
  const Result<landing::Approach> approach = landing::approachTo(*request.world, static_cast<std::size_t>(answer.path->site));
  return request.altitude - answer.heightInHand - approach->altitude;
}

/// Least loss by two curves through a thin wall's gap that meet no weather: poses every 10 m and 3 degrees.
double bestThroughWeatherGap(const LandingRequest& request, double south, double north) {
  const landing::World& world = *request.world;
  const landing::Approach approach = *landing::approachTo(world, 0);
  const double radius = world.glide.glideRadii().front();
  const flight::TurnLoss loss = flight::turnLossOf(world.glide, radius);
  const risk::WeatherRisk weather(request.weather);
  const auto meets = [&](const flight::DubinsPath& path) {
    double sum = 0.0;
    geo::Pose pose = path.start;
    for (std::size_t i = 0; i < 3; ++i) {
      sum += weather.of(pose, path.piece(i), 1000.0, 1000.0);
      pose = flight::endOf(pose, path.piece(i));
    }
    return sum > 0.0;
  };
  double best = std::numeric_limits<double>::infinity();
  for (double y = south + 5.0; y < north; y += 10.0) {
    for (int degrees = -90; degrees <= 90; degrees += 3) {
      const geo::Pose middle{0.0, y, Angle::degrees(degrees).radians()};
      const flight::DubinsPath first = flight::leastLossDubins(request.pose, middle, radius, loss);
      const flight::DubinsPath second = flight::leastLossDubins(middle, approach.gate, radius, loss);
      const double lost = flight::lossOf(first, loss) + flight::lossOf(second, loss);
      if (lost < best && !meets(first) && !meets(second)) {
        best = lost;
      }
    }
  }
  return best;
}

}  // namespace

class TestWeatherPlanners : public QObject {
  Q_OBJECT

private slots:
  /// A square off the way: of the three corners that start and gate see, the middle one is not locally tangent.
  void tangentGraph_leavesOutWhatIsNotLocallyTangent() {
    const LandingRequest request = test::eastward(test::landingMission(test::oneBankCessna()), 2500.0,
                                                  {test::weatherCell(test::rectangle(-1000.0, 2000.0, 1000.0, 4000.0), 0.5)});
    const LandingGoals goals(*request.world, request.pose, request.altitude);
    DescentFlight descents(*request.world, *request.mission);
    WeatherFlight flight(request, descents, request.weather);
    const Countdown countdown(request);
    const RoadmapTask task{request, goals, flight, countdown};
    const auto edgesOf = [](const WeatherRoadmap& roadmap) {
      std::size_t count = 0;
      for (const std::vector<int>& edges : roadmap.edges) {
        count += edges.size();
      }
      return count;
    };
    const WeatherRoadmap all = visibilityRoadmap(task, false);
    QVERIFY(all.vertices.size() == 6 && all.goals == 1);
    QCOMPARE(all.edges[0].size(), std::size_t{4});       // the gate and three corners
    QCOMPARE(edgesOf(all), std::size_t{4 + 3 + 4 * 2});  // and three to the gate, four sides both ways
    const WeatherRoadmap tangent = visibilityRoadmap(task, true);
    QCOMPARE(tangent.edges[0].size(), std::size_t{3});
    QCOMPARE(edgesOf(tangent), std::size_t{3 + 2 + 4 * 2});
    // two poses at each corner; edges between corners where headings differ by less than a right angle
    const WeatherRoadmap poses = layeredRoadmap(task, true);
    QVERIFY(poses.vertices.size() == 10 && poses.hasDynamics);
    for (std::size_t from = 2; from < poses.vertices.size(); ++from) {
      for (const int to : poses.edges[from]) {
        QVERIFY(to == 1 ||
                std::abs(wrapPi(poses.vertices[from].pose.heading - poses.vertices[static_cast<std::size_t>(to)].pose.heading)) < 0.5 * Angle::kPi);
      }
    }
  }

  void flatGround_isTheClosedForm_data() { rowsOf(kAll); }
  void flatGround_isTheClosedForm() {
    QFETCH(QString, planner);
    for (const double course : {0.0, 1.2, -2.5}) {
      LandingRequest request = test::eastward(test::landingMission(test::oneBankCessna()), 2500.0, {}, course);
      const LandingAnswer answer = planned(planner, request);
      QVERIFY2(answer.reachesRunway() && answer.verified, answer.whyNot.c_str());
      QCOMPARE(answer.planner, planner.toStdString());
      const double least = test::closedForm(*request.world, request.pose, landing::approachTo(*request.world, 0)->gate);
      QVERIFY2(std::abs(lostBy(request, answer) - least) < 1e-3, qPrintable(QString("%1 m against %2").arg(lostBy(request, answer)).arg(least)));
      QCOMPARE(termOf(answer, "weather"), 0.0);
      QCOMPARE(termOf(answer, kWeatherSuccess), 1.0);
      // without any weather the same, but for the terms
      request.weather = nullptr;
      const LandingAnswer without = planned(planner, request);
      QVERIFY(without.reachesRunway() && without.heightInHand == answer.heightInHand && std::isnan(termOf(without, "weather")));
    }
  }

  void straight_meetsWhatTheClosedFormSays() {
    const LandingRequest request = test::eastward(test::landingMission(test::oneBankCessna()), 2500.0, test::weatherWall(-2000.0, 2000.0, 0.0, 0.0));
    const LandingAnswer answer = planned("straight", request);
    QVERIFY2(answer.reachesRunway() && answer.verified, answer.whyNot.c_str());
    const double straight = 4.0 * std::log(2.0);
    QVERIFY2(answer.cost() >= straight && answer.cost() < 1.01 * straight, qPrintable(QString::number(answer.cost())));
    QVERIFY(std::abs(termOf(answer, kWeatherSuccess) - std::exp(-answer.cost())) < 1e-12);
    QVERIFY(!answer.lowerBound);
  }

  /// Every roadmap finds the gap of a thin wall, and comes near to the best way through it.
  void wallWithOneGap_isPassedThrough_data() { rowsOf({"vg", "tg", "lvg", "hrm", "prm", "vprm", "dlvg", "dprm", "dvprm"}); }
  void wallWithOneGap_isPassedThrough() {
    QFETCH(QString, planner);
    const LandingRequest request =
        test::eastward(test::landingMission(test::oneBankCessna()), 2500.0, test::weatherWall(-20.0, 20.0, 2500.0, 3100.0));
    const LandingAnswer answer = planned(planner, request);
    QVERIFY2(answer.reachesRunway() && answer.verified, answer.whyNot.c_str());
    QVERIFY2(answer.cost() < 1e-6, qPrintable(QString("weather %1").arg(answer.cost())));
    const double best = bestThroughWeatherGap(request, 2500.0, 3100.0);
    const double lost = lostBy(request, answer);
    QVERIFY2(lost > best - 3.0 && lost < 1.02 * best, qPrintable(QString("%1 m against %2").arg(lost).arg(best)));
  }

  void corridorThroughAField_isFound_data() { rowsOf({"vg", "tg", "lvg", "hrm", "prm", "vprm", "dlvg", "dprm", "dvprm"}); }
  void corridorThroughAField_isFound() {
    QFETCH(QString, planner);
    const LandingRequest request =
        test::eastward(test::landingMission(test::oneBankCessna()), 2500.0, test::weatherWall(-1500.0, 1500.0, 1500.0, 2300.0));
    const LandingAnswer answer = planned(planner, request);
    QVERIFY2(answer.reachesRunway() && answer.verified, answer.whyNot.c_str());
    QVERIFY2(answer.cost() < 1e-6, qPrintable(QString("weather %1").arg(answer.cost())));
  }

  /// The way around is too long for the height: what is left is the thinnest place of the wall.
  void thinPlace_isCrossedThere_data() { rowsOf({"prm", "vprm", "dprm", "dvprm"}); }
  void thinPlace_isCrossedThere() {
    QFETCH(QString, planner);
    // 1000 m thick, 200 m between y = 1500 and 2500
    const LandingRequest request = test::eastward(test::landingMission(test::oneBankCessna()), 1500.0,
                                                  {test::weatherCell({{-500.0, -19000.0},
                                                                      {500.0, -19000.0},
                                                                      {500.0, 1500.0},
                                                                      {100.0, 1500.0},
                                                                      {100.0, 2500.0},
                                                                      {500.0, 2500.0},
                                                                      {500.0, 19000.0},
                                                                      {-500.0, 19000.0},
                                                                      {-500.0, 2500.0},
                                                                      {-100.0, 2500.0},
                                                                      {-100.0, 1500.0},
                                                                      {-500.0, 1500.0}},
                                                                     0.5)});
    const LandingAnswer answer = planned(planner, request);
    QVERIFY2(answer.reachesRunway() && answer.verified, answer.whyNot.c_str());
    const double least = 0.2 * std::log(2.0);
    QVERIFY2(answer.cost() >= least - 1e-9 && answer.cost() < 1.05 * least,
             qPrintable(QString("weather %1, least %2").arg(answer.cost()).arg(least)));
  }

  /// Weather from 500 m up behind x = 0: who may come down steeply flies under it, who may not flies through.
  void layer_isFlownUnderWhereSlopesLetIt_data() { rowsOf(kAll); }
  void layer_isFlownUnderWhereSlopesLetIt() {
    QFETCH(QString, planner);
    const std::vector<mission::WeatherCell> cells{test::weatherCell(test::rectangle(0.0, -19000.0, 3000.0, 19000.0), 0.5, 800.0)};
    const LandingAnswer under = planned(planner, test::eastward(test::steepMission(), 1500.0, cells));
    QVERIFY2(under.reachesRunway() && under.verified, under.whyNot.c_str());
    QVERIFY2(under.cost() < 1e-6, qPrintable(QString("weather %1").arg(under.cost())));
    // the glide alone is at 984 m where the weather begins and at 800 m 2150 m later; a circle flown first, which loses 90 m, leaves 1 km of it
    const LandingRequest flat = test::eastward(test::landingMission(test::oneBankCessna()), 1500.0, cells);
    if (planner == "straight") {
      const LandingAnswer through = planned(planner, flat);
      QVERIFY2(through.reachesRunway() && through.cost() > std::log(2.0) && through.cost() < 2.16 * std::log(2.0),
               qPrintable(QString::number(through.cost())));
    }
  }

  /// Weather up to 600 m: flown over, not down into it.
  void layer_isFlownOver_data() { rowsOf(kAll); }
  void layer_isFlownOver() {
    QFETCH(QString, planner);
    const std::vector<mission::WeatherCell> cells{test::weatherCell(test::rectangle(-2000.0, -19000.0, 3000.0, 19000.0), 0.5, std::nullopt, 600.0)};
    const LandingAnswer over = planned(planner, test::eastward(test::steepMission(), 1450.0, cells));
    QVERIFY2(over.reachesRunway() && over.verified, over.whyNot.c_str());
    QVERIFY2(over.cost() < 1e-6, qPrintable(QString("weather %1").arg(over.cost())));
  }

  void wallOfGround_isPassedThroughItsGap_data() { rowsOf({"prm", "vprm", "dprm", "dvprm"}); }
  void wallOfGround_isPassedThroughItsGap() {
    QFETCH(QString, planner);
    LandingRequest request = test::landingRequest(test::landingMission(test::oneBankCessna()), {test::placedSite("A/09", {2500.0, -500.0, 0.0}, 0.0)},
                                                  test::wallGrid(800.0, 1600.0), {-2500.0, 0.0, 0.0}, 900.0);
    const LandingAnswer straight = planned("straight", request);
    QVERIFY(!straight.reachesRunway() && !straight.whyNot.empty());
    const LandingAnswer answer = planned(planner, request);
    QVERIFY2(answer.reachesRunway() && answer.verified, answer.whyNot.c_str());
    const double best = test::bestThroughGap(request, *landing::approachTo(*request.world, 0), 800.0, 1600.0);
    const double lost = lostBy(request, answer);
    QVERIFY2(lost > best - 3.0 && lost < 1.1 * best, qPrintable(QString("%1 m against %2").arg(lost).arg(best)));
  }

  void onlySite_isTheOneThatIsLandedAt_data() { rowsOf(kAll); }
  void onlySite_isTheOneThatIsLandedAt() {
    QFETCH(QString, planner);
    LandingRequest request = test::landingRequest(
        test::landingMission(test::oneBankCessna()),
        {test::placedSite("A/09", {3000.0, 0.0, 0.0}, 0.0), test::placedSite("B/09", {6000.0, 3000.0, 0.0}, 0.0)}, test::wideGrid(), {}, 2000.0);
    request.weather = test::weatherOf({test::weatherCell(test::rectangle(1000.0, -500.0, 2000.0, 5000.0), 0.7)});
    for (const int site : {0, 1}) {
      request.onlySite = site;
      const LandingAnswer answer = planned(planner, request);
      QVERIFY2(answer.reachesRunway() && answer.path->site == site, answer.whyNot.c_str());
    }
  }

  void sameSeed_sameAnswer_onAnyThread_data() { rowsOf({"prm", "vprm", "dprm", "dvprm"}); }
  void sameSeed_sameAnswer_onAnyThread() {
    QFETCH(QString, planner);
    LandingRequest request = test::eastward(test::steepMission(), 1900.0,
                                            {test::weatherCell(test::rectangle(-2000.0, -9000.0, 2000.0, 2000.0), 0.6, 300.0, 4000.0),
                                             test::weatherCell(test::rectangle(-500.0, 1000.0, 3000.0, 12000.0), 0.8)});
    WeatherPlannerOptions options = *weatherPlannerOptions(planner.toStdString());
    options.rounds = 2;
    options.samples = 60;
    request.deadline = 120.0;
    const WeatherPlanner one("one", options);
    const LandingAnswer first = one.plan(request);
    LandingAnswer second;
    LandingAnswer third;
    std::thread beside([&] { second = one.plan(request); });
    third = one.plan(request);
    beside.join();
    QVERIFY(first.reachesRunway() && first.path == second.path && first.path == third.path && first.cost() == third.cost());
    for (std::size_t i = 0; i < first.tried.size(); ++i) {
      QCOMPARE(first.tried[i].count, second.tried[i].count);
    }
  }

  void deadlineAndStop_areKept_data() { rowsOf(kAll); }
  void deadlineAndStop_areKept() {
    QFETCH(QString, planner);
    std::vector<mission::WeatherCell> cells;
    for (int i = 0; i < 25; ++i) {
      const double x = 2500.0 * (i % 5) - 6000.0;
      const double y = 2500.0 * (i / 5) - 6000.0;
      cells.push_back(test::weatherCell(test::rectangle(x, y, x + 2600.0, y + 2600.0), 0.5 + 0.01 * i, 100.0 * i, 1000.0 + 100.0 * i));
    }
    LandingRequest request = test::eastward(test::steepMission(), 2500.0, cells);
    request.deadline = 0.05;
    const LandingAnswer answer = planned(planner, request);
    QVERIFY2(answer.reachesRunway() && answer.verified, answer.whyNot.c_str());
    QVERIFY2(answer.seconds < 2.0, qPrintable(QString::number(answer.seconds)));  // on a busy machine
    request.deadline = 300.0;
    std::stop_source stop;
    request.job = Job(stop.get_token());
    request.better = [&stop](const LandingAnswer&) { stop.request_stop(); };
    const auto start = std::chrono::steady_clock::now();
    const LandingAnswer stopped = makePlanner(planner.toStdString())->plan(request);
    QVERIFY(stopped.reachesRunway());
    QVERIFY(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < 5.0);
  }

  void nonsense_isAnsweredWithItsSentence_data() { rowsOf(kAll); }
  void nonsense_isAnsweredWithItsSentence() {
    QFETCH(QString, planner);
    LandingRequest request = test::eastward(test::landingMission(), 2500.0, {});
    request.altitude = -10.0;
    const LandingAnswer below = planned(planner, request);
    QVERIFY(!below.path && below.whyNot.find("below the ground") != std::string::npos);
    request.altitude = 300.0;
    const LandingAnswer low = planned(planner, request);
    QVERIFY(!low.reachesRunway() && low.whyNot.find("No runway is in range") != std::string::npos && low.missing > 0.0);
  }

  /// The combined planner comes through the weather as likely as the best of [4] that it runs.
  void combined_weighsWeather() {
    LandingRequest request = test::eastward(test::landingMission(test::oneBankCessna()), 2500.0, test::weatherWall(-1500.0, 1500.0, 1500.0, 2300.0));
    request.deadline = 3.0;
    const std::vector<std::string> known = plannerNames();
    for (const bool hasWeather : {false, true}) {
      const std::vector<std::string> names = combinedNames(hasWeather);
      QCOMPARE(std::count(names.begin(), names.end(), "dvprm"), hasWeather ? 1 : 0);
      QVERIFY(std::all_of(names.begin(), names.end(), [&](const std::string& name) { return std::count(known.begin(), known.end(), name) == 1; }));
    }
    const LandingAnswer answer = makePlanner("combined")->plan(request);
    QVERIFY2(answer.reachesRunway() && answer.verified, answer.whyNot.c_str());
    QVERIFY2(answer.cost() < 1e-3, qPrintable(QString("%1: weather %2").arg(QString::fromStdString(answer.planner)).arg(answer.cost())));
  }
};

QTEST_APPLESS_MAIN(TestWeatherPlanners)
#include "tst_weather_planners.moc"
