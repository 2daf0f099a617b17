#include "maps/airstrip.h"

#include "maps/deterministic.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace vp::maps {

double landingCourse(const geo::LocalFrame& frame, geo::Point from, geo::Point to) {
  return frame.trueCourseOf(std::atan2(to.y - from.y, to.x - from.x), from).degrees();
}

std::string runwayNumber(double course_deg) {
  const long number = std::lround(course_deg / 10.0) % 36;
  return fmt::format("{:02}", number == 0 ? 36 : number);
}

double distanceToStrip(const Airstrip& strip, geo::Point p) {
  const double ux = strip.second.x - strip.first.x;
  const double uy = strip.second.y - strip.first.y;
  const double along = ((p.x - strip.first.x) * ux + (p.y - strip.first.y) * uy) / (ux * ux + uy * uy);
  const double t = std::clamp(along, 0.0, 1.0);
  const double dx = p.x - strip.first.x - t * ux;
  const double dy = p.y - strip.first.y - t * uy;
  return std::sqrt(dx * dx + dy * dy);
}

void levelGround(HeightField& field, Airstrip& strip, double flat, double blend, double unit) {
  constexpr int kSamples = 32;
  double sum = 0.0;
  for (int k = 0; k <= kSamples; ++k) {
    const double t = static_cast<double>(k) / kSamples;
    const double x = strip.first.x + t * (strip.second.x - strip.first.x);
    const double y = strip.first.y + t * (strip.second.y - strip.first.y);
    sum += field.at(field.nearest(x), field.nearest(y));
  }
  strip.elevation = roundTo(sum / (kSamples + 1), unit);
  for (int j = 0; j < field.size(); ++j) {
    for (int i = 0; i < field.size(); ++i) {
      const double distance = distanceToStrip(strip, {field.coordinate(i), field.coordinate(j)});
      if (distance < blend) {
        const double share = smoothStep(flat, blend, distance);
        field.at(i, j) = strip.elevation * (1.0 - share) + field.at(i, j) * share;
      }
    }
  }
}

}  // namespace vp::maps
