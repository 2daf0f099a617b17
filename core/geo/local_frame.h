#pragma once

#include "core/base/quantity.h"
#include "core/geo/pose.h"

#include <string>

namespace vp::geo {

/** A place on the WGS 84 ellipsoid, degrees; latitude in [-90, 90], longitude in [-180, 180]. */
struct LatLon {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  bool operator==(const LatLon&) const = default;
};

/** The local metric frame of a mission and the only door between LatLon and metres.
 *
 *  Azimuthal equidistant projection about the origin: x east, y north, metres. Distances from the origin are exact;
 *  across that direction they are too long by r^2 / (6 R^2): 4 mm/km at 31 km, 0.16 m/km at 200 km from the origin.
 *  @accuracy round trip < 1 um within 1000 km (tst_local_frame)   @threads const members are pure
 *  @source C. F. F. Karney, GeographicLib 2.1, AzimuthalEquidistant; Snyder 1987, USGS PP 1395, p. 191 */
class LocalFrame {
public:
  LocalFrame() = default;
  explicit LocalFrame(LatLon origin) : origin_(origin) {}

  [[nodiscard]] LatLon origin() const { return origin_; }
  [[nodiscard]] Point toPoint(LatLon place) const;
  [[nodiscard]] LatLon toLatLon(Point point) const;

  /** Mathematical heading [rad, 0..2 pi) in the frame of a true course at a place: grid convergence included. */
  [[nodiscard]] double headingOf(Angle trueCourse, LatLon place) const;
  /** True course [0, 360 deg) at a point of a mathematical heading in the frame. Inverse of headingOf. */
  [[nodiscard]] Angle trueCourseOf(double heading, Point point) const;

  /** The frame as a PROJ string, for readers of other programs and for GDAL. */
  [[nodiscard]] std::string projString() const;

  bool operator==(const LocalFrame&) const = default;

private:
  LatLon origin_;
};

/** Geodesic distance on WGS 84. @source Karney 2013, J. Geodesy 87, by GeographicLib */
Length geodesicDistance(LatLon a, LatLon b);

/** The place reached from `from` after `distance` along the geodesic that starts with true course `course`. */
LatLon geodesicDestination(LatLon from, Angle course, Length distance);

/** True course of the geodesic from a to b at a, [0, 360) degrees. */
Angle geodesicCourse(LatLon a, LatLon b);

}  // namespace vp::geo
