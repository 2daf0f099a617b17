#include "core/formats/polygon_file.h"

#include "core/base/plain_text.h"
#include "core/formats/text_file.h"
#include "core/terrain/crs_transform.h"
#include "core/terrain/gdal_support.h"

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace vp::formats {
namespace {

constexpr GIntBig kMostFeatures = 5'000'000;      // census blocks of a whole country: 8 million of the USA come in files of states
constexpr std::size_t kMostCorners = 50'000'000;  // 800 MB of places

/// To degrees of WGS 84; none where the file's coordinates are degrees.
Result<std::optional<terrain::detail::CrsTransform>> transformOf(OGRLayer& layer, const std::string& path) {
  const OGRSpatialReference* system = layer.GetSpatialRef();
  if (system == nullptr) {
    OGREnvelope box;
    const bool isKnown = layer.GetExtent(&box, TRUE) == OGRERR_NONE;
    if (!isKnown || !(box.MinX >= -180.0 && box.MaxX <= 180.0 && box.MinY >= -90.0 && box.MaxY <= 90.0)) {
      return fail(Errc::BadFormat, "the file names no coordinate system and its coordinates are no degrees; add the .prj file that belongs to it",
                  path);
    }
    return std::nullopt;
  }
  char* text = nullptr;
  const bool isWritten = system->exportToWkt(&text) == OGRERR_NONE;
  const std::string wkt = isWritten && text != nullptr ? text : "";
  CPLFree(text);
  const Result<terrain::detail::Crs> from = terrain::detail::crsFrom(wkt);
  const Result<terrain::detail::Crs> degrees = terrain::detail::crsFrom("EPSG:4326");
  if (!from || !degrees) {
    return fail(Errc::BadFormat, "the coordinate system of the file is none that the program understands; save it in WGS 84 degrees (EPSG:4326)",
                path);
  }
  Result<terrain::detail::CrsTransform> transform = terrain::detail::CrsTransform::between(*from, *degrees);
  if (!transform) {
    return fail(transform.error().code, transform.error().what, path);
  }
  return std::move(*transform);
}

PolygonField fieldOf(const OGRFeature& feature, const std::vector<int>& fields) {
  PolygonField value;
  const auto found = std::find_if(fields.begin(), fields.end(), [&](int field) { return feature.IsFieldSetAndNotNull(field) != 0; });
  if (found == fields.end()) {
    return value;
  }
  const OGRFieldDefn& definition = *feature.GetFieldDefnRef(*found);
  value.name = definition.GetNameRef();
  value.text = feature.GetFieldAsString(*found);
  value.text = plainText(isUtf8(value.text) ? value.text : fromWindows1252(value.text));
  value.number = definition.GetType() == OFTString ? parseDecimal(value.text) : std::optional(feature.GetFieldAsDouble(*found));
  return value;
}

}  // namespace

struct PolygonFile::State {
  std::string path;
  std::unique_ptr<GDALDataset> dataset;
  OGRLayer* layer = nullptr;
  std::vector<std::vector<int>> fields;  ///< for each of ours those of the file that mean it, in their order
  std::optional<terrain::detail::CrsTransform> transform;
  std::size_t corners = 0;
  int number = 0;

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
    if (transform) {
      transform->apply(x, y);
    }
    corners += x.size();
    std::vector<geo::LatLon> places;
    for (std::size_t i = 0; i < x.size(); ++i) {
      places.push_back({y[i], x[i]});
    }
    return places;
  }

  void addPart(const OGRPolygon& polygon, PolygonFeature& feature) {
    PolygonFeature::Rings rings;
    for (const OGRLinearRing* ring : polygon) {
      std::vector<geo::LatLon> places = cornersOf(*ring);
      if (rings.empty() ? !places.empty() : places.size() >= 3) {
        rings.push_back(std::move(places));
      }
    }
    if (!rings.empty()) {
      feature.parts.push_back(std::move(rings));
    }
  }
};

