#include "core/formats/population_file.h"

#include "core/formats/named_fields.h"
#include "core/formats/text_file.h"
#include "core/terrain/crs_transform.h"
#include "core/terrain/gdal_support.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

namespace vp::formats {
namespace {

constexpr double kSquareKm = 1e6;                 // m^2
constexpr GIntBig kMostFeatures = 5'000'000;      // census blocks of a whole country: 8 million of the USA come in files of states
constexpr std::size_t kMostCorners = 50'000'000;  // 800 MB of places

enum Field { kDensity, kPeople, kLand, kLabel };

const FieldNames& fieldNames() {
  static const FieldNames names(
      {{"density", "pop_density", "popdens", "pop_dens", "pop_km2", "per_km2", "density_km2", "persons_per_km2", "people_per_km2"},
       {"pop", "population", "people", "persons", "total_pop", "totpop", "pop100", "pop2000", "pop2010", "pop2020", "p1_001n", "b01001_001e"},
       {"aland", "aland10", "aland20", "arealand"},
       {"name", "geoid", "geoid10", "geoid20", "stfid", "tractid", "id"}});
  return names;
}

/// For each of our fields those of the file that mean it, in their order.
using FileFields = std::vector<std::vector<int>>;

FileFields fieldsOf(const OGRFeatureDefn& definition) {
  FileFields fields(fieldNames().count());
  for (int i = 0; i < definition.GetFieldCount(); ++i) {
    const int field = fieldNames().find(definition.GetFieldDefn(i)->GetNameRef());
    if (field >= 0) {
      fields[static_cast<std::size_t>(field)].push_back(i);
    }
  }
  return fields;
}

/// The first that the feature has a value for, or -1.
int setField(const OGRFeature& feature, const std::vector<int>& fields) {
  const auto found = std::find_if(fields.begin(), fields.end(), [&](int field) { return feature.IsFieldSetAndNotNull(field) != 0; });
  return found == fields.end() ? -1 : *found;
}

std::optional<double> numberOf(const OGRFeature& feature, const std::vector<int>& fields) {
  const int field = setField(feature, fields);
  if (field < 0) {
    return std::nullopt;
  }
  return feature.GetFieldDefnRef(field)->GetType() == OFTString ? parseDecimal(feature.GetFieldAsString(field))
                                                                : std::optional(feature.GetFieldAsDouble(field));
}

class AreaReader {
public:
  AreaReader(std::string path, OGRLayer& layer) : path_(std::move(path)), layer_(&layer), fields_(fieldsOf(*layer.GetLayerDefn())) {}

  Result<PopulationReport> read() {
    if (fields_[kDensity].empty() && fields_[kPeople].empty()) {
      return fail(Errc::BadFormat,
                  "no field of this file says how many people live in its polygons; call one POPULATION, or DENSITY for people per square kilometre",
                  path_);
    }
    if (const Result<bool> isReady = prepareSystem(); !isReady) {
      return forward(isReady);
    }
    if (layer_->GetFeatureCount() > kMostFeatures) {
      return fail(Errc::BadFormat, fmt::format("more than {} areas; cut the file to the region that is flown over", kMostFeatures), path_);
    }
    layer_->ResetReading();
    for (std::unique_ptr<OGRFeature> feature(layer_->GetNextFeature()); feature != nullptr; feature.reset(layer_->GetNextFeature())) {
      if (const Result<bool> isRead = readFeature(*feature); !isRead) {
        return forward(isRead);
      }
    }
    addNote(withoutPolygon_, "without a polygon");
    addNote(withoutNumber_, "without a number of people");
    if (report_.areas.empty()) {
      return fail(Errc::BadFormat, "no feature has both a polygon and a number of people; this is no file of population", path_);
    }
    return std::move(report_);
  }

private:
  void addNote(int count, const char* what) {
    if (count > 0) {
      report_.notes.push_back(
          fmt::format("{}: {} feature{} {} left out; nobody is taken to live there.", fileName(path_), count, count == 1 ? "" : "s", what));
    }
  }

  Result<bool> prepareSystem() {
    const OGRSpatialReference* system = layer_->GetSpatialRef();
    if (system == nullptr) {
      OGREnvelope box;
      const bool isKnown = layer_->GetExtent(&box, TRUE) == OGRERR_NONE;
      if (!isKnown || !(box.MinX >= -180.0 && box.MaxX <= 180.0 && box.MinY >= -90.0 && box.MaxY <= 90.0)) {
        return fail(Errc::BadFormat, "the file names no coordinate system and its coordinates are no degrees; add the .prj file that belongs to it",
                    path_);
      }
      return true;
    }
    char* text = nullptr;
    const bool isWritten = system->exportToWkt(&text) == OGRERR_NONE;
    const std::string wkt = isWritten && text != nullptr ? text : "";
    CPLFree(text);
    const Result<terrain::detail::Crs> from = terrain::detail::crsFrom(wkt);
    const Result<terrain::detail::Crs> degrees = terrain::detail::crsFrom("EPSG:4326");
    if (!from || !degrees) {
      return fail(Errc::BadFormat, "the coordinate system of the file is none that the program understands; save it in WGS 84 degrees (EPSG:4326)",
                  path_);
    }
    Result<terrain::detail::CrsTransform> transform = terrain::detail::CrsTransform::between(*from, *degrees);
    if (!transform) {
      return fail(transform.error().code, transform.error().what, path_);
    }
    transform_ = std::move(*transform);
    return true;
  }

