#pragma once

#include "core/terrain/elevation_grid.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace vp::scene3d {

/** Connected areas of unknown cells inside a terrain, each with the height of the lowest known cell at its rim: there it is
 *  drawn as a flat hatched lid. Areas that reach the edge of the grid belong to the unknown outside and have no lid.
 *  @threads const members are pure */
class UnknownRegions {
public:
  UnknownRegions() = default;
  explicit UnknownRegions(const terrain::ElevationGrid& grid, const std::stop_token& stop = {});

  /** Height of the lid over a cell [m MSL]; nothing for known cells and for the unknown outside. @cost O(log runs of the row) */
  [[nodiscard]] std::optional<double> lidOver(int column, int row) const;
  [[nodiscard]] int count() const { return static_cast<int>(lids_.size()); }  ///< with a lid

private:
  struct Run {
    int first = 0;  ///< column
    int last = 0;
    int region = 0;
  };
  void findRuns(const terrain::ElevationGrid& grid, const std::stop_token& stop);

  std::vector<std::vector<Run>> rows_;
  std::vector<double> lids_;  ///< m MSL, by region
};

}  // namespace vp::scene3d
