#include "core/formats/airfields.h"

#include "core/formats/mission_file.h"

#include <algorithm>
#include <filesystem>

namespace vp::formats {

Result<AirfieldReport> readAirfields(const mission::AirfieldSource& source, const std::string& folder, const mission::SiteFilter& filter,
                                     const std::optional<geo::GeoBox>& area) {
  const std::string airports = resolvePath(folder, source.airports);
  std::string lower = airports;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const bool isCup = lower.ends_with(".cup") || lower.ends_with(".cup.gz");
  if (isCup && !source.runways.empty()) {
    return fail(Errc::BadFormat, "a .cup file holds its runways itself; remove \"runways\"", airports);
  }
  if (isCup) {
    return readCup(airports, filter, area);
  }
  if (!lower.ends_with(".csv") && !lower.ends_with(".csv.gz")) {
    return fail(Errc::BadFormat, "airfields are read from OurAirports .csv files or a SeeYou .cup; this is neither by its name", airports);
  }
  if (source.runways.empty()) {
    return fail(Errc::BadFormat, "an OurAirports file needs its runways file too; add \"runways\": \"runways.csv\" beside it", airports);
  }
  return readOurAirports(airports, resolvePath(folder, source.runways), filter, area);
}

}  // namespace vp::formats
