#include "core/formats/weather_file.h"

#include "core/base/quantity.h"
#include "core/formats/atomic_file.h"
#include "core/formats/json_value.h"
#include "core/formats/named_fields.h"
#include "core/formats/polygon_file.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <utility>

namespace vp::formats {
namespace {

enum Field { kName, kFloorM, kFloorFt, kFloor, kTopM, kTopFt, kTop, kSuccess, kPerNm, kPerKm, kPerM };

constexpr double kMetresPerLevel = 100.0 * kMetresPerFoot;

const FieldNames& fieldNames() {
  static const FieldNames names({{"name", "id", "label", "hazard"},
                                 {"floor_m", "base_m"},
                                 {"floor_ft", "base_ft"},
                                 {"floor", "base"},
                                 {"top_m", "ceiling_m"},
                                 {"top_ft", "ceiling_ft"},
                                 {"top", "ceiling"},
                                 {"success"},
                                 {"per_nm"},
                                 {"per_km"},
                                 {"per_m"}});
  return names;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::erase(text, ' ');
  return text;
}

class CellReader {
public:
  CellReader(const std::string& path, const PolygonFeature& feature) : path_(path), feature_(feature) {}

  Result<mission::WeatherCell> read(bool& hasSuccess) {
    mission::WeatherCell cell;
    cell.name = feature_.fields[kName].text;
    const Result<std::optional<double>> floor = height(kFloorM, kFloorFt, kFloor);
    const Result<std::optional<double>> top = height(kTopM, kTopFt, kTop);
    const Result<std::optional<double>> success = number(kSuccess, 1.0);
    for (const Result<std::optional<double>>* value : {&floor, &top, &success}) {
      if (!*value) {
        return forward(*value);
      }
    }
    cell.floor = *floor;
    cell.top = *top;
    hasSuccess = success->has_value();
    cell.success = success->value_or(cell.success);
    for (const auto& [field, unit] : {std::pair{kPerNm, kMetresPerNauticalMile}, std::pair{kPerKm, 1000.0}, std::pair{kPerM, 1.0}}) {
      const Result<std::optional<double>> distance = number(field, unit);
      if (!distance) {
        return forward(distance);
      }
      cell.perDistance = distance->value_or(cell.perDistance);
    }
    return cell;
  }

private:
  [[nodiscard]] tl::unexpected<Error> refuse(const PolygonField& field, const char* remedy) const {
    const std::string& name = feature_.fields[kName].text;
    return fail(Errc::BadFormat,
                fmt::format("feature {}{}: {} is \"{}\"; {}", feature_.number, name.empty() ? "" : " (" + name + ")", field.name, field.text, remedy),
                path_);
  }

  /// A number times a unit, if the feature has it.
  [[nodiscard]] Result<std::optional<double>> number(Field which, double unit) const {
    const PolygonField& field = feature_.fields[static_cast<std::size_t>(which)];
    if (!field.isSet()) {
      return std::nullopt;
    }
    if (!field.number || !std::isfinite(*field.number)) {
      return refuse(field, "give a number");
    }
    return *field.number * unit;
  }

  [[nodiscard]] Result<std::optional<double>> height(Field metres, Field feet, Field either) const {
    Result<std::optional<double>> value = number(metres, 1.0);
    if (!value || *value) {
      return value;
    }
    value = number(feet, kMetresPerFoot);
    const PolygonField& field = feature_.fields[static_cast<std::size_t>(either)];
    if (!value || *value || !field.isSet()) {
      return value;
    }
    const std::string text = upper(field.text);
    if (text == "SFC" || text == "GND" || text == "UNL" || text == "UNLIM") {
      return std::nullopt;
    }
    if (text.starts_with("FL")) {
      if (const std::optional<double> level = parseDecimal(text.substr(2))) {
        return *level * kMetresPerLevel;
      }
    } else if (const std::optional<Length> length = parseLengthWithUnit(field.text, 0.0)) {
      return length->si();
    }
    return refuse(field, "give it with its unit, for example 3000 m, 25000 ft or FL250, or call the field FLOOR_M or TOP_FT");
  }

