// The roadmap's planner and the combined one, and every planner's paths before the independent checker: in still air, wind, layers and an atmosphere,
// with each kind of approach.
#include "core/emergency/anytime_planner.h"
#include "core/emergency/combined_planner.h"
#include "core/emergency/landing_outcome.h"
#include "core/emergency/planners.h"
#include "core/emergency/roadmap_planner.h"
#include "core/emergency/verified_answer.h"
#include "core/emergency/weather/weather_planner.h"
#include "core/landing/build_roadmap.h"
#include "core/safety/landing_check.h"
#include "tests/support/band_flight.h"
#include "tests/support/landing_cases.h"
#include "tests/support/weather_cases.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace vp;
using namespace vp::emergency;

namespace {

constexpr double kHalf = 2300.0;

air::WindLayer layer(double altitude, double from, double spread, double least, double most) {
  return {geo::HeightMsl::fromMetres(altitude), {from, spread, least * test::kKnot, most * test::kKnot}};
}

struct Condition {
  const char* name;
  mission::Mission mission;
};

std::vector<Condition> conditions() {
  std::vector<Condition> all;
  const mission::Mission calm = test::landingMission();
  all.push_back({"calm", calm});
  mission::Mission wind = calm;
  wind.wind = {layer(0.0, 270.0, 20.0, 10.0, 20.0)};
  all.push_back({"15 +- 5 kt, +- 20 degrees", wind});
  mission::Mission layers = calm;
  layers.wind = {layer(0.0, 270.0, 0.0, 5.0, 5.0), layer(1000.0, 290.0, 10.0, 10.0, 15.0), layer(2000.0, 310.0, 0.0, 25.0, 25.0)};
  all.push_back({"three layers", layers});
  mission::Mission air = calm;
  air.atmosphere = air::Atmosphere();
  air.ceiling = geo::HeightMsl::fromMetres(3000.0);
  all.push_back({"standard atmosphere", air});
  mission::Mission straight = calm;
  straight.approach.kind = mission::ApproachKind::Straight;
  straight.approach.finalLength = Length::fromSi(800.0);
  all.push_back({"straight approach", straight});
  mission::Mission overhead = wind;
  overhead.approach.kind = mission::ApproachKind::Overhead;
  all.push_back({"overhead approach in wind", overhead});
  return all;
}

geo::Pose poseOf(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double x = kHalf * unit(random);
  const double y = kHalf * unit(random);
  return {x, y, Angle::kPi * unit(random)};
}

QByteArray findingsOf(const LandingRequest& request, const mission::LandingPath& path) {
  QByteArray texts;
  for (const safety::Finding& finding :
       safety::checkLanding({*request.mission, request.world->sites, request.frameOrigin, request.world->terrain.grid()}, path).findings) {
    texts += QByteArray::fromStdString(finding.rule + ": " + finding.text + "\n");
  }
  return texts;
}

/// Answers what it was given, whatever it was asked.
class FixedPlanner final : public LandingPlanner {
public:
  explicit FixedPlanner(LandingAnswer answer) : answer_(std::move(answer)) {}
  [[nodiscard]] std::string_view name() const override { return answer_.planner; }
  [[nodiscard]] LandingAnswer plan(const LandingRequest& request) const override {
    if (request.better) {
      request.better(answer_);
    }
    return answer_;
  }

private:
  LandingAnswer answer_;
};

class ThrowingPlanner final : public LandingPlanner {
public:
  [[nodiscard]] std::string_view name() const override { return "throwing"; }
  [[nodiscard]] LandingAnswer plan(const LandingRequest& /*request*/) const override { throw std::runtime_error("out of luck"); }
};

}  // namespace

