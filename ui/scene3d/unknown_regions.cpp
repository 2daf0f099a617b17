#include "ui/scene3d/unknown_regions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace vp::scene3d {
namespace {

/// Regions that turn out to touch are joined: the smaller number stands for both.
class Joined {
public:
  int add() {
    parent_.push_back(static_cast<int>(parent_.size()));
    return parent_.back();
  }
  int rootOf(int region) {
    while (parent_[static_cast<std::size_t>(region)] != region) {
      int& up = parent_[static_cast<std::size_t>(region)];
      up = parent_[static_cast<std::size_t>(up)];
      region = up;
    }
    return region;
  }
  void join(int a, int b) {
    a = rootOf(a);
    b = rootOf(b);
    parent_[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  }
  [[nodiscard]] std::size_t size() const { return parent_.size(); }

private:
  std::vector<int> parent_;
};

}  // namespace

UnknownRegions::UnknownRegions(const terrain::ElevationGrid& grid, const std::stop_token& stop) {
  findRuns(grid, stop);
}

void UnknownRegions::findRuns(const terrain::ElevationGrid& grid, const std::stop_token& stop) {
  Joined joined;
  rows_.resize(static_cast<std::size_t>(grid.rows()));
  const auto isUnknown = [&](int column, int row) { return !std::isfinite(grid.upperInCell(column, row)); };
  for (int row = 0; row < grid.rows() && !stop.stop_requested(); ++row) {
    std::vector<Run>& runs = rows_[static_cast<std::size_t>(row)];
    const std::vector<Run>* south = row > 0 ? &rows_[static_cast<std::size_t>(row) - 1] : nullptr;
    std::size_t below = 0;
    for (int column = 0; column < grid.columns(); ++column) {
      if (!isUnknown(column, row)) {
        continue;
      }
      Run run{column, column, joined.add()};
      while (run.last + 1 < grid.columns() && isUnknown(run.last + 1, row)) {
        ++run.last;
      }
      column = run.last;
      // corners join too: there a surface between known cells would lead over the unknown
      while (south != nullptr && below < south->size() && (*south)[below].last < run.first - 1) {
        ++below;
      }
      for (std::size_t k = below; south != nullptr && k < south->size() && (*south)[k].first <= run.last + 1; ++k) {
        joined.join(run.region, (*south)[k].region);
      }
      runs.push_back(run);
    }
  }
  constexpr double kNone = std::numeric_limits<double>::infinity();
  std::vector<double> rim(joined.size(), kNone);
  std::vector<bool> isOutside(joined.size(), false);
  for (int row = 0; row < grid.rows() && !stop.stop_requested(); ++row) {
    for (Run& run : rows_[static_cast<std::size_t>(row)]) {
      run.region = joined.rootOf(run.region);
      const auto region = static_cast<std::size_t>(run.region);
      isOutside[region] = isOutside[region] || row == 0 || row == grid.rows() - 1 || run.first == 0 || run.last == grid.columns() - 1;
      for (int column = run.first - 1; column <= run.last + 1; ++column) {
        for (int j = row - 1; j <= row + 1; ++j) {
          rim[region] = std::min(rim[region], static_cast<double>(grid.upperInCell(column, j)));
        }
      }
    }
  }
  std::vector<int> numberOf(joined.size(), -1);
  for (std::size_t region = 0; region < rim.size(); ++region) {
    if (!isOutside[region] && rim[region] < kNone) {
      numberOf[region] = static_cast<int>(lids_.size());
      lids_.push_back(rim[region]);
    }
  }
  for (std::vector<Run>& runs : rows_) {
    for (Run& run : runs) {
      run.region = numberOf[static_cast<std::size_t>(run.region)];
    }
    std::erase_if(runs, [](const Run& run) { return run.region < 0; });
    runs.shrink_to_fit();
  }
}

std::optional<double> UnknownRegions::lidOver(int column, int row) const {
  if (row < 0 || row >= static_cast<int>(rows_.size())) {
    return std::nullopt;
  }
  const std::vector<Run>& runs = rows_[static_cast<std::size_t>(row)];
  const auto run = std::lower_bound(runs.begin(), runs.end(), column, [](const Run& r, int c) { return r.last < c; });
  return run != runs.end() && run->first <= column ? std::optional(lids_[static_cast<std::size_t>(run->region)]) : std::nullopt;
}

}  // namespace vp::scene3d
