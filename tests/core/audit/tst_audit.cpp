// The second opinion on a racetrack over flat ground, where what is left has a closed form, and on plans that are not what they promise.
#include "core/audit/audit.h"
#include "tests/support/plan_builder.h"

#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <thread>

using namespace vp;
using namespace vp::audit;
using test::PlanBuilder;

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kGravity = 9.80665;  // m/s^2

/// Ground of one height, with a hill in the shape of a disc.
struct Ground {
  double height = 0.0;
  geo::Point hill;
  double hillRadius = 0.0;
  double hillHeight = 0.0;

  [[nodiscard]] Result<GroundLookup> lookup() const {
    return GroundLookup([ground = *this](const std::vector<geo::Point>& places, std::vector<double>& heights) {
      heights.assign(places.size(), ground.height);
      for (std::size_t i = 0; i < places.size(); ++i) {
        heights[i] = geo::distance(places[i], ground.hill) < ground.hillRadius ? ground.hillHeight : heights[i];
      }
    });
  }
};

AuditReport opinionOf(const mission::Plan& plan, const Ground& ground = {}, std::uint64_t samples = 800, std::uint64_t seed = 1, int threads = 1) {
  const Result<AuditReport> report = audit::audit({plan, [&ground] { return ground.lookup(); }, {}, samples, seed, threads}, Job());
  if (!report) {
    throw std::runtime_error(report.error().message());
  }
  return *report;
}

const LeastMargin& leastOf(const AuditReport& report, MarginKind kind) {
  return report.least[static_cast<std::size_t>(kind)].value();
}

/// Loss per metre of the glide in still air by [1]: tan(gamma), sin(gamma) = q S (C_D0 + L C_L^2) / W. @param radius  0: straight
double lossPerMetre(const aircraft::AircraftProfile& profile, double radius) {
  const double v = profile.bestGlideSpeed.si();
  const double weight = profile.mass_kg * kGravity;
  const double pressure = 0.5 * profile.airDensity_kgm3 * v * v * profile.wingArea_m2;
  const double bank = radius > 0.0 ? std::atan(v * v / (kGravity * radius)) : 0.0;
  const double lift = weight / std::cos(bank) / pressure;
  return std::tan(std::asin(pressure * (profile.zeroLiftDrag + profile.inducedDrag * lift * lift) / weight));
}

/// Height lost from where an engine stopped, in still air.
double lossFrom(const mission::Plan& plan, const EngineStop& stop) {
  const mission::DecisionPoint& from = plan.tour[stop.point];
  const mission::DecisionPoint& to = plan.tour[(stop.point + 1) % plan.tour.size()];
  const double chord = geo::distance(stop.where, to.pose.point());
  const double radius = from.onward.radius;
  double loss = from.onward.turn == flight::Turn::Straight
                    ? chord * lossPerMetre(plan.mission.aircraft, 0.0)
                    : 2.0 * radius * std::asin(chord / (2.0 * radius)) * lossPerMetre(plan.mission.aircraft, radius);
  for (const flight::Piece& piece : to.witness.pieces) {
    loss += piece.length * lossPerMetre(plan.mission.aircraft, piece.radius);
  }
  return loss;
}

bool says(const AuditReport& report, const char* text) {
  return !report.unsafePoints.empty() && report.unsafePoints.front().text.find(text) != std::string::npos;
}

/// Lowest altitude of the whole tour at which no engine failure arrives too low: from the first metre of the worst interval.
double safeAltitudeOfTour(const PlanBuilder& builder) {
  double highest = 0.0;
  const mission::Plan& plan = builder.plan();
  for (std::size_t i = 0; i < plan.tour.size(); ++i) {
    highest = std::max(highest, lossFrom(plan, {0, "tour", i, plan.tour[i].pose.point(), 0.0, {}, 0.0, 0}));
  }
  return highest + plan.mission.safety.clearance.si();
}

}  // namespace

