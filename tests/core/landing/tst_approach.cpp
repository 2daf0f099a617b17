// Approaches: where they begin, how high, and which sites cannot have them; every height is flown in small steps.
#include "core/flight/curve_sampling.h"
#include "core/landing/approach.h"
#include "core/landing/lattice_roadmap.h"
#include "core/landing/rrt_star.h"
#include "tests/support/condition_flight.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <cmath>

using namespace vp;
using namespace vp::landing;
using mission::ApproachKind;

namespace {

/// Flat ground at sea level with one site in the middle, landing course East.
World flatWorld() {
  World world = test::mountainWorld();
  world.terrain = terrain::TerrainPyramid(test::makeGrid(5000.0, 20.0, [](double, double) { return 0.0; }));
  world.sites = {test::site("E/09", 0.0, 0.0, 0.0, 0.0)};
  world.arrivalMargin = 15.0;
  return world;
}

World withKind(World world, ApproachKind kind) {
  world.approach.kind = kind;
  return world;
}

/// A straight approach of 800 m, the aircraft able to descend at 12 degrees.
World straightWorld() {
  World world = withKind(flatWorld(), ApproachKind::Straight);
  world.approach.finalLength = Length::fromSi(800.0);
  world.steepestDescent = Angle::degrees(12.0);
  return world;
}

std::string faultOf(const World& world) {
  const std::vector<std::string> faults = approachFaults(world);
  return faults.size() == 1 ? faults[0] : std::to_string(faults.size()) + " faults";
}

/// What a plan and a world that belong together say of an approach, for flyGlide.
mission::Plan planOf(const World& world) {
  mission::Plan plan;
  plan.mission.aircraft = test::paperCessna();
  plan.mission.approach = world.approach;
  plan.mission.safety.clearance = Length::fromSi(world.clearance);
  return plan;
}

}  // namespace

class TestApproach : public QObject {
  Q_OBJECT

private slots:
  void threshold_isTheSiteItself() {
    World world = flatWorld();
    QCOMPARE(approachTo(world, 0)->altitude, 100.0);
    world.arrivalMargin = 130.0;
    const Result<Approach> approach = approachTo(world, 0);
    QCOMPARE(approach->altitude, 130.0);
    QVERIFY(approach->pieces.empty() && !approach->hold && approach->gate == world.sites[0].pose);
  }

  void straight_overFlatGround_losesItsLength() {
    World world = straightWorld();
    const Result<Approach> approach = approachTo(world, 0);
    QVERIFY(approach->gate == (geo::Pose{-800.0, 0.0, 0.0}));
    QVERIFY(approach->pieces == (std::vector<flight::Piece>{{flight::Turn::Straight, 0.0, 800.0}}));
    QVERIFY(std::abs(approach->altitude - (100.0 + 800.0 * world.glide.straightLoss())) < 1e-6);  // the clearance down to the touchdown point
    world.approach.surfaceSlope = 0.05;
    // below the glide the surface asks for less the nearer: the arrival decides
    QVERIFY(std::abs(approachTo(world, 0)->altitude - (15.0 + 800.0 * world.glide.straightLoss())) < 1e-6);
    world.arrivalMargin = 0.0;
    world.approach.slope = Angle::degrees(8.0);
    QVERIFY(std::abs(approachTo(world, 0)->altitude - 800.0 * std::tan(Angle::degrees(8.0).radians())) < 1e-6);
  }

  void obstacleSurface_asksForLessNearTheRunway() {
    World world = straightWorld();
    // a wall across the approach, 300 m before the touchdown point
    world.terrain = terrain::TerrainPyramid(test::makeGrid(5000.0, 20.0, [](double x, double) { return x > -330.0 && x < -290.0 ? 60.0 : 0.0; }));
    const double whole = approachTo(world, 0)->altitude;
    world.approach.surfaceSlope = 0.05;
    const double tapered = approachTo(world, 0)->altitude;
    // cells of the wall reach from -340 to -280: at 340 m to go the surface is 14 m high, at 280 m 11 m
    const double rate = world.glide.straightLoss();
    QVERIFY(std::abs(whole - (160.0 + rate * 520.0)) < 0.5);
    QVERIFY(std::abs(tapered - std::max(60.0 + 0.05 * 220.0 + rate * 520.0, 15.0 + rate * 800.0)) < 0.5);
    world.approach.surfaceStart = Length::fromSi(400.0);
    QVERIFY(std::abs(approachTo(world, 0)->altitude - std::max(60.0 + rate * 520.0, 15.0 + rate * 800.0)) < 0.5);
  }

