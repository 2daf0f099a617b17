#pragma once
// Values and files that several tests of core/formats share.

#include "core/aircraft/glide_model.h"
#include "core/base/result.h"
#include "core/flight/curve_sampling.h"
#include "core/mission/plan.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace vp::formats::samples {

inline std::string readBytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

/** A folder that goes away with the test. */
class Folder {
public:
  [[nodiscard]] std::string path(const std::string& name = {}) const {
    const std::string folder = directory_.path().toStdString();
    return name.empty() ? folder : folder + "/" + name;
  }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream file(path(name), std::ios::binary);
    file << text;
    return path(name);
  }

private:
  QTemporaryDir directory_;
};

/** The folder of real data, or nothing. */
inline std::optional<std::string> dataFolder() {
  std::vector<std::string> places{std::string(VOLPLANE_SOURCE_DIR) + "/../../shared/data", std::string(VOLPLANE_SOURCE_DIR) + "/../shared/data"};
  if (const char* chosen = std::getenv("VOLPLANE_DATA")) {
    places.insert(places.begin(), chosen);
  }
  for (const std::string& place : places) {
    if (std::filesystem::is_directory(place)) {
      return place;
    }
  }
  return std::nullopt;
}

/** Empty if `text` contains every part; else the parts that are missing and the text. */
inline std::string lacking(const std::string& text, const std::vector<std::string>& parts) {
  std::string missing;
  for (const std::string& part : parts) {
    if (text.find(part) == std::string::npos) {
      missing += "[" + part + "] ";
    }
  }
  return missing.empty() ? "" : "lacks " + missing + "in: " + text;
}

inline aircraft::AircraftProfile sampleAircraft() {
  aircraft::AircraftProfile profile;
  profile.id = "test";
  profile.name = "Test \"172\" \xC3\xA9";
  profile.mass_kg = 1000.0;
  profile.wingArea_m2 = 16.2;
  profile.zeroLiftDrag = 0.0341;
  profile.inducedDrag = 0.053;
  profile.airDensity_kgm3 = 1.225;
  profile.bestGlideSpeed = Speed::fromSi(33.4);
  profile.glideBanks = {Angle::degrees(30.0), Angle::degrees(45.0)};
  profile.tourBank = Angle::degrees(45.0);
  profile.maxClimb = Angle::radians(0.1);  // no round number of degrees
  profile.maxDescent = Angle::degrees(10.0);
  profile.stallSpeed = Speed::fromSi(25.4);
  profile.maxLoadFactor = 3.8;
  profile.ceiling = geo::HeightMsl::fromMetres(4114.8);
  profile.maxTailwind = Speed::fromSi(5.1);
  profile.maxCrosswind = Speed::fromSi(7.7);
  profile.leastMass_kg = 800.5;
  profile.mostMass_kg = 1100.25;
  profile.windmillingDrag = 0.0513;
  profile.stoppedDrag = 0.0434;
  profile.maxSpeed = Speed::fromSi(82.3);
  profile.steepestDescent = Angle::radians(0.16);  // no round number of degrees
  profile.rollRate_dps = 16.5;
  profile.landingDistance = Length::fromSi(381.0);
  profile.climbRate = Speed::fromSi(3.9116);
  profile.serviceCeiling = geo::HeightMsl::fromMetres(4328.16);
  profile.powerSettings = {{"75 %", Speed::fromSi(62.0), 31.8, aircraft::PowerSetting::Unit::Litres},
                           {"55 \"%\"", Speed::fromSi(100.0 / 3.0), 0.0, aircraft::PowerSetting::Unit::Litres}};
  profile.usableEnergy = 151.5;
  profile.sources = {"a test", ""};
  return profile;
}

inline mission::LandingSite sampleSite(const std::string& id, geo::LatLon place, double course_deg) {
  mission::LandingSite site;
  site.id = id;
  site.airportIdent = "LSZS";
  site.airportName = "Samedan, \xC3\x89ngadin";
  site.runwayIdent = "21";
  site.touchdown = place;
  site.elevation = geo::HeightMsl::fromMetres(1698.9552);
  site.landingCourse = Angle::degrees(course_deg);
  site.length = Length::fromSi(1690.4);
  site.width = Length::fromSi(39.6);
  site.surface = mission::Surface::Hard;
  site.lighted = true;
  site.approximations = {"elevation of the airport, not of the threshold"};
  site.source = "airports.csv";
  return site;
}

