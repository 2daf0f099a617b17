#include "core/aircraft/course_loss.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace vp::aircraft {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// What the checker's own bound may lie above the true one, and rounding [relative].
constexpr double kSlack = 1.0 + 2e-5;

/// A course this little outside a sector's opposite counts as inside, against rounding [cosine].
constexpr double kDirectionSlack = 1e-12;

/// Parts of a sector overlap by this share, so that rounding leaves no gap between them.
constexpr double kPartOverlap = 1e-9;

/// sqrt(1 - x^2), zero beyond.
double besides(double x) {
  return std::sqrt(std::max(0.0, 1.0 - x * x));
}

/// A sector seen from a course: the angles between them that occur, in [0, pi], and the speeds.
struct Bearing {
  double nearest = 0.0;   ///< rad; 0: the wind may blow along the course
  double farthest = 0.0;  ///< rad; pi: it may blow straight against it
  double leastSpeed = 0.0;
  double mostSpeed = 0.0;
};

Bearing bearingOf(const air::WindSector& sector, double course, double halfRange) {
  const double off = std::abs(wrapPi(sector.towards() - course));
  const double around = sector.spread() + halfRange;
  return {std::max(0.0, off - around), std::min(Angle::kPi, off + around), sector.leastSpeed, sector.mostSpeed};
}

/// Greatest part of the wind along the course.
double mostAlong(const Bearing& b) {
  const double cosine = std::cos(b.nearest);
  return (cosine > 0.0 ? b.mostSpeed : b.leastSpeed) * cosine;
}

/** Upper bound of u^2 / cos(eta): the lateral acceleration of a turn over ground, times its radius. WHY.md, "Turns over ground". */
double mostLateral(double airspeed, std::span<const air::WindSector> winds, double course, double halfRange) {
  if (winds.size() == 1) {
    const Bearing b = bearingOf(winds.front(), course, halfRange);
    const double along = b.mostSpeed * std::cos(b.nearest);
    const double sine = std::sin(b.nearest) / airspeed;
    const double cosEta = besides(b.mostSpeed * sine);
    return cosEta > 0.0 ? airspeed * airspeed * besides(b.leastSpeed * sine) + 2.0 * airspeed * mostAlong(b) + along * along / cosEta : kInfinite;
  }
  double along = -kInfinite;
  double across = 0.0;
  for (const air::WindSector& sector : winds) {
    const Bearing b = bearingOf(sector, course, halfRange);
    along = std::max(along, mostAlong(b));
    const bool isBeside = b.nearest <= 0.5 * Angle::kPi && b.farthest >= 0.5 * Angle::kPi;
    across = std::max(across, b.mostSpeed * (isBeside ? 1.0 : std::max(std::sin(b.nearest), std::sin(b.farthest))));
  }
  const double cosEta = besides(across / airspeed);
  return cosEta > 0.0 ? airspeed * airspeed + 2.0 * airspeed * along + along * along / cosEta : kInfinite;
}

/// Least ground speed at a horizontal airspeed; below zero where the wind is too strong.
double slowest(double horizontal, std::span<const air::WindSector> winds, double course, double halfRange) {
  double least = kInfinite;
  for (const air::WindSector& sector : winds) {
    const Bearing b = bearingOf(sector, course, halfRange);
    for (const double speed : {b.leastSpeed, b.mostSpeed}) {
      if (speed >= horizontal) {
        return -1.0;
      }
      const double across = speed * std::sin(b.farthest);
      least = std::min(least, std::sqrt(horizontal * horizontal - across * across) + speed * std::cos(b.farthest));
    }
  }
  return least;
}

