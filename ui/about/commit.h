#pragma once

#include <string_view>

namespace vp::about {

/** The commit that the program was built from, as `git describe --always --dirty` says it; "unknown" where neither git nor
 *  the archive tells. The build writes its source file (packaging/cmake/WriteCommit.cmake). */
std::string_view builtCommit();

}  // namespace vp::about