PolygonFile::PolygonFile(std::unique_ptr<State> state) : state_(std::move(state)) {}
PolygonFile::~PolygonFile() = default;
PolygonFile::PolygonFile(PolygonFile&&) noexcept = default;
PolygonFile& PolygonFile::operator=(PolygonFile&&) noexcept = default;

Result<PolygonFile> PolygonFile::open(const std::string& path, const FieldNames& names, const std::string& content) {
  const terrain::detail::GdalMessages messages;
  if (const Result<std::string> start = readStart(path, 1); !start) {
    return forward(start);
  }
  const Result<GDALDataset*> opened = terrain::detail::openDataset(path, terrain::detail::Content::Vector);
  if (!opened) {
    return forward(opened);
  }
  auto state = std::make_unique<State>();
  state->path = path;
  state->dataset.reset(*opened);
  if (state->dataset == nullptr) {
    return fail(Errc::BadFile, "this is no file of polygons that the program reads (GeoJSON, shapefile, GeoPackage, KML)" + messages.inBrackets(),
                path);
  }
  for (OGRLayer* layer : state->dataset->GetLayers()) {
    const OGRwkbGeometryType type = wkbFlatten(layer->GetGeomType());
    if (type == wkbPolygon || type == wkbMultiPolygon || type == wkbUnknown || type == wkbGeometryCollection) {
      state->layer = layer;
      break;
    }
  }
  if (state->layer == nullptr) {
    return fail(Errc::BadFormat, "the file has no polygons; " + content, path);
  }
  if (state->layer->GetFeatureCount() > kMostFeatures) {
    return fail(Errc::BadFormat, fmt::format("more than {} areas; cut the file to the region that is flown over", kMostFeatures), path);
  }
  const OGRFeatureDefn& definition = *state->layer->GetLayerDefn();
  state->fields.resize(names.count());
  for (int i = 0; i < definition.GetFieldCount(); ++i) {
    if (const int field = names.find(definition.GetFieldDefn(i)->GetNameRef()); field >= 0) {
      state->fields[static_cast<std::size_t>(field)].push_back(i);
    }
  }
  Result<std::optional<terrain::detail::CrsTransform>> transform = transformOf(*state->layer, path);
  if (!transform) {
    return forward(transform);
  }
  state->transform = std::move(*transform);
  state->layer->ResetReading();
  return PolygonFile(std::move(state));
}

bool PolygonFile::hasField(int field) const {
  return !state_->fields[static_cast<std::size_t>(field)].empty();
}

bool PolygonFile::hasAnyField(int first, int last) const {
  for (int field = first; field <= last; ++field) {
    if (hasField(field)) {
      return true;
    }
  }
  return false;
}

bool PolygonFile::beginsWithPolygons() {
  constexpr int kLookedAt = 20;  // features, some of which may lack their polygon
  PolygonFeature feature;
  for (int i = 0; i < kLookedAt; ++i) {
    const Result<bool> isRead = next(feature);
    if (!isRead || !*isRead) {
      return false;
    }
    if (!feature.parts.empty()) {
      return true;
    }
  }
  return false;
}

Result<bool> PolygonFile::next(PolygonFeature& feature) {
  const terrain::detail::GdalMessages messages;
  const std::unique_ptr<OGRFeature> read(state_->layer->GetNextFeature());
  if (read == nullptr) {
    return false;
  }
  feature = {};
  feature.number = ++state_->number;
  for (const std::vector<int>& fields : state_->fields) {
    feature.fields.push_back(fieldOf(*read, fields));
  }
  const OGRGeometry* geometry = read->GetGeometryRef();
  const OGRwkbGeometryType type = geometry == nullptr ? wkbUnknown : wkbFlatten(geometry->getGeometryType());
  if (type == wkbPolygon) {
    state_->addPart(*geometry->toPolygon(), feature);
  } else if (type == wkbMultiPolygon) {
    for (const OGRPolygon* part : *geometry->toMultiPolygon()) {
      state_->addPart(*part, feature);
    }
  }
  if (state_->corners > kMostCorners) {
    return fail(Errc::BadFormat, fmt::format("more than {} corners; cut the file to the region that is flown over", kMostCorners), state_->path);
  }
  return true;
}

}  // namespace vp::formats
