#pragma once

#include "core/base/result.h"

#include <string>

namespace vp::fetch {

/** $XDG_CACHE_HOME/volplane, else ~/.cache/volplane. @errors OutputFailed - the environment names neither
 *  @source XDG Base Directory Specification 0.8 */
Result<std::string> cacheFolder();

/** Where the files of a server lie in a cache: CACHE/WHAT/SERVER. Each server has its own, so that a test server never feeds a mission. */
std::string folderOfServer(const std::string& cache, const std::string& what, const std::string& base);

/** The address without the slashes at its end. @errors OutOfRange - neither http:// nor https:// */
Result<std::string> checkedBase(const std::string& base);

/** Value of an environment variable, or `otherwise`. */
std::string fromEnvironment(const char* variable, const std::string& otherwise);

}  // namespace vp::fetch
