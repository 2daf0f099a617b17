#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace vp::formats::exports {

/** A name under /vsimem/ that nothing else uses, with this ending. */
std::string memoryFileName(const std::string& ending);

/** The bytes of such a file, which is deleted.  @errors OutputFailed */
Result<std::string> takeMemoryFile(const std::string& name);

/** A zip archive with one file.  @errors OutputFailed */
Result<std::string> zipped(const std::string& name, std::string_view bytes);

}  // namespace vp::formats::exports
