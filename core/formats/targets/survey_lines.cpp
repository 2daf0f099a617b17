#include "core/formats/targets/survey_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::formats {
namespace {

using geo::Point;

constexpr std::size_t kMostLines = 5000;
constexpr double kShortestLine = 1.0;  // m

/// Corners in a frame whose x axis runs along the lines.
struct Rings {
  std::vector<std::vector<Point>> rings;
  double low = 1e300;
  double high = -1e300;
};

Point turned(Point p, double by) {
  return {p.x * std::cos(by) - p.y * std::sin(by), p.x * std::sin(by) + p.y * std::cos(by)};
}

geo::LatLon middleOf(const std::vector<geo::LatLon>& ring) {
  geo::LatLon middle;
  for (const geo::LatLon& corner : ring) {
    const double east = corner.longitude_deg - ring.front().longitude_deg;
    middle.latitude_deg += corner.latitude_deg / static_cast<double>(ring.size());
    middle.longitude_deg += (east > 180.0 ? east - 360.0 : east < -180.0 ? east + 360.0 : east) / static_cast<double>(ring.size());
  }
  middle.longitude_deg = std::remainder(middle.longitude_deg + ring.front().longitude_deg, 360.0);
  return middle;
}

/// Mathematical heading of the longest side.
double headingOfLongestSide(const std::vector<Point>& ring) {
  double longest = -1.0;
  double heading = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    if (geo::distance(a, b) > longest) {
      longest = geo::distance(a, b);
      heading = std::atan2(b.y - a.y, b.x - a.x);
    }
  }
  return heading;
}

/// Where the line at this height crosses the rings, in order. A corner belongs to the side above it only, so crossings pair up.
std::vector<double> crossings(const Rings& area, double y) {
  std::vector<double> xs;
  for (const std::vector<Point>& ring : area.rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i];
      const Point b = ring[(i + 1) % ring.size()];
      if ((a.y <= y) != (b.y <= y)) {
        xs.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    }
  }
  std::sort(xs.begin(), xs.end());
  return xs;
}

}  // namespace

Result<std::vector<SurveyLine>> surveyLines(const std::vector<geo::LatLon>& ring, const std::vector<std::vector<geo::LatLon>>& holes, Length spacing,
                                            std::optional<Angle> course) {
  if (ring.size() < 3 || !(spacing.si() > 0.0)) {
    return fail(Errc::OutOfRange, "survey lines need an area of three corners or more and a spacing above zero");
  }
  const geo::LocalFrame frame(middleOf(ring));
  std::vector<std::vector<Point>> corners;
  for (std::size_t i = 0; i <= holes.size(); ++i) {
    std::vector<Point>& placed = corners.emplace_back();
    for (const geo::LatLon& corner : i == 0 ? ring : holes[i - 1]) {
      placed.push_back(frame.toPoint(corner));
    }
  }
  const double heading = course ? frame.headingOf(*course, frame.origin()) : headingOfLongestSide(corners.front());
  Rings area;
  for (std::vector<Point>& placed : corners) {
    for (Point& p : placed) {
      p = turned(p, -heading);
      area.low = std::min(area.low, p.y);
      area.high = std::max(area.high, p.y);
    }
    area.rings.push_back(std::move(placed));
  }
  const double across = area.high - area.low;
  const double count = std::max(1.0, std::ceil(across / spacing.si() - 1e-9));
  if (!(across > kShortestLine) || !(count <= static_cast<double>(kMostLines))) {
    return fail(Errc::OutOfRange, !(across > kShortestLine)
                                      ? "the area has no extent"
                                      : fmt::format("a spacing of {:.1f} m gives {:.0f} survey lines; choose a wider one", spacing.si(), count));
  }
  std::vector<SurveyLine> lines;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const double y = area.low + across * (static_cast<double>(i) + 0.5) / count;  // evenly, so that no line just grazes a corner
    std::vector<double> xs = crossings(area, y);
    std::vector<SurveyLine> row;
    for (std::size_t k = 0; k + 1 < xs.size(); k += 2) {
      if (xs[k + 1] - xs[k] >= kShortestLine) {
        row.push_back({frame.toLatLon(turned({xs[k], y}, heading)), frame.toLatLon(turned({xs[k + 1], y}, heading))});
      }
    }
    if (i % 2 == 1) {
      std::reverse(row.begin(), row.end());
      for (SurveyLine& line : row) {
        std::swap(line.from, line.to);
      }
    }
    lines.insert(lines.end(), row.begin(), row.end());
  }
  return lines;
}

}  // namespace vp::formats
