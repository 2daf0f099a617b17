#include "core/audit/roll_account.h"

#include <algorithm>
#include <cmath>

namespace vp::audit {
namespace {

constexpr double kGravity = 9.80665;  // m/s^2, standard gravity
constexpr double kRightAngle = 1.5707963267948966;
constexpr double kMostBank = 1.5;   // rad: nothing flies beyond
constexpr double kTime = 0.01;      // s, steps of a roll
constexpr double kIntoBrief = 1.5;  // of the roll's time: late by half of it

}  // namespace

double RollAccount::costOf(double angle, double steepest, double height) const {
  return std::abs(angle) / rate_ * motion_.sinkRate(std::tan(std::min(std::abs(steepest), kMostBank)), height);
}

/// Bank up to which an aircraft can roll that has to be level again when its nose has turned so far.
double RollAccount::reachedWithin(double turned, double height) const {
  const double speed = motion_.airspeed(height);
  double bank = 0.0;
  for (double nose = 0.0; 2.0 * nose < turned && bank < kMostBank;) {
    bank += rate_ * kTime;
    nose += kGravity * std::tan(bank - 0.5 * rate_ * kTime) / speed * kTime;
  }
  return bank;
}

void RollAccount::rollInto(const Bend& bend, bool isAlone, double bank, double speed, double height) {
  Flown next{bank, {}};
  if (bend.side != 0 && isAlone && bend.turned <= kRightAngle) {
    const double time = bend.length / speed;
    const double nose = kGravity * std::tan(std::abs(bank)) / motion_.airspeed(height) * time;
    const double reached = reachedWithin(nose, height);
    if (kIntoBrief * costOf(reached, reached, height) < costOf(bank, bank, height)) {
      next.brief = reached;
    }
  }
  if (!before_.brief && !next.brief) {
    const bool isSameSide = before_.bank * bank > 0.0;
    const double angle = isSameSide ? before_.bank - bank : std::abs(before_.bank) + std::abs(bank);
    lost_ += costOf(angle, std::max(std::abs(before_.bank), std::abs(bank)), height);
  } else {
    const double out = before_.brief.value_or(before_.bank);
    const double in = next.brief.value_or(bank);
    lost_ += costOf(out, out, height) + (next.brief ? kIntoBrief : 1.0) * costOf(in, in, height);
  }
  before_ = next;
}

}  // namespace vp::audit