/// A sector cut into parts so narrow that the greatest bank and the least ground speed of each nearly belong to one wind.
std::vector<air::WindSector> partsOf(const air::WindSector& sector) {
  constexpr double kSpeedPart = 1.0;   // m/s
  constexpr double kSpreadPart = 5.0;  // degrees to each side
  constexpr int kMost = 12;
  const int speeds = std::clamp(static_cast<int>(std::ceil((sector.mostSpeed - sector.leastSpeed) / kSpeedPart)), 1, kMost);
  const int directions = std::clamp(static_cast<int>(std::ceil(sector.spread_deg / kSpreadPart)), 1, kMost);
  const double speed = (sector.mostSpeed - sector.leastSpeed) / speeds;
  const double spread = sector.spread_deg / directions;
  std::vector<air::WindSector> parts;
  for (int i = 0; i < speeds; ++i) {
    for (int k = 0; k < directions; ++k) {
      air::WindSector part = sector;
      part.from_deg = sector.from_deg - sector.spread_deg + (2 * k + 1) * spread;
      part.spread_deg = directions > 1 ? spread * (1.0 + kPartOverlap) : spread;
      part.leastSpeed = sector.leastSpeed + i * speed;
      part.mostSpeed = i + 1 < speeds ? sector.leastSpeed + (i + 1) * speed : sector.mostSpeed;
      parts.push_back(part);
    }
  }
  return parts;
}

}  // namespace

CourseLoss::CourseLoss(const GlidePolar& polar, std::vector<air::WindSector> winds, double radius, const std::vector<const CourseLoss*>& within)
    : polar_(polar), winds_(std::move(winds)), radius_(radius), cellsPerRadian_(kCells / (2.0 * Angle::kPi)) {
  VP_EXPECT(!winds_.empty() && radius > 0.0 && polar.airspeed > 0.0 && polar.shear >= 0.0);
  double sinEta = 0.0;
  for (const air::WindSector& wind : winds_) {
    sinEta = std::max(sinEta, wind.mostSpeed / polar_.airspeed);
  }
  shearLoad_ = sinEta < 1.0 ? polar_.shear * sinEta / besides(sinEta) : 0.0;  // else no course can be held
  findCorners();
  tabulate(within);
}

/** Upper bound of sin(gamma) at a tangent of bank over ground; 1 where there is none. WHY.md, "Shear". */
double CourseLoss::sinGammaAt(double bank) const {
  const auto steady = [this](double tangent) { return polar_.parasite + polar_.induced * (1.0 + tangent * tangent); };
  const double still = steady(bank);
  if (polar_.shear == 0.0) {
    return still;
  }
  if (!(polar_.shear < 1.0)) {
    return 1.0;
  }
  const double sheared = steady(bank + shearLoad_ * 2.0 * still) / (1.0 - polar_.shear);
  return steady(bank + shearLoad_ * sheared) / (1.0 - polar_.shear) <= sheared ? sheared : 1.0;
}

double CourseLoss::worstRate(std::span<const air::WindSector> winds, double course, double halfRange, bool inTurn) const {
  const double bank = inTurn ? mostLateral(polar_.airspeed, winds, course, halfRange) / (kGravity.si() * radius_) : 0.0;
  const double sinGamma = sinGammaAt(bank);
  if (!(sinGamma < 1.0)) {
    return kInfinite;
  }
  const double ground = slowest(polar_.airspeed * besides(sinGamma), winds, course, halfRange);
  return ground > 0.0 ? polar_.airspeed * sinGamma / ground * kSlack : kInfinite;
}

double CourseLoss::worstTurn(const std::vector<air::WindSector>& parts, double course, double halfRange) const {
  if (winds_.size() > 1) {
    return worstRate(winds_, course, halfRange, true);
  }
  double worst = 0.0;
  for (const air::WindSector& part : parts) {
    worst = std::max(worst, worstRate({&part, 1}, course, halfRange, true));
  }
  return worst;
}

double CourseLoss::straightRate(double east, double north) const {
  double ground = kInfinite;
  for (const Corner& wind : corners_) {
    const double along = wind.east * east + wind.north * north;
    const double across = wind.east * north - wind.north * east;
    ground = std::min(ground, std::sqrt(std::max(0.0, straightSquare_ - across * across)) + along);
  }
  for (const Opposed& sector : opposed_) {
    if (-(sector.east * east + sector.north * north) >= sector.cosSpread) {
      ground = std::min(ground, std::sqrt(straightSquare_) - sector.speed);
    }
  }
  return ground > 0.0 ? straightSink_ / ground * kSlack : kInfinite;
}

