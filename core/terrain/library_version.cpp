#include "core/terrain/library_version.h"

#include <gdal.h>
#include <ogr_srs_api.h>

namespace vp::terrain {

std::string gdalVersion() {
  return GDALVersionInfo("RELEASE_NAME");
}

std::string projVersion() {
  int major = 0;
  int minor = 0;
  int patch = 0;
  OSRGetPROJVersion(&major, &minor, &patch);
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

}  // namespace vp::terrain
