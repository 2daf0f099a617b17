#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/local_frame.h"
#include "core/terrain/elevation_grid.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::terrain {

/** What a set of terrain files covers, without reading the posts. */
struct TerrainInfo {
  struct File {
    std::string path;
    std::string driver;  ///< GDAL short name, "GTiff"
    std::string crs;     ///< name of the coordinate system
    int columns = 0;
    int rows = 0;
    double spacing_m = 0.0;  ///< smaller of the two post spacings on the ground
    geo::LatLon southWest;
    geo::LatLon northEast;
  };
  std::vector<File> files;
  geo::LatLon southWest;  ///< of all files together
  geo::LatLon northEast;
  double spacing_m = 0.0;  ///< finest of all

  /** Middle of the covered area, rounded to 0.001 degree: the default origin of the local frame. */
  [[nodiscard]] geo::LatLon centre() const;
};

/** Looks at terrain files: opens, checks that they are rasters with a coordinate system and one band of heights.
 *  @errors BadFile (not there, truncated, no raster, no CRS) naming the file and what to do */
Result<TerrainInfo> inspectTerrain(const std::vector<std::string>& files);

struct ReadOptions {
  std::optional<double> cell;  ///< m; default: the finest post spacing of the files, coarser if the grid would exceed maxCells
  std::size_t maxCells = 40'000'000;
};

/** Reads terrain files as one mosaic and warps it to the local frame *conservatively*: every cell is at least the
 *  highest source post that surrounds any of its points, so the result is never below the source's posts; a cell that
 *  touches no-data or the outside of all files is unknown.
 *  A raster of the formats in the README of this folder, any CRS, any affine geotransform; band scale, offset, unit (m, ft) and no-data are applied;
 * posts are the pixel centres. Files of one CRS and spacing join without a seam; where files overlap the higher post counts.
 *  @errors BadFile, OutOfRange, Cancelled   @cost 1 x 1 degree at 3 arc seconds well below 2 s */
Result<ElevationGrid> readTerrain(const std::vector<std::string>& files, const geo::LocalFrame& frame, const ReadOptions& options, const Job& job);

/** SHA-256 of a file's bytes, lower-case hex. @errors BadFile, Cancelled */
Result<std::string> sha256OfFile(const std::string& path, const Job& job = Job{});

}  // namespace vp::terrain
