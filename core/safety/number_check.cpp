#include "core/safety/number_check.h"

#include "core/safety/rules.h"

#include <fmt/core.h>

namespace vp::safety {

void NumberCheck::within(std::string_view name, double value, double low, double high) {
  if (!(value >= low && value <= high)) {  // also false for NaN
    context_.findings.violated(rule::kPlanNumber, fmt::format("{}: {} is {}, must be between {} and {}", part_, name, value, low, high),
                               {tourPoint_, {}});
  }
}

}  // namespace vp::safety
