#include "core/fetch/terrain_area.h"

#include "core/fetch/raster_output.h"
#include "core/terrain/gdal_support.h"

#include <fmt/format.h>
#include <gdal_priv.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <system_error>

namespace vp::fetch {
namespace {

constexpr double kSamePost = 1e-3;  // of a spacing; files that lie further apart are not on one lattice

/// An open tile with its place on a lattice.
struct Source {
  TileFile file;
  std::unique_ptr<GDALDataset> raster;
  std::optional<double> noData;
  std::int64_t column = 0;  ///< of its first post
  std::int64_t row = 0;
  std::int64_t columns = 0;
  std::int64_t rows = 0;
};

/// Tiles whose posts are of one spacing and line. Post (c, r) lies at (x0 + c dx, y0 - r dy).
struct Lattice {
  double x0 = 0.0;
  double y0 = 0.0;
  double dx = 0.0;
  double dy = 0.0;
  std::vector<Source> sources;

  struct Extent {
    std::int64_t left = 0;
    std::int64_t right = 0;  ///< last column
    std::int64_t top = 0;
    std::int64_t bottom = 0;  ///< last row
  };
  [[nodiscard]] Extent extent() const {
    Extent all{INT64_MAX, INT64_MIN, INT64_MAX, INT64_MIN};
    for (const Source& source : sources) {
      all.left = std::min(all.left, source.column);
      all.right = std::max(all.right, source.column + source.columns - 1);
      all.top = std::min(all.top, source.row);
      all.bottom = std::max(all.bottom, source.row + source.rows - 1);
    }
    return all;
  }
};

/// Rows that a coarser lattice is continued by over a finer one beside it. About a kilometre: the terrain reader knows a cell only
/// where one lattice covers the whole of it, so the overlap must be wider than a cell.
constexpr std::int64_t kSeamRows = 33;

struct Seam {
  std::int64_t first = 0;  ///< row of the coarser lattice
  std::int64_t rows = 0;
  const Lattice* finer = nullptr;
  std::int64_t finerFirst = 0;  ///< the same parallel in the finer lattice
};

bool isWhole(double value) {
  return std::abs(value - std::round(value)) < kSamePost;
}

Result<void> addSource(std::vector<Lattice>& lattices, const TileFile& file) {
  const terrain::detail::GdalMessages messages;
  Source source;
  source.file = file;
  const Result<GDALDataset*> opened = terrain::detail::openDataset(file.path, terrain::detail::Content::Raster);
  source.raster.reset(opened ? *opened : nullptr);
  std::array<double, 6> at{};
  if (source.raster == nullptr || source.raster->GetGeoTransform(at.data()) != CE_None) {
    return fail(Errc::BadFile, "the tile cannot be read" + messages.inBrackets() + "; remove it and fetch it again", file.path);
  }
  int hasNoData = 0;
  const double noData = source.raster->GetRasterBand(1)->GetNoDataValue(&hasNoData);
  source.noData = hasNoData != 0 ? std::optional(noData) : std::nullopt;
  source.columns = source.raster->GetRasterXSize();
  source.rows = source.raster->GetRasterYSize();
  const double x = at[0] + at[1] / 2.0;
  const double y = at[3] + at[5] / 2.0;
  const auto fits = [&](const Lattice& lattice) {
    return std::abs(lattice.dx - at[1]) * static_cast<double>(source.columns) < kSamePost * at[1] &&
           std::abs(lattice.dy + at[5]) * static_cast<double>(source.rows) < kSamePost * lattice.dy && isWhole((x - lattice.x0) / lattice.dx) &&
           isWhole((lattice.y0 - y) / lattice.dy);
  };
  auto lattice = std::find_if(lattices.begin(), lattices.end(), fits);
  if (lattice == lattices.end()) {
    lattices.push_back({x, y, at[1], -at[5], {}});
    lattice = lattices.end() - 1;
  }
  source.column = std::llround((x - lattice->x0) / lattice->dx);
  source.row = std::llround((lattice->y0 - y) / lattice->dy);
  lattice->sources.push_back(std::move(source));
  return {};
}

/// Posts of `count` rows from column `left`, `width` wide; unknown where no tile is or says so. Where tiles overlap the higher counts.
Result<std::vector<float>> readPosts(const Lattice& lattice, std::int64_t left, std::int64_t width, std::int64_t top, std::int64_t count) {
  const terrain::detail::GdalMessages messages;
  std::vector<float> posts(static_cast<std::size_t>(width * count), kNoHeight);
  std::vector<float> part;
  for (const Source& source : lattice.sources) {
    const std::int64_t c0 = std::max(left, source.column);
    const std::int64_t c1 = std::min(left + width, source.column + source.columns);
    const std::int64_t r0 = std::max(top, source.row);
    const std::int64_t r1 = std::min(top + count, source.row + source.rows);
    if (c0 >= c1 || r0 >= r1) {
      continue;
    }
    const auto w = static_cast<int>(c1 - c0);
    const auto h = static_cast<int>(r1 - r0);
    part.resize(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
    if (source.raster->GetRasterBand(1)->RasterIO(GF_Read, static_cast<int>(c0 - source.column), static_cast<int>(r0 - source.row), w, h, part.data(),
                                                  w, h, GDT_Float32, 0, 0, nullptr) != CE_None) {
      return fail(Errc::BadFile, "the tile is damaged" + messages.inBrackets() + "; remove it and fetch it again", source.file.path);
    }
    for (std::int64_t i = 0; i < static_cast<std::int64_t>(part.size()); ++i) {
      const float height = part[static_cast<std::size_t>(i)];
      if (!std::isfinite(height) || (source.noData && static_cast<double>(height) == *source.noData)) {
        continue;
      }
      float& post = posts[static_cast<std::size_t>((r0 - top + i / w) * width + (c0 - left) + i % w)];
      post = std::max(post, height);
    }
  }
  return posts;
}

/// Where finer neighbours continue this lattice.
std::vector<Seam> seamsOf(const Lattice& lattice, const std::vector<Lattice>& all) {
  std::vector<Seam> seams;
  const Lattice::Extent mine = lattice.extent();
  for (const Lattice& other : all) {
    const Lattice::Extent its = other.extent();
    if (!(other.dx < lattice.dx * 0.999)) {
      continue;
    }
    const double itsTop = (lattice.y0 - (other.y0 - static_cast<double>(its.top) * other.dy)) / lattice.dy;  // in rows of this lattice
    const double itsBottom = (lattice.y0 - (other.y0 - static_cast<double>(its.bottom) * other.dy)) / lattice.dy;
    if (std::abs(itsTop - static_cast<double>(mine.bottom + 1)) < kSamePost) {
      seams.push_back({mine.bottom + 1, std::min(kSeamRows, its.bottom - its.top + 1), &other, its.top});
    } else if (std::abs(itsBottom - static_cast<double>(mine.top - 1)) < kSamePost) {
      const std::int64_t rows = std::min(kSeamRows, its.bottom - its.top + 1);
      seams.push_back({mine.top - rows, rows, &other, its.bottom - rows + 1});
    }
  }
  return seams;
}

/// The posts of one row of a seam: each the highest finer post within one step, unknown if one of them is.
Result<std::vector<float>> readSeam(const Lattice& lattice, const Seam& seam, std::int64_t rowOfSeam, std::int64_t left, std::int64_t width) {
  const Lattice& finer = *seam.finer;
  const Lattice::Extent its = finer.extent();
  const Result<std::vector<float>> row = readPosts(finer, its.left, its.right - its.left + 1, seam.finerFirst + rowOfSeam, 1);
  if (!row) {
    return row;
  }
  std::vector<float> posts(static_cast<std::size_t>(width), kNoHeight);
  const double ratio = lattice.dx / finer.dx;
  for (std::int64_t c = 0; c < width; ++c) {
    const double place = (lattice.x0 + static_cast<double>(left + c) * lattice.dx - finer.x0) / finer.dx;
    const std::int64_t from = std::max(its.left, static_cast<std::int64_t>(std::floor(place - ratio + kSamePost)));
    const std::int64_t to = std::min(its.right, static_cast<std::int64_t>(std::ceil(place + ratio - kSamePost)));
    float highest = kNoHeight;
    bool isKnown = from <= to;
    for (std::int64_t f = from; f <= to; ++f) {
      const float height = (*row)[static_cast<std::size_t>(f - its.left)];
      isKnown = isKnown && height != kNoHeight;
      highest = std::max(highest, height);
    }
    posts[static_cast<std::size_t>(c)] = isKnown ? highest : kNoHeight;
  }
  return posts;
}

/// Posts around the area, one more on each side, as far as there are tiles or seams.
Lattice::Extent windowOf(const Lattice& lattice, const std::vector<Seam>& seams, const geo::GeoBox& area) {
  const auto before = [](double post) { return static_cast<std::int64_t>(std::floor(post)) - 1; };
  const auto after = [](double post) { return static_cast<std::int64_t>(std::ceil(post)) + 1; };
  Lattice::Extent window = lattice.extent();
  for (const Seam& seam : seams) {
    window.top = std::min(window.top, seam.first);
    window.bottom = std::max(window.bottom, seam.first + seam.rows - 1);
  }
  window.left = std::max(window.left, before((area.southWest.longitude_deg - lattice.x0) / lattice.dx));
  window.right = std::min(window.right, after((area.northEast.longitude_deg - lattice.x0) / lattice.dx));
  window.top = std::max(window.top, before((lattice.y0 - area.northEast.latitude_deg) / lattice.dy));
  window.bottom = std::min(window.bottom, after((lattice.y0 - area.southWest.latitude_deg) / lattice.dy));
  return window;
}

/// Puts what seams know into a strip of posts that begins at row `first` of the window.
Result<void> fillSeams(const Lattice& lattice, const std::vector<Seam>& seams, const Lattice::Extent& window, std::int64_t first,
                       std::vector<float>& posts) {
  const std::int64_t width = window.right - window.left + 1;
  const std::int64_t count = static_cast<std::int64_t>(posts.size()) / width;
  for (const Seam& seam : seams) {
    const std::int64_t top = seam.first - window.top - first;  // in the strip
    for (std::int64_t row = std::max<std::int64_t>(top, 0); row < std::min(top + seam.rows, count); ++row) {
      const Result<std::vector<float>> filled = readSeam(lattice, seam, row - top, window.left, width);
      if (!filled) {
        return forward(filled);
      }
      std::copy(filled->begin(), filled->end(), posts.begin() + row * width);
    }
  }
  return {};
}

std::string tilesOfKind(const Lattice& lattice, const std::string& kind) {
  std::string names;
  for (const Source& source : lattice.sources) {
    if (source.file.kind == kind) {
      names += (names.empty() ? "" : " ") + shortNameOf(source.file.tile);
    }
  }
  return names.empty() ? "none" : names;
}

std::map<std::string, std::string> wordsFor(const Lattice& lattice) {
  return {{"VOLPLANE_KIND", "terrain"},
          {"VOLPLANE_TILES", tilesOfKind(lattice, "terrain")},
          {"VOLPLANE_OCEAN_TILES", tilesOfKind(lattice, "ocean")},
          {"VOLPLANE_UNKNOWN_TILES", tilesOfKind(lattice, "unknown")},
          {"TIFFTAG_IMAGEDESCRIPTION", "Copernicus GLO-30 surface model, heights above EGM2008 in metres, posts copied and not resampled"},
          {"TIFFTAG_COPYRIGHT", kTerrainCredit}};
}

Result<void> writeLattice(const Lattice& lattice, const std::vector<Seam>& seams, const Lattice::Extent& window, const std::string& path,
                          const Job& job) {
  const std::int64_t width = window.right - window.left + 1;
  const std::int64_t height = window.bottom - window.top + 1;
  RasterPlace place;
  place.stepX = lattice.dx;
  place.stepY = lattice.dy;
  place.west = lattice.x0 + (static_cast<double>(window.left) - 0.5) * lattice.dx;
  place.north = lattice.y0 - (static_cast<double>(window.top) - 0.5) * lattice.dy;
  place.columns = static_cast<int>(width);
  place.rows = static_cast<int>(height);
  Result<RasterOutput> output = RasterOutput::create(path, place, wordsFor(lattice));
  if (!output) {
    return forward(output);
  }
  constexpr std::int64_t kAtOnce = 512;  // rows, as the blocks of the file
  for (std::int64_t first = 0; first < height; first += kAtOnce) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "fetching was stopped; the tiles that are here stay");
    }
    job.progress(static_cast<double>(first) / static_cast<double>(height), "joining the tiles");
    const std::int64_t count = std::min(kAtOnce, height - first);
    Result<std::vector<float>> posts = readPosts(lattice, window.left, width, window.top + first, count);
    if (!posts) {
      return forward(posts);
    }
    if (const Result<void> filled = fillSeams(lattice, seams, window, first, *posts); !filled) {
      return filled;
    }
    if (Result<void> written = output->writeRows(static_cast<int>(first), static_cast<int>(count), *posts); !written) {
      return written;
    }
  }
  return output->finish();
}

