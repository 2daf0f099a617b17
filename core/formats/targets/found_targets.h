#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/formats/airfield_candidates.h"
#include "core/formats/geojson_features.h"
#include "core/geo/local_frame.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::formats {

/** What the reader of one format found, before it becomes targets. */
struct FoundTargets {
  struct Place {
    std::string name;  ///< "" = has none
    geo::LatLon position;
    std::optional<double> heightMsl_m;
    std::optional<double> heightAboveGround_m;
  };
  struct Area {
    std::string name;
    std::vector<geo::LatLon> ring;
    std::vector<std::vector<geo::LatLon>> holes;
  };
  std::vector<Place> places;
  std::vector<Area> areas;
  LeftOut leftOut;
  std::size_t trackPoints = 0;   ///< seen but not asked for
  bool heightsAreFlown = false;  ///< the heights are meant to be flown at, not those of the ground below
  Job job;                       ///< that the readers of long files ask whether to go on
};

inline tl::unexpected<Error> readingStopped() {
  return fail(Errc::Cancelled, "reading the targets was stopped");
}

/** One reader per format; `text` is the file's content. Rows and elements that cannot be used go to leftOut with their line.
 *  @errors BadFormat - the structure is not that of the format; Cancelled */
Result<void> findCupTargets(const std::string& path, const std::string& text, FoundTargets& found);
Result<void> findGpxTargets(const std::string& path, const std::string& text, bool tracks, FoundTargets& found);
Result<void> findKmlTargets(const std::string& path, const std::string& text, bool tracks, FoundTargets& found);
Result<void> findTableTargets(const std::string& path, const std::string& text, FoundTargets& found);
Result<void> findQgcTargets(const std::string& path, const std::string& text, FoundTargets& found);
Result<void> findLnmTargets(const std::string& path, const std::string& text, FoundTargets& found);
Result<void> findGeoJsonTargets(const std::string& path, FoundTargets& found);

/** True if a table with this header has places. */
bool isTargetTableHeader(std::string_view line);

/** A place of two numbers of degrees; nothing if it is none on Earth. */
std::optional<geo::LatLon> placeOfDegrees(std::string_view latitude, std::string_view longitude);

}  // namespace vp::formats