  const std::string& path_;
  const PolygonFeature& feature_;
};

}  // namespace

Result<WeatherReport> readWeather(const std::string& path) {
  Result<PolygonFile> file = PolygonFile::open(path, fieldNames(), "weather is read from areas");
  if (!file) {
    return forward(file);
  }
  WeatherReport report;
  int withoutPolygon = 0;
  int withoutSuccess = 0;
  int withHoles = 0;
  PolygonFeature feature;
  Result<bool> isRead = file->next(feature);
  for (; isRead && *isRead; isRead = file->next(feature)) {
    if (feature.parts.empty()) {
      ++withoutPolygon;
      continue;
    }
    bool hasSuccess = false;
    Result<mission::WeatherCell> cell = CellReader(path, feature).read(hasSuccess);
    if (!cell) {
      return forward(cell);
    }
    withoutSuccess += hasSuccess ? 0 : 1;
    for (PolygonFeature::Rings& rings : feature.parts) {
      withHoles += rings.size() > 1 ? 1 : 0;
      cell->outline = std::move(rings.front());
      report.cells.push_back(*cell);
    }
  }
  if (!isRead) {
    return forward(isRead);
  }
  if (report.cells.empty()) {
    return fail(Errc::BadFormat, "no feature has a polygon; this is no file of weather", path);
  }
  const auto addNote = [&](int count, const char* one, const char* many) {
    if (count > 0) {
      report.notes.push_back(fmt::format("{}: {} {}", fileName(path), count, count == 1 ? one : many));
    }
  };
  addNote(withoutPolygon, "feature without a polygon is left out; no weather is taken to be there.",
          "features without a polygon are left out; no weather is taken to be there.");
  addNote(withoutSuccess, "cell does not say how likely it is to come through (SUCCESS); 0.9 for a nautical mile is taken.",
          "cells do not say how likely it is to come through (SUCCESS); 0.9 for a nautical mile is taken.");
  addNote(withHoles, "cell has a hole, which counts as weather too.", "cells have holes, which count as weather too.");
  return report;
}

bool isWeatherFile(const std::string& path) {
  Result<PolygonFile> file = PolygonFile::open(path, fieldNames(), {});
  return file && file->hasAnyField(kFloorM, kPerM) && file->beginsWithPolygons();
}

Result<void> writeWeather(const std::string& path, const std::vector<mission::WeatherCell>& cells) {
  JsonValue features = JsonValue::array();
  for (const mission::WeatherCell& cell : cells) {
    JsonValue fields = JsonValue::object();
    if (!cell.name.empty()) {
      fields.set("NAME", cell.name);
    }
    bool isFinite = std::isfinite(cell.success) && std::isfinite(cell.perDistance);
    const auto setHeight = [&](const char* name, const std::optional<double>& height) {
      if (height) {
        isFinite = isFinite && std::isfinite(*height);
        fields.set(name, *height);
      }
    };
    setHeight("FLOOR_M", cell.floor);
    setHeight("TOP_M", cell.top);
    fields.set("SUCCESS", cell.success);
    fields.set("PER_M", cell.perDistance);
    JsonValue ring = JsonValue::array();
    for (std::size_t i = 0; i <= cell.outline.size() && !cell.outline.empty(); ++i) {
      const geo::LatLon& corner = cell.outline[i % cell.outline.size()];
      isFinite = isFinite && std::isfinite(corner.latitude_deg) && std::isfinite(corner.longitude_deg);
      ring.push(JsonValue(JsonValue::Array{corner.longitude_deg, corner.latitude_deg}));
    }
    if (!isFinite) {
      return fail(Errc::OutOfRange, fmt::format("weather {} has a number that is not finite; correct it before it is saved", cell.name), path);
    }
    JsonValue geometry = JsonValue::object();
    geometry.set("type", "Polygon");
    geometry.set("coordinates", JsonValue(JsonValue::Array{std::move(ring)}));
    JsonValue feature = JsonValue::object();
    feature.set("type", "Feature");
    feature.set("properties", std::move(fields));
    feature.set("geometry", std::move(geometry));
    features.push(std::move(feature));
  }
  JsonValue document = JsonValue::object();
  document.set("type", "FeatureCollection");
  document.set("features", std::move(features));
  return writeFileAtomically(path, writeJson(document, {120, {"features"}}));
}

}  // namespace vp::formats
