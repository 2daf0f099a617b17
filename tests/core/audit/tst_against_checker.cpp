// Plans in random winds, air, masses and approaches, flown as low as the checker just certifies: the second opinion must not find one of them unsafe,
// and must not be so much milder that it could not.
#include "core/audit/audit.h"
#include "tests/core/safety/plan_fixture.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using test::PlanFixture;

namespace {

constexpr int kConditions = 12;
constexpr std::uint64_t kSamples = 840;  // 10,080 engine failures in all

class Conditions {
public:
  explicit Conditions(unsigned seed) : random_(seed) {}

  void putInto(PlanFixture& fixture, int number) {
    mission::Mission& mission = fixture.mission();
    mission.aircraft.glideBanks = {Angle::degrees(45.0)};
    mission.aircraft.tourBank = Angle::degrees(45.0);
    for (int layer = 0; layer < number % 4; ++layer) {  // none: calm
      const double least = between(0.0, 7.0);
      mission.wind.push_back(
          {geo::HeightMsl::fromMetres(150.0 + 700.0 * layer), {between(0.0, 360.0), between(0.0, 30.0), least, least + between(0.0, 3.0)}});
    }
    if (chance()) {
      mission.atmosphere = air::Atmosphere{between(-15.0, 20.0), between(990.0, 1030.0)};
      mission.ceiling = geo::HeightMsl::fromMetres(6000.0);
    }
    if (chance()) {
      mission.aircraft.leastMass_kg = 0.75 * mission.aircraft.mass_kg;
      mission.aircraft.mostMass_kg = 1.05 * mission.aircraft.mass_kg;
    }
    if (chance()) {
      mission.aircraft.rollRate_dps = between(8.0, 30.0);
    }
    if (chance()) {
      mission.safety.reactionTime = Duration::fromSi(between(1.0, 5.0));
      mission.safety.reactionLoss = Length::fromSi(between(0.0, 20.0));
    }
    mission.safety.dragFactor = chance() ? between(1.0, 1.3) : 1.0;
    const double kind = between(0.0, 3.0);
    mission.approach.kind = kind < 1.0   ? mission::ApproachKind::Threshold
                            : kind < 2.0 ? mission::ApproachKind::Straight
                                         : mission::ApproachKind::Overhead;
    mission.approach.finalLength = Length::fromSi(between(300.0, 900.0));
    if (kind >= 1.0 && chance()) {
      mission.approach.surfaceSlope = 0.05;
    }
    if (kind >= 2.0 && chance()) {
      mission.approach.keyHeight = Length::fromSi(between(200.0, 500.0));
    }
    for (int hill = 0; hill < 30; ++hill) {
      fixture.terrain.setCell(between(-3000.0, 3000.0) + 0.5, between(-3000.0, 3000.0) + 0.5, static_cast<float>(between(0.0, 200.0)));
    }
    fixture.terrain.setCell(1.0, -999.0, 0.0F);
  }

private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  bool chance() { return between(0.0, 1.0) < 0.5; }
  std::mt19937_64 random_;
};

bool isCertified(PlanFixture& fixture, double altitude) {
  fixture.builder.flyAt(altitude);
  const std::string broken = test::rulesBroken(test::checkedPlan(fixture));
  // what a plan claims its safe altitudes to be does not matter here
  for (const char* rule : {"glide.radius", "glide.reaction", "glide.site", "glide.heading", "glide.arrival", "glide.clearance", "glide.dynamics",
                           "between.", "tour.clearance", "tour.radius", "approach.key", "approach.straight", "approach.circle", "plan.", "wind."}) {
    if (broken.find(rule) != std::string::npos) {
      return false;
    }
  }
  return true;
}

}  // namespace

class TestAgainstChecker : public QObject {
  Q_OBJECT

private slots:
  void justCertified_isNotUnsafe() {
    const unsigned seed = 20261130;
    qInfo("seed %u", seed);
    Conditions conditions(seed);
    std::vector<double> slacks;
    double mostInCalm = 0.0;
    for (int number = 0; number < kConditions; ++number) {
      PlanFixture fixture;
      conditions.putInto(fixture, number);
      fixture.builder.flyAt(4000.0);
      fixture.refit();
      double low = 0.0;
      double high = 4000.0;
      QVERIFY2(isCertified(fixture, high), test::textsOfFindings(test::checkedPlan(fixture)));
      while (high - low > 0.05) {
        const double middle = 0.5 * (low + high);
        (isCertified(fixture, middle) ? high : low) = middle;
      }
      QVERIFY(isCertified(fixture, high));
      const terrain::ElevationGrid grid = fixture.terrain.grid();
      const auto lookup = [&grid]() -> Result<audit::GroundLookup> {
        return audit::GroundLookup([&grid](const std::vector<geo::Point>& places, std::vector<double>& heights) {
          heights.clear();
          for (const geo::Point& place : places) {
            heights.push_back(grid.upperAt(place));
          }
        });
      };
      const auto report = audit::audit({fixture.plan(), lookup, {}, kSamples, seed + static_cast<unsigned>(number), 1}, Job());
      QVERIFY(report.has_value());
      QVERIFY2(report->unsafe == 0, report->unsafe > 0 ? (report->unsafePoints.front().text + ", condition " + std::to_string(number)).c_str() : "");
      double slack = 1e9;
      for (const std::optional<audit::LeastMargin>& margin : report->least) {
        slack = margin ? std::min(slack, margin->place.left) : slack;
      }
      slacks.push_back(slack);
      mostInCalm = fixture.mission().wind.empty() ? std::max(mostInCalm, slack) : mostInCalm;
    }
    std::sort(slacks.begin(), slacks.end());
    qInfo("left over in the samples: least %.2f m, median %.2f m, most %.2f m, most in calm %.2f m", slacks.front(), slacks[slacks.size() / 2],
          slacks.back(), mostInCalm);
    QVERIFY(slacks.front() < 1.0 && mostInCalm < 2.0 && slacks[slacks.size() / 2] < 40.0);
  }
};

QTEST_APPLESS_MAIN(TestAgainstChecker)
#include "tst_against_checker.moc"
