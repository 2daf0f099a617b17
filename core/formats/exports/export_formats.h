#pragma once

#include "core/base/result.h"
#include "core/formats/exports/export_input.h"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace vp::formats {

/** A form that a plan can be handed on in. */
struct ExportFormat {
  std::string name;             ///< as on the command line: "fms"
  std::string extension;        ///< of its files, without the dot
  std::string what;             ///< in words
  std::string loses;            ///< what does not survive, to be told before it is written; may be empty
  double stepsPerDegree = 1e6;  ///< what it can say of a place: whole multiples of 1 / so many degrees
  std::size_t mostPoints = 0;   ///< that it takes in one file; 0: no limit
  std::function<Result<std::string>(const ExportInput&)> write;
  bool holdsMark = true;  ///< whether its files can say that a route is unverified: Route::mark
};

/** All of them, in the order of menus and help. */
const std::vector<ExportFormat>& exportFormats();

/** The one of that name, or null. */
const ExportFormat* findExportFormat(const std::string& name);

}  // namespace vp::formats
