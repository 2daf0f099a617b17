#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vp {

/** Text from a file as it may stand in a sentence, on a terminal or in a window: control characters become blanks, what is no UTF-8 becomes
 *  U+FFFD, and what is longer than `most` bytes is cut between two characters and ends in "...".   @threads pure */
std::string plainText(std::string_view text, std::size_t most = std::string_view::npos);

}  // namespace vp
