#include "core/terrain/gdal_support.h"

#include "core/base/expect.h"
#include "core/base/local_file.h"
#include "core/base/plain_text.h"
#include "core/terrain/proj_files.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_http.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <cpl_vsi_virtual.h>
#include <gdal.h>
#include <gdal_priv.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <fstream>
#include <limits>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace vp::terrain::detail {
namespace {

namespace fs = std::filesystem;

thread_local int networkUsers = 0;

/// Answers every request of GDAL that nobody asked for; null lets GDAL go on and ask the server.
CPLHTTPResult* refuseRequest(const char* /*url*/, CSLConstList /*options*/, GDALProgressFunc /*progress*/, void* /*progressArgument*/,
                             CPLHTTPFetchWriteFunc /*write*/, void* /*writeArgument*/, void* /*user*/) {
  if (networkUsers > 0) {
    return nullptr;
  }
  constexpr const char* kWords = "the network is used on command only";
  CPLError(CE_Failure, CPLE_NotSupported, "%s", kWords);
  auto* answer = static_cast<CPLHTTPResult*>(CPLCalloc(1, sizeof(CPLHTTPResult)));
  answer->nStatus = 1;
  answer->pszErrBuf = CPLStrdup(kWords);
  return answer;
}

/// Puts a file system without any files in the place of those of GDAL that lead off this computer or to standard input and output.
void closeFileSystems() {
  constexpr std::array<std::string_view, 4> kHarmless{"/vsimem/", "/vsizip/", "/vsigzip/", "/vsisubfile/"};
  // For ever: GDAL keeps the pointer to a prefix, not the text; and those that are replaced may be in use by other code of it, and are no leaks.
  static auto* const replaced = new std::deque<std::pair<std::string, const VSIFilesystemHandler*>>();
  const CPLStringList prefixes(VSIGetFileSystemsPrefixes());
  for (int i = 0; i < prefixes.size(); ++i) {
    const std::string prefix = prefixes[i];
    if (prefix.starts_with("/vsi") && std::find(kHarmless.begin(), kHarmless.end(), prefix) == kHarmless.end()) {
      VSIFilesystemPluginCallbacksStruct* nothing = VSIAllocFilesystemPluginCallbacksStruct();
      nothing->open = [](void* /*user*/, const char* /*name*/, const char* /*access*/) -> void* { return nullptr; };
      nothing->stat = [](void* /*user*/, const char* /*name*/, VSIStatBufL* /*status*/, int /*flags*/) { return -1; };
      replaced->emplace_back(prefix, VSIFileManager::GetHandler(prefix.c_str()));
      VSIInstallPluginHandler(replaced->back().first.c_str(), nothing);
      VSIFreeFilesystemPluginCallbacksStruct(nothing);
    }
  }
}

void registerDriversOnce() {
  static std::once_flag once;
  std::call_once(once, [] {
    VP_EXPECT(isProjGuarded());
    GDALAllRegister();
    closeFileSystems();
    CPLHTTPSetFetchCallback(&refuseRequest, nullptr);
    OSRSetPROJEnableNetwork(0);  // grids of datum shifts are those that are installed
  });
}

/// What reads the file and what belongs to it beside it, nothing else.
const char* const* driversFor(Content content) {
  static constexpr std::array<const char*, 19> kRasters{"GTiff", "SRTMHGT", "DTED", "AAIGrid", "GRASSASCIIGrid", "USGSDEM", "HFA",
                                                        "EHdr",  "ENVI",    "BT",   "GSAG",    "GSBG",           "GS7BG",   "SAGA",
                                                        "RST",   "GPKG",    "ISG",  "XYZ",     nullptr};
  static constexpr std::array<const char*, 8> kVectors{"GeoJSON", "GeoJSONSeq", "ESRI Shapefile", "GPKG", "KML", "LIBKML", "FlatGeobuf", nullptr};
  return content == Content::Raster ? kRasters.data() : kVectors.data();
}

bool isVrt(const std::string& path) {
  std::string start(256, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start.find("<VRTDataset") != std::string::npos || start.find("<OGRVRTDataSource") != std::string::npos;
}

void CPL_STDCALL onMessage(CPLErr severity, CPLErrorNum /*number*/, const char* message) {
  if (severity == CE_Failure || severity == CE_Fatal) {
    static_cast<GdalMessages*>(CPLGetErrorHandlerUserData())->take(message);
  }
}

}  // namespace

GdalMessages::GdalMessages() {
  registerDriversOnce();
  CPLPushErrorHandlerEx(&onMessage, this);
}

GdalMessages::~GdalMessages() {
  CPLPopErrorHandler();
  CPLErrorReset();
}

void GdalMessages::take(const char* message) {
  text_ = plainText(message);
  while (!text_.empty() && (text_.back() == '.' || text_.back() == ' ')) {
    text_.pop_back();
  }
}

Result<GDALDataset*> openDataset(const std::string& path, Content content) {
  // A raster is read in parts, so its bytes need no limit; its posts have one (post_mosaic.cpp). OGR reads some formats as a whole.
  constexpr std::uint64_t kMostVectorBytes = std::uint64_t{1} << 30;
  const std::uint64_t most = content == Content::Raster ? std::numeric_limits<std::uint64_t>::max() : kMostVectorBytes;
  if (const Result<void> local = checkLocalFile(path, most); !local) {
    return forward(local);
  }
  registerDriversOnce();
  std::error_code code;
  const fs::path whole = fs::absolute(path, code);  // a name that begins with a folder cannot be taken for the text of a connection
  const unsigned flags = content == Content::Raster ? GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR : GDAL_OF_VECTOR;
  GDALDataset* dataset = GDALDataset::Open(whole.c_str(), flags | GDAL_OF_READONLY, driversFor(content));
  if (dataset == nullptr && isVrt(path)) {
    return fail(Errc::BadFile, "this is a VRT, which only names other files; name those files themselves, they are joined", path);
  }
  return dataset;
}

NetworkAllowed::NetworkAllowed() {
  registerDriversOnce();
  ++networkUsers;
}

NetworkAllowed::~NetworkAllowed() {
  --networkUsers;
}

std::string GdalMessages::inBrackets() const {
  constexpr std::size_t kMost = 200;  // some of PROJ's messages quote whole coordinate systems
  if (text_.empty()) {
    return {};
  }
  return " (GDAL: " + plainText(text_, kMost) + ")";
}

}  // namespace vp::terrain::detail