/** A mission with every field away from its default. */
inline mission::Mission sampleMission() {
  mission::Mission mission;
  mission.name = "Davos \"test\"";
  mission.terrain = {"a.tif", "../b\n\"c\".tif"};  // names of files may hold anything
  mission.airfields = {{"airports.csv.gz", "runways.csv"}, {"ch.cup", ""}};
  mission.sites = {sampleSite("LSZS/21", {46.5341, 9.88411}, 209.3), sampleSite("LSZS/03", {46.52, 9.87}, 29.3)};
  mission.sites[1].length.reset();
  mission.sites[1].width.reset();
  mission.siteFilter = {false,
                        true,
                        true,
                        Length::fromSi(450.5),
                        {"LSZX", "LSZS/03"},
                        {"LSZS/21"},
                        Length::fromSi(18.5),
                        {mission::Surface::Hard, mission::Surface::Unknown},
                        true,
                        Length::fromSi(25000.0),
                        geo::LatLon{46.5, 9.75},
                        {{"LSZX", "closed for the airshow"}, {"LSZS/21", ""}}};
  mission.aircraft = sampleAircraft();
  mission.targets = {{"T1", {46.6, 9.9}, 150.25, mission::HeightReference::AboveGround},
                     {"Flüela", {46.75, 9.95}, 2500.0, mission::HeightReference::Msl}};
  mission.home = mission::HomeBase{"LSZS/21", "LSZS/03"};
  mission.ceiling = geo::HeightMsl::fromMetres(3900.0);
  mission.safety = {Length::fromSi(120.0), Length::fromSi(15.0), Duration::fromSi(4.5), Length::fromSi(30.25), 1.1};
  mission.planner.headings = 12;
  mission.planner.step = Length::fromSi(33.3);
  mission.planner.method = mission::Method::Base;
  mission.planner.seed = 18446744073709551615ull;
  mission.planner.roadmapSamples = 7500;
  mission.planner.roadmapTime = Duration::fromSi(30.5);
  mission.planner.beta = 2.5;
  mission.planner.lowTargets = mission::LowTargets::Descend;
  mission.planner.tourSolver = mission::TourSolver::Lkh;
  mission.planner.roadmap = mission::RoadmapKind::RrtStar;
  mission.planner.refine = mission::Refine::None;
  mission.airspace = {
      {"../air.txt"}, {{"C", "", mission::AirspaceUse::Forbid}, {"", "TMA \"1\"", mission::AirspaceUse::Hide}}, mission::AirspaceUse::Warn};
  mission.wind = {{geo::HeightMsl::fromMetres(-1.0 / 3.0), {270.0, 0.0, 7.0 / 3.0, 7.0 / 3.0}},
                  {geo::HeightMsl::fromMetres(1524.0), {359.9, 20.1, 0.0, 20.0 * kMpsPerKnot}}};
  mission.atmosphere = air::Atmosphere{-12.5, 1003.4};
  mission.approach = {
      mission::ApproachKind::Straight, Length::fromSi(1500.0), Angle::radians(0.1), 0.05, Length::fromSi(30.0), Length::fromSi(305.0), true};
  mission.propeller = aircraft::Propeller::Stopped;
  mission.powerSetting = "55 \"%\"";
  mission.weather = {{"storm \"A\"", {{46.6, 9.9}, {46.7, 9.9}, {46.7, 10.0 + 1.0 / 3.0}}, 1524.0 / 7.0, 3048.0, 0.9, 1852.0},
                     {"", {{46.5, -9.9}, {46.4, -9.9}, {46.4, -9.8}, {46.5, -9.8}}, std::nullopt, std::nullopt, 1.0, 1000.0}};
  mission.populationFiles = {"../people.geojson", "blocks.shp"};
  return mission;
}

/** A closed tour: a rounded square of four straight sides and four left turns, decision points at most 50 m apart, a
 *  target in the middle of each side, altitudes that climb and descend. Geometry exact, safety none. */