class TestAudit : public QObject {
  Q_OBJECT

private slots:
  void flatGround_leavesWhatTheClosedFormSays() {
    const PlanBuilder builder(600.0);
    const mission::Plan& plan = builder.plan();
    const AuditReport report = opinionOf(plan);
    QVERIFY(report.isSafe());
    QCOMPARE(report.samples, std::uint64_t{800});
    QVERIFY(std::abs(report.tourLength - (4000.0 + 600.0 * kPi)) < 1e-6);
    const LeastMargin& arrival = leastOf(report, MarginKind::Arrival);
    QVERIFY(std::abs(arrival.place.left - (600.0 - 50.0 - lossFrom(plan, arrival.stop))) < 1e-3);
    const LeastMargin& glide = leastOf(report, MarginKind::GlideClearance);
    QVERIFY(std::abs(glide.place.left - (600.0 - 100.0 - lossFrom(plan, glide.stop))) < 1e-3);
    QVERIFY(std::abs(leastOf(report, MarginKind::TourClearance).place.left - 500.0) < 1e-9);
    QVERIFY(geo::distance(arrival.place.where, {0.0, -1000.0}) < 1e-3);
    QVERIFY(!report.least[static_cast<std::size_t>(MarginKind::Rolling)] && !report.least[static_cast<std::size_t>(MarginKind::Key)]);
    // the longest glide takes its length at the speed over ground
    QVERIFY(report.longest_s > 60.0 && report.longest_s < 400.0);
    QVERIFY(std::abs(report.steepestBank_deg - 60.0) < 0.1);
  }

  /// The verdict turns where the closed form says, to the centimetres that 6,000 samples leave between them.
  void tourAtItsLowest_isSafeAndJustBelowIsNot() {
    PlanBuilder builder;
    const double lowest = safeAltitudeOfTour(builder);
    builder.flyAt(lowest);
    QCOMPARE(opinionOf(builder.plan(), {}, 6000).unsafe, std::uint64_t{0});
    builder.flyAt(lowest - 0.3);
    const AuditReport report = opinionOf(builder.plan(), {}, 6000);
    QVERIFY(report.unsafe > 0);
    QVERIFY(report.unsafePoints.front().place.left < -kHeightTolerance && report.unsafePoints.front().place.left > -0.3 - 1e-3);
    QVERIFY(says(report, "below the clearance"));
  }

  void tourTenMetresLower_isUnsafe() {
    PlanBuilder builder;
    const double lowest = safeAltitudeOfTour(builder);
    builder.flyAt(lowest - 10.0);
    const AuditReport report = opinionOf(builder.plan());
    QVERIFY(!report.isSafe() && report.unsafe > 10 && report.unsafe < report.samples);
    QVERIFY(leastOf(report, MarginKind::GlideClearance).place.left < -9.0);
    QVERIFY(leastOf(report, MarginKind::GlideClearance).place.left > -10.001);
  }

  void onePointLowered_isFoundInItsIntervalsAlone() {
    PlanBuilder builder(600.0);
    builder.plan().tour[7].altitude = 95.0;
    const AuditReport report = opinionOf(builder.plan());
    QVERIFY(report.unsafe > 0);
    for (const UnsafePoint& point : report.unsafePoints) {
      QVERIFY(point.stop.point == 6 || point.stop.point == 7);
    }
  }

  void mountainInTheWay_isFound() {
    const PlanBuilder builder(600.0);
    const std::optional<GroundTrack> glide = cutIntoMetres(builder.plan().tour[15].pose, builder.plan().tour[15].witness.pieces);
    const geo::Point way = glide->steps[glide->steps.size() / 2].place;
    const Ground hill{0.0, way, 60.0, 450.0};
    QVERIFY(opinionOf(builder.plan()).isSafe());
    const AuditReport report = opinionOf(builder.plan(), hill);
    QVERIFY(report.unsafe > 0 && says(report, "below the clearance"));
    QVERIFY(geo::distance(report.unsafePoints.front().place.where, hill.hill) <= hill.hillRadius);
    QVERIFY(report.unsafePoints.front().place.seconds > 0.0);
    const AuditReport unknown = opinionOf(builder.plan(), {0.0, way, 60.0, kUnknownGround});
    QVERIFY(unknown.unsafe > 0 && says(unknown, "unknown height"));
    const AuditReport underTour = opinionOf(builder.plan(), {0.0, {0.0, 1000.0}, 50.0, 501.0});
    QVERIFY(underTour.unsafe > 0 && leastOf(underTour, MarginKind::TourClearance).place.left == -1.0);
  }

