#include "core/formats/height_map.h"

#include "core/formats/atomic_file.h"
#include "core/formats/exports/xml_writer.h"
#include "core/terrain/gdal_support.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <set>

namespace vp::formats {
namespace {

constexpr float kNoValue = -32767.0F;

/// A file in memory while GDAL writes it; its bytes then go to the disk in one piece.
class MemoryFile {
public:
  explicit MemoryFile(const std::string& ending) {
    static std::atomic<int> counter{0};  // apart within the process
    path_ = fmt::format("/vsimem/volplane-{}.{}", counter++, ending);
  }
  ~MemoryFile() { VSIUnlink(path_.c_str()); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }
  Result<void> writeTo(const std::string& target) const {
    vsi_l_offset length = 0;
    const GByte* bytes = VSIGetMemFileBuffer(path_.c_str(), &length, FALSE);
    if (bytes == nullptr) {
      return fail(Errc::OutputFailed, "there is not enough memory for the file; choose wider cells", target);
    }
    return writeFileAtomically(target, {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(length)});
  }

private:
  std::string path_;
};

tl::unexpected<Error> refused(const std::string& path, const terrain::detail::GdalMessages& messages) {
  return fail(Errc::OutputFailed, "the file could not be made" + messages.inBrackets(), path);
}

/// Values from north to south with no-data, as rasters have them.
std::vector<float> northUp(const HeightMap& map, const std::vector<float>& values) {
  std::vector<float> result;
  result.reserve(values.size());
  for (int row = map.rows - 1; row >= 0; --row) {
    for (int column = 0; column < map.columns; ++column) {
      const float value = values[static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(column)];
      result.push_back(std::isfinite(value) ? value : kNoValue);
    }
  }
  return result;
}

/// Each cell the highest of itself and its neighbours; unknown if one of them is.
std::vector<float> highestAround(const HeightMap& map, const std::vector<float>& values) {
  std::vector<float> result(values.size());
  const auto at = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.columns) + static_cast<std::size_t>(column);
  };
  for (int row = 0; row < map.rows; ++row) {
    for (int column = 0; column < map.columns; ++column) {
      float highest = values[at(column, row)];
      for (int j = std::max(0, row - 1); j <= std::min(map.rows - 1, row + 1); ++j) {
        for (int i = std::max(0, column - 1); i <= std::min(map.columns - 1, column + 1); ++i) {
          highest = std::max(highest, values[at(i, j)]);
        }
      }
      result[at(column, row)] = highest;
    }
  }
  return result;
}

std::array<double, 6> transformOf(const HeightMap& map) {
  return {map.originX, map.cell, 0.0, map.originY + map.cell * map.rows, 0.0, -map.cell};
}

int CPL_STDCALL onProgress(double done, const char* /*text*/, void* argument) {
  const Job& job = *static_cast<const Job*>(argument);
  job.progress(done, "contours");
  return job.stopRequested() ? FALSE : TRUE;
}

using Dataset = std::unique_ptr<GDALDataset>;

Dataset created(const char* driver, const std::string& path, const HeightMap& map, int bands, char** options) {
  GDALDriver* maker = GetGDALDriverManager()->GetDriverByName(driver);
  Dataset raster(maker->Create(path.c_str(), map.columns, map.rows, bands, GDT_Float32, options));
  if (raster != nullptr) {
    std::array<double, 6> at = transformOf(map);
    raster->SetGeoTransform(at.data());
  }
  return raster;
}

bool put(GDALDataset& raster, int band, const HeightMap& map, std::vector<float> values) {
  GDALRasterBand* target = raster.GetRasterBand(band);
  target->SetNoDataValue(static_cast<double>(kNoValue));
  return target->RasterIO(GF_Write, 0, 0, map.columns, map.rows, values.data(), map.columns, map.rows, GDT_Float32, 0, 0, nullptr) == CE_None;
}

