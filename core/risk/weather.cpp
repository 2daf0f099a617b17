#include "core/risk/weather.h"

#include "core/base/expect.h"
#include "core/flight/curve_sampling.h"
#include "core/risk/box_tree.h"
#include "core/risk/ring_clip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace vp::risk {
namespace {

constexpr double kTouch = 1e-5;  // m: cells this near are looked at; more than a place may be from a side and still on it

tl::unexpected<Error> refuse(const std::string& name, const std::string& what) {
  return fail(Errc::BadFormat, fmt::format("weather {}: {}", name, what));
}

/// What numbers of a cell cannot be; empty if they can.
std::string faultOf(const mission::WeatherCell& cell) {
  if (!(cell.success > 0.0 && cell.success <= 1.0)) {
    return fmt::format("a probability of {:g} to come through cannot be; give one above 0 and up to 1, for example 0.95", cell.success);
  }
  if (!(cell.perDistance > 0.0) || !std::isfinite(cell.perDistance)) {
    return fmt::format("its probability holds for {:g} m, which is no distance; give one above 0, for example 1852 m", cell.perDistance);
  }
  const auto isNumber = [](const std::optional<double>& height) { return !height || std::isfinite(*height); };
  if (!isNumber(cell.floor) || !isNumber(cell.top)) {
    return "its floor or its top is no finite number; give metres above mean sea level, or leave it out";
  }
  if (cell.floor && cell.top && !(*cell.floor < *cell.top)) {
    return fmt::format("its floor at {:.0f} m MSL is not below its top at {:.0f} m MSL; exchange or correct them", *cell.floor, *cell.top);
  }
  return {};
}

}  // namespace

struct Weather::Index {
  std::vector<Cell> cells;
  std::vector<PolygonSides> sides;
  std::vector<double> levels;
  BoxTree tree;
};

Weather::Weather(std::unique_ptr<const Index> index) : index_(std::move(index)) {}
Weather::~Weather() = default;

Result<std::shared_ptr<const Weather>> Weather::from(const std::vector<mission::WeatherCell>& cells, const geo::LocalFrame& frame) {
  auto index = std::make_unique<Index>();
  std::vector<geo::Box> boxes;
  for (const mission::WeatherCell& given : cells) {
    Cell cell;
    const std::string number = fmt::format("cell {}", index->cells.size() + 1);
    cell.name = given.name.empty() ? number : given.name;
    const std::string named = given.name.empty() ? number : fmt::format("{} ({})", number, given.name);
    if (const std::string fault = faultOf(given); !fault.empty()) {
      return refuse(named, fault);
    }
    cell.ring = ringOf(given.outline, frame);
    if (cell.ring.size() < 3) {
      return refuse(named, "its outline has fewer than three different corners; add corners or leave the cell out");
    }
    if (std::any_of(cell.ring.begin(), cell.ring.end(), [](geo::Point p) { return !std::isfinite(p.x) || !std::isfinite(p.y); })) {
      return refuse(named, "a corner is no place on Earth; correct it or leave the cell out");
    }
    if (const std::optional<geo::Point> place = selfCrossing({cell.ring})) {
      return refuse(named,
                    fmt::format("sides of its outline cross each other at {}; draw it without the loop, or as two cells", placeText(frame, *place)));
    }
    cell.floor = given.floor.value_or(cell.floor);
    cell.top = given.top.value_or(cell.top);
    cell.rate = given.success == 1.0 ? 0.0 : -std::log(given.success) / given.perDistance;
    for (const std::optional<double>& level : {given.floor, given.top}) {
      if (level && cell.rate > 0.0) {
        index->levels.push_back(*level);
      }
    }
    index->sides.emplace_back(std::vector<Ring>{cell.ring});
    boxes.push_back(index->sides.back().box());
    index->cells.push_back(std::move(cell));
  }
  std::sort(index->levels.begin(), index->levels.end());
  index->levels.erase(std::unique(index->levels.begin(), index->levels.end()), index->levels.end());
  index->tree = BoxTree(boxes);
  return std::shared_ptr<const Weather>(new Weather(std::move(index)));
}

std::size_t Weather::size() const {
  return index_->cells.size();
}

const Weather::Cell& Weather::cell(std::size_t i) const {
  VP_EXPECT(i < index_->cells.size());
  return index_->cells[i];
}

const std::vector<double>& Weather::levels() const {
  return index_->levels;
}

double Weather::shareAt(std::size_t cell, geo::Point place) const {
  VP_EXPECT(cell < index_->cells.size());
  return index_->sides[cell].shareAt(place);
}

double Weather::rateAt(geo::Point place, double altitude) const {
  double rate = 0.0;
  geo::Box box;
  box.add(place);
  thread_local std::vector<std::size_t> near;
  index_->tree.meeting(box.grown(kTouch), near);
  for (const std::size_t i : near) {
    const Cell& cell = index_->cells[i];
    rate += cell.rate > 0.0 && cell.holds(altitude) ? index_->sides[i].shareAt(place) * cell.rate : 0.0;
  }
  return rate;
}

void Weather::along(const geo::Pose& from, const flight::Piece& piece, double low, double high, std::vector<WeatherStretch>& out) const {
  out.clear();
  if (!(piece.length > 0.0) || index_->tree.isEmpty()) {
    return;
  }
  const geo::Box box = flight::boxOf(from, piece, 0.0, piece.length);
  thread_local std::vector<std::size_t> near;
  thread_local std::vector<PolygonSides::Inside> parts;
  index_->tree.meeting(box.grown(kTouch), near);
  for (const std::size_t i : near) {
    const Cell& cell = index_->cells[i];
    if (cell.rate == 0.0 || cell.floor > high || cell.top < low) {
      continue;
    }
    index_->sides[i].insideAlong(from, piece, box, parts);
    for (const PolygonSides::Inside& inside : parts) {
      out.push_back({inside.from, inside.to, i, inside.share});
    }
  }
}

double lengthInside(const Weather::Cell& cell, const WeatherStretch& stretch, double start, double slope) {
  double from = stretch.from;
  double to = stretch.to;
  if (slope == 0.0) {
    return cell.holds(start) ? to - from : 0.0;
  }
  // where the leg is at floor and at top, lowest first along it
  const double atFloor = (cell.floor - start) / slope;
  const double atTop = (cell.top - start) / slope;
  from = std::max(from, std::min(atFloor, atTop));
  to = std::min(to, std::max(atFloor, atTop));
  return std::max(0.0, to - from);
}

WeatherRisk::WeatherRisk(std::shared_ptr<const Weather> weather) : weather_(std::move(weather)) {
  VP_EXPECT(weather_ != nullptr);
}

double WeatherRisk::of(const geo::Pose& from, const flight::Piece& piece, double startAltitude, double endAltitude) const {
  if (!(piece.length > 0.0)) {
    return 0.0;
  }
  thread_local std::vector<WeatherStretch> stretches;
  weather_->along(from, piece, std::min(startAltitude, endAltitude), std::max(startAltitude, endAltitude), stretches);
  const double slope = (endAltitude - startAltitude) / piece.length;
  double risk = 0.0;
  for (const WeatherStretch& stretch : stretches) {
    const Weather::Cell& cell = weather_->cell(stretch.cell);
    risk += stretch.share * cell.rate * lengthInside(cell, stretch, startAltitude, slope);
  }
  return risk;
}

}  // namespace vp::risk