  Result<bool> readFeature(const OGRFeature& feature) {
    ++number_;
    mission::PopulationArea area;
    area.source = path_;
    area.name = fmt::format("feature {}", number_);
    if (const int named = setField(feature, fields_[kLabel]); named >= 0) {
      const std::string label = feature.GetFieldAsString(named);
      area.name += isUtf8(label) ? fmt::format(" ({})", label) : fmt::format(" ({})", fromWindows1252(label));
    }
    const OGRGeometry* geometry = feature.GetGeometryRef();
    const OGRwkbGeometryType type = geometry == nullptr ? wkbUnknown : wkbFlatten(geometry->getGeometryType());
    if (type == wkbPolygon) {
      addPart(*geometry->toPolygon(), area);
    } else if (type == wkbMultiPolygon) {
      for (const OGRPolygon* part : *geometry->toMultiPolygon()) {
        addPart(*part, area);
      }
    }
    if (area.parts.empty()) {
      ++withoutPolygon_;
      return true;
    }
    if (corners_ > kMostCorners) {
      return fail(Errc::BadFormat, fmt::format("more than {} corners; cut the file to the region that is flown over", kMostCorners), path_);
    }
    setPeople(feature, area);
    if (!area.people && !area.perSquareKm) {
      ++withoutNumber_;
      return true;
    }
    report_.areas.push_back(std::move(area));
    return true;
  }

  void setPeople(const OGRFeature& feature, mission::PopulationArea& area) const {
    area.perSquareKm = numberOf(feature, fields_[kDensity]);
    if (area.perSquareKm) {
      return;
    }
    area.people = numberOf(feature, fields_[kPeople]);
    const std::optional<double> land = numberOf(feature, fields_[kLand]);
    if (area.people && land && *land > 0.0) {
      area.perSquareKm = *area.people / (*land / kSquareKm);
      area.people.reset();
    }
  }

  void addPart(const OGRPolygon& polygon, mission::PopulationArea& area) {
    mission::PopulatedPolygon part;
    for (const OGRLinearRing* ring : polygon) {
      std::vector<geo::LatLon> corners = cornersOf(*ring);
      if (part.outline.empty()) {
        part.outline = std::move(corners);
      } else if (corners.size() >= 3) {
        part.holes.push_back(std::move(corners));
      }
    }
    if (!part.outline.empty()) {
      area.parts.push_back(std::move(part));
    }
  }

  std::vector<geo::LatLon> cornersOf(const OGRLinearRing& ring) {
    std::vector<double> x;
    std::vector<double> y;
    for (int i = 0; i < ring.getNumPoints(); ++i) {
      x.push_back(ring.getX(i));
      y.push_back(ring.getY(i));
    }
    if (x.size() > 1 && x.front() == x.back() && y.front() == y.back()) {
      x.pop_back();
      y.pop_back();
    }
    if (transform_) {
      transform_->apply(x, y);
    }
    corners_ += x.size();
    std::vector<geo::LatLon> corners;
    for (std::size_t i = 0; i < x.size(); ++i) {
      corners.push_back({y[i], x[i]});
    }
    return corners;
  }

  std::string path_;
  OGRLayer* layer_;
  FileFields fields_;
  std::optional<terrain::detail::CrsTransform> transform_;
  PopulationReport report_;
  std::size_t corners_ = 0;
  int number_ = 0;
  int withoutPolygon_ = 0;
  int withoutNumber_ = 0;
};

}  // namespace

Result<PopulationReport> readPopulation(const std::string& path) {
  terrain::detail::GdalMessages messages;
  if (const Result<std::string> start = readStart(path, 1); !start) {
    return forward(start);
  }
  const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY));
  if (dataset == nullptr) {
    return fail(Errc::BadFile, "this is no file of polygons that the program reads (GeoJSON, shapefile, GeoPackage, KML)" + messages.inBrackets(),
                path);
  }
  for (OGRLayer* layer : dataset->GetLayers()) {
    const OGRwkbGeometryType type = wkbFlatten(layer->GetGeomType());
    if (type == wkbPolygon || type == wkbMultiPolygon || type == wkbUnknown || type == wkbGeometryCollection) {
      return AreaReader(path, *layer).read();
    }
  }
  return fail(Errc::BadFormat, "the file has no polygons; population is read from areas with people in them", path);
}

}  // namespace vp::formats
