#pragma once
// A small mountain with five landing sites, made from formulas: the setting of [1] section 8 without any file.

#include "core/aircraft/aircraft_profile.h"
#include "core/landing/world.h"

#include <cmath>
#include <memory>

namespace vp::test {

/// Cessna 172 of [1] Table 1; the turning glide may use four bank angles.
inline aircraft::AircraftProfile paperCessna() {
  aircraft::AircraftProfile p;
  p.id = "cessna172-elasp";
  p.name = "Cessna 172 of the source paper";
  p.mass_kg = 1000.0;
  p.wingArea_m2 = 16.2;
  p.zeroLiftDrag = 0.0341;
  p.inducedDrag = 0.053;
  p.airDensity_kgm3 = 1.225;
  p.bestGlideSpeed = Speed::fromSi(33.4);
  p.glideBanks = {Angle::degrees(30.0), Angle::degrees(45.0), Angle::degrees(53.0), Angle::degrees(60.0)};
  p.tourBank = Angle::degrees(60.0);
  p.maxClimb = Angle::degrees(30.0);
  p.maxDescent = Angle::degrees(20.0);
  return p;
}

inline double mountainHeight(double x, double y) {
  const double r = std::hypot(x - 300.0, y + 200.0);
  const double dome = 1500.0 * std::exp(-r * r / (2.0 * 900.0 * 900.0));
  const double ridges = 1.0 + 0.25 * std::sin(4.0 * std::atan2(y + 200.0, x - 300.0) + r / 500.0);
  return std::min(1500.0, std::max(0.0, dome * ridges));
}

/// side x side metres around the origin, cell in metres; `height` at the corners of cells, the highest of which counts.
template <typename HeightOf>
std::shared_ptr<const terrain::ElevationGrid> makeGrid(double side, double cell, HeightOf height) {
  const int n = static_cast<int>(std::lround(side / cell));
  std::vector<float> values;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const double x = -0.5 * side + i * cell;
      const double y = -0.5 * side + j * cell;
      values.push_back(static_cast<float>(std::max({height(x, y), height(x + cell, y), height(x, y + cell), height(x + cell, y + cell)})));
    }
  }
  return std::make_shared<const terrain::ElevationGrid>(-0.5 * side, -0.5 * side, cell, n, n, std::move(values));
}

inline mission::SiteInFrame site(const char* id, double x, double y, double heading, double elevation) {
  mission::SiteInFrame s;
  s.site.id = id;
  s.site.elevation = geo::HeightMsl::fromMetres(elevation);
  s.pose = {x, y, heading};
  return s;
}

/// The mountain, 20 m cells, two two-way runways and one one-way runway on low ground.
inline landing::World mountainWorld() {
  landing::World world;
  world.terrain = terrain::TerrainPyramid(makeGrid(5000.0, 20.0, mountainHeight));
  world.glide = aircraft::GlideModel(paperCessna());
  constexpr double pi = Angle::kPi;
  const auto add = [&](const char* id, double x, double y, double heading) {
    world.sites.push_back(site(id, x, y, heading, world.terrain.grid().upperAt({x, y})));
  };
  add("A/09", -2000.0, 2000.0, 0.0);
  add("A/27", -1400.0, 2000.0, pi);
  add("B/36", 2100.0, -2100.0, 0.5 * pi);
  add("B/18", 2100.0, -1500.0, 1.5 * pi);
  add("C/05", -2100.0, -1900.0, 0.25 * pi);
  return world;
}

}  // namespace vp::test