  void slopeThatCannotBeHeld_leavesNoApproach() {
    World world = straightWorld();
    world.approach.slope = Angle::degrees(4.0);
    QCOMPARE(faultOf(world), std::string("E/09: its approach of 4.0 degrees cannot be held, as the glide descends at 4.9 degrees there"));
    world.approach.slope = Angle::degrees(12.5);
    QCOMPARE(faultOf(world),
             std::string("E/09: its approach of 12.5 degrees cannot be held, as the aircraft descends at no more than 12.0 degrees there"));
    world.approach.slope = Angle::degrees(8.0);
    QVERIFY(approachFaults(world).empty());
    world.steepestDescent.reset();
    QCOMPARE(faultOf(world), std::string("E/09: the aircraft's profile has no steepest descent, which an approach of a chosen slope needs"));
  }

  /// With the wind behind the same descent through the air is shallower over ground; against it the glide is steeper.
  void slope_countsWithTheWindOnTheLandingCourse() {
    World world = straightWorld();
    const auto inWind = [&](double from_deg, double slope_deg) {
      world.glide = aircraft::GlideModel(test::paperCessna(), {.winds = {{geo::HeightMsl(), {from_deg, 0.0, 8.0, 8.0}}}});
      world.approach.slope = Angle::degrees(slope_deg);
      return approachTo(world, 0).has_value();
    };
    const double steepest = Angle::radians(std::atan(std::tan(Angle::degrees(12.0).radians()) * 33.4 / 41.4)).degrees();
    QVERIFY(inWind(270.0, steepest - 0.01) && !inWind(270.0, steepest + 0.01));  // from the West, behind
    QVERIFY(inWind(90.0, 11.9) && !inWind(90.0, 12.1));                          // against: still no steeper than through the air
    const double glide = 4.9 * 33.4 / (33.4 - 8.0);
    QVERIFY(inWind(90.0, glide + 0.1) && !inWind(90.0, glide - 0.1));
  }

  void overhead_takesTheCircleThatNeedsLeast() {
    World world = withKind(flatWorld(), ApproachKind::Overhead);
    world.clearance = 10.0;
    const Result<Approach> flat = approachTo(world, 0);
    double least = 1e9;
    for (const double radius : world.glide.glideRadii()) {
      least = std::min(least, 2.0 * Angle::kPi * radius * world.glide.lossAt(radius));
    }
    QVERIFY(std::abs(flat->altitude - (15.0 + least)) < 1e-6);
    QVERIFY(flat->gate == world.sites[0].pose && flat->pieces.size() == 1);
    QCOMPARE(flat->pieces[0].length, 2.0 * Angle::kPi * flat->pieces[0].radius);
    // high ground on the left of the runway
    world.terrain = terrain::TerrainPyramid(test::makeGrid(5000.0, 20.0, [](double, double y) { return y > 50.0 ? 300.0 : 0.0; }));
    const Result<Approach> right = approachTo(world, 0);
    QVERIFY(right->pieces[0].turn == flight::Turn::Right);
    QVERIFY(std::abs(right->altitude - (15.0 + least)) < 1e-6);
    world.approach.keyHeight = Length::fromSi(250.0);
    QCOMPARE(approachTo(world, 0)->altitude, 250.0);
  }