  /// Wind that the plan was not made for, and the same wind where heights have room for it.
  void windRaised_isFound() {
    PlanBuilder builder;
    for (std::size_t i = 0; i < builder.plan().tour.size(); ++i) {
      builder.rebuildGlide(i, builder.plan().sites[0].pose, 300.0);  // turns that wind leaves below 60 degrees of bank
    }
    builder.flyAt(safeAltitudeOfTour(builder));
    QCOMPARE(opinionOf(builder.plan()).unsafe, std::uint64_t{0});
    builder.plan().mission.wind = {{geo::HeightMsl(), {180.0, 20.0, 3.0, 8.0}}};
    const AuditReport report = opinionOf(builder.plan());
    QVERIFY(report.unsafe > 100);
    builder.flyAt(builder.plan().tour[0].altitude + 250.0);
    QCOMPARE(opinionOf(builder.plan()).unsafe, std::uint64_t{0});
    builder.plan().mission.wind = {{geo::HeightMsl(), {180.0, 20.0, 3.0, 20.0}}};
    const AuditReport storm = opinionOf(builder.plan());
    QVERIFY(storm.unsafe > 0);
  }

  void siteSwapped_isFound() {
    PlanBuilder builder(600.0);
    mission::SiteInFrame other = builder.plan().sites[0];
    other.site.id = "OTHER/27";
    other.pose = {0.0, -1000.0, kPi};
    builder.plan().sites.push_back(other);
    builder.plan().tour[4].witness.site = 1;
    const AuditReport report = opinionOf(builder.plan());
    QVERIFY(report.unsafe > 0 && says(report, "180.00 degrees off the landing course of OTHER/27"));
    QCOMPARE(report.unsafePoints.front().stop.point, std::size_t{3});
    builder.plan().sites[1].pose = {30.0, -1000.0, 0.0};
    QVERIFY(says(opinionOf(builder.plan()), "30.00 m from the touchdown point"));
    builder.plan().tour[4].witness.site = -1;
    QVERIFY(says(opinionOf(builder.plan()), "no glide"));
  }

  void siteBesideItsDegrees_isFound() {
    const PlanBuilder builder(600.0);
    const Ground flat;
    const auto report = audit::audit({builder.plan(), [&flat] { return flat.lookup(); }, {{0.0, -1010.0}}, 50, 1, 1}, Job());
    QVERIFY(report && report->unsafe == 50 && says(*report, "10.00 m beside where its degrees are"));
  }

  void reaction_asksForWayAndHeight() {
    PlanBuilder builder(600.0);
    const double before = leastOf(opinionOf(builder.plan()), MarginKind::Arrival).place.left;
    builder.plan().mission.safety.reactionLoss = Length::fromSi(20.0);
    QVERIFY(std::abs(leastOf(opinionOf(builder.plan()), MarginKind::Arrival).place.left - before + 20.0) < 1e-9);
    builder.plan().mission.safety.reactionTime = Duration::fromSi(3.0);
    const AuditReport report = opinionOf(builder.plan());  // its glides turn at once
    QVERIFY(report.unsafe > 0 && report.unsafe < report.samples && says(report, "until the pilot reacts"));
    // a straight of 3 s at 33.4 m/s before every glide is what it takes
    for (std::size_t i = 0; i < builder.plan().tour.size(); ++i) {
      mission::DecisionPoint& point = builder.plan().tour[i];
      const double ahead = 3.0 * 33.4;
      const geo::Pose turns{point.pose.x + ahead * std::cos(point.pose.heading), point.pose.y + ahead * std::sin(point.pose.heading),
                            point.pose.heading};
      point.witness.pieces = test::glideTo(turns, builder.plan().sites[0].pose, 65.7);
      point.witness.pieces.insert(point.witness.pieces.begin(), {flight::Turn::Straight, 0.0, ahead});
    }
    QCOMPARE(opinionOf(builder.plan()).unsafe, std::uint64_t{0});
    builder.plan().mission.safety.reactionTime = Duration::fromSi(3.05);
    QVERIFY(opinionOf(builder.plan()).unsafe > 0);
  }

