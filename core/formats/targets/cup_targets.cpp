// Waypoints of a SeeYou .cup, whatever their style; tasks are not read.
#include "core/formats/csv.h"
#include "core/formats/cup_fields.h"
#include "core/formats/named_fields.h"
#include "core/formats/targets/found_targets.h"

#include <fmt/format.h>

namespace vp::formats {

Result<void> findCupTargets(const std::string& path, const std::string& text, FoundTargets& found) {
  CsvReader csv(text, path, CsvQuotes::Lenient);
  CsvRecord record;
  Result<bool> more = csv.next(record);
  if (!more) {
    return forward(more);
  }
  const CupColumns columns(CsvColumns(path, record));
  if (const char* missing = columns.missing()) {
    return fail(Errc::BadFormat, fmt::format("the header has no column \"{}\"", missing), csvPlace(path, 1, 1, {}));
  }
  while (!beginsCupTasks(csv)) {
    if (found.job.stopRequested()) {
      return readingStopped();
    }
    more = csv.next(record);
    if (!more) {
      return forward(more);
    }
    if (!*more) {
      break;
    }
    const std::optional<double> latitude = parseCupAngle(fieldOf(record, columns.latitude), 2, "NS");
    const std::optional<double> longitude = parseCupAngle(fieldOf(record, columns.longitude), 3, "EW");
    if (!latitude || !longitude) {
      found.leftOut.add("lat and lon are no place like 4632.046N 00953.046E", fmt::format("row {}", record.row));
      continue;
    }
    const std::optional<Length> elevation = parseLengthWithUnit(fieldOf(record, columns.elevation), 0.0);
    found.places.push_back(
        {std::string(fieldOf(record, columns.name)), {*latitude, *longitude}, elevation ? std::optional(elevation->si()) : std::nullopt, {}});
  }
  return {};
}

}  // namespace vp::formats
