// Reads terrain files into one grid of the local frame: layout, then mosaic after mosaic read and warped.
#include "core/terrain/terrain_reader.h"

#include "core/terrain/conservative_warp.h"
#include "core/terrain/post_mosaic.h"
#include "core/terrain/raster_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::terrain {
namespace {

using detail::Crs;
using detail::CrsTransform;
using detail::GridLayout;
using detail::RasterHeader;

constexpr double kLargestSpan = 1'500'000.0;  // m; at its corners the local frame is too long by half a per cent
constexpr double kCellStep = 1e-3;            // m; cell sizes are whole millimetres, so that posts spaced 30 m give 30 m
constexpr double kEdgeNoise = 1e-6;           // of a cell: an edge on a multiple of the cell does not begin another one

/// Files in the local frame: where their posts lie, and the finest spacing of their middles [m].
struct Footprint {
  geo::Box box;
  double spacing = std::numeric_limits<double>::infinity();
};

Result<void> addFootprint(const RasterHeader& header, const Crs& frame, Footprint& footprint) {
  auto toFrame = CrsTransform::between(header.crs, frame);
  if (!toFrame) {
    return fail(Errc::BadFile, toFrame.error().what, header.path);
  }
  const geo::Point middle{std::floor(0.5 * header.columns), std::floor(0.5 * header.rows)};
  std::vector<geo::Point> posts{middle, {middle.x - 1.0, middle.y}, {middle.x, middle.y - 1.0}};
  const auto edge = detail::outline(header.columns, header.rows);
  posts.insert(posts.end(), edge.begin(), edge.end());
  std::vector<double> x;
  std::vector<double> y;
  for (const geo::Point& post : posts) {
    const geo::Point at = header.posts.apply(post);
    x.push_back(at.x);
    y.push_back(at.y);
  }
  toFrame->apply(x, y);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i])) {
      return fail(Errc::OutOfRange,
                  "the raster reaches too far from the mission for its local frame; cut out the part around the mission with gdalwarp -te",
                  header.path);
    }
    footprint.box.add({x[i], y[i]});
  }
  footprint.spacing = std::min({footprint.spacing, std::hypot(x[1] - x[0], y[1] - y[0]), std::hypot(x[2] - x[0], y[2] - y[0])});
  return {};
}

/// The grid of one cell size over a box, its origin on multiples of the cell; columns and rows may exceed what an int holds.
struct Span {
  double column0 = 0.0;
  double row0 = 0.0;
  double columns = 0.0;
  double rows = 0.0;
  Span(const geo::Box& box, double cell)
      : column0(std::floor(box.minX / cell + kEdgeNoise)),
        row0(std::floor(box.minY / cell + kEdgeNoise)),
        columns(std::max(1.0, std::ceil(box.maxX / cell - kEdgeNoise) - column0)),
        rows(std::max(1.0, std::ceil(box.maxY / cell - kEdgeNoise) - row0)) {}
  [[nodiscard]] double cells() const { return columns * rows; }
};

Result<GridLayout> layOut(const Footprint& footprint, const ReadOptions& options) {
  const double width = footprint.box.maxX - footprint.box.minX;
  const double height = footprint.box.maxY - footprint.box.minY;
  if (!(width <= kLargestSpan && height <= kLargestSpan)) {
    return fail(Errc::OutOfRange,
                fmt::format("the terrain files together span {:.0f} x {:.0f} km, more than {:.0f} km; load only those around the mission",
                            width / 1000.0, height / 1000.0, kLargestSpan / 1000.0));
  }
  const double most = static_cast<double>(std::clamp<std::size_t>(options.maxCells, 1, std::numeric_limits<int>::max()));
  double cell = options.cell.value_or(std::max(kCellStep, std::round(footprint.spacing / kCellStep) * kCellStep));
  if (!(std::isfinite(cell) && cell > 0.0)) {
    return fail(Errc::OutOfRange, fmt::format("a terrain cell of {} m is not possible; give a size above zero", cell));
  }
  if (options.cell && Span(footprint.box, cell).cells() > most) {
    return fail(Errc::OutOfRange, fmt::format("terrain cells of {} m over {:.0f} x {:.0f} km would be more than {:.0f}; give a larger cell size",
                                              cell, width / 1000.0, height / 1000.0, most));
  }
  double cells = Span(footprint.box, cell).cells();
  while (cells > most) {
    cell = std::ceil(cell * std::max(1.001, std::sqrt(cells / most)) / kCellStep) * kCellStep;
    cells = Span(footprint.box, cell).cells();
  }
  const Span span(footprint.box, cell);
  return GridLayout{span.column0 * cell, span.row0 * cell, cell, static_cast<int>(span.columns), static_cast<int>(span.rows)};
}

Result<std::vector<RasterHeader>> readHeaders(const std::vector<std::string>& files, const Job& job) {
  if (files.empty()) {
    return fail(Errc::BadFile, "no terrain file is named; give at least one elevation raster");
  }
  std::vector<RasterHeader> headers;
  for (const std::string& path : files) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "reading the terrain was stopped");
    }
    const auto file = detail::RasterFile::open(path);
    if (!file) {
      return forward(file);
    }
    headers.push_back(file->header());
  }
  return headers;
}

}  // namespace

Result<ElevationGrid> readTerrain(const std::vector<std::string>& files, const geo::LocalFrame& frame, const ReadOptions& options, const Job& job) {
  const auto headers = readHeaders(files, job);
  if (!headers) {
    return forward(headers);
  }
  const auto frameCrs = detail::crsOf(frame);
  if (!frameCrs) {
    return forward(frameCrs);
  }
  Footprint footprint;
  for (const RasterHeader& header : *headers) {
    if (const auto added = addFootprint(header, *frameCrs, footprint); !added) {
      return forward(added);
    }
  }
  const auto layout = layOut(footprint, options);
  if (!layout) {
    return forward(layout);
  }
  const auto mosaics = detail::planMosaics(*headers);
  double total = 0.0;
  for (const auto& mosaic : mosaics) {
    total += static_cast<double>(mosaic.size());
  }
  std::vector<float> cells(layout->size(), kUnknownUpper);
  double done = 0.0;
  for (const auto& mosaic : mosaics) {
    const Job part = job.part(done / total, (done + static_cast<double>(mosaic.size())) / total);
    auto posts = detail::readMosaic(mosaic, *headers, part.part(0.0, 0.6));
    if (!posts) {
      return forward(posts);
    }
    if (const auto warped = detail::warpInto(mosaic, *posts, *frameCrs, *layout, cells, part.part(0.6, 1.0)); !warped) {
      return forward(warped);
    }
    done += static_cast<double>(mosaic.size());
  }
  job.progress(1.0, "terrain: read");
  return ElevationGrid(layout->originX, layout->originY, layout->cell, layout->columns, layout->rows, std::move(cells));
}

}  // namespace vp::terrain
