#include "core/route/track.h"

#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::route {
namespace {

constexpr double kChord = 5.0;           // m; 0.05 m beside an arc of 65 m radius
constexpr double kWindowBack = 150.0;    // m, a follower looks back
constexpr double kWindowOnward = 300.0;  // m, and onward

void append(Track& track, const geo::Pose& start, const flight::Piece& piece) {
  const double chord = piece.turn == flight::Turn::Straight ? 10.0 * kChord : std::min(kChord, std::sqrt(8.0 * kTrackError * piece.radius));
  const int parts = std::max(1, static_cast<int>(std::ceil(piece.length / chord)));
  const double from = track.distance.back();
  for (int i = 1; i <= parts; ++i) {
    const double length = piece.length * i / parts;
    track.points.push_back(flight::poseAfter(start, piece, length).point());
    track.distance.push_back(from + length);
  }
}

/// The way from a decision point to the next, with altitude.
void appendInterval(const mission::DecisionPoint& from, const mission::DecisionPoint& to, Track& track) {
  const double begin = track.distance.back();
  append(track, from.pose, from.onward);
  while (track.altitude.size() < track.points.size()) {
    const double done = from.onward.length > 0.0 ? (track.distance[track.altitude.size()] - begin) / from.onward.length : 1.0;
    track.altitude.push_back(from.altitude + done * (to.altitude - from.altitude));
  }
}

}  // namespace

Track trackOf(const geo::Pose& start, std::span<const flight::Piece> pieces) {
  Track track;
  track.points.push_back(start.point());
  track.distance.push_back(0.0);
  geo::Pose pose = start;
  for (const flight::Piece& piece : pieces) {
    append(track, pose, piece);
    pose = flight::endOf(pose, piece);
  }
  return track;
}

Track trackOfTour(const mission::Plan& plan, std::size_t first) {
  const std::size_t count = plan.tour.size();
  Track track;
  track.points.push_back(plan.tour[first].pose.point());
  track.distance.push_back(0.0);
  track.altitude.push_back(plan.tour[first].altitude);
  for (std::size_t i = 0; i < count; ++i) {
    const mission::DecisionPoint& from = plan.tour[(first + i) % count];
    const mission::DecisionPoint& to = plan.tour[(first + i + 1) % count];
    appendInterval(from, to, track);
  }
  return track;
}

Track trackOfWay(const std::vector<mission::DecisionPoint>& way) {
  Track track;
  track.isClosed = false;
  track.points.push_back(way.front().pose.point());
  track.distance.push_back(0.0);
  track.altitude.push_back(way.front().altitude);
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    appendInterval(way[i], way[i + 1], track);
  }
  return track;
}

Follower::Follower(const Track& track, double start) : track_(track) {
  moveTo(start);
}

void Follower::moveTo(double distance) {
  const auto after = std::upper_bound(track_.distance.begin() + 1, track_.distance.end() - 1, distance);
  at_ = static_cast<std::size_t>(after - track_.distance.begin()) - 1;
}

Beside Follower::next(geo::Point point) {
  const std::size_t chords = track_.points.size() - 1;
  Beside best{0.0, std::numeric_limits<double>::infinity()};
  std::size_t found = at_;
  const auto look = [&](std::size_t i) {
    const geo::Point a = track_.points[i];
    const geo::Point b = track_.points[i + 1];
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double t = square > 0.0 ? std::clamp(((point.x - a.x) * dx + (point.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
    const double aside = std::hypot(a.x + t * dx - point.x, a.y + t * dy - point.y);
    if (aside < best.aside) {
      best = {track_.distance[i] + t * (track_.distance[i + 1] - track_.distance[i]), aside};
      found = i;
    }
  };
  double covered = 0.0;
  std::size_t i = at_;
  while (covered < kWindowBack && covered < track_.length() && (track_.isClosed || i > 0)) {
    i = (i + chords - 1) % chords;
    covered += track_.distance[i + 1] - track_.distance[i];
  }
  for (double window = covered + kWindowOnward, seen = 0.0; seen < window && seen < track_.length(); i = (i + 1) % chords) {
    look(i);
    seen += track_.distance[i + 1] - track_.distance[i];
    if (!track_.isClosed && i + 1 == chords) {
      break;
    }
  }
  at_ = found;
  return best;
}

double altitudeOn(const Track& track, double distance) {
  const auto next = std::upper_bound(track.distance.begin() + 1, track.distance.end() - 1, distance);
  const auto b = static_cast<std::size_t>(next - track.distance.begin());
  const double span = track.distance[b] - track.distance[b - 1];
  const double t = span > 0.0 ? std::clamp((distance - track.distance[b - 1]) / span, 0.0, 1.0) : 0.0;
  return track.altitude[b - 1] + t * (track.altitude[b] - track.altitude[b - 1]);
}

}  // namespace vp::route
