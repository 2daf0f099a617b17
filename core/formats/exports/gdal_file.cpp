#include "core/formats/exports/gdal_file.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <atomic>

namespace vp::formats::exports {

std::string memoryFileName(const std::string& ending) {
  static std::atomic<unsigned> number{0};
  return fmt::format("/vsimem/volplane-export-{}.{}", number++, ending);
}

Result<std::string> takeMemoryFile(const std::string& name) {
  vsi_l_offset size = 0;
  GByte* bytes = VSIGetMemFileBuffer(name.c_str(), &size, TRUE);
  if (bytes == nullptr) {
    return fail(Errc::OutputFailed, "GDAL did not write the file that it was to make in memory");
  }
  std::string text(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  VSIFree(bytes);
  return text;
}

Result<std::string> zipped(const std::string& name, std::string_view bytes) {
  const std::string archive = memoryFileName("zip");
  VSILFILE* file = VSIFOpenL(("/vsizip/" + archive + "/" + name).c_str(), "wb");
  bool isWritten = file != nullptr && VSIFWriteL(bytes.data(), 1, bytes.size(), file) == bytes.size();
  if (file != nullptr) {
    isWritten = VSIFCloseL(file) == 0 && isWritten;
  }
  Result<std::string> result = takeMemoryFile(archive);
  if (!isWritten) {
    return fail(Errc::OutputFailed, "GDAL could not make the zip archive; is it built with zip support?");
  }
  return result;
}

}  // namespace vp::formats::exports