class TestLandingPlanners : public QObject {
  Q_OBJECT

private slots:
  void everyPath_isAcceptedByTheChecker_data() {
    QTest::addColumn<int>("number");
    const std::vector<Condition> all = conditions();
    for (std::size_t i = 0; i < all.size(); ++i) {
      QTest::newRow(all[i].name) << static_cast<int>(i);
    }
  }
  void everyPath_isAcceptedByTheChecker() {
    QFETCH(int, number);
    const mission::Mission mission = conditions()[static_cast<std::size_t>(number)].mission;
    LandingRequest request = test::mountainRequest(mission, {}, 0.0);
    landing::RoadmapRequest wanted;
    wanted.area = request.world->terrain.grid().extent();
    request.roadmap = *landing::buildRoadmap(*request.world, mission.planner, wanted, Job());
    std::mt19937_64 random(static_cast<std::uint64_t>(number));
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    landing::QueryScratch scratch;
    int roadmaps = 0;
    int landings = 0;
    int elsewhere = 0;
    constexpr std::size_t kWeatherPlanners = 3;  // for each pose of those; ten poses in still air ask each three times
    const std::vector<std::string_view> ofWeather = weatherPlannerNames();
    const std::shared_ptr<const risk::Weather> weather =
        test::weatherOf({test::weatherCell(test::rectangle(-1800.0, 200.0, -200.0, 1700.0), 0.5, 300.0, 900.0),
                         test::weatherCell(test::rectangle(900.0, -2000.0, 1700.0, 400.0), 0.7),
                         test::weatherCell(test::rectangle(-900.0, -1900.0, 400.0, -900.0), 0.6)});
    std::size_t inTurn = static_cast<std::size_t>(number);
    const int poses = mission.wind.empty() ? 40 : 12;  // in wind the checker takes some ten milliseconds for each radius and band of each path
    for (int i = 0; i < poses; ++i) {
      request.pose = poseOf(random);
      const auto safe = request.roadmap->queryTurning(*request.world, request.pose, scratch);
      QVERIFY(safe);
      request.altitude = std::max(safe->altitude + 80.0 * unit(random) - 20.0, request.world->terrain.grid().upperAt(request.pose.point()) + 101.0);
      request.seed = static_cast<std::uint64_t>(i);
      const LandingAnswer witness = RoadmapPlanner().plan(request);
      std::vector<LandingAnswer> answers{witness, AnytimePlanner(300).plan(request)};
      constexpr int kOften = 4;  // of the poses all planners are asked about one in so many
      for (const char* const other : {"dubins", "gradient", "fmt-octree", "fmt"}) {
        if (i % kOften == 0) {
          answers.push_back(makePlanner(other)->plan(request));
        }
      }
      if (i % kOften == 0) {  // all of [4] in turn, among weather
        LandingRequest among = request;
        among.weather = weather;
        among.deadline = 0.15;
        for (std::size_t k = 0; k < kWeatherPlanners; ++k) {
          answers.push_back(makePlanner(ofWeather[inTurn++ % ofWeather.size()])->plan(among));
        }
      }
      for (const LandingAnswer& answer : answers) {
        if (!answer.path) {  // so low over rising ground that not even the longest glide begins clear of it
          QVERIFY(!answer.whyNot.empty());
          continue;
        }
        const LandingAnswer judged = verifiedAnswer(request, answer);
        QVERIFY2(judged.verified && judged.path, (answer.planner + ": " + findingsOf(request, *answer.path).toStdString()).c_str());
        landings += answer.reachesRunway() ? 1 : 0;
        elsewhere += answer.reachesRunway() ? 0 : 1;
        QVERIFY(!answer.reachesRunway() || answer.heightInHand >= -1e-3);
        QVERIFY(answer.reachesRunway() == answer.whyNot.empty());
      }
      // the missing metres are those of the roadmap's safe altitude, and what turns flown at their dearest metre take on top
      roadmaps += witness.reachesRunway() ? 1 : 0;
      if (request.altitude < safe->altitude) {
        QVERIFY(!witness.reachesRunway() && witness.missing >= safe->altitude - request.altitude);
        QVERIFY2(witness.missing <= safe->altitude - request.altitude + 6.0, witness.whyNot.c_str());
      }
    }
    QVERIFY2(2 * roadmaps >= poses && landings >= poses, qPrintable(QString("%1 %2 of %3").arg(roadmaps).arg(landings).arg(poses)));
    QVERIFY(elsewhere > 0);
  }

  void roadmapPlanner_buildsItsOwnRoadmapInTime() {
    LandingRequest request = test::mountainRequest(test::landingMission(), {900.0, 1400.0, -1.0}, 900.0);
    const LandingAnswer answer = RoadmapPlanner().plan(request);
    QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
    request.deadline = 0.001;
    const LandingAnswer late = RoadmapPlanner().plan(request);
    QVERIFY(!late.reachesRunway());
    QVERIFY2(QByteArray::fromStdString(late.whyNot).contains("not enough time to build the roadmap"), late.whyNot.c_str());
  }