std::string numbered(const std::string& output, std::size_t number) {
  if (number == 0) {
    return output;
  }
  const std::filesystem::path path(output);
  return (path.parent_path() / fmt::format("{}-{}{}", path.stem().string(), number + 1, path.extension().string())).string();
}

}  // namespace

Result<std::vector<std::string>> cutArea(const std::vector<TileFile>& tiles, const geo::GeoBox& area, const std::string& output, const Job& job) {
  std::vector<Lattice> lattices;
  for (const TileFile& tile : tiles) {
    if (const Result<void> added = addSource(lattices, tile); !added) {
      return forward(added);
    }
  }
  std::vector<std::string> files;
  std::error_code ignored;
  for (std::size_t i = 0; i < lattices.size(); ++i) {
    const std::vector<Seam> seams = seamsOf(lattices[i], lattices);
    const Lattice::Extent window = windowOf(lattices[i], seams, area);
    if (window.left >= window.right || window.top >= window.bottom) {
      continue;
    }
    const auto part = static_cast<double>(lattices.size());
    const std::string path = numbered(output, files.size());
    const Result<void> written =
        writeLattice(lattices[i], seams, window, path, job.part(static_cast<double>(i) / part, (static_cast<double>(i) + 1.0) / part));
    if (!written) {
      for (const std::string& file : files) {
        std::filesystem::remove(file, ignored);  // all or none
      }
      return forward(written);
    }
    files.push_back(path);
  }
  if (files.empty()) {
    return fail(Errc::OutOfRange, "the area holds no post of the terrain; choose a larger one");
  }
  return files;
}

}  // namespace vp::fetch