  void rollRate_takesHeightOutOfTheClearance() {
    PlanBuilder builder(600.0);
    builder.plan().mission.aircraft.rollRate_dps = 15.0;
    const AuditReport usual = opinionOf(builder.plan());
    QVERIFY(usual.isSafe());
    const double left = leastOf(usual, MarginKind::Rolling).place.left;
    builder.plan().mission.aircraft.rollRate_dps = 7.5;  // takes twice the time
    const double slower = leastOf(opinionOf(builder.plan()), MarginKind::Rolling).place.left;
    const double charged = leastOf(usual, MarginKind::GlideClearance).place.left + 100.0 - left;
    QVERIFY(charged > 120.0 && charged < 140.0);  // four changes of 60 degrees in 4 s each at 7.6 m/s, and what the tour's turns add
    QVERIFY(std::abs(left - slower - charged) < 0.1 * charged);
    builder.plan().mission.aircraft.rollRate_dps = 1.0;
    QVERIFY(says(opinionOf(builder.plan()), "into the ground"));
  }

  void approach_isAskedFor() {
    PlanBuilder builder(700.0);
    builder.plan().mission.approach.kind = mission::ApproachKind::Straight;
    builder.plan().mission.approach.finalLength = Length::fromSi(500.0);
    QVERIFY(says(opinionOf(builder.plan()), "does not end in a straight of 500 m"));
    const geo::Pose gate{-500.0, -1000.0, 0.0};
    for (std::size_t i = 0; i < builder.plan().tour.size(); ++i) {
      builder.rebuildGlide(i, gate, 65.7);
      builder.plan().tour[i].witness.pieces.push_back({flight::Turn::Straight, 0.0, 500.0});
    }
    const AuditReport whole = opinionOf(builder.plan());
    QVERIFY(whole.isSafe());
    // with a surface of 1 : 20 from 60 m on the clearance is 22 m at the gate, so the least is left before it, or at the touchdown point itself
    builder.plan().mission.approach.surfaceSlope = 0.05;
    builder.plan().mission.approach.surfaceStart = Length::fromSi(60.0);
    const AuditReport surface = opinionOf(builder.plan());
    QVERIFY(leastOf(surface, MarginKind::GlideClearance).place.left > leastOf(whole, MarginKind::GlideClearance).place.left + 20.0);
    // a steep slope loses more on the last 500 m
    builder.plan().mission.approach.slope = Angle::radians(std::atan(0.15));
    const double lost = 500.0 * (0.15 - lossPerMetre(builder.plan().mission.aircraft, 0.0));
    QVERIFY(std::abs(leastOf(opinionOf(builder.plan()), MarginKind::Arrival).place.left - leastOf(surface, MarginKind::Arrival).place.left + lost) <
            0.01);
  }

  void highKey_isAskedFor() {
    PlanBuilder builder(900.0);
    builder.plan().mission.approach.kind = mission::ApproachKind::Overhead;
    QVERIFY(says(opinionOf(builder.plan()), "one full circle"));
    for (mission::DecisionPoint& point : builder.plan().tour) {
      point.witness.pieces.push_back({flight::Turn::Straight, 0.0, 0.0});
      point.witness.pieces.push_back({flight::Turn::Left, 100.0, 200.0 * kPi});
    }
    QVERIFY(opinionOf(builder.plan()).isSafe());
    builder.plan().mission.approach.keyHeight = Length::fromSi(300.0);
    const AuditReport report = opinionOf(builder.plan());
    const double circle = 200.0 * kPi * lossPerMetre(builder.plan().mission.aircraft, 100.0);
    const LeastMargin& key = leastOf(report, MarginKind::Key);
    QVERIFY(std::abs(key.place.left - (900.0 - 300.0 - (lossFrom(builder.plan(), key.stop) - circle))) < 0.12);  // the place next to the gate
    builder.plan().mission.approach.keyHeight = Length::fromSi(300.5 + key.place.left);
    QVERIFY(says(opinionOf(builder.plan()), "too low at the high key"));
  }

