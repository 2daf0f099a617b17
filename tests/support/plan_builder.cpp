#include "tests/support/plan_builder.h"

#include "core/aircraft/glide_model.h"
#include "core/geo/local_frame.h"

#include <algorithm>
#include <cmath>

namespace vp::test {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// One turn, a straight and the same turn; side +1 left, -1 right.
std::vector<flight::Piece> sameSideGlide(const geo::Pose& from, const geo::Pose& to, double radius, double side) {
  const geo::Point a{from.x - side * radius * std::sin(from.heading), from.y + side * radius * std::cos(from.heading)};
  const geo::Point b{to.x - side * radius * std::sin(to.heading), to.y + side * radius * std::cos(to.heading)};
  const double straight = geo::distance(a, b);
  const double direction = straight > 1e-9 ? std::atan2(b.y - a.y, b.x - a.x) : from.heading;
  const flight::Turn turn = side > 0.0 ? flight::Turn::Left : flight::Turn::Right;
  return {{turn, radius, radius * wrapTwoPi(side * (direction - from.heading))},
          {flight::Turn::Straight, 0.0, straight},
          {turn, radius, radius * wrapTwoPi(side * (to.heading - direction))}};
}

double lengthOfPieces(const std::vector<flight::Piece>& pieces) {
  double length = 0.0;
  for (const flight::Piece& piece : pieces) {
    length += piece.length;
  }
  return length;
}

geo::Pose moved(const geo::Pose& pose, const flight::Piece& piece) {
  if (piece.turn == flight::Turn::Straight) {
    return {pose.x + piece.length * std::cos(pose.heading), pose.y + piece.length * std::sin(pose.heading), pose.heading};
  }
  const double side = piece.turn == flight::Turn::Left ? 1.0 : -1.0;
  const double turned = side * piece.length / piece.radius;
  const double chord = 2.0 * piece.radius * std::sin(std::abs(turned) / 2.0);
  const double direction = pose.heading + turned / 2.0;
  return {pose.x + chord * std::cos(direction), pose.y + chord * std::sin(direction), wrapTwoPi(pose.heading + turned)};
}

}  // namespace

std::vector<flight::Piece> glideTo(const geo::Pose& from, const geo::Pose& to, double radius) {
  auto left = sameSideGlide(from, to, radius, 1.0);
  auto right = sameSideGlide(from, to, radius, -1.0);
  return lengthOfPieces(left) <= lengthOfPieces(right) ? left : right;
}

aircraft::AircraftProfile cessna() {
  aircraft::AircraftProfile profile;
  profile.id = "test172";
  profile.name = "Test 172";
  profile.mass_kg = 1111.0;
  profile.wingArea_m2 = 16.2;
  profile.zeroLiftDrag = 0.0341;
  profile.inducedDrag = 0.054;
  profile.airDensity_kgm3 = 1.225;
  profile.bestGlideSpeed = Speed::fromSi(33.4);
  profile.glideBanks = {Angle::degrees(30.0), Angle::degrees(60.0)};
  profile.tourBank = Angle::degrees(60.0);
  profile.maxClimb = Angle::degrees(15.0);
  profile.maxDescent = Angle::degrees(15.0);
  return profile;
}

TestTerrain::TestTerrain(float height) : values_(static_cast<std::size_t>(kCount) * kCount, height) {}

TestTerrain& TestTerrain::setCell(double x, double y, float height) {
  const auto column = static_cast<std::size_t>(std::floor(x / kCell) + kCount / 2);
  const auto row = static_cast<std::size_t>(std::floor(y / kCell) + kCount / 2);
  values_.at(row * kCount + column) = height;
  return *this;
}

terrain::ElevationGrid TestTerrain::grid() const {
  return terrain::ElevationGrid(-kCount / 2 * kCell, -kCount / 2 * kCell, kCell, kCount, kCount, values_);
}

