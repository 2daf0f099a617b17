#include "core/terrain/post_mosaic.h"

#include "core/base/expect.h"
#include "core/terrain/elevation_grid.h"

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>

namespace vp::terrain::detail {
namespace {

constexpr double kAlignedPosts = 1e-3;
constexpr std::size_t kMaxMosaicPosts = 300'000'000;  // 1.2 GB while they are being warped

/// A file's place on the lattice of another, in whole posts.
struct Placement {
  std::size_t file = 0;
  std::int64_t column = 0;
  std::int64_t row = 0;
  double misfit = 0.0;
};

/// Longitudes repeat: the file's transform moved by whole turns to lie nearest to the reference.
PostTransform nearestTurn(const RasterHeader& file, const RasterHeader& reference) {
  PostTransform moved = file.posts;
  if (file.turn > 0.0) {
    moved.x0 -= file.turn * std::round((file.posts.x0 - reference.posts.x0) / file.turn);
  }
  return moved;
}

std::optional<Placement> placeOn(const RasterHeader& reference, const RasterHeader& file, std::size_t index) {
  const auto inverse = reference.posts.inverse();
  VP_EXPECT(inverse.has_value());
  const PostTransform posts = nearestTurn(file, reference);
  const geo::Point first = inverse->apply(posts.apply({0.0, 0.0}));
  if (!(std::abs(first.x) < 1e8 && std::abs(first.y) < 1e8)) {
    return std::nullopt;
  }
  Placement placement{index, std::llround(first.x), std::llround(first.y), 0.0};
  for (const double column : {0.0, file.columns - 1.0}) {
    for (const double row : {0.0, file.rows - 1.0}) {
      const geo::Point at = inverse->apply(posts.apply({column, row}));
      const double du = at.x - (static_cast<double>(placement.column) + column);
      const double dv = at.y - (static_cast<double>(placement.row) + row);
      placement.misfit = std::max({placement.misfit, std::abs(du), std::abs(dv)});
    }
  }
  return placement.misfit <= kAlignedPosts ? std::optional<Placement>(placement) : std::nullopt;
}

bool isSameCrs(const RasterHeader& a, const RasterHeader& b) {
  static constexpr std::array<const char*, 3> kOptions{"CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS", "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                                       nullptr};
  return a.crs->IsSame(b.crs.get(), kOptions.data()) != 0;
}

bool touch(const Placement& a, const RasterHeader& fileA, const Placement& b, const RasterHeader& fileB) {
  return b.column <= a.column + fileA.columns && a.column <= b.column + fileB.columns && b.row <= a.row + fileA.rows && a.row <= b.row + fileB.rows;
}

/// Splits the files of one lattice into clusters that touch, so that files far apart do not span a huge empty array.
std::vector<std::vector<Placement>> clusters(const std::vector<Placement>& placed, const std::vector<RasterHeader>& files) {
  std::vector<std::size_t> clusterOf(placed.size());
  std::iota(clusterOf.begin(), clusterOf.end(), std::size_t{0});
  for (std::size_t a = 0; a < placed.size(); ++a) {
    for (std::size_t b = a + 1; b < placed.size(); ++b) {
      if (clusterOf[a] != clusterOf[b] && touch(placed[a], files[placed[a].file], placed[b], files[placed[b].file])) {
        std::replace(clusterOf.begin(), clusterOf.end(), std::size_t{clusterOf[b]}, std::size_t{clusterOf[a]});
      }
    }
  }
  std::vector<std::vector<Placement>> all(placed.size());
  for (std::size_t i = 0; i < placed.size(); ++i) {
    all[clusterOf[i]].push_back(placed[i]);
  }
  std::erase_if(all, [](const auto& cluster) { return cluster.empty(); });
  return all;
}

Mosaic assemble(const std::vector<Placement>& cluster, const RasterHeader& reference, const std::vector<RasterHeader>& files) {
  std::int64_t west = cluster.front().column;
  std::int64_t top = cluster.front().row;
  std::int64_t east = west;
  std::int64_t bottom = top;
  Mosaic mosaic;
  for (const Placement& p : cluster) {
    west = std::min(west, p.column);
    top = std::min(top, p.row);
    east = std::max(east, p.column + files[p.file].columns);
    bottom = std::max(bottom, p.row + files[p.file].rows);
    mosaic.misfit = std::max(mosaic.misfit, p.misfit);
  }
  mosaic.crs = reference.crs;
  mosaic.turn = reference.turn;
  mosaic.posts = reference.posts;
  const geo::Point origin = reference.posts.apply({static_cast<double>(west), static_cast<double>(top)});
  mosaic.posts.x0 = origin.x;
  mosaic.posts.y0 = origin.y;
  const bool isCountable = std::max(east - west, bottom - top) <= std::numeric_limits<int>::max();
  mosaic.columns = isCountable ? static_cast<int>(east - west) : std::numeric_limits<int>::max();  // readMosaic refuses so many
  mosaic.rows = isCountable ? static_cast<int>(bottom - top) : std::numeric_limits<int>::max();
  for (const Placement& p : cluster) {
    mosaic.parts.push_back({p.file, static_cast<int>(p.column - west), static_cast<int>(p.row - top)});
  }
  return mosaic;
}

/// Reads one file into its place. Returns whether it knows any height.
Result<bool> paste(const Mosaic& mosaic, const Mosaic::Part& part, RasterFile& file, std::vector<float>& posts, const Job& job) {
  const int columns = file.header().columns;
  const int rows = file.header().rows;
  std::vector<float> heights;
  bool isAnyKnown = false;
  for (int first = 0; first < rows; first += file.rowsPerRead()) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "reading the terrain was stopped");
    }
    const int count = std::min(file.rowsPerRead(), rows - first);
    if (const auto read = file.readRows(first, count, heights); !read) {
      return forward(read);
    }
    for (int row = 0; row < count; ++row) {
      const float* from = heights.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(columns);
      float* to = posts.data() + static_cast<std::size_t>(part.row + first + row) * static_cast<std::size_t>(mosaic.columns) + part.column;
      for (int column = 0; column < columns; ++column) {
        isAnyKnown |= from[column] < kUnknownUpper;
        // higher of the known, else the known one, else unknown
        const bool takes = to[column] == kUnknownUpper || (from[column] > to[column] && from[column] < kUnknownUpper);
        to[column] = takes ? from[column] : to[column];
      }
    }
    job.progress(static_cast<double>(first + count) / rows, "terrain: reading heights");
  }
  return isAnyKnown;
}

}  // namespace

