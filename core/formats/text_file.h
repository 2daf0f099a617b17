#pragma once

#include "core/base/result.h"
#include "core/formats/limits.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace vp::formats {

/** The bytes of a file; a gzip file is unpacked (by its first bytes, not its name).
 *  @param most  bytes, unpacked   @errors BadFile - no ordinary file of this computer (core/base/local_file.h), unreadable, too large, a damaged or
 *  truncated gzip */
Result<std::string> readFile(const std::string& path, std::size_t most = kMostFileBytes);

/** The same as text in UTF-8: a byte order mark is dropped, and bytes that are no UTF-8 are taken as Windows-1252;
 *  control characters other than tabs and line ends become blanks.
 *  @errors as readFile; BadFormat - UTF-16 or binary content */
Result<std::string> readText(const std::string& path, std::size_t most = kMostTextBytes);

/** The first bytes of a file, unpacked if it is gzip: enough to tell what it is without reading all of it.
 *  @errors BadFile */
Result<std::string> readStart(const std::string& path, std::size_t bytes);

bool isUtf8(std::string_view bytes);

/** Windows-1252 (of which Latin-1's printable part is a subset) as UTF-8. */
std::string fromWindows1252(std::string_view bytes);

/** The last part of a path, for messages and LandingSite::source. */
std::string fileName(const std::string& path);

}  // namespace vp::formats