PlanBuilder::PlanBuilder(double tourAltitude) {
  plan_.createdBy = "test";
  plan_.frameOrigin = {46.5, 9.9};
  plan_.terrainCell = TestTerrain::kCell;
  plan_.terrain = {{"flat.tif", std::string(64, 'a')}};
  plan_.mission.name = "racetrack";
  plan_.mission.terrain = {"flat.tif"};
  plan_.mission.aircraft = cessna();
  plan_.mission.safety.clearance = Length::fromSi(100.0);
  plan_.mission.safety.arrivalMargin = Length::fromSi(50.0);
  plan_.mission.planner.step = Length::fromSi(200.0);

  const geo::LocalFrame frame(plan_.frameOrigin);
  mission::LandingSite site;
  site.id = "TEST/09";
  site.airportIdent = "TEST";
  site.runwayIdent = "09";
  site.touchdown = frame.toLatLon({0.0, -1000.0});
  site.landingCourse = frame.trueCourseOf(0.0, {0.0, -1000.0});
  plan_.mission.sites = {site};
  plan_.sites = {{site, {0.0, -1000.0, 0.0}}};

  geo::Pose pose{-1000.0, 1000.0, 0.0};
  addLeg(flight::Turn::Straight, 0.0, 2000.0, 10, pose, tourAltitude);
  addLeg(flight::Turn::Left, 300.0, 300.0 * kPi, 5, pose, tourAltitude);
  addLeg(flight::Turn::Straight, 0.0, 2000.0, 10, pose, tourAltitude);
  addLeg(flight::Turn::Left, 300.0, 300.0 * kPi, 5, pose, tourAltitude);
  addTarget("mill", 3, 110.0, mission::HeightReference::AboveGround);
  addTarget("bridge", 18, 300.0, mission::HeightReference::Msl);
  for (std::size_t i = 0; i < plan_.tour.size(); ++i) {
    rebuildGlide(i, plan_.sites[0].pose, 65.7);
  }
  updateMetrics();
}

void PlanBuilder::addLeg(flight::Turn turn, double radius, double length, int parts, geo::Pose& pose, double altitude) {
  for (int i = 0; i < parts; ++i) {
    mission::DecisionPoint point;
    point.pose = pose;
    point.altitude = altitude;
    point.onward = {turn, radius, length / parts};
    pose = moved(pose, point.onward);
    plan_.tour.push_back(point);
  }
}

void PlanBuilder::addTarget(const std::string& name, std::size_t point, double height, mission::HeightReference reference) {
  const geo::LocalFrame frame(plan_.frameOrigin);
  const geo::Point place = plan_.tour[point].pose.point();
  const mission::Target target{name, frame.toLatLon(place), height, reference};
  plan_.tour[point].target = static_cast<int>(plan_.targets.size());
  plan_.mission.targets.push_back(target);
  plan_.targets.push_back({target, place, height});
}

std::vector<std::string> PlanBuilder::checksums() const {
  return {std::string(64, 'a')};
}

double PlanBuilder::lossOf(const std::vector<flight::Piece>& pieces) const {
  const aircraft::GlideModel model(plan_.mission.aircraft);
  double loss = 0.0;
  for (const flight::Piece& piece : pieces) {
    loss += model.lossAt(piece.radius) * piece.length;
  }
  return loss;
}

void PlanBuilder::rebuildGlide(std::size_t point, const geo::Pose& to, double radius) {
  mission::DecisionPoint& decision = plan_.tour[point];
  decision.witness.site = 0;
  decision.witness.pieces = glideTo(decision.pose, to, radius);
  const mission::SafetySettings& safety = plan_.mission.safety;
  const double arrival = std::max(plan_.sites[0].site.elevation.metres() + safety.arrivalMargin.si(), safety.clearance.si());
  decision.safeAltitude = arrival + lossOf(decision.witness.pieces);
}

void PlanBuilder::updateMetrics() {
  double length = 0.0;
  double penalty = 0.0;
  for (std::size_t i = 0; i < plan_.tour.size(); ++i) {
    const mission::DecisionPoint& point = plan_.tour[i];
    const double rise = plan_.tour[(i + 1) % plan_.tour.size()].altitude - point.altitude;
    length += std::sqrt(point.onward.length * point.onward.length + rise * rise);
    if (point.target >= 0 && static_cast<std::size_t>(point.target) < plan_.targets.size()) {
      penalty += plan_.mission.planner.beta * (point.altitude - plan_.targets[static_cast<std::size_t>(point.target)].altitude);
    }
  }
  plan_.metrics.length = length;
  plan_.metrics.penalty = penalty;
  plan_.metrics.cost = length + penalty;
}

void PlanBuilder::flyAt(double altitude) {
  for (mission::DecisionPoint& point : plan_.tour) {
    point.altitude = altitude;
  }
  updateMetrics();
}

double PlanBuilder::highestSafeAltitude() const {
  double highest = 0.0;
  for (const mission::DecisionPoint& point : plan_.tour) {
    highest = std::max(highest, point.safeAltitude);
  }
  return highest;
}

}  // namespace vp::test
