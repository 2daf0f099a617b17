#include "core/geo/local_frame.h"

#include <GeographicLib/AzimuthalEquidistant.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <fmt/core.h>

#include <cmath>

namespace vp::geo {
namespace {

const GeographicLib::AzimuthalEquidistant& projection() {
  static const GeographicLib::AzimuthalEquidistant instance(GeographicLib::Geodesic::WGS84());
  return instance;
}

/// Grid course minus true course at a point of the frame [rad]: the radial line through the point has grid azimuth
/// atan2(x, y) and, as its geodesic, the true azimuth that the projection reports.
double convergence(double x, double y, double azimuthAtPoint_deg) {
  if (std::hypot(x, y) < 1e-6) {
    return 0.0;
  }
  return wrapPi(std::atan2(x, y) - Angle::degrees(azimuthAtPoint_deg).radians());
}

double convergenceAt(LatLon origin, LatLon place) {
  double x = 0.0;
  double y = 0.0;
  double azimuth = 0.0;
  double scale = 0.0;
  projection().Forward(origin.latitude_deg, origin.longitude_deg, place.latitude_deg, place.longitude_deg, x, y, azimuth, scale);
  return convergence(x, y, azimuth);
}

}  // namespace

Point LocalFrame::toPoint(LatLon place) const {
  Point p;
  projection().Forward(origin_.latitude_deg, origin_.longitude_deg, place.latitude_deg, place.longitude_deg, p.x, p.y);
  return p;
}

LatLon LocalFrame::toLatLon(Point point) const {
  LatLon place;
  projection().Reverse(origin_.latitude_deg, origin_.longitude_deg, point.x, point.y, place.latitude_deg, place.longitude_deg);
  return place;
}

double LocalFrame::headingOf(Angle trueCourse, LatLon place) const {
  const double gridCourse = trueCourse.radians() + convergenceAt(origin_, place);
  return wrapTwoPi(Angle::kPi / 2.0 - gridCourse);
}

Angle LocalFrame::trueCourseOf(double heading, Point point) const {
  const double gridCourse = Angle::kPi / 2.0 - heading;
  return Angle::radians(wrapTwoPi(gridCourse - convergenceAt(origin_, toLatLon(point))));
}

std::string LocalFrame::projString() const {
  return fmt::format("+proj=aeqd +lat_0={} +lon_0={} +datum=WGS84 +units=m +no_defs", origin_.latitude_deg, origin_.longitude_deg);
}

Length geodesicDistance(LatLon a, LatLon b) {
  double metres = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(a.latitude_deg, a.longitude_deg, b.latitude_deg, b.longitude_deg, metres);
  return Length::fromSi(metres);
}

LatLon geodesicDestination(LatLon from, Angle course, Length distance) {
  LatLon to;
  GeographicLib::Geodesic::WGS84().Direct(from.latitude_deg, from.longitude_deg, course.degrees(), distance.si(), to.latitude_deg, to.longitude_deg);
  return to;
}

Angle geodesicCourse(LatLon a, LatLon b) {
  double azimuthA = 0.0;
  double azimuthB = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(a.latitude_deg, a.longitude_deg, b.latitude_deg, b.longitude_deg, azimuthA, azimuthB);
  return Angle::radians(wrapTwoPi(Angle::degrees(azimuthA).radians()));
}

}  // namespace vp::geo
