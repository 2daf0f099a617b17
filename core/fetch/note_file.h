#pragma once

#include "core/base/result.h"

#include <map>
#include <string>

namespace vp::fetch {

/// What is noted beside a fetched file: "key: value" lines, readable by people.
using Notes = std::map<std::string, std::string>;

/** Nothing if the file is missing or no such text. */
Notes readNotes(const std::string& path);

/** @errors OutputFailed */
Result<void> writeNotes(const std::string& path, const Notes& notes);

/** The moment now as "2026-05-07T09:30:00Z". */
std::string timeNow();

}  // namespace vp::fetch
