// Measuring and cutting the ways from and to home.
#include "core/route/way_pieces.h"

#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <cmath>

namespace vp::route {

Ruler::Ruler(const mission::Plan& plan) : at_(plan.tour.size()) {
  const std::size_t first = firstVisit(plan);
  for (std::size_t i = 0; i < at_.size(); ++i) {
    at_[(first + i) % at_.size()] = length_;
    length_ += plan.tour[(first + i) % at_.size()].onward.length;
  }
}

double Ruler::onward(double from, double to) const {
  const double d = std::fmod(to - from, length_);
  const double positive = d < 0.0 ? d + length_ : d;
  return positive > length_ - kOnePlace ? 0.0 : positive;
}

double entryOf(const Corner& corner) {
  return corner.tourDistance - corner.radius * std::abs(corner.angle) / 2.0;
}

double exitOf(const Corner& corner) {
  return corner.tourDistance + corner.radius * std::abs(corner.angle) / 2.0;
}

std::size_t nearestCorner(const Layout& loop, const Ruler& ruler, double at, bool isAhead) {
  const auto apart = [&](const Corner& c) { return isAhead ? ruler.onward(at, entryOf(c)) : ruler.onward(exitOf(c), at); };
  const auto best = std::min_element(loop.corners.begin(), loop.corners.end(), [&](const Corner& a, const Corner& b) { return apart(a) < apart(b); });
  return static_cast<std::size_t>(best - loop.corners.begin());
}

std::vector<mission::DecisionPoint> cutWay(const std::vector<mission::DecisionPoint>& way, double from, double to) {
  std::vector<mission::DecisionPoint> part;
  double begin = 0.0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const flight::Piece& piece = way[i].onward;
    const double a = std::max(0.0, from - begin);
    const double b = std::min(piece.length, to - begin);
    if (b > a) {
      const double slope = (way[i + 1].altitude - way[i].altitude) / piece.length;
      mission::DecisionPoint point;
      point.pose = flight::poseAfter(way[i].pose, piece, a);
      point.altitude = way[i].altitude + slope * a;
      point.onward = {piece.turn, piece.radius, b - a};
      point.target = a == 0.0 ? way[i].target : -1;
      mission::DecisionPoint end;
      end.pose = flight::endOf(point.pose, point.onward);
      end.altitude = way[i].altitude + slope * b;
      if (!part.empty()) {
        part.pop_back();
      }
      part.push_back(point);
      part.push_back(end);
    }
    begin += piece.length;
  }
  return part;
}

double lengthOf(const std::vector<mission::DecisionPoint>& way) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    length += way[i].onward.length;
  }
  return length;
}

void appendTour(const mission::Plan& plan, std::size_t first, double length, std::vector<mission::DecisionPoint>& way) {
  std::size_t i = first;
  for (double done = 0.0; done < length + kOnePlace; i = (i + 1) % plan.tour.size()) {
    way.push_back(plan.tour[i]);
    done += plan.tour[i].onward.length;
  }
  way.push_back(plan.tour[i]);
}

Circles circlesOf(const std::vector<mission::DecisionPoint>& way) {
  const flight::Piece& first = way.front().onward;
  Circles circles;
  if (first.turn == flight::Turn::Straight) {
    return circles;
  }
  circles.length = 2.0 * Angle::kPi * first.radius;
  double done = 0.0;
  for (std::size_t i = 0; i + 1 < way.size() && way[i].onward.turn == first.turn && way[i].onward.radius == first.radius; ++i) {
    done += way[i].onward.length;
    const double laps = std::round(done / circles.length);
    if (std::abs(done - laps * circles.length) < kOnePlace) {
      circles.count = static_cast<int>(laps);
      circles.all = i + 1;
      circles.one = circles.one == 0 ? i + 1 : circles.one;
    }
  }
  return circles;
}

void addCircle(std::vector<mission::DecisionPoint>& way) {
  const Circles circles = circlesOf(way);
  if (circles.count == 0) {
    return;
  }
  std::vector<mission::DecisionPoint> lap(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(circles.one));
  for (mission::DecisionPoint& point : lap) {
    point.altitude = way[circles.all].altitude;
  }
  way.insert(way.begin() + static_cast<std::ptrdiff_t>(circles.all), lap.begin(), lap.end());
}

}  // namespace vp::route
