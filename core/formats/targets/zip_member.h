#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

namespace vp::formats {

/** The first member of a zip archive whose name ends so (case does not matter), unpacked; names are only compared, never used as
 *  paths. Stored and deflated members are read, none beyond kMostXmlBytes unpacked, whatever the archive says of their size.
 *  @errors BadFile - damaged, cut short, encrypted, no such member, too large   @source PKWARE APPNOTE 6.3.3 */
Result<std::string> zipMember(const std::string& path, std::string_view archive, std::string_view ending);

}  // namespace vp::formats
