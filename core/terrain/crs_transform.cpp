#include "core/terrain/crs_transform.h"

#include "core/base/expect.h"
#include "core/terrain/gdal_support.h"

#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace vp::terrain::detail {
namespace {

/// Whether a system names files of datum shifts by a path: PROJ would open whatever it is. By their names alone they are those that are installed.
bool namesFileByPath(const OGRSpatialReference& crs) {
  char* written = nullptr;
  const std::array<const char*, 2> options{"FORMAT=WKT2_2019", nullptr};
  const bool isWritten = crs.exportToWkt(&written, options.data()) == OGRERR_NONE && written != nullptr;
  const std::string text = isWritten ? written : "";
  CPLFree(written);
  for (const std::string_view before : {"PARAMETERFILE[", "grids="}) {
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at + 1)) {
      const std::size_t end = std::min(text.find(before.back() == '[' ? ']' : ' ', at), text.size());
      if (text.substr(at, end - at).find('/') != std::string::npos) {
        return true;
      }
    }
  }
  return false;
}

}  // namespace

Result<Crs> crsFrom(const std::string& definition) {
  GdalMessages messages;
  auto crs = std::make_shared<OGRSpatialReference>();
  if (crs->SetFromUserInput(definition.c_str()) != OGRERR_NONE) {
    return fail(Errc::BadFormat, "this is not a coordinate system that GDAL knows" + messages.inBrackets(), definition);
  }
  crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return Crs(std::move(crs));
}

Result<CrsTransform> CrsTransform::between(const Crs& from, const Crs& to) {
  VP_EXPECT(from != nullptr && to != nullptr);
  GdalMessages messages;
  OGRCoordinateTransformationOptions options;
  options.SetBallparkAllowed(false);
  if (namesFileByPath(*from)) {
    return fail(Errc::Unsupported, "its coordinate system names a file of datum shifts; state a system that needs none, for example EPSG:4326");
  }
  CrsTransform made;
  made.transformation_.reset(OGRCreateCoordinateTransformation(from.get(), to.get(), options));
  if (!made.transformation_) {
    return fail(Errc::Unsupported, "no transformation is known between its coordinate system and WGS 84; state its datum with gdal_edit.py -a_srs" +
                                       messages.inBrackets());
  }
  return made;
}

void CrsTransform::apply(std::span<double> x, std::span<double> y) {
  VP_EXPECT(x.size() == y.size());
  if (x.empty()) {
    return;
  }
  GdalMessages messages;  // one message per failed point is of no use: they become not-a-number
  isDone_.assign(x.size(), 0);
  transformation_->Transform(static_cast<int>(x.size()), x.data(), y.data(), nullptr, isDone_.data());
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (isDone_[i] == 0 || !std::isfinite(x[i]) || !std::isfinite(y[i])) {
      x[i] = y[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
}

void CrsTransform::Closer::operator()(OGRCoordinateTransformation* transformation) const {
  OGRCoordinateTransformation::DestroyCT(transformation);
}

}  // namespace vp::terrain::detail
