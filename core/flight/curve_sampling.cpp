#include "core/flight/curve_sampling.h"

#include "core/base/quantity.h"

#include <algorithm>
#include <cmath>

namespace vp::flight {

geo::Pose poseAfter(const geo::Pose& start, const Piece& piece, double length) {
  const double c = std::cos(start.heading);
  const double s = std::sin(start.heading);
  if (piece.turn == Turn::Straight) {
    return {start.x + length * c, start.y + length * s, start.heading};
  }
  const double side = static_cast<double>(static_cast<int>(piece.turn));
  const double turned = side * length / piece.radius;
  const double end = start.heading + turned;
  return {start.x + side * piece.radius * (std::sin(end) - s), start.y - side * piece.radius * (std::cos(end) - c), wrapTwoPi(end)};
}

geo::Pose poseAlong(const Curve& curve, double length, double airspeed) {
  geo::Pose pose = curve.start;
  double flown = 0.0;
  for (const Piece& piece : curve.pieces) {
    const double part = std::clamp(length - flown, 0.0, piece.length);
    pose = poseAfter(pose, piece, part);
    flown += part;
    if (part < piece.length) {
      break;
    }
  }
  if (!curve.wind.isCalm()) {
    const double seconds = flown / airspeed;
    pose.x += curve.wind.east * seconds;
    pose.y += curve.wind.north * seconds;
  }
  return pose;
}

double lengthOf(const Curve& curve) {
  double total = 0.0;
  for (const Piece& piece : curve.pieces) {
    total += piece.length;
  }
  return total;
}

geo::Pose endOf(const Curve& curve, double airspeed) {
  return poseAlong(curve, lengthOf(curve), airspeed);
}

geo::Box boxOf(const geo::Pose& start, const Piece& piece, double from, double to) {
  const geo::Pose a = poseAfter(start, piece, from);
  const geo::Pose b = poseAfter(start, piece, to);
  geo::Box box;
  box.add(a.point());
  box.add(b.point());
  if (piece.turn == Turn::Straight) {
    return box;
  }
  const double side = static_cast<double>(static_cast<int>(piece.turn));
  const double centreX = start.x - side * piece.radius * std::sin(start.heading);
  const double centreY = start.y + side * piece.radius * std::cos(start.heading);
  // Angle of the radius vector to the curve, and how far it sweeps; an extreme lies at every multiple of 90 degrees.
  constexpr double quarter = Angle::kPi / 2.0;
  const double first = start.heading - side * quarter + side * from / piece.radius;
  const double last = first + side * (to - from) / piece.radius;
  const double low = std::min(first, last);
  const double high = std::max(first, last);
  for (double k = std::ceil(low / quarter); k * quarter <= high; k += 1.0) {
    box.add({centreX + piece.radius * std::cos(k * quarter), centreY + piece.radius * std::sin(k * quarter)});
  }
  return box;
}

std::vector<geo::Pose> sample(const Curve& curve, double step, double airspeed) {
  std::vector<geo::Pose> poses{curve.start};
  double offset = 0.0;
  for (const Piece& piece : curve.pieces) {
    const int parts = std::max(1, static_cast<int>(std::ceil(piece.length / step)));
    for (int i = 1; i <= parts; ++i) {
      poses.push_back(poseAlong(curve, offset + piece.length * i / parts, airspeed));
    }
    offset += piece.length;
  }
  return poses;
}

}  // namespace vp::flight
