#include "maps/valleys.h"

#include "core/base/expect.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::maps {
namespace {

constexpr double kBorder = 4000.0;   // m from the edge of the map to a strip: room to turn on to the approach
constexpr double kLevel = 18.0;      // m, largest difference of height around a short strip before it is levelled
constexpr double kFreeSide = 200.0;  // m to both sides of a strip that are as level
constexpr int kPathPosts = 6;        // posts down the river that give its direction

double squared(double value) {
  return value * value;
}

struct Candidate {
  geo::Point centre;
  double ux = 0.0;  // direction of the valley
  double uy = 0.0;
};

/// Whether a strip of this length fits: all ground beside and beyond it as level as it must be.
bool fits(const HeightField& field, const Candidate& place, double length) {
  const double reach = length / 2.0 + 200.0;
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  const double grain = field.spacing() / 2.0;
  const int alongSteps = static_cast<int>(reach / grain);
  const int acrossSteps = static_cast<int>(kFreeSide / grain);
  for (int k = -alongSteps; k <= alongSteps; ++k) {
    for (int l = -acrossSteps; l <= acrossSteps; ++l) {
      const double along = k * grain;
      const double across = l * grain;
      const double x = place.centre.x + along * place.ux - across * place.uy;
      const double y = place.centre.y + along * place.uy + across * place.ux;
      const double height = field.at(field.nearest(x), field.nearest(y));
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  return high - low <= kLevel * (1.0 + length / 1000.0);
}

/// Posts on large rivers with the direction of the valley there.
std::vector<Candidate> riverPlaces(const HeightField& field, const Drainage& drainage, int drainageSize, double leastArea) {
  const HeightField large(drainageSize, field.spacing());
  const double reach = -field.coordinate(0) - kBorder;
  std::vector<Candidate> places;
  for (const std::size_t post : drainage.order) {
    if (drainage.area[post] < leastArea) {
      continue;
    }
    std::size_t below = post;
    for (int k = 0; k < kPathPosts; ++k) {
      below = drainage.receiver[below];
    }
    const auto side = static_cast<std::size_t>(drainageSize);
    const geo::Point from{large.coordinate(static_cast<int>(post % side)), large.coordinate(static_cast<int>(post / side))};
    const geo::Point to{large.coordinate(static_cast<int>(below % side)), large.coordinate(static_cast<int>(below / side))};
    const double length = std::sqrt(squared(to.x - from.x) + squared(to.y - from.y));
    if (length > 2.0 * field.spacing() && std::abs(from.x) < reach && std::abs(from.y) < reach) {
      places.push_back({{(from.x + to.x) / 2.0, (from.y + to.y) / 2.0}, (to.x - from.x) / length, (to.y - from.y) / length});
    }
  }
  return places;
}

double distanceToNearest(const std::vector<Airstrip>& strips, geo::Point p) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Airstrip& strip : strips) {
    nearest = std::min(nearest, distanceToStrip(strip, p));
  }
  return nearest;
}

}  // namespace

void carveValleys(HeightField& field, const Drainage& drainage, const ValleyShape& shape) {
  const std::vector<double> rivers = field.heights();
  for (const std::size_t post : drainage.order) {
    if (drainage.area[post] < shape.leastArea) {
      continue;
    }
    const double floor = std::min(shape.floorPerRootArea * std::sqrt(drainage.area[post]), shape.widestFloor);
    const double bend = shape.steepestSide / (2.0 * shape.curvature);  // beyond it the side is straight
    const double reach = floor + bend + 1500.0;
    const int posts = static_cast<int>(reach / field.spacing());
    const int column = static_cast<int>(post % static_cast<std::size_t>(field.size()));
    const int row = static_cast<int>(post / static_cast<std::size_t>(field.size()));
    for (int j = std::max(row - posts, 0); j <= std::min(row + posts, field.size() - 1); ++j) {
      for (int i = std::max(column - posts, 0); i <= std::min(column + posts, field.size() - 1); ++i) {
        const double distance = std::sqrt(squared(i - column) + squared(j - row)) * field.spacing();
        const double beyond = std::max(distance - floor, 0.0);
        const double rise = beyond < bend ? shape.curvature * beyond * beyond : shape.curvature * bend * bend + (beyond - bend) * shape.steepestSide;
        field.at(i, j) = std::min(field.at(i, j), rivers[post] + rise);
      }
    }
  }
}

HeightField cropped(const HeightField& field, int size) {
  const int offset = (field.size() - size) / 2;
  VP_EXPECT(offset >= 0 && field.size() - size == 2 * offset);
  HeightField middle(size, field.spacing());
  for (int j = 0; j < size; ++j) {
    for (int i = 0; i < size; ++i) {
      middle.at(i, j) = field.at(i + offset, j + offset);
    }
  }
  return middle;
}

std::vector<Airstrip> placeAirstrips(const HeightField& field, const Drainage& drainage, int drainageSize, double leastArea,
                                     const std::vector<AirstripWish>& wishes) {
  const std::vector<Candidate> places = riverPlaces(field, drainage, drainageSize, leastArea);
  std::vector<Airstrip> strips;
  for (const AirstripWish& wish : wishes) {
    const Candidate* best = nullptr;
    double farthest = 0.0;
    for (const Candidate& place : places) {
      // The first goes to the middle of the map, the others where the way to the next one is longest.
      const double away =
          strips.empty() ? 1e6 - squared(place.centre.x / 100.0) - squared(place.centre.y / 100.0) : distanceToNearest(strips, place.centre);
      if (away > farthest && fits(field, place, wish.length)) {
        farthest = away;
        best = &place;
      }
    }
    if (best == nullptr) {
      break;
    }
    Airstrip strip{wish.ident, wish.name, {}, {}, wish.width, wish.surface};
    const double half = wish.length / 2.0;
    strip.first = {std::round(best->centre.x - half * best->ux), std::round(best->centre.y - half * best->uy)};
    strip.second = {std::round(best->centre.x + half * best->ux), std::round(best->centre.y + half * best->uy)};
    strips.push_back(strip);
  }
  return strips;
}

}  // namespace vp::maps