  void bankBeyondTheProfile_isFound() {
    PlanBuilder builder(700.0);
    builder.rebuildGlide(12, builder.plan().sites[0].pose, 60.0);
    QVERIFY(says(opinionOf(builder.plan()), "needs a bank of 62.2 degrees"));
  }

  void equalSeeds_giveEqualReportsWithAnyThreads() {
    PlanBuilder builder;
    builder.flyAt(safeAltitudeOfTour(builder) - 5.0);
    builder.plan().mission.wind = {{geo::HeightMsl(), {180.0, 20.0, 0.0, 4.0}}};
    const AuditReport one = opinionOf(builder.plan(), {}, 3000, 7, 1);
    const AuditReport three = opinionOf(builder.plan(), {}, 3000, 7, 3);
    const AuditReport other = opinionOf(builder.plan(), {}, 3000, 8, 1);
    QVERIFY(one.unsafe > kMostListed);
    QCOMPARE(three.unsafe, one.unsafe);
    QCOMPARE(three.metresFlown, one.metresFlown);
    QCOMPARE(three.unsafePoints.size(), kMostListed);
    for (std::size_t i = 0; i < kMostListed; ++i) {
      QCOMPARE(three.unsafePoints[i].stop.sample, one.unsafePoints[i].stop.sample);
      QCOMPARE(three.unsafePoints[i].text, one.unsafePoints[i].text);
    }
    QCOMPARE(leastOf(three, MarginKind::Arrival).place.left, leastOf(one, MarginKind::Arrival).place.left);
    QCOMPARE(leastOf(three, MarginKind::Arrival).stop.sample, leastOf(one, MarginKind::Arrival).stop.sample);
    QVERIFY(leastOf(other, MarginKind::Arrival).place.left != leastOf(one, MarginKind::Arrival).place.left);
  }

  void samples_areUniformAlongTheTour() {
    PlanBuilder builder;
    builder.flyAt(90.0);  // all are unsafe, so the first hundred are listed as drawn
    int turning = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      for (const UnsafePoint& point : opinionOf(builder.plan(), {}, 100, seed).unsafePoints) {
        turning += builder.plan().tour[point.stop.point].onward.turn == flight::Turn::Left ? 1 : 0;
      }
    }
    const double expected = 2000.0 * 600.0 * kPi / (4000.0 + 600.0 * kPi);
    QVERIFY2(std::abs(turning - expected) < 110.0, qPrintable(QString::number(turning)));  // five standard deviations
  }

  void planWithoutTour_saysSo() {
    PlanBuilder builder;
    builder.plan().tour.clear();
    const Ground flat;
    const auto report = audit::audit({builder.plan(), [&flat] { return flat.lookup(); }, {}, 10, 1, 1}, Job());
    QVERIFY(!report && report.error().code == Errc::OutOfRange);
  }

  void cancel_returnsWithin100ms() {
    const PlanBuilder builder(600.0);
    const Ground flat;
    std::stop_source stop;
    QElapsedTimer timer;
    std::jthread stopper([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      timer.start();
      stop.request_stop();
    });
    const auto report = audit::audit({builder.plan(), [&flat] { return flat.lookup(); }, {}, 1'000'000, 1, 2}, Job(stop.get_token()));
    stopper.join();
    const qint64 took = timer.elapsed();
    QVERIFY(!report && report.error().code == Errc::Cancelled);
    QVERIFY2(took < 1000, qPrintable(QString::number(took)));  // 100 ms on a machine of one's own
  }
};

QTEST_APPLESS_MAIN(TestAudit)
#include "tst_audit.moc"