  void approach_overUnknownGround_isNone() {
    for (const ApproachKind kind : {ApproachKind::Straight, ApproachKind::Overhead, ApproachKind::Threshold}) {
      World world = withKind(flatWorld(), kind);
      QVERIFY(approachFaults(world).empty());
      world.sites[0].pose = {-2450.0, 0.0, 0.0};  // 50 m from the western border
      QCOMPARE(approachTo(world, 0).has_value(), kind == ApproachKind::Threshold);
      if (kind != ApproachKind::Threshold) {
        QCOMPARE(faultOf(world), std::string("E/09: the ground under its approach is of unknown height"));
        QCOMPARE(noApproach(world).what, "no landing site can have the approach that the mission asks for: " + faultOf(world));
        const auto lattice = buildLatticeRoadmap(world, {world.terrain.grid().extent(), std::nullopt}, Job{});
        QVERIFY(!lattice && lattice.error().what == noApproach(world).what && lattice.error().code == Errc::NoLandingSite);
      }
    }
  }

  void hold_isTheLowestCircle_orTheSiteIsOut() {
    World world = straightWorld();
    world.approach.hold = true;
    const Result<Approach> flat = approachTo(world, 0);
    QVERIFY(flat->hold.has_value());
    QCOMPARE(flat->hold->lowest, flat->altitude);
    QCOMPARE(flat->hold->radius, world.glide.glideRadii().front());  // of equal ones the widest
    // ground that rises to the left: right circles, and the tightest of them
    world.terrain = terrain::TerrainPyramid(test::makeGrid(5000.0, 20.0, [](double x, double y) { return x < -600.0 ? 400.0 + 0.5 * y : 0.0; }));
    const Result<Approach> sloping = approachTo(world, 0);
    QVERIFY(sloping->hold->turn == flight::Turn::Right);
    QVERIFY(sloping->hold->lowest >= sloping->altitude);
    // unknown ground to both sides of the gate
    std::vector<float> values = world.terrain.grid().values();
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double y = -2500.0 + 20.0 * (static_cast<double>(i / 250) + 0.5);
      values[i] = std::abs(y) > 60.0 ? terrain::kUnknownUpper : 0.0F;
    }
    world.terrain = terrain::TerrainPyramid(std::make_shared<const terrain::ElevationGrid>(-2500.0, -2500.0, 20.0, 250, 250, std::move(values)));
    QCOMPARE(faultOf(world), std::string("E/09: there is no room for a holding circle over known ground at the beginning of its approach"));
    world.approach.hold = false;
    QVERIFY(approachFaults(world).empty());
  }

  void holds_areOneForEachSiteUsed() {
    World world = test::mountainWorld();
    world.approach.hold = true;
    mission::Plan plan;
    plan.sites = world.sites;
    for (const int site : {3, 1, 3, 3, -1}) {
      mission::DecisionPoint point;
      point.witness.site = site;
      plan.tour.push_back(point);
    }
    setHolds(world, plan);
    QCOMPARE(plan.holds.size(), std::size_t(2));
    QVERIFY(plan.holds[0].site == 1 && plan.holds[1].site == 3);
    world.approach.hold = false;
    setHolds(world, plan);
    QVERIFY(plan.holds.empty());
  }

  /// From the altitude of the gate the approach clears ground and surface and arrives; a metre lower it does not.
  void everyApproach_flown_justWorks() {
    const auto terrain = test::makeGrid(8000.0, 20.0, test::mountainHeight);
    int flown = 0;
    for (const ApproachKind kind : {ApproachKind::Straight, ApproachKind::Overhead}) {
      for (int variant = 0; variant < 8; ++variant) {
        World world = withKind(test::mountainWorld(), kind);
        world.terrain = terrain::TerrainPyramid(terrain);
        world.steepestDescent = Angle::degrees(14.0);
        world.arrivalMargin = 5.0;
        if ((variant & 1) != 0) {
          world.approach.surfaceSlope = 0.04;
        }
        if ((variant & 2) != 0) {
          world.approach.slope = Angle::degrees(7.0);
        }
        if ((variant & 4) != 0) {
          world.approach.finalLength = Length::fromSi(1500.0);
        }
        world.sites.push_back(test::site("M/27", -500.0, -100.0, 0.3, 950.0));  // on the slope of the mountain
        for (mission::SiteInFrame& site : world.sites) {
          site.pose.x += 7.0;  // not along the border of cells, of which only one side is looked at below
          site.pose.y += 3.0;
        }
        const mission::Plan plan = planOf(world);
        for (const Approach& approach : approachesOf(world)) {
          const mission::SiteInFrame& site = world.sites[static_cast<std::size_t>(approach.site)];
          const test::Day day{1000.0, {}};
          const auto from = [&](double altitude) { return test::flyGlide(plan, {}, day, *terrain, approach.gate, altitude, approach.pieces); };
          const double arrival = site.site.elevation.metres() + world.arrivalMargin;
          const test::ConditionOutcome works = from(approach.altitude);
          QVERIFY(works.leastSpare > -1e-6 && works.endAltitude > arrival - 1e-6);
          QVERIFY(geo::distance(works.end.point(), site.pose.point()) < 1e-3);
          const test::ConditionOutcome lower = from(approach.altitude - 2.0);
          QVERIFY(lower.leastSpare < 0.0 || lower.endAltitude < arrival);
          ++flown;
        }
      }
    }
    QVERIFY(flown >= 80);
  }

  /// Glides of both kinds of roadmap end with the approach, whole.
  void roadmaps_endWithTheApproach() {
    World world = test::mountainWorld();
    world.terrain = terrain::TerrainPyramid(test::makeGrid(8000.0, 20.0, test::mountainHeight));
    for (const ApproachKind kind : {ApproachKind::Straight, ApproachKind::Overhead}) {
      world.approach.kind = kind;
      world.approach.finalLength = Length::fromSi(700.0);
      const std::vector<Approach> approaches = approachesOf(world);
      const geo::Box area{-2500.0, -2500.0, 2500.0, 2500.0};
      const LatticeRoadmap lattice = *buildLatticeRoadmap(world, {area, std::nullopt}, Job{});
      const TreeRoadmap tree = *buildRrtStarRoadmap(world, {area, 500, {}, 1, {}}, Job{});
      QueryScratch scratch;
      for (const Roadmap* roadmap : {static_cast<const Roadmap*>(&lattice), static_cast<const Roadmap*>(&tree)}) {
        for (int i = 0; i < 300; ++i) {
          const geo::Pose pose{-2000.0 + 13.0 * i, 1900.0 - 7.0 * i, 0.7 * i};
          const auto answer = roadmap->query(world, pose, scratch);
          QVERIFY(answer.has_value());
          const std::vector<flight::Piece> pieces = roadmap->witnessPieces(*answer);
          const Approach& approach = approaches[static_cast<std::size_t>(answer->site)];
          QCOMPARE(approach.site, answer->site);
          QVERIFY(pieces.back() == approach.pieces.back());
          const geo::Pose end = flight::endOf(flight::Curve{pose, pieces, {}}, 1.0);
          QVERIFY(geo::distance(end.point(), world.sites[static_cast<std::size_t>(answer->site)].pose.point()) < 1e-3);
        }
      }
    }
  }

  void joinedGlide_keepsTheCircleApart() {
    const flight::Piece turn{flight::Turn::Left, 100.0, 30.0};
    const flight::Piece circle{flight::Turn::Left, 100.0, 200.0 * Angle::kPi};
    World world;
    QVERIFY(joinedGlide(world, {turn}, {turn, circle}) == (std::vector<flight::Piece>{{flight::Turn::Left, 100.0, 60.0 + circle.length}}));
    world.approach.kind = ApproachKind::Overhead;
    QVERIFY(joinedGlide(world, {turn}, {turn, circle}) == (std::vector<flight::Piece>{{flight::Turn::Left, 100.0, 60.0}, circle}));
    QVERIFY(joinedGlide(world, {turn}, {circle}) == (std::vector<flight::Piece>{turn, circle}));
  }
};

QTEST_APPLESS_MAIN(TestApproach)
#include "tst_approach.moc"
