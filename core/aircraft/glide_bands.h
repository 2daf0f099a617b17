#pragma once

#include "core/aircraft/glide_model.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

namespace vp::aircraft {

/** Altitudes at which the losses of a glide change [m MSL], ascending: those of the layers of wind, and with an atmosphere every 1000 m between
 *  its lowest and highest altitude. None: the same losses everywhere.  @threads pure */
std::vector<double> bandEdges(const GlideConditions& conditions);

/** What glides lose by altitude. Between two neighbouring edges lies a band, with the winds of the layers around it and the densities in it.
 *  A glide that crosses edges is charged by the cover of all bands that it comes through: every wind and density of any of them.
 *
 *  Why heights that are charged so are enough: WHY.md, "Bands of altitude". Covers are made when they are first asked for, and kept.
 *  @threads every member may be called from many threads */
class GlideBands {
public:
  static constexpr double kInterval = 1000.0;  ///< between edges in an atmosphere [m]

  /** @param whole  of all altitudes, without bands   @pre edges ascending, not empty */
  GlideBands(const GlideModel& whole, AircraftProfile profile, GlideConditions conditions, std::vector<double> edges);
  GlideBands(const GlideBands&) = delete;
  GlideBands& operator=(const GlideBands&) = delete;
  GlideBands(GlideBands&&) = delete;
  GlideBands& operator=(GlideBands&&) = delete;
  ~GlideBands();

  [[nodiscard]] std::size_t count() const { return edges_.size() + 1; }
  /** Lower edge of a band [m MSL]; minus infinity below all. */
  [[nodiscard]] double bottom(std::size_t band) const { return band > 0 ? edges_[band - 1] : -std::numeric_limits<double>::infinity(); }
  /** Upper edge of a band [m MSL]; infinity above all. */
  [[nodiscard]] double top(std::size_t band) const { return band < edges_.size() ? edges_[band] : std::numeric_limits<double>::infinity(); }
  /** The band over an altitude: that through which a glide comes down to it. */
  [[nodiscard]] std::size_t above(double altitude) const {
    return static_cast<std::size_t>(std::upper_bound(edges_.begin(), edges_.end(), altitude) - edges_.begin());
  }
  /** The band under an altitude: that into which a glide comes down from it. */
  [[nodiscard]] std::size_t below(double altitude) const {
    return static_cast<std::size_t>(std::lower_bound(edges_.begin(), edges_.end(), altitude) - edges_.begin());
  }

  /** Losses that hold in each of the bands from the first to the last. They are no less than those of any of these bands alone.
   *  Radii are those of all altitudes. Lives as long as this object. */
  [[nodiscard]] const GlideModel& between(std::size_t first, std::size_t last) const;

  /** As GlideModel::leastLoss over all bands. */
  [[nodiscard]] double leastLoss() const;

private:
  struct Slot;

  [[nodiscard]] std::unique_ptr<const GlideModel> make(std::size_t first, std::size_t last) const;

  std::unique_ptr<const GlideModel> whole_;
  AircraftProfile profile_;
  GlideConditions conditions_;  ///< layers by ascending altitude
  std::vector<double> edges_;
  mutable std::vector<Slot> covers_;  ///< by first and last band; filled when first asked for
};

/** Least height at the start of a glide from which it ends at `end` or higher, losses by altitude.
 *
 *  A cover holds from the end up to the top of its last band, so what a glide needs by it counts if it lies below that; else the next wider is
 *  taken. And what arrives above an edge arrives above all below it, so ends raised to an edge above are tried too: a height that suffices
 *  for one end suffices for all lower ones.
 *  @param needed   (cover, end, giveUpAbove) -> height needed by the losses of that cover [m MSL]; infinite above giveUpAbove
 *  @return infinity above giveUpAbove */
template <typename Needed>
double leastStart(const GlideModel& glide, double end, Needed needed, double giveUpAbove = std::numeric_limits<double>::infinity()) {
  const GlideBands* const bands = glide.bands();
  if (bands == nullptr) {
    return needed(glide, end, giveUpAbove);
  }
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double least = kInfinite;
  double limit = giveUpAbove;
  for (std::size_t first = bands->above(end); first < bands->count() && (bands->bottom(first) < limit || bands->bottom(first) <= end); ++first) {
    const double raised = std::max(end, bands->bottom(first));
    std::size_t last = first;
    while (last < bands->count()) {
      const double height = needed(bands->between(first, last), raised, limit);
      if (height <= bands->top(last)) {
        if (height <= limit) {
          least = limit = height;
        }
        break;
      }
      if (!std::isfinite(height) && (limit <= bands->top(last) || limit == kInfinite)) {
        break;  // no start below the limit, or no glide at all
      }
      last = std::isfinite(height) ? std::max(last + 1, bands->below(height)) : last + 1;
    }
    if (last == first) {
      break;  // it crosses no edge: a higher end asks for more
    }
  }
  return least;
}

}  // namespace vp::aircraft
