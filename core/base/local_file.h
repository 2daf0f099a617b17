#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>

namespace vp {

/** What a name leads to, symbolic links followed. */
enum class FileKind {
  Missing,
  Folder,
  Ordinary,  ///< a file with bytes that stay where they are
  Special,   ///< a device, pipe or socket, or one that the operating system makes up while it is read (/proc, /sys)
  Remote,    ///< an address (http://...) or a virtual name that GDAL would resolve (/vsicurl/...)
};

FileKind kindOfFile(const std::string& path);

/** The one rule of what may be read because a file, perhaps a mission from the mail, names it: an ordinary file of this computer that is not
 *  too large. Every reader asks here before it opens anything; nothing is opened.
 *  @param most  bytes
 *  @errors BadFile - anything else, with what it is instead   @threads pure but for the file system */
Result<void> checkLocalFile(const std::string& path, std::uint64_t most);

}  // namespace vp
