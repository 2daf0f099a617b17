#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/terrain/raster_file.h"

#include <cstddef>
#include <vector>

namespace vp::terrain::detail {

/** Files whose posts lie on one lattice and whose areas touch, to be read into one array of posts without seams. */
struct Mosaic {
  struct Part {
    std::size_t file = 0;  ///< index into the headers
    int column = 0;        ///< where its first post lies in the mosaic
    int row = 0;
  };
  Crs crs;
  double turn = 0.0;    ///< see RasterHeader
  PostTransform posts;  ///< of the mosaic's post (0, 0)
  int columns = 0;
  int rows = 0;
  double misfit = 0.0;  ///< how far the posts of a part may lie beside the lattice, in posts
  std::vector<Part> parts;

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows); }
};

/** Sorts files into mosaics. Two files share one if all their posts lie on one lattice to 1e-3 post and they overlap,
 *  share their edge posts or lie one post apart. */
std::vector<Mosaic> planMosaics(const std::vector<RasterHeader>& files);

/** Reads the posts of a mosaic, row-major in file order; where files overlap the higher known post counts, and unknown
 *  (kUnknownUpper) is what none knows. @errors BadFile (a file without any known height too), OutOfRange, Cancelled */
Result<std::vector<float>> readMosaic(const Mosaic& mosaic, const std::vector<RasterHeader>& files, const Job& job);

}  // namespace vp::terrain::detail
