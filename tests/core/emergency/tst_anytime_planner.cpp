// The any-time planner on problems whose optimum is known, and what it does when it is stopped, early or for good.
#include "core/emergency/anytime_planner.h"
#include "core/emergency/landing_outcome.h"
#include "core/risk/leg_risk.h"
#include "tests/support/landing_optima.h"
#include "tests/support/path_check.h"

#include <QTest>

#include <chrono>
#include <random>
#include <stop_token>

using namespace vp;
using namespace vp::emergency;

namespace {

std::vector<flight::Piece> piecesOf(const mission::LandingPath& path) {
  std::vector<flight::Piece> pieces;
  for (const mission::LandingLeg& leg : path.legs) {
    pieces.push_back(leg.piece);
  }
  return pieces;
}

/// People along a strip north to south, but for a corridor.
class StripRisk final : public risk::LegRisk {
public:
  [[nodiscard]] double of(const geo::Pose& from, const flight::Piece& piece, double /*start*/, double /*end*/) const override {
    const std::vector<test::FlownPoint> points = test::fly(from, {piece}, 20.0);
    double inside = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const bool isOver = std::abs(points[i].x) < 300.0 && !(points[i].y > 1200.0 && points[i].y < 1800.0);
      inside += isOver ? points[i].distance - points[i - 1].distance : 0.0;
    }
    return inside;
  }
  [[nodiscard]] std::string name() const override { return "metres over people"; }
  [[nodiscard]] std::string unit() const override { return "m"; }
};

}  // namespace

