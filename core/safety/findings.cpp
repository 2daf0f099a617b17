#include "core/safety/findings.h"

#include "core/safety/limits.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::safety {

void Findings::violated(const char* rule, std::string text, FindingPlace place, std::optional<double> margin) {
  add(Severity::Violated, rule, std::move(text), place, margin);
}

void Findings::unknown(const char* rule, std::string text, FindingPlace place) {
  add(Severity::Unknown, rule, std::move(text), place, {});
}

void Findings::warning(const char* rule, std::string text, FindingPlace place) {
  add(Severity::Warning, rule, std::move(text), place, {});
}

void Findings::note(const char* rule, std::string text, FindingPlace place) {
  add(Severity::Note, rule, std::move(text), place, {});
}

void Findings::add(Severity severity, const char* rule, std::string text, const FindingPlace& place, std::optional<double> margin) {
  clean_ = clean_ && severity != Severity::Violated && severity != Severity::Unknown;
  Count& count = counts_[rule];
  count.worst = std::max(count.worst, severity);
  if (++count.all > kMostPerRule) {
    return;
  }
  Finding finding;
  finding.severity = severity;
  finding.rule = rule;
  finding.text = std::move(text);
  finding.tourPoint = place.tourPoint;
  finding.margin = margin;
  if (place.point && std::abs(place.point->x) <= 2.0 * kFarthest && std::abs(place.point->y) <= 2.0 * kFarthest) {
    finding.where = frame_.toLatLon(*place.point);
  }
  findings_.push_back(std::move(finding));
}

std::vector<Finding> Findings::finish() const {
  std::vector<Finding> all = findings_;
  for (const auto& [rule, count] : counts_) {
    if (count.all > kMostPerRule) {
      Finding rest;
      rest.severity = count.worst;
      rest.rule = rule;
      rest.text = fmt::format("{} more findings of rule {} are not listed, {} in all", count.all - kMostPerRule, rule, count.all);
      all.push_back(std::move(rest));
    }
  }
  return all;
}

std::vector<mission::Margin> Margins::finish(const geo::LocalFrame& frame) const {
  static constexpr std::array<const char*, 10> kNames = {"tour.clearance", "tour.glide",   "glide.clearance", "glide.arrival",    "tour.climb",
                                                         "tour.descent",   "tour.ceiling", "target.height",   "spiral.clearance", "glide.dynamics"};
  std::vector<mission::Margin> margins;
  for (std::size_t i = 0; i < least_.size(); ++i) {
    const Least& least = least_[i];
    if (least.value >= 1e300) {
      continue;
    }
    const auto kind = static_cast<MarginKind>(i);
    const bool isAngle = kind == MarginKind::TourClimb || kind == MarginKind::TourDescent;
    const double tolerance = isAngle ? 0.0 : kind == MarginKind::TargetHeight ? kClaimTolerance : kAltitudeTolerance;
    const double value = least.value < 0.0 && least.value >= -tolerance ? 0.0 : least.value;
    margins.push_back({kNames[i], value, isAngle ? "deg" : "m", frame.toLatLon(least.where)});
  }
  return margins;
}

}  // namespace vp::safety
