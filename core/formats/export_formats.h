#pragma once

#include "core/base/result.h"
#include "core/mission/plan.h"

#include <functional>
#include <string>
#include <vector>

namespace vp::formats {

/** A form that a plan can be handed on in. */
struct ExportFormat {
  std::string name;       ///< as on the command line: "fms"
  std::string extension;  ///< of its files, without the dot
  std::string what;       ///< in words
  std::string loses;      ///< what does not survive, to be told before it is written; may be empty
  std::function<Result<std::string>(const mission::Plan&)> write;
};

/** All of them, in the order of menus and help. */
const std::vector<ExportFormat>& exportFormats();

}  // namespace vp::formats
