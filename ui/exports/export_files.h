#pragma once

#include "core/base/result.h"
#include "ui/exports/prepare_export.h"

#include <string>
#include <vector>

namespace vp::exports {

/// The pattern of names unless another is asked for.
inline constexpr const char* kNamePattern = "{mission}";

/** A name for a file: {mission}, {format} and {part} of the pattern replaced, what a file name cannot hold as '-', the part
 *  appended where the pattern leaves it out, and the extension. */
std::string fileNameOf(const std::string& pattern, const std::string& mission, const formats::ExportFormat& format, int part, int parts);

/** Path of each prepared file in a folder. Two files of one name (fms and fms3) get the format's name appended. */
std::vector<std::string> pathsOf(const PreparedExport& prepared, const std::string& folder, const std::string& pattern, const std::string& mission);

/** Path of each prepared file of one format, from the path of the one: parts are appended to the name. */
std::vector<std::string> pathsOf(const PreparedExport& prepared, const std::string& path);

/** Writes the files, all of them or none: what is there is copied to PATH~ first, and after an error everything is as it was
 *  before, folders that were made included.
 *  @param folder  is made, with what it lies in, unless it is there; "": none is made
 *  @return paths of the copies, "" where nothing was there   @errors OutputFailed - names the file or folder */
Result<std::vector<std::string>> writeExports(const PreparedExport& prepared, const std::vector<std::string>& paths, const std::string& folder = "");

}  // namespace vp::exports