  void combined_returnsTheBestThatIsVerified() {
    LandingRequest request = test::mountainRequest(test::landingMission(), {900.0, 1400.0, -1.0}, 900.0);
    const LandingAnswer good = AnytimePlanner(100).plan(request);
    LandingAnswer worse = good;
    worse.planner = "worse";
    worse.heightInHand -= 1.0;
    LandingAnswer tooGood = good;  // promises height that is not there
    tooGood.planner = "dreamer";
    tooGood.heightInHand += 100.0;
    for (mission::LandingLeg& leg : tooGood.path->legs) {
      leg.endAltitude += 100.0;
    }
    std::vector<std::unique_ptr<const LandingPlanner>> planners;
    planners.push_back(std::make_unique<FixedPlanner>(tooGood));
    planners.push_back(std::make_unique<FixedPlanner>(worse));
    planners.push_back(std::make_unique<ThrowingPlanner>());
    planners.push_back(std::make_unique<FixedPlanner>(good));
    for (const int threads : {1, 4}) {
      request.threads = threads;
      const LandingAnswer answer = CombinedPlanner({}).plan(request);
      QVERIFY(!answer.path && !answer.whyNot.empty());
    }
    request.threads = 2;
    const LandingAnswer answer = CombinedPlanner(std::move(planners)).plan(request);
    QCOMPARE(answer.planner, std::string("anytime"));
    QVERIFY(answer.verified && *answer.path == *good.path);
    const bool tellsOfTheThrown =
        std::any_of(answer.notes.begin(), answer.notes.end(), [](const std::string& note) { return note.find("out of luck") != std::string::npos; });
    QVERIFY(tellsOfTheThrown);
  }

  void combined_withNothingVerified_returnsNoPath() {
    LandingRequest request = test::mountainRequest(test::landingMission(), {900.0, 1400.0, -1.0}, 900.0);
    LandingAnswer dream = AnytimePlanner(100).plan(request);
    dream.path->legs.front().endAltitude += 50.0;
    std::vector<std::unique_ptr<const LandingPlanner>> planners;
    planners.push_back(std::make_unique<FixedPlanner>(dream));
    const LandingAnswer answer = CombinedPlanner(std::move(planners)).plan(request);
    QVERIFY(!answer.path && !answer.verified);
    QVERIFY2(QByteArray::fromStdString(answer.whyNot).contains("the checker did not accept it"), answer.whyNot.c_str());
  }

  void combined_isNoWorseThanItsParts() {
    LandingRequest request = test::mountainRequest(test::landingMission(), {}, 0.0);
    landing::RoadmapRequest wanted;
    wanted.area = request.world->terrain.grid().extent();
    request.roadmap = *landing::buildRoadmap(*request.world, request.mission->planner, wanted, Job());
    request.deadline = 0.5;
    request.threads = 2;
    std::mt19937_64 random(77);
    for (int i = 0; i < 5; ++i) {
      request.pose = poseOf(random);
      request.altitude = request.world->terrain.grid().upperAt(request.pose.point()) + 500.0;
      const LandingAnswer witness = RoadmapPlanner().plan(request);
      const LandingAnswer combined = makePlanner("combined")->plan(request);
      QVERIFY(combined.seconds < 5.0);  // on a busy machine
      QVERIFY(combined.reachesRunway() || !witness.reachesRunway());
      QVERIFY(!combined.path || combined.verified);
      if (witness.reachesRunway()) {
        const auto worth = [](const LandingAnswer& one) { return one.heightInHand - kPerManoeuvre * manoeuvresOf(*one.path); };
        QVERIFY(worth(combined) >= worth(witness) - 1e-9);
        const std::vector<std::string> names = plannerNames();
        QVERIFY(combined.planner != "combined" && std::count(names.begin(), names.end(), combined.planner) == 1);
      }
    }
  }

  void combined_whenStopped_ends() {
    LandingRequest request = test::mountainRequest(test::landingMission(), {900.0, 1400.0, -1.0}, 900.0);
    std::stop_source stop;
    request.job = Job(stop.get_token());
    request.better = [&stop](const LandingAnswer&) { stop.request_stop(); };
    request.deadline = 120.0;
    const LandingAnswer answer = makePlanner("combined")->plan(request);
    QVERIFY(answer.reachesRunway() && answer.verified);
    QVERIFY(answer.seconds < 60.0);  // by the stop, not by the deadline, on a busy machine too
  }
};

QTEST_APPLESS_MAIN(TestLandingPlanners)
#include "tst_landing_planners.moc"
