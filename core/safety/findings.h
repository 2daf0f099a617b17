#pragma once

#include "core/geo/local_frame.h"
#include "core/mission/plan.h"
#include "core/safety/checker.h"

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vp::safety {

/** Where a finding is: a decision point, a place, both or neither. */
struct FindingPlace {
  int tourPoint = -1;
  std::optional<geo::Point> point;
};

/** Collects findings. Of one rule the first kMostPerRule are kept; finish() adds one that counts the rest. */
class Findings {
public:
  static constexpr std::int64_t kMostPerRule = 20;

  explicit Findings(geo::LocalFrame frame) : frame_(frame) {}

  void violated(const char* rule, std::string text, FindingPlace place = {}, std::optional<double> margin = {});
  void unknown(const char* rule, std::string text, FindingPlace place = {});
  void warning(const char* rule, std::string text, FindingPlace place = {});
  void note(const char* rule, std::string text, FindingPlace place = {});

  /** True as long as nothing is violated or unknown. */
  [[nodiscard]] bool isClean() const { return clean_; }

  /** All findings in the order found, with the counts of those left out. */
  [[nodiscard]] std::vector<Finding> finish() const;

private:
  void add(Severity severity, const char* rule, std::string text, const FindingPlace& place, std::optional<double> margin);

  struct Count {
    std::int64_t all = 0;
    Severity worst = Severity::Note;
  };
  geo::LocalFrame frame_;
  std::vector<Finding> findings_;
  std::map<std::string, Count> counts_;
  bool clean_ = true;
};

enum class MarginKind {
  TourClearance,
  TourGlide,
  GlideClearance,
  GlideArrival,
  TourClimb,
  TourDescent,
  TourCeiling,
  TargetHeight,
  SpiralClearance,
  GlideDynamics
};

/** The least margin of each kind: what is left beyond the requirement, and where. */
class Margins {
public:
  void note(MarginKind kind, double value, geo::Point where) {
    Least& least = least_[static_cast<std::size_t>(kind)];
    if (value < least.value) {
      least = {value, where};
    }
  }
  /** Kinds that were noted at least once. Values within the altitude tolerance below zero are given as zero. */
  [[nodiscard]] std::vector<mission::Margin> finish(const geo::LocalFrame& frame) const;

private:
  struct Least {
    double value = 1e300;
    geo::Point where;
  };
  std::array<Least, 10> least_;
};

}  // namespace vp::safety
