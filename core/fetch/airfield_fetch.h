#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/fetch/http.h"
#include "core/geo/local_frame.h"

#include <cstdint>
#include <optional>
#include <string>

namespace vp::fetch {

/** Where OurAirports puts its files every night. @source ourairports.com/data */
inline constexpr const char* kAirfieldServer = "https://davidmegginson.github.io/ourairports-data";

struct AirfieldRequest {
  std::string server;  ///< empty: environment VOLPLANE_AIRFIELDS_URL, else kAirfieldServer
  std::string cache;   ///< empty: cacheFolder()
  Patience patience;
};

/** The two files of OurAirports on this machine. */
struct AirfieldFiles {
  std::string airports;      ///< path of airports.csv
  std::string runways;       ///< path of runways.csv
  std::string fetched;       ///< when, "2026-05-07T09:30:00Z"
  std::size_t sites = 0;     ///< landing sites in them; 0 where they were not read
  std::uint64_t bytes = 0;   ///< that came from the server this time
  bool wasUpToDate = false;  ///< the server has nothing newer
};

/** Files fetched earlier. @return nothing if there are none   @errors as checkedBase, cacheFolder */
Result<std::optional<AirfieldFiles>> cachedAirfields(const AirfieldRequest& request);

/** Bytes that updateAirfields would fetch. @errors BadFile, Cancelled */
Result<std::uint64_t> airfieldBytes(const AirfieldRequest& request, const Job& job);

/** Fetches airports.csv and runways.csv. The new ones replace the old ones only when both are here and have been read as what they
 *  should be, with landing sites in them; otherwise the old ones stay.
 *  @errors BadFile, BadFormat, OutputFailed, Cancelled */
Result<AirfieldFiles> updateAirfields(const AirfieldRequest& request, const Job& job);

/** Where an airfield is, by its ident, ICAO, GPS, IATA or local code, in this order; case does not matter.
 *  @param file  OurAirports airports.csv (also .gz) or a SeeYou .cup   @errors BadFile, BadFormat, OutOfRange - no such airfield */
Result<geo::LatLon> placeOfAirfield(const std::string& file, const std::string& code);

}  // namespace vp::fetch
