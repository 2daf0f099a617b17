#pragma once

#include "core/audit/ground.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/local_frame.h"

#include <memory>
#include <string>
#include <vector>

namespace vp::audit {

/** Terrain files as their posts, unchanged: no cells, no warp. A place counts as high as the highest of the four posts around it
 *  (DESIGN section 2), found by projecting the place into the file's own coordinates.
 *
 *  Shares no code with core/terrain. Posts are pixel centres. Where files of one lattice meet, posts of both surround a place, and where they
 *  overlap the higher known post counts; of files of different lattices the higher known ground. A void among the four posts makes the place
 *  unknown, as does the outside of all files; -9999, -99999, -32767, -32768 and heights outside -500 to 9000 m are voids.
 *  @threads const members are pure; each thread takes a lookup of its own   @accuracy places: that of PROJ, well below 1 cm */
class RawGround {
public:
  /** @param origin  of the local frame, azimuthal equidistant on WGS 84
   *  @errors BadFile (no raster, no coordinate system, unknown unit), Unsupported (no way into its coordinates), Cancelled */
  static Result<RawGround> read(const std::vector<std::string>& files, geo::LatLon origin, const Job& job);

  /** A lookup for one thread; it holds what it needs of this. @errors Unsupported */
  [[nodiscard]] Result<GroundLookup> lookup() const;

  /** Places given in degrees, in the frame [m]. @errors Unsupported */
  [[nodiscard]] static Result<std::vector<geo::Point>> toFrame(geo::LatLon origin, const std::vector<geo::LatLon>& places);

private:
  struct Posts;
  std::shared_ptr<const Posts> posts_;
};

}  // namespace vp::audit
