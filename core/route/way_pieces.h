#pragma once

#include "core/route/layout.h"

#include <vector>

namespace vp::route {

inline constexpr double kOnePlace = 1e-6;  // m along a path

/** Distances along the closed tour [m], from the first visit on, as those of the corners are. */
class Ruler {
public:
  explicit Ruler(const mission::Plan& plan);
  /// Of a decision point.
  [[nodiscard]] double at(int point) const { return at_[static_cast<std::size_t>(point)]; }
  [[nodiscard]] double length() const { return length_; }
  /// From one distance on to another; just behind counts as there.
  [[nodiscard]] double onward(double from, double to) const;

private:
  std::vector<double> at_;
  double length_ = 0.0;
};

/** Where the turn of a corner begins and ends, m along the tour. */
double entryOf(const Corner& corner);
double exitOf(const Corner& corner);

/** The corner of the closed tour that comes first behind a place (isAhead), or last before it. */
std::size_t nearestCorner(const Layout& loop, const Ruler& ruler, double at, bool isAhead);

/** The part of an open way between two distances; its ends are new decision points, without glides. */
std::vector<mission::DecisionPoint> cutWay(const std::vector<mission::DecisionPoint>& way, double from, double to);

/** Length of an open way: the last point has no way on. */
double lengthOf(const std::vector<mission::DecisionPoint>& way);

/** Appends the tour's points from `first` on until they reach `length` metres. */
void appendTour(const mission::Plan& plan, std::size_t first, double length, std::vector<mission::DecisionPoint>& way);

/** The whole circles that a climb-out begins with. */
struct Circles {
  int count = 0;
  double length = 0.0;  ///< m, of one
  std::size_t one = 0;  ///< decision points of one
  std::size_t all = 0;  ///< of all
};

Circles circlesOf(const std::vector<mission::DecisionPoint>& way);

/** One more circle behind those that the climb-out begins with, at the height that it has there. */
void addCircle(std::vector<mission::DecisionPoint>& way);

}  // namespace vp::route
