#include "core/formats/geojson_features.h"

#include "core/formats/json_value.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace vp::formats {
namespace {

std::string textOf(const JsonValue& value) {
  if (const auto* text = value.as<std::string>()) {
    return *text;
  }
  if (const auto* flag = value.as<bool>()) {
    return *flag ? "yes" : "no";
  }
  return value.isNumber() && std::isfinite(value.number()) ? shortestNumber(value.number()) : std::string();
}

std::string wordOf(const JsonValue& object, std::string_view key) {
  const JsonValue* value = object.find(key);
  const std::string* text = value == nullptr ? nullptr : value->as<std::string>();
  return text == nullptr ? std::string() : *text;
}

/// A position; nothing if it is none on Earth.
std::optional<GeoPlace> placeOf(const JsonValue& value) {
  const auto* numbers = value.as<JsonValue::Array>();
  if (numbers == nullptr || numbers->size() < 2 || !(*numbers)[0].isNumber() || !(*numbers)[1].isNumber()) {
    return std::nullopt;
  }
  GeoPlace place{{(*numbers)[1].number(), (*numbers)[0].number()}, {}};
  if (!(std::fabs(place.position.latitude_deg) <= 90.0) || !(std::fabs(place.position.longitude_deg) <= 180.0)) {
    return std::nullopt;
  }
  if (numbers->size() > 2 && (*numbers)[2].isNumber() && std::isfinite((*numbers)[2].number())) {
    place.height = (*numbers)[2].number();
  }
  return place;
}

std::optional<std::vector<GeoPlace>> placesOf(const JsonValue& value) {
  const auto* list = value.as<JsonValue::Array>();
  std::vector<GeoPlace> places;
  if (list == nullptr || list->empty()) {
    return std::nullopt;
  }
  for (const JsonValue& item : *list) {
    const std::optional<GeoPlace> place = placeOf(item);
    if (!place) {
      return std::nullopt;
    }
    places.push_back(*place);
  }
  return places;
}

class FeatureReader {
public:
  explicit FeatureReader(const FieldNames& names) : names_(&names) {}

  void readFeature(const JsonValue& feature, std::size_t line) {
    GeoFeature common;
    common.line = line;
    common.values.resize(names_->count());
    const JsonValue* properties = feature.find("properties");
    if (const auto* members = properties == nullptr ? nullptr : properties->as<JsonValue::Object>()) {
      for (const JsonMember& member : *members) {
        const int field = names_->find(member.key);
        if (field >= 0 && common.values[static_cast<std::size_t>(field)].empty()) {
          common.values[static_cast<std::size_t>(field)] = textOf(member.value);
        }
      }
    }
    const JsonValue* geometry = feature.find("geometry");
    if (geometry == nullptr || geometry->as<JsonValue::Object>() == nullptr) {
      common.fault = "no geometry";
      features.push_back(std::move(common));
      return;
    }
    readGeometry(*geometry, common);
  }

  /// A geometry, or each of its parts.
  void readGeometry(const JsonValue& geometry, const GeoFeature& common) {
    const std::string type = wordOf(geometry, "type");
    const JsonValue* coordinates = geometry.find(type == "GeometryCollection" ? "geometries" : "coordinates");
    const auto* list = coordinates == nullptr ? nullptr : coordinates->as<JsonValue::Array>();
    if (list == nullptr) {
      addFault(common, "geometry without coordinates");
    } else if (type == "GeometryCollection") {
      for (const JsonValue& part : *list) {
        readGeometry(part, common);
      }
    } else if (type == "MultiPoint" || type == "MultiLineString" || type == "MultiPolygon") {
      for (const JsonValue& part : *list) {
        readSimple(type.substr(5), part, common);
      }
    } else {
      readSimple(type, *coordinates, common);
    }
  }

  std::vector<GeoFeature> features;

private:
  void addFault(GeoFeature feature, std::string fault) {
    feature.fault = std::move(fault);
    features.push_back(std::move(feature));
  }

  void readSimple(const std::string& type, const JsonValue& coordinates, const GeoFeature& common) {
    GeoFeature feature = common;
    if (type == "Point") {
      if (const std::optional<GeoPlace> place = placeOf(coordinates)) {
        feature.kind = GeoFeature::Kind::Point;
        feature.places = {*place};
      }
    } else if (type == "LineString") {
      if (std::optional<std::vector<GeoPlace>> places = placesOf(coordinates)) {
        feature.kind = GeoFeature::Kind::Line;
        feature.places = std::move(*places);
      }
    } else if (type == "Polygon") {
      readRings(coordinates, feature);
    } else {
      addFault(common, "a geometry of unknown type");
      return;
    }
    if (feature.kind == GeoFeature::Kind::None) {
      addFault(common, "coordinates are no places in degrees of longitude and latitude");
      return;
    }
    features.push_back(std::move(feature));
  }

  static void readRings(const JsonValue& coordinates, GeoFeature& feature) {
    const auto* rings = coordinates.as<JsonValue::Array>();
    for (std::size_t i = 0; rings != nullptr && i < rings->size(); ++i) {
      std::optional<std::vector<GeoPlace>> ring = placesOf((*rings)[i]);
      if (!ring) {
        feature.kind = GeoFeature::Kind::None;
        return;
      }
      if (ring->size() > 1 && ring->front().position == ring->back().position) {
        ring->pop_back();
      }
      if (i == 0) {
        feature.kind = ring->size() >= 3 ? GeoFeature::Kind::Polygon : GeoFeature::Kind::None;
        feature.places = std::move(*ring);
      } else {
        feature.holes.push_back(std::move(*ring));
      }
    }
  }

  const FieldNames* names_;
};

}  // namespace

Result<std::vector<GeoFeature>> readGeoFeatures(const std::string& path, const FieldNames& names) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return forward(text);
  }
  const Result<JsonValue> json = parseJson(*text, path);
  if (!json) {
    return forward(json);
  }
  const std::string type = wordOf(*json, "type");
  FeatureReader reader(names);
  if (type == "FeatureCollection") {
    const JsonValue* list = json->find("features");
    const auto* features = list == nullptr ? nullptr : list->as<JsonValue::Array>();
    if (features == nullptr) {
      return fail(Errc::BadFormat, "the FeatureCollection has no list \"features\"", path);
    }
    constexpr std::size_t kExactLines = 200;  // finding a line walks the text, which is slow for the last of very many
    for (std::size_t i = 0; i < features->size(); ++i) {
      const std::size_t line = features->size() <= kExactLines ? locateJson(*text, fmt::format("/features/{}", i)).line : i + 1;
      reader.readFeature((*features)[i], line);
    }
  } else if (type == "Feature") {
    reader.readFeature(*json, 1);
  } else if (!type.empty() && (json->find("coordinates") != nullptr || json->find("geometries") != nullptr)) {
    GeoFeature common;
    common.values.resize(names.count());
    reader.readGeometry(*json, common);
  } else {
    return fail(Errc::BadFormat, "this is no GeoJSON: it has no \"type\" of a FeatureCollection, Feature or geometry", path);
  }
  return std::move(reader.features);
}

}  // namespace vp::formats