std::vector<Contour> readContours(OGRLayer& layer, const HeightMap& map) {
  std::vector<Contour> contours;
  layer.ResetReading();
  while (const std::unique_ptr<OGRFeature> feature{layer.GetNextFeature()}) {
    const auto* line = dynamic_cast<const OGRLineString*>(feature->GetGeometryRef());
    if (line == nullptr || line->getNumPoints() < 2) {
      continue;
    }
    Contour contour;
    contour.altitude = feature->GetFieldAsDouble(1);
    for (int i = 0; i < line->getNumPoints(); ++i) {
      contour.points.push_back(map.frame.toLatLon({line->getX(i), line->getY(i)}));
    }
    contours.push_back(std::move(contour));
  }
  std::stable_sort(contours.begin(), contours.end(), [](const Contour& a, const Contour& b) { return a.altitude < b.altitude; });
  return contours;
}

}  // namespace

Result<void> writeHeightMapTiff(const HeightMap& map, const std::string& path) {
  const terrain::detail::GdalMessages messages;
  const MemoryFile file("tif");
  CPLStringList options;
  for (const char* option : {"COMPRESS=DEFLATE", "PREDICTOR=3", "INTERLEAVE=BAND"}) {
    options.AddString(option);
  }
  Dataset raster = created("GTiff", file.path(), map, static_cast<int>(map.bands.size()), options.List());
  OGRSpatialReference frame;
  if (raster == nullptr || frame.importFromProj4(map.frame.projString().c_str()) != OGRERR_NONE) {
    return refused(path, messages);
  }
  frame.SetProjCS("Local frame of the mission");
  raster->SetSpatialRef(&frame);
  for (const auto& [key, value] : map.words) {
    raster->SetMetadataItem(key.c_str(), value.c_str());
  }
  for (std::size_t b = 0; b < map.bands.size(); ++b) {
    const HeightMap::Band& band = map.bands[b];
    GDALRasterBand* target = raster->GetRasterBand(static_cast<int>(b) + 1);
    target->SetDescription(band.name.c_str());
    target->SetUnitType("m");
    for (const auto& [key, value] : band.words) {
      target->SetMetadataItem(key.c_str(), value.c_str());
    }
    if (!put(*raster, static_cast<int>(b) + 1, map, northUp(map, band.values))) {
      return refused(path, messages);
    }
  }
  raster.reset();
  return messages.text().empty() ? file.writeTo(path) : refused(path, messages);
}

Result<std::vector<Contour>> contoursOf(const HeightMap& map, std::size_t band, double interval, const Job& job) {
  const std::vector<float> values = highestAround(map, map.bands[band].values);
  float highest = 0.0F;
  float lowest = 0.0F;
  for (const float value : values) {
    highest = std::isfinite(value) ? std::max(highest, value) : highest;
    lowest = std::isfinite(value) ? std::min(lowest, value) : lowest;
  }
  constexpr double kMostLevels = 2000.0;
  if (!(interval > 0.0) || static_cast<double>(highest - lowest) / interval > kMostLevels) {
    return fail(Errc::OutOfRange, "there would be more than 2,000 levels of contours; choose a wider interval");
  }
  const terrain::detail::GdalMessages messages;
  const Dataset raster = created("MEM", "", map, 1, nullptr);
  const Dataset lines(GetGDALDriverManager()->GetDriverByName("Memory")->Create("", 0, 0, 0, GDT_Unknown, nullptr));
  if (raster == nullptr || lines == nullptr || !put(*raster, 1, map, northUp(map, values))) {
    return fail(Errc::Internal, "the contours could not be drawn" + messages.inBrackets());
  }
  OGRLayer* layer = lines->CreateLayer("contours", nullptr, wkbLineString, nullptr);
  OGRFieldDefn number("id", OFTInteger);
  OGRFieldDefn altitude("altitude_m", OFTReal);
  layer->CreateField(&number);
  layer->CreateField(&altitude);
  CPLStringList options;
  options.SetNameValue("LEVEL_INTERVAL", fmt::format("{}", interval).c_str());
  options.SetNameValue("ID_FIELD", "0");
  options.SetNameValue("ELEV_FIELD", "1");
  options.SetNameValue("NODATA", fmt::format("{}", kNoValue).c_str());
  Job copy = job;
  const CPLErr state = GDALContourGenerateEx(raster->GetRasterBand(1), layer, options.List(), &onProgress, &copy);
  if (job.stopRequested()) {
    return fail(Errc::Cancelled, "the map was stopped; nothing was written");
  }
  if (state != CE_None) {
    return fail(Errc::Internal, "the contours could not be drawn" + messages.inBrackets());
  }
  return readContours(*layer, map);
}

