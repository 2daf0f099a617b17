#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace vp::formats {

/** How unpacking ended. */
enum class Inflation { Done, Damaged, TooLarge, NoMemory };

/** What the packed bytes are. */
enum class Packing {
  Gzip,  ///< one or more members, which are one file
  Raw,   ///< deflate without a header, as in zip archives, which keep the sizes themselves
};

/** Unpacks to at most `most` bytes, which stand in `text` even where it ends early. @source RFC 1951, 1952, by zlib */
Inflation inflateBytes(std::string_view packed, Packing packing, std::size_t most, std::string& text);

}  // namespace vp::formats