double CourseLoss::mostInTurn(double from, double turned) const {
  const double begin = std::min(from, from + turned) * cellsPerRadian_;
  const double end = std::max(from, from + turned) * cellsPerRadian_;
  const double first = std::floor(begin);
  const auto count = static_cast<int>(std::min(std::floor(end) - first + 1.0, static_cast<double>(kCells)));
  auto cell = static_cast<int>(first - std::floor(first / kCells) * kCells);
  double most = 0.0;
  for (int i = 0; i < count; ++i) {
    most = std::max(most, rate_[static_cast<std::size_t>(cell)]);
    cell = cell + 1 < kCells ? cell + 1 : 0;
  }
  return most;
}

void CourseLoss::findCorners() {
  const double sinGamma = sinGammaAt(0.0);
  const double horizontal = polar_.airspeed * besides(sinGamma);
  straightSink_ = sinGamma < 1.0 ? polar_.airspeed * sinGamma : kInfinite;
  straightSquare_ = horizontal * horizontal;
  for (const air::WindSector& sector : winds_) {
    if (sector.mostSpeed >= horizontal) {  // no course can be held whatever blows
      straightSink_ = kInfinite;
    }
    for (const double direction : {sector.towards() - sector.spread(), sector.towards() + sector.spread()}) {
      for (const double speed : {sector.leastSpeed, sector.mostSpeed}) {
        const Corner corner{speed * std::cos(direction), speed * std::sin(direction)};
        const auto isSame = [&](const Corner& other) { return other.east == corner.east && other.north == corner.north; };
        if (std::none_of(corners_.begin(), corners_.end(), isSame)) {
          corners_.push_back(corner);
        }
      }
    }
    if (sector.spread_deg > 0.0) {
      opposed_.push_back({std::cos(sector.towards()), std::sin(sector.towards()), std::cos(sector.spread()) - kDirectionSlack, sector.mostSpeed});
    }
  }
}

void CourseLoss::tabulate(const std::vector<const CourseLoss*>& within) {
  const double half = 0.5 / cellsPerRadian_;
  double strongest = 0.0;
  leastStraight_ = leastTurn_ = leastExcess_ = kInfinite;
  for (const air::WindSector& sector : winds_) {
    strongest = std::max(strongest, sector.mostSpeed);
  }
  const std::vector<air::WindSector> parts = partsOf(winds_.front());
  for (int i = 0; i < kCells; ++i) {
    const double course = (i + 0.5) / cellsPerRadian_;
    double inTurn = worstTurn(parts, course, half);
    for (const CourseLoss* part : within) {
      inTurn = std::max(inTurn, part->rate_[static_cast<std::size_t>(i)]);
    }
    rate_.push_back(inTurn);
    perCell_.push_back(inTurn * radius_ / cellsPerRadian_);
    cumulative_.push_back(total_);
    total_ += perCell_.back();
    const double straight = worstRate(winds_, course, half, false);
    mostStraight_ = std::max(mostStraight_, straight);
    mostTurn_ = std::max(mostTurn_, inTurn);
    leastTurn_ = std::min(leastTurn_, inTurn);
    leastStraight_ = std::min(leastStraight_, straightRate(std::cos(course), std::sin(course)));
    leastExcess_ = std::min(leastExcess_, inTurn - straight);
  }
  // between the courses looked at, each half a cell away, ln(rate) changes by tan(eta) per radian at most
  const double sinEta = strongest / std::sqrt(straightSquare_);
  leastStraight_ *= sinEta < 1.0 ? 1.0 - std::min(1.0, half * sinEta / besides(sinEta)) : 0.0;
  leastExcess_ = std::max(0.0, leastExcess_);
}

}  // namespace vp::aircraft
