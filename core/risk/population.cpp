#include "core/risk/population.h"

#include "core/base/expect.h"
#include "core/flight/curve_sampling.h"
#include "core/risk/box_tree.h"
#include "core/risk/ring_check.h"
#include "core/risk/ring_clip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace vp::risk {
namespace {

constexpr double kSquareKm = 1e6;  // m^2
constexpr double kTouch = 1e-5;    // m: areas this near are looked at; more than a place may be from a side and still on it

double signedArea(const Ring& ring) {
  double twice = 0.0;  // about the first corner, so that far from the origin nothing cancels
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    twice += (ring[i].x - ring[0].x) * (ring[i + 1].y - ring[0].y) - (ring[i + 1].x - ring[0].x) * (ring[i].y - ring[0].y);
  }
  return 0.5 * twice;
}

double areaOf(const std::vector<Ring>& rings) {
  double area = 0.0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    area += (i == 0 ? 1.0 : -1.0) * std::abs(signedArea(rings[i]));
  }
  return area;
}

tl::unexpected<Error> refuse(const mission::PopulationArea& area, const std::string& what) {
  return fail(Errc::BadFormat, area.name + ": " + what, area.source);
}

/// The rings of a polygon in the frame, if they are sound.
Result<std::vector<Ring>> ringsOf(const mission::PopulationArea& area, const mission::PopulatedPolygon& polygon, const geo::LocalFrame& frame) {
  std::vector<Ring> rings;
  const auto add = [&](const std::vector<geo::LatLon>& corners) { rings.push_back(ringOf(corners, frame)); };
  add(polygon.outline);
  for (const std::vector<geo::LatLon>& hole : polygon.holes) {
    add(hole);
  }
  for (const Ring& ring : rings) {
    if (ring.size() < 3) {
      return refuse(area, "a polygon has fewer than three different corners; correct it or leave the feature out");
    }
    if (std::any_of(ring.begin(), ring.end(), [](geo::Point p) { return !std::isfinite(p.x) || !std::isfinite(p.y); })) {
      return refuse(area, "a corner is no place on Earth; correct it or leave the feature out");
    }
  }
  if (const std::optional<geo::Point> place = selfCrossing(rings)) {
    return refuse(
        area, fmt::format("sides of the polygon cross each other at {}; draw the outline without the loop, for example with QGIS > Fix geometries",
                          placeText(frame, *place)));
  }
  const PolygonSides outline({rings.front()});
  for (std::size_t i = 1; i < rings.size(); ++i) {
    // no sides cross, so a hole is inside with all its corners or outside with one
    const auto outside = std::find_if(rings[i].begin(), rings[i].end(), [&](geo::Point p) { return outline.shareAt(p) == 0.0; });
    if (outside != rings[i].end()) {
      return refuse(area,
                    fmt::format("a hole lies outside its polygon at {}; make it a polygon of its own or leave it out", placeText(frame, *outside)));
    }
  }
  return rings;
}

/// Value below which a share of the sorted values lies, linear between two.
double quantile(const std::vector<double>& sorted, double share) {
  const double at = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (at - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

void lowerOutliers(std::vector<Population::Polygon>& polygons, const std::vector<double>& ofAreas) {
  if (ofAreas.empty()) {
    return;
  }
  std::vector<double> sorted = ofAreas;
  std::sort(sorted.begin(), sorted.end());
  const double first = quantile(sorted, 0.25);
  const double third = quantile(sorted, 0.75);
  for (Population::Polygon& polygon : polygons) {
    if (polygon.density > third + 1.5 * (third - first)) {
      polygon.density = third;
    }
  }
}

}  // namespace

struct Population::Index {
  std::vector<Polygon> polygons;
  std::vector<PolygonSides> sides;
  BoxTree tree;
  double greatest = 0.0;
};

Population::Population() : index_(std::make_unique<Index>()) {}
Population::~Population() = default;
Population::Population(Population&&) noexcept = default;
Population& Population::operator=(Population&&) noexcept = default;

Result<Population> Population::from(const std::vector<mission::PopulationArea>& areas, const geo::LocalFrame& frame, Outliers outliers) {
  auto index = std::make_unique<Index>();
  std::vector<double> densities;
  for (const mission::PopulationArea& area : areas) {
    const double number = area.people ? *area.people : area.perSquareKm.value_or(0.0);
    if (!std::isfinite(number) || number < 0.0) {
      return refuse(area, fmt::format("{} is {:g}, which cannot be; correct it or leave the feature out",
                                      area.people ? "the number of people" : "the number of people per square kilometre", number));
    }
    const std::size_t begin = index->polygons.size();
    double total = 0.0;
    for (const mission::PopulatedPolygon& part : area.parts) {
      Result<std::vector<Ring>> rings = ringsOf(area, part, frame);
      if (!rings) {
        return forward(rings);
      }
      const double size = areaOf(*rings);
      index->polygons.push_back({std::move(*rings), 0.0, size});
      total += size;
    }
    if (!(total > 0.0)) {
      return refuse(area, "it covers no ground that people could live on; correct its outline or leave the feature out");
    }
    const double density = area.people ? number / total : number / kSquareKm;
    densities.push_back(density);
    for (std::size_t i = begin; i < index->polygons.size(); ++i) {
      index->polygons[i].density = density;
    }
  }
  if (outliers == Outliers::ThirdQuartile) {
    lowerOutliers(index->polygons, densities);
  }
  std::vector<geo::Box> boxes;
  for (std::size_t i = 0; i < index->polygons.size(); ++i) {
    index->sides.emplace_back(index->polygons[i].rings);
    index->greatest = std::max(index->greatest, index->polygons[i].density);
    boxes.push_back(index->sides.back().box());
  }
  index->tree = BoxTree(boxes);
  Population population;
  population.index_ = std::move(index);
  return population;
}

double Population::densityAt(geo::Point place) const {
  double density = 0.0;
  geo::Box box;
  box.add(place);
  thread_local std::vector<std::size_t> near;
  index_->tree.meeting(box.grown(kTouch), near);
  for (const std::size_t i : near) {
    density += index_->sides[i].shareAt(place) * index_->polygons[i].density;
  }
  return density;
}

void Population::along(const geo::Pose& from, const flight::Piece& piece, std::vector<Stretch>& out) const {
  out.clear();
  if (!(piece.length > 0.0)) {
    return;
  }
  const geo::Box box = flight::boxOf(from, piece, 0.0, piece.length);
  thread_local std::vector<std::size_t> near;
  thread_local std::vector<PolygonSides::Inside> parts;
  index_->tree.meeting(box.grown(kTouch), near);
  for (const std::size_t i : near) {
    const double density = index_->polygons[i].density;
    if (density == 0.0) {
      continue;
    }
    index_->sides[i].insideAlong(from, piece, box, parts);
    for (const PolygonSides::Inside& inside : parts) {
      out.push_back({inside.from, inside.to, inside.share * density});
    }
  }
}

double Population::integralAlong(const geo::Pose& from, const flight::Piece& piece) const {
  std::vector<Stretch> stretches;
  along(from, piece, stretches);
  double sum = 0.0;
  for (const Stretch& stretch : stretches) {
    sum += (stretch.to - stretch.from) * stretch.density;
  }
  return sum;
}

double Population::greatestDensity() const {
  return index_->greatest;
}

std::size_t Population::size() const {
  return index_->polygons.size();
}

const Population::Polygon& Population::polygon(std::size_t i) const {
  VP_EXPECT(i < index_->polygons.size());
  return index_->polygons[i];
}

}  // namespace vp::risk
