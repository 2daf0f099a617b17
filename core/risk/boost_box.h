// Boxes as the R*-tree of Boost.Geometry wants them. Of the .cpp files of this folder only.
#pragma once

#include "core/geo/pose.h"

#include <boost/geometry/core/cs.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>

namespace vp::risk {

using BoostPoint = boost::geometry::model::point<double, 2, boost::geometry::cs::cartesian>;
using BoostBox = boost::geometry::model::box<BoostPoint>;

/** @param box  local frame, m */
inline BoostBox boostBox(const geo::Box& box) {
  return {{box.minX, box.minY}, {box.maxX, box.maxY}};
}

}  // namespace vp::risk