std::string contoursToKml(const HeightMap& map, std::size_t band, const std::vector<Contour>& contours) {
  const double lowest = contours.empty() ? 0.0 : contours.front().altitude;
  const double span = contours.empty() ? 1.0 : std::max(1.0, contours.back().altitude - lowest);
  std::set<double> levels;
  for (const Contour& contour : contours) {
    levels.insert(contour.altitude);
  }
  std::string kml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<kml "
      "xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n<name>{}</name>\n<description>{}</description>\n",
      escapedXml(map.name), escapedXml(map.bands[band].name));
  for (const double level : levels) {
    const double share = (level - lowest) / span;
    const int red = static_cast<int>(std::lround(255.0 * std::min(1.0, 2.0 * share)));
    const int green = static_cast<int>(std::lround(200.0 * std::min(1.0, 2.0 * (1.0 - share))));
    kml += fmt::format("<Style id=\"a{:.0f}\"><LineStyle><color>ff00{:02x}{:02x}</color><width>2</width></LineStyle></Style>\n", level, green, red);
  }
  double open = -1e9;
  for (const Contour& contour : contours) {
    if (contour.altitude != open) {
      kml += fmt::format("{}<Folder>\n<name>{:.0f} m MSL ({:.0f} ft)</name>\n", open > -1e8 ? "</Folder>\n" : "", contour.altitude,
                         contour.altitude / kMetresPerFoot);
      open = contour.altitude;
    }
    kml += fmt::format("<Placemark><name>{:.0f} m</name><styleUrl>#a{:.0f}</styleUrl><LineString><altitudeMode>absolute</altitudeMode><coordinates>",
                       contour.altitude, contour.altitude);
    for (const geo::LatLon& point : contour.points) {
      kml += fmt::format("{:.6f},{:.6f},{:.1f} ", point.longitude_deg, point.latitude_deg, contour.altitude);
    }
    kml += "</coordinates></LineString></Placemark>\n";
  }
  return kml + (open > -1e8 ? "</Folder>\n" : "") + "</Document>\n</kml>\n";
}

Result<void> writeContoursGpkg(const HeightMap& map, std::size_t band, const std::vector<Contour>& contours, const std::string& path) {
  const terrain::detail::GdalMessages messages;
  const MemoryFile file("gpkg");
  Dataset package(GetGDALDriverManager()->GetDriverByName("GPKG")->Create(file.path().c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  OGRSpatialReference degrees;
  degrees.importFromEPSG(4326);
  degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  CPLStringList options;
  options.SetNameValue("DESCRIPTION", map.bands[band].name.c_str());
  OGRLayer* layer = package != nullptr ? package->CreateLayer("contours", &degrees, wkbLineString25D, options.List()) : nullptr;
  if (layer == nullptr) {
    return refused(path, messages);
  }
  for (const auto& [key, value] : map.words) {
    layer->SetMetadataItem(key.c_str(), value.c_str());
  }
  OGRFieldDefn altitude("altitude_m", OFTReal);
  layer->CreateField(&altitude);
  bool isTaken = layer->StartTransaction() == OGRERR_NONE;  // one for all: each feature on its own would take seconds
  for (const Contour& contour : contours) {
    OGRFeature feature(layer->GetLayerDefn());
    OGRLineString line;
    for (const geo::LatLon& point : contour.points) {
      line.addPoint(point.longitude_deg, point.latitude_deg, contour.altitude);
    }
    feature.SetField(0, contour.altitude);
    feature.SetGeometry(&line);
    isTaken = isTaken && layer->CreateFeature(&feature) == OGRERR_NONE;
  }
  isTaken = layer->CommitTransaction() == OGRERR_NONE && isTaken;
  package.reset();
  return isTaken && messages.text().empty() ? file.writeTo(path) : refused(path, messages);
}

}  // namespace vp::formats
