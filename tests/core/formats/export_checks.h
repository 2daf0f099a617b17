#pragma once
// Strict checkers of exported files, written from the rules of each format and not from the writers.

#include <string>
#include <vector>

namespace vp::formats::checks {

/** A place as a file gives it. */
struct ReadPoint {
  std::string name;
  double latitude = 0.0;
  double longitude = 0.0;
  double feet = 0.0;  ///< 0 where the format has none
};

struct Checked {
  std::string fault;              ///< the rule that is broken; empty if none is
  std::vector<ReadPoint> points;  ///< in flying order
};

/** @param format  name of an ExportFormat */
Checked check(const std::string& format, const std::string& bytes);

}  // namespace vp::formats::checks
