#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace vp::formats {

/** Puts `bytes` into a file so that at every moment the path holds the old content or the new one, whole: a temporary
 *  file in the same folder (temporary_file.h) is written, flushed to the disk and renamed. Permissions of an existing file are
 *  kept, symbolic links are followed. A device or pipe is written directly.
 *  @errors OutputFailed - no such folder, no permission, disk full, a folder in the way; nothing is left behind */
Result<void> writeFileAtomically(const std::string& path, std::string_view bytes);

struct FileToWrite {
  std::string path;
  std::string_view bytes;
};

/** Several files that belong together: all are written beside their places and flushed before the first appears, so a full
 *  disk or a missing permission leaves every path as it was. A process killed between two of them leaves each path with its
 *  old or its new file, whole. @errors as writeFileAtomically() */
Result<void> writeFilesAtomically(const std::vector<FileToWrite>& files);

/** Why the system refused to write, and what to do about it, for the end of a sentence. @param code  as in errno */
std::string writeFailureReason(int code);

}  // namespace vp::formats