class TestAnytimePlanner : public QObject {
  Q_OBJECT

private slots:
  void flatGround_withOneRadius_givesTheClosedForm() {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 40; ++i) {
      const geo::Pose from{4000.0 * unit(random), 4000.0 * unit(random), Angle::kPi * unit(random)};
      const LandingRequest request = test::landingRequest(test::landingMission(test::oneBankCessna()),
                                                          {test::placedSite("A/09", {500.0, -300.0, 0.4}, 0.0)}, test::flatGrid(), from, 1500.0);
      const LandingAnswer answer = AnytimePlanner(300).plan(request);
      QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
      const double known = 1500.0 - 100.0 - test::closedForm(*request.world, from, request.world->sites[0].pose);  // 100 m clearance at the threshold
      QVERIFY2(answer.heightInHand >= known - 1e-6, qPrintable(QString::number(answer.heightInHand - known)));
      QVERIFY2(answer.heightInHand <= known + 0.01, qPrintable(QString::number(answer.heightInHand - known)));
      QVERIFY(answer.lowerBound && *answer.lowerBound <= answer.cost() + 1e-9);
      QVERIFY(std::abs(answer.path->legs.back().endAltitude - 100.0 - answer.heightInHand) < 1e-6);
    }
  }

  void flatGround_withSeveralRadii_isNeverWorseThanTheClosedForm() {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    for (int i = 0; i < 20; ++i) {
      const geo::Pose from{1500.0 * unit(random), 1500.0 * unit(random), Angle::kPi * unit(random)};
      const LandingRequest request = test::landingRequest(
          test::landingMission(),
          {test::placedSite("A/09", {500.0, -300.0, 0.4}, 0.0), test::placedSite("A/27", {1500.0, -300.0, 0.4 + Angle::kPi}, 0.0)}, test::flatGrid(),
          from, 1200.0);
      const LandingAnswer answer = AnytimePlanner(2000).plan(request);
      QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
      const double direct = std::min(test::closedForm(*request.world, from, request.world->sites[0].pose),
                                     test::closedForm(*request.world, from, request.world->sites[1].pose));
      QVERIFY(answer.heightInHand - kPerManoeuvre * manoeuvresOf(*answer.path) >= 1200.0 - 100.0 - direct - 3.0 * kPerManoeuvre - 1e-6);
      QVERIFY(answer.lowerBound && *answer.lowerBound <= answer.cost() + 1e-9);
    }
  }

  void wallWithOneGap_isPassedThroughTheGapAtTheLeastLoss() {
    constexpr double kSouth = 1500.0;
    constexpr double kNorth = 1900.0;
    const auto grid = test::wallGrid(kSouth, kNorth);
    const LandingRequest request = test::landingRequest(
        test::landingMission(test::oneBankCessna()), {test::placedSite("B/09", {2500.0, -1000.0, 0.0}, 0.0)}, grid, {-2500.0, -500.0, 0.3}, 1500.0);
    const landing::Approach approach = *landing::approachTo(*request.world, 0);
    const double known = test::bestThroughGap(request, approach, kSouth + 20.0, kNorth - 20.0);
    const LandingAnswer answer = AnytimePlanner(20'000).plan(request);
    QVERIFY2(answer.reachesRunway(), answer.whyNot.c_str());
    const double lost = 1500.0 - answer.heightInHand - approach.altitude;
    QVERIFY2(lost <= 1.01 * known, qPrintable(QString("%1 m lost, %2 m known").arg(lost).arg(known)));
    QVERIFY2(lost >= 0.97 * known, qPrintable(QString("%1 m lost, %2 m known").arg(lost).arg(known)));
    int crossings = 0;
    const std::vector<test::FlownPoint> points = test::fly(answer.path->start, piecesOf(*answer.path), 2.0);
    for (const test::FlownPoint& point : points) {
      if (std::abs(point.x) <= 10.0) {
        ++crossings;
        QVERIFY(point.y > kSouth && point.y < kNorth);
      }
    }
    QVERIFY(crossings > 0);
    QVERIFY(geo::distance({points.back().x, points.back().y}, {2500.0, -1000.0}) < 0.05);
  }

  void wallWithoutGap_isSaidWithTheLongestGlide() {
    const auto grid = test::wallGrid(9000.0, 9001.0);
    const LandingRequest request =
        test::landingRequest(test::landingMission(), {test::placedSite("B/09", {2500.0, 0.0, 0.0}, 0.0)}, grid, {-2500.0, 0.0, 0.0}, 900.0);
    const LandingAnswer answer = AnytimePlanner(3000).plan(request);
    QVERIFY(!answer.reachesRunway());
    QVERIFY2(QByteArray::fromStdString(answer.whyNot).contains("stays clear of the ground"), answer.whyNot.c_str());
    QVERIFY(answer.path && answer.path->site == -1);
    // straight on it would meet the wall after 2,490 m; farthest away are the corners between the wall and the edge of the map
    const double corner = std::hypot(2490.0, 4000.0);
    QVERIFY2(reachOf(*answer.path) < corner && reachOf(*answer.path) > 0.97 * corner, qPrintable(QString::number(reachOf(*answer.path))));
  }

  void tooFarAway_isSaidWithTheMetresThatAreMissing() {
    const LandingRequest request = test::landingRequest(test::landingMission(), {test::placedSite("B/09", {4000.0, 0.0, 0.0}, 0.0)}, test::flatGrid(),
                                                        {-4000.0, 0.0, 0.0}, 700.0);
    const LandingAnswer answer = AnytimePlanner().plan(request);
    const double needed = 8000.0 * request.world->glide.straightLoss() + 100.0;
    QVERIFY(!answer.reachesRunway() && std::abs(answer.missing - (needed - 700.0)) < 1e-6);
    QVERIFY2(QByteArray::fromStdString(answer.whyNot).contains("No runway is in range: the closest is B/09, 8.0 km away"), answer.whyNot.c_str());
    // flat ground: straight on until the clearance is used up
    QVERIFY(answer.path && answer.path->site == -1);
    QVERIFY(std::abs(lengthOf(*answer.path) - 600.0 / request.world->glide.straightLoss()) < 30.0);
  }

  void peopleWithOneCorridor_areNotOverflown() {
    LandingRequest request = test::landingRequest(test::landingMission(), {test::placedSite("B/09", {2500.0, 0.0, 0.0}, 0.0)}, test::flatGrid(),
                                                  {-2500.0, 0.0, 0.0}, 2000.0);
    const LandingAnswer without = AnytimePlanner(2000).plan(request);
    request.risk = std::make_shared<const StripRisk>();
    QVERIFY(riskOf(request, *without.path) > 550.0);
    const LandingAnswer with = AnytimePlanner(20'000).plan(request);
    QVERIFY2(with.reachesRunway(), with.whyNot.c_str());
    QCOMPARE(riskOf(request, *with.path), 0.0);
    QCOMPARE(with.terms.front().name, std::string("metres over people"));
    QVERIFY(!with.lowerBound && with.heightInHand < without.heightInHand);
  }

  void answers_becomeBetterOneAfterTheOther() {
    LandingRequest request = test::mountainRequest(test::landingMission(), {900.0, 1400.0, -1.0}, 900.0);
    std::vector<double> saved;
    request.better = [&saved](const LandingAnswer& answer) { saved.push_back(-answer.cost()); };
    const LandingAnswer answer = AnytimePlanner(5000).plan(request);
    QVERIFY(saved.size() > 1);
    QVERIFY(std::is_sorted(saved.begin(), saved.end()) && saved.back() == -answer.cost());
  }

  void sameSeed_givesTheSamePath() {
    LandingRequest request = test::landingRequest(test::landingMission(), {test::placedSite("B/09", {2500.0, -1000.0, 0.0}, 0.0)},
                                                  test::wallGrid(1500.0, 1900.0), {-2500.0, -500.0, 0.3}, 1500.0);
    const LandingAnswer first = AnytimePlanner(3000).plan(request);
    const LandingAnswer second = AnytimePlanner(3000).plan(request);
    QVERIFY(first.reachesRunway() && *first.path == *second.path && first.seed == 1);
    request.seed = 2;
    const LandingAnswer other = AnytimePlanner(3000).plan(request);
    QVERIFY(other.reachesRunway() && *other.path != *first.path && other.seed == 2);
  }

  void stopped_returnsTheBestSoFarWithin100ms() {
    LandingRequest request = test::mountainRequest(test::landingMission(), {900.0, 1400.0, -1.0}, 900.0);
    std::stop_source stop;
    request.job = Job(stop.get_token());
    request.better = [&stop](const LandingAnswer&) { stop.request_stop(); };
    const auto begin = std::chrono::steady_clock::now();
    const LandingAnswer answer = AnytimePlanner().plan(request);
    QVERIFY(answer.reachesRunway());
    QVERIFY(std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(100));
  }

  void deadline_isKept() {
    LandingRequest request = test::mountainRequest(test::landingMission(), {900.0, 1400.0, -1.0}, 900.0);
    request.deadline = 0.15;
    const LandingAnswer answer = AnytimePlanner().plan(request);
    QVERIFY(answer.reachesRunway());
    QVERIFY2(answer.seconds < 0.25, qPrintable(QString::number(answer.seconds)));
  }
};

QTEST_APPLESS_MAIN(TestAnytimePlanner)
#include "tst_anytime_planner.moc"