inline mission::Plan samplePlan(double side = 2000.0, double radius = 114.0) {
  mission::Plan plan;
  plan.createdBy = "volplane 0.1.0";
  plan.mission = sampleMission();
  plan.mission.aircraftReference = "cessna172-operational";
  plan.frameOrigin = {46.6, 9.9};
  plan.terrainCell = 26.7;
  plan.terrain = {{"a.tif", "00ff"}, {"../b c.tif", "abcd"}};
  plan.sites = {{plan.mission.sites[0], {-3000.25, 1.0 / 3.0, -1.25}}, {plan.mission.sites[1], {1e-7, -0.0, 6.1}}};
  geo::Pose pose{-side / 2.0, -side / 2.0 - radius, 0.0};
  double flown = 0.0;
  const double quarter = Angle::kPi / 2.0 * radius;
  const double total = 4.0 * (side + quarter);
  const auto altitudeAt = [&](double s) {
    return 2500.0 + 200.0 * std::sin(2.0 * Angle::kPi * s / total) + 20.0 * std::sin(14.0 * Angle::kPi * s / total);
  };
  const auto add = [&](const flight::Piece& piece, int target) {
    mission::DecisionPoint point;
    point.pose = pose;
    point.altitude = altitudeAt(flown);
    point.safeAltitude = point.altitude - 12.5;
    point.onward = piece;
    point.witness = {static_cast<int>(plan.tour.size() % 2),
                     {{flight::Turn::Left, 197.0, 321.5}, {flight::Turn::Straight, 0.0, 1234.5}, {flight::Turn::Right, 113.8, 20.0}}};
    point.target = target;
    plan.tour.push_back(point);
    pose = flight::endOf(pose, piece);
    flown += piece.length;
  };
  for (int leg = 0; leg < 4; ++leg) {
    mission::TargetInFrame target;
    target.target = {"Target " + std::to_string(leg + 1), {46.6, 9.9 + leg / 100.0}, 100.0, mission::HeightReference::AboveGround};
    const int steps = static_cast<int>(std::ceil(side / 50.0));
    for (int i = 0; i < steps; ++i) {
      const bool visit = i == steps / 2;
      if (visit) {
        target.point = pose.point();
        target.altitude = altitudeAt(flown) - 5.0;
        plan.targets.push_back(target);
      }
      add({flight::Turn::Straight, 0.0, side / steps}, visit ? leg : -1);
    }
    const int turnSteps = static_cast<int>(std::ceil(quarter / 50.0));
    for (int i = 0; i < turnSteps; ++i) {
      add({flight::Turn::Left, radius, quarter / turnSteps}, -1);
    }
  }
  plan.spirals = {{2, 2600.0, 2300.5, flight::Turn::Right, 150.0, 4, 8}};
  plan.holds = {{0, flight::Turn::Left, 197.0, 2100.5}, {1, flight::Turn::Right, 113.8, -1.0 / 3.0}};
  mission::DecisionPoint climbing = plan.tour[3];
  climbing.witness = {};
  plan.departure = mission::HomePath{0, 5, 1, {climbing, plan.tour[4], plan.tour[5]}};
  plan.arrival = mission::HomePath{1, 7, 0, {plan.tour[7], plan.tour[8]}};
  plan.airspaces = {{"TMA",
                     "C",
                     {mission::AirspaceLimit::Kind::FlightLevel, 1981.2},
                     {mission::AirspaceLimit::Kind::Unlimited, 0.0},
                     {{46.5, 9.8}, {46.5, 9.9}, {46.6, 9.9}}}};
  plan.metrics = {9000.5, 8800.25, 200.25, 8700.0, true, 7500, 123456789012, 33, 40, 9100.75, 1234, 56, 8500.5};
  plan.certificate = mission::Certificate{"Every point has a glide.", {"one", ""}, {{"glide.clearance", 0.125, "m", {46.6, 9.9}}}, 5000000000, 170};
  return plan;
}

/** The same without the ways from and to home, wind, air, approach and skill, which are only there to be written and read. */
template <typename... Size>
mission::Plan sampleTour(Size... size) {
  mission::Plan plan = samplePlan(size...);
  plan.departure.reset();
  plan.arrival.reset();
  plan.mission.home.reset();
  plan.mission.wind.clear();
  plan.mission.atmosphere.reset();
  plan.mission.approach = {};
  plan.mission.propeller = {};
  plan.mission.powerSetting.clear();
  plan.mission.safety = {plan.mission.safety.clearance, plan.mission.safety.arrivalMargin};
  plan.mission.aircraft.leastMass_kg.reset();
  plan.mission.aircraft.mostMass_kg.reset();
  plan.holds.clear();
  return plan;
}

inline bool sameMission(const mission::Mission& a, const mission::Mission& b) {
  return a.name == b.name && a.terrain == b.terrain && a.airfields == b.airfields && a.sites == b.sites && a.siteFilter == b.siteFilter &&
         a.aircraft == b.aircraft && a.aircraftReference == b.aircraftReference && a.targets == b.targets && a.home == b.home &&
         a.ceiling == b.ceiling && a.safety == b.safety && a.planner == b.planner && a.airspace == b.airspace && a.wind == b.wind &&
         a.atmosphere == b.atmosphere && a.approach == b.approach && a.propeller == b.propeller && a.powerSetting == b.powerSetting &&
         a.weather == b.weather && a.populationFiles == b.populationFiles;
}

inline bool samePlan(const mission::Plan& a, const mission::Plan& b) {
  return a.createdBy == b.createdBy && sameMission(a.mission, b.mission) && a.frameOrigin == b.frameOrigin && a.terrainCell == b.terrainCell &&
         a.terrain == b.terrain && a.sites == b.sites && a.targets == b.targets && a.tour == b.tour && a.spirals == b.spirals && a.holds == b.holds &&
         a.airspaces == b.airspaces && a.departure == b.departure && a.arrival == b.arrival && a.metrics == b.metrics &&
         a.certificate == b.certificate;
}

}  // namespace vp::formats::samples

/** Fails the test if the text lacks a part. */
#define VP_CONTAINS(text, ...)                                                       \
  do {                                                                               \
    const std::string lacking_ = vp::formats::samples::lacking((text), __VA_ARGS__); \
    QVERIFY2(lacking_.empty(), lacking_.c_str());                                    \
  } while (false)
