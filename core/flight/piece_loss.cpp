#include "core/flight/piece_loss.h"

#include "core/aircraft/glide_bands.h"
#include "core/flight/curve_sampling.h"

#include <algorithm>
#include <cmath>

namespace vp::flight {

namespace {

/// Passes what a piece loses to `use`.
template <typename Use>
double withLoss(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece, Use use) {
  const double radius = piece.turn == Turn::Straight ? model.tourRadius() : piece.radius;
  const std::shared_ptr<const aircraft::CourseLoss> byCourse = model.courseLoss(radius);
  return use(PieceLoss(piece, start.heading, {model.straightLoss(), model.lossAt(radius), byCourse.get()}));
}

/// Metres along a piece on which that much height is lost, at least. @param most  on which it is surely lost
double lengthOfLoss(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece, double height, double most) {
  return withLoss(model, start, piece, [&](const PieceLoss& loss) {
    double low = 0.0;
    double high = most;
    for (int halving = 0; halving < 50 && low < high; ++halving) {
      const double middle = 0.5 * (low + high);
      (loss.upTo(middle) < height ? low : high) = middle;
    }
    return low;
  });
}

}  // namespace

std::vector<TurnLoss> bandLossesOf(const aircraft::GlideModel& model, std::size_t radius) {
  const aircraft::GlideBands* const bands = model.bands();
  if (bands == nullptr) {
    return {turnLossAt(model, radius)};
  }
  std::vector<TurnLoss> losses;
  for (std::size_t band = 0; band < bands->count(); ++band) {
    losses.push_back(turnLossAt(bands->between(band, band), radius));
  }
  return losses;
}

double lossUpTo(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece, double length) {
  return withLoss(model, start, piece, [length](const PieceLoss& loss) { return loss.upTo(length); });
}

double mostLossOver(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece) {
  return withLoss(model, start, piece, [&](const PieceLoss& loss) { return loss.mostPerMetre(piece.length) * piece.length; });
}

double mostHeightBefore(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece, double end, double lostAtOnce) {
  if (model.bands() == nullptr) {
    return end + mostLossOver(model, start, piece);
  }
  const auto needed = [&](const aircraft::GlideModel& cover, double low, double /*giveUpAbove*/) {
    return low + lostAtOnce + mostLossOver(cover, start, piece);
  };
  return aircraft::leastStart(model, end - lostAtOnce, needed);
}

double heightAlong(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece, double altitude, double length) {
  const aircraft::GlideBands* const bands = model.bands();
  if (bands == nullptr || !std::isfinite(altitude)) {
    return altitude - lossUpTo(model, start, piece, length);
  }
  double flown = 0.0;
  for (std::size_t band = bands->below(altitude);; --band) {
    const aircraft::GlideModel& losses = bands->between(band, band);
    const geo::Pose from = poseAfter(start, piece, flown);
    const double left = length - flown;
    const double end = altitude - lossUpTo(losses, from, piece, left);
    if (band == 0 || end >= bands->bottom(band)) {
      return end;
    }
    flown += lengthOfLoss(losses, from, piece, altitude - bands->bottom(band), left);
    altitude = bands->bottom(band);
  }
}

double cruiseSeconds(double airspeed, air::Wind wind, const geo::Pose& start, const Piece& piece, double rise) {
  const double flown = std::hypot(piece.length, rise);
  if (wind.isCalm() || piece.length <= 0.0) {
    return flown / airspeed;
  }
  constexpr double kPart = 0.1;  // rad: Simpson's rule over these errs by less than 1e-6 of the time
  const double turned = piece.turn == Turn::Straight ? 0.0 : static_cast<double>(static_cast<int>(piece.turn)) * piece.length / piece.radius;
  const int parts = 2 * std::max(1, static_cast<int>(std::ceil(0.5 * std::abs(turned) / kPart)));
  double sum = 0.0;
  for (int i = 0; i <= parts; ++i) {
    const double weight = i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight / air::groundSpeed(airspeed, wind, start.heading + turned * i / parts);
  }
  return flown * sum / (3.0 * parts);
}

double glideSeconds(const aircraft::GlideModel& model, const geo::Pose& start, const Piece& piece) {
  const double still = model.lossAt(piece.turn == Turn::Straight ? 0.0 : piece.radius);
  // the way through the air: in wind, as far as it takes to lose the height at the still-air rate
  const double length = model.isCalm() ? piece.length : lossUpTo(model, start, piece, piece.length) / still;
  return length * std::hypot(1.0, still) / model.airspeed();
}

std::vector<double> lossesOf(const aircraft::GlideModel& model, const geo::Pose& start, const std::vector<Piece>& pieces) {
  std::vector<double> losses;
  geo::Pose pose = start;
  for (const Piece& piece : pieces) {
    losses.push_back(lossUpTo(model, pose, piece, piece.length));
    pose = endOf(pose, piece);
  }
  return losses;
}

}  // namespace vp::flight
