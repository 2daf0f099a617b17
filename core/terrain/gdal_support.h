#pragma once

#include "core/base/result.h"

#include <string>

class GDALDataset;

namespace vp::terrain::detail {

/** Catches what GDAL and PROJ say on this thread while it lives, so that nothing spills on stderr and the words can go
 *  into our own sentence. Registers GDAL's drivers on first use and closes GDAL's ways into the network
 *  and to standard input (NetworkAllowed). Objects must end in reverse order of their making. */
class GdalMessages {
public:
  GdalMessages();
  ~GdalMessages();
  GdalMessages(const GdalMessages&) = delete;
  GdalMessages& operator=(const GdalMessages&) = delete;

  /** The last error as one line, without the final stop; empty if there was none. */
  [[nodiscard]] const std::string& text() const { return text_; }
  /** " (GDAL: the last error)" for the end of a sentence; empty if there was none. */
  [[nodiscard]] std::string inBrackets() const;
  void clear() { text_.clear(); }
  void take(const char* message);

private:
  std::string text_;
};

/** What a file is opened for. */
enum class Content { Raster, Vector };

/** Opens a file that somebody named, by the one rule of core/base/local_file.h and with a short list of drivers: those that read nothing but the
 *  file and what belongs to it beside it. So no file makes the program read other files or ask a server; drivers that do (VRT, WMS, WFS, HTTP,
 *  databases, catalogues) are not on the list. A VRT is told what to do instead.
 *  @return the data set, to be closed by GDALClose; null: none of the drivers reads it, and `messages` of the caller may say why
 *  @errors BadFile - no ordinary file of this computer, or one that only names others   @source gdal.org, drivers and virtual file systems */
Result<GDALDataset*> openDataset(const std::string& path, Content content);

/** Lets this thread use the network by GDAL while it lives; nothing else does, whatever a file names. For core/fetch, on the user's command alone. */
class NetworkAllowed {
public:
  NetworkAllowed();
  ~NetworkAllowed();
  NetworkAllowed(const NetworkAllowed&) = delete;
  NetworkAllowed& operator=(const NetworkAllowed&) = delete;
};

}  // namespace vp::terrain::detail
