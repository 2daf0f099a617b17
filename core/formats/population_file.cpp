#include "core/formats/population_file.h"

#include "core/formats/named_fields.h"
#include "core/formats/polygon_file.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <utility>

namespace vp::formats {
namespace {

constexpr double kSquareKm = 1e6;  // m^2

enum Field { kDensity, kPeople, kLand, kLabel };

const FieldNames& fieldNames() {
  static const FieldNames names(
      {{"density", "pop_density", "popdens", "pop_dens", "pop_km2", "per_km2", "density_km2", "persons_per_km2", "people_per_km2"},
       {"pop", "population", "people", "persons", "total_pop", "totpop", "pop100", "pop2000", "pop2010", "pop2020", "p1_001n", "b01001_001e"},
       {"aland", "aland10", "aland20", "arealand"},
       {"name", "geoid", "geoid10", "geoid20", "stfid", "tractid", "id"}});
  return names;
}

mission::PopulationArea areaOf(PolygonFeature feature, const std::string& path) {
  mission::PopulationArea area;
  area.source = path;
  area.name = fmt::format("feature {}", feature.number);
  if (const std::string& label = feature.fields[kLabel].text; !label.empty()) {
    area.name += fmt::format(" ({})", label);
  }
  for (PolygonFeature::Rings& rings : feature.parts) {
    mission::PopulatedPolygon part;
    part.outline = std::move(rings.front());
    part.holes.assign(std::make_move_iterator(rings.begin() + 1), std::make_move_iterator(rings.end()));
    area.parts.push_back(std::move(part));
  }
  area.perSquareKm = feature.fields[kDensity].number;
  if (!area.perSquareKm) {
    area.people = feature.fields[kPeople].number;
    const std::optional<double> land = feature.fields[kLand].number;
    if (area.people && land && *land > 0.0) {
      area.perSquareKm = *area.people / (*land / kSquareKm);
      area.people.reset();
    }
  }
  return area;
}

}  // namespace

Result<PopulationReport> readPopulation(const std::string& path) {
  Result<PolygonFile> file = PolygonFile::open(path, fieldNames(), "population is read from areas with people in them");
  if (!file) {
    return forward(file);
  }
  if (!file->hasField(kDensity) && !file->hasField(kPeople)) {
    return fail(Errc::BadFormat,
                "no field of this file says how many people live in its polygons; call one POPULATION, or DENSITY for people per square kilometre",
                path);
  }
  PopulationReport report;
  int withoutPolygon = 0;
  int withoutNumber = 0;
  PolygonFeature feature;
  Result<bool> isRead = file->next(feature);
  for (; isRead && *isRead; isRead = file->next(feature)) {
    mission::PopulationArea area = areaOf(std::move(feature), path);
    if (area.parts.empty()) {
      ++withoutPolygon;
    } else if (!area.people && !area.perSquareKm) {
      ++withoutNumber;
    } else {
      report.areas.push_back(std::move(area));
    }
  }
  if (!isRead) {
    return forward(isRead);
  }
  const auto addNote = [&](int count, const char* what) {
    if (count > 0) {
      report.notes.push_back(count == 1 ? fmt::format("{}: 1 feature {} left out; nobody is taken to live there.", fileName(path), what)
                                        : fmt::format("{}: {} features {} left out; nobody is taken to live there.", fileName(path), count, what));
    }
  };
  addNote(withoutPolygon, "without a polygon");
  addNote(withoutNumber, "without a number of people");
  if (report.areas.empty()) {
    return fail(Errc::BadFormat, "no feature has both a polygon and a number of people; this is no file of population", path);
  }
  return report;
}

bool isPopulationFile(const std::string& path) {
  Result<PolygonFile> file = PolygonFile::open(path, fieldNames(), {});
  return file && file->hasAnyField(kDensity, kPeople) && file->beginsWithPolygons();
}

}  // namespace vp::formats