std::vector<Mosaic> planMosaics(const std::vector<RasterHeader>& files) {
  std::vector<std::vector<Placement>> lattices;
  for (std::size_t i = 0; i < files.size(); ++i) {
    bool isPlaced = false;
    for (auto& lattice : lattices) {
      const RasterHeader& reference = files[lattice.front().file];
      const auto placement = isSameCrs(reference, files[i]) ? placeOn(reference, files[i], i) : std::nullopt;
      if (placement) {
        lattice.push_back(*placement);
        isPlaced = true;
        break;
      }
    }
    if (!isPlaced) {
      lattices.push_back({Placement{i, 0, 0, 0.0}});
    }
  }
  std::vector<Mosaic> mosaics;
  for (const auto& lattice : lattices) {
    for (const auto& cluster : clusters(lattice, files)) {
      mosaics.push_back(assemble(cluster, files[lattice.front().file], files));
    }
  }
  return mosaics;
}

Result<std::vector<float>> readMosaic(const Mosaic& mosaic, const std::vector<RasterHeader>& files, const Job& job) {
  if (mosaic.size() > kMaxMosaicPosts) {
    return fail(Errc::OutOfRange,
                fmt::format("the terrain files that join here span {} x {} heights, more than {} million; cut out the part that the mission needs or "
                            "use coarser files",
                            mosaic.columns, mosaic.rows, kMaxMosaicPosts / 1'000'000),
                files[mosaic.parts.front().file].path);
  }
  std::vector<float> posts(mosaic.size(), kUnknownUpper);
  const double parts = static_cast<double>(mosaic.parts.size());
  for (std::size_t i = 0; i < mosaic.parts.size(); ++i) {
    const Mosaic::Part& part = mosaic.parts[i];
    auto file = RasterFile::open(files[part.file].path);
    if (!file) {
      return forward(file);
    }
    if (file->header().columns != files[part.file].columns || file->header().rows != files[part.file].rows) {
      return fail(Errc::BadFile, "the file changed while it was being read; try again", files[part.file].path);
    }
    const auto isAnyKnown = paste(mosaic, part, *file, posts, job.part(static_cast<double>(i) / parts, static_cast<double>(i + 1) / parts));
    if (!isAnyKnown) {
      return forward(isAnyKnown);
    }
    if (!*isAnyKnown) {
      return fail(Errc::BadFile, "the raster holds no height at all, only no-data; leave it out or fetch it again", files[part.file].path);
    }
  }
  return posts;
}

}  // namespace vp::terrain::detail
