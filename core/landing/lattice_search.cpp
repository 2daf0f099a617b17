#include "core/aircraft/glide_bands.h"
#include "core/base/quantity.h"
#include "core/landing/lattice_ground.h"
#include "core/landing/lattice_roadmap.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace vp::landing {
namespace {

constexpr double kPaperArea = 25e6;  // m^2, [1] section 8
constexpr double kHeadings = 16.0;   // of glide_primitives.cpp
constexpr double kMostStates = 1e8;  // a gigabyte; a smaller step than this allows is not used
/// Measured with bench_roadmap: 0.09 s for 5 x 5 km, 0.3 m lower than with 80 m [m].
constexpr double kPaperStep = 60.0;
/// So 46 x 67 km get 294 m and a square degree of the Alps 411 m: there 450 m asks for 50 m more over a target far from all runways.
constexpr double kStepGrowth = 0.33;
/// Smaller gains than this are left [m]: 0.1 settles a tenth more poses again and finds altitudes 0.05 m lower.
constexpr float kWorthwhile = 0.35F;
constexpr std::int64_t kPoll = 2000;  // states between looks at the stop token, some milliseconds
constexpr float kNone = std::numeric_limits<float>::infinity();

/** The search; a class to keep the loop readable. */
class LatticeSearch {
public:
  LatticeSearch(const World& world, bool isPlain, LatticeGlides& glides, LatticeStatistics& counts)
      : world_(world), isPlain_(isPlain), glides_(glides), ground_(world, glides), counts_(counts) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& arrivals : glides.primitives.arrivals) {
      least = arrivals.empty() ? least : std::min(least, arrivals.front().loss);
    }
    coverOf(glides_.glide);
    if (const aircraft::GlideBands* bands = glides.glide.bands()) {
      numbers_.assign(bands->count() * bands->count(), 0);
      least *= glides.glide.leastLoss() / glides.radii.front().loss.straight;
    }
    isHeldUp_.assign(static_cast<std::size_t>(glides.states()), 0);
    bucketsPerMetre_ = 1.0 / (0.5 * least);  // every primitive leads out of its bucket
    base_ = std::numeric_limits<double>::infinity();
    for (const LatticeGlides::Root& root : glides.roots) {
      base_ = std::min(base_, root.altitude);
    }
  }

  Result<void> run(const Job& job) {
    for (std::size_t i = 0; i < glides_.roots.size(); ++i) {
      if (job.stopRequested()) {
        return stopped();
      }
      connectAround(static_cast<int>(i) + glides_.states());
    }
    const double whole = static_cast<double>(glides_.states());
    for (current_ = 0; current_ < buckets_.size(); ++current_) {
      // the bucket may grow while it is worked off, which a range would not survive
      for (std::size_t i = 0; i < buckets_[current_].size(); ++i) {  // NOLINT(modernize-loop-convert)
        const auto [state, altitude] = buckets_[current_][i];
        if (altitude == glides_.altitude[static_cast<std::size_t>(state)]) {
          settle(state);
        }
        if (++counts_.settled % kPoll == 0) {
          if (job.stopRequested()) {
            return stopped();
          }
          job.progress(std::min(1.0, static_cast<double>(counts_.settled) / whole), fmt::format("roadmap: {} glides", counts_.settled));
        }
      }
      std::vector<Entry>().swap(buckets_[current_]);
    }
    return {};
  }

private:
  struct Arrival {
    std::int32_t offset = 0;  ///< from the state that the primitive ends at to the one that it starts at
    float loss = 0.0F;
    std::int16_t columns = 0;
    std::int16_t rows = 0;
    std::uint16_t leg = 0;
  };
  struct Entry {
    std::int32_t state = 0;
    float altitude = 0.0F;
  };

  static tl::unexpected<Error> stopped() { return fail(Errc::Cancelled, "stopped while building the roadmap of landing glides"); }

  void push(int state, float altitude) {
    const auto bucket = static_cast<std::size_t>((static_cast<double>(altitude) - base_) * bucketsPerMetre_);
    const std::size_t at = std::max(bucket, current_);
    if (at >= buckets_.size()) {
      buckets_.resize(at + 1);
    }
    buckets_[at].push_back({state, altitude});
  }

  /// Tries to glide from a state straight to a node. @return true if that needs less height than what was known
  bool connect(int state, int node) {
    ++counts_.connections;
    float& known = glides_.altitude[static_cast<std::size_t>(state)];
    const LatticeLeg found =
        lowestLeg(world_, glides_, glides_.poseOf(state), glides_.directionOf(state), node, static_cast<double>(known - kWorthwhile), counts_.legs);
    if (!std::isfinite(found.altitude)) {
      return false;
    }
    known = roundedUp(found.altitude);
    isHeldUp_[static_cast<std::size_t>(state)] = found.isHeldUp ? 1 : 0;
    glides_.via[static_cast<std::size_t>(state)] = node;
    glides_.leg[static_cast<std::size_t>(state)] = static_cast<std::uint16_t>(found.radius * 8 + static_cast<std::size_t>(found.path.word));
    return true;
  }

  /// Off-lattice runways are connected exactly: all states near a site try to glide to it.
  void connectAround(int root) {
    const geo::Pose& site = glides_.rootOf(root).pose;
    const double step = glides_.primitives.step;
    const int around = glides_.primitives.reach + 1;
    const int column = static_cast<int>(std::lround((site.x - glides_.originX) / step));
    const int row = static_cast<int>(std::lround((site.y - glides_.originY) / step));
    for (int r = std::max(0, row - around); r <= std::min(glides_.rows - 1, row + around); ++r) {
      for (int c = std::max(0, column - around); c <= std::min(glides_.columns - 1, column + around); ++c) {
        for (int h = 0; h < glides_.headings(); ++h) {
          const int state = glides_.stateAt(c, r, h);
          if (connect(state, root)) {
            push(state, glides_.altitude[static_cast<std::size_t>(state)]);
          }
        }
      }
    }
  }

  /// Straight to where the successor glides, as long as that helps. Not where the ground ahead of the successor asks for more
  /// than its glide loses: it asks as much of a glide past it. (Tried all the same, Davos takes 604 thousand tries instead of
  /// 377 thousand and twice as long, and is 1.4 m lower; a finer step gives more for that time.)
  void glidePastSuccessors(int state) {
    for (int node = glides_.via[static_cast<std::size_t>(state)]; !glides_.isRoot(node) && isHeldUp_[static_cast<std::size_t>(node)] == 0;) {
      node = glides_.nextOf(node);
      if (!connect(state, node)) {
        return;
      }
    }
  }

  void settle(int state) {
    if (!isPlain_) {
      glidePastSuccessors(state);
    }
    const int heading = state % glides_.headings();
    const int point = state / glides_.headings();
    const int column = point % glides_.columns;
    const int row = point / glides_.columns;
    const float altitude = glides_.altitude[static_cast<std::size_t>(state)];
    const bool isClear = ground_.highestAround(column, row) <= altitude;
    const int reach = glides_.primitives.reach;
    const bool isInner = column >= reach && row >= reach && column + reach < glides_.columns && row + reach < glides_.rows;
    const aircraft::GlideBands* const bands = glides_.glide.bands();
    const std::size_t band = bands == nullptr ? 0 : bands->above(static_cast<double>(altitude));
    const std::size_t number = bands == nullptr ? 0 : coverOf(bands->between(band, band));
    const LatticeGround::Arrivals ground = ground_.arrivalsAt(heading, column, row, number);
    const float top = covers_[number].top;
    const std::vector<Arrival>& arrivals = covers_[number].arrivals[static_cast<std::size_t>(heading)];
    const Arrival* const first = arrivals.data();
    float* const altitudes = glides_.altitude.data();
    for (std::size_t i = 0, count = arrivals.size(); i < count; ++i) {
      const Arrival& arrival = first[i];
      if (!isInner && !glides_.isInside(column - arrival.columns, row - arrival.rows)) {
        continue;
      }
      const int before = state + arrival.offset;
      float& known = altitudes[before];
      const float lost = altitude + arrival.loss;
      float needed = lost;
      if (needed >= known - kWorthwhile) {
        continue;
      }
      if (!isClear) {
        ++counts_.groundTests;
        needed = std::max(needed, ground.required(i, known - kWorthwhile));
        if (needed >= known - kWorthwhile) {
          continue;
        }
      }
      bool isHeldUp = needed > lost;
      if (needed > top) {  // out of the band that the pose is in
        needed = acrossBands(heading, column, row, altitude, i, known - kWorthwhile, isHeldUp);
        if (needed >= known - kWorthwhile) {
          continue;
        }
      }
      known = needed;
      isHeldUp_[static_cast<std::size_t>(before)] = isHeldUp ? 1 : 0;
      glides_.via[static_cast<std::size_t>(before)] = state;
      glides_.leg[static_cast<std::size_t>(before)] = arrival.leg;
      push(before, needed);
    }
  }

  /// Height that a primitive needs that comes through an edge between bands; infinite where that is no less than `limit`.
  float acrossBands(int heading, int column, int row, float altitude, std::size_t primitive, float limit, bool& isHeldUp) {
    float best = kNone;
    const auto needed = [&](const aircraft::GlideModel& glide, double end, double /*giveUpAbove*/) {
      const std::size_t number = coverOf(glide);
      const float lost = std::max(altitude, roundedUp(end)) + covers_[number].arrivals[static_cast<std::size_t>(heading)][primitive].loss;
      const float height = std::max(lost, ground_.arrivalsAt(heading, column, row, number).required(primitive));
      if (static_cast<double>(height) <= glide.holdsUpTo() && height < best) {
        best = height;
        isHeldUp = height > lost;
      }
      return static_cast<double>(height);
    };
    aircraft::leastStart(glides_.glide, static_cast<double>(altitude), needed, static_cast<double>(limit));
    return best;
  }

  /// Primitives as the loop over them wants them, and the highest altitude that their losses hold for.
  struct Cover {
    std::vector<std::vector<Arrival>> arrivals;  ///< by heading of the end
    float top = kNone;
  };

  /// Number of the cover with the losses of a model, here and of ground_.
  std::size_t coverOf(const aircraft::GlideModel& glide) {
    if (covers_.empty()) {
      layOutArrivals(glide, 0);
      return 0;
    }
    std::size_t& number = numbers_[glide.firstBand() * glides_.glide.bands()->count() + glide.lastBand()];
    if (number == 0) {
      number = ground_.addCover(glides_, glide);
      layOutArrivals(glide, number);
    }
    return number;
  }

  void layOutArrivals(const aircraft::GlideModel& glide, std::size_t number) {
    Cover& cover = covers_.emplace_back();
    const auto top = static_cast<float>(glide.holdsUpTo());
    cover.top = static_cast<double>(top) > glide.holdsUpTo() ? std::nextafter(top, 0.0F) : top;
    for (std::size_t heading = 0; heading < glides_.primitives.arrivals.size(); ++heading) {
      std::vector<Arrival>& arrivals = cover.arrivals.emplace_back();
      for (const GlidePrimitive& p : glides_.primitives.arrivals[heading]) {
        const int offset = -(p.rows * glides_.columns + p.columns) * glides_.headings() + p.from - static_cast<int>(heading);
        const double lost = number == 0 ? p.loss : ground_.lossOf(number, heading, arrivals.size());
        arrivals.push_back({offset, roundedUp(lost + kRoundingOfSum), static_cast<std::int16_t>(p.columns), static_cast<std::int16_t>(p.rows),
                            static_cast<std::uint16_t>(p.radius * 8 + static_cast<std::size_t>(p.word))});
      }
    }
  }

  const World& world_;
  bool isPlain_;
  LatticeGlides& glides_;
  LatticeGround ground_;
  LatticeStatistics& counts_;
  double bucketsPerMetre_ = 1.0;
  double base_ = 0.0;
  std::size_t current_ = 0;
  std::vector<std::vector<Entry>> buckets_;
  std::vector<std::uint8_t> isHeldUp_;  ///< by state: whether the ground under its first leg asks for more than the glide loses
  std::deque<Cover> covers_;            ///< the first holds at all altitudes
  std::vector<std::size_t> numbers_;    ///< by first and last band: the number of their cover, 0: not made yet
};

/// Lattice points at centres of terrain cells, covering the part of the area that lies on terrain.
void layOut(const World& world, const geo::Box& area, double step, LatticeGlides& glides) {
  const terrain::ElevationGrid& grid = world.terrain.grid();
  const double cell = grid.cellSize();
  const double leastStep = std::sqrt((area.maxX - area.minX) / kMostStates * kHeadings * (area.maxY - area.minY));
  const int perStep = std::max(1, static_cast<int>(std::lround(std::max(step, leastStep) / cell)));
  const geo::Box extent = grid.extent();
  const auto first = [&](double least, double origin) { return static_cast<int>(std::floor((least - origin) / cell)); };
  const int column = std::clamp(first(area.minX, grid.originX()), 0, grid.columns() - 1);
  const int row = std::clamp(first(area.minY, grid.originY()), 0, grid.rows() - 1);
  glides.originX = grid.originX() + (column + 0.5) * cell;
  glides.originY = grid.originY() + (row + 0.5) * cell;
  const double width = std::min(area.maxX, extent.maxX) - glides.originX;
  const double height = std::min(area.maxY, extent.maxY) - glides.originY;
  glides.columns = std::max(2, 1 + static_cast<int>(width / (perStep * cell)));
  glides.rows = std::max(2, 1 + static_cast<int>(height / (perStep * cell)));
  glides.primitives = makeGlidePrimitives(glides.radii, perStep * cell);
  const auto states = static_cast<std::size_t>(glides.states());
  glides.altitude.assign(states, kNone);
  glides.via.assign(states, -1);
  glides.leg.assign(states, 0);
}

void addRoots(const std::vector<Approach>& approaches, LatticeGlides& glides) {
  for (const Approach& approach : approaches) {
    glides.roots.push_back({approach.gate, flight::Direction(approach.gate.heading), approach.altitude, approach.site});
  }
}

}  // namespace

double defaultLatticeStep(const geo::Box& area) {
  return kPaperStep * std::pow(std::max(1.0, (area.maxX - area.minX) * (area.maxY - area.minY) / kPaperArea), kStepGrowth);
}

Result<LatticeRoadmap> buildLatticeRoadmap(const World& world, const LatticeOptions& options, const Job& job, LatticeStatistics* statistics) {
  if (options.area.isEmpty()) {
    return fail(Errc::OutOfRange, "the area for the roadmap of landing glides is empty");
  }
  const std::vector<Approach> approaches = approachesOf(world);
  if (approaches.empty()) {
    return tl::unexpected(noApproach(world));
  }
  LatticeGlides glides;
  addRoots(approaches, glides);
  glides.glide = world.glide;
  glides.radii = radiusLossesOf(glides.glide);
  std::erase_if(glides.radii, [](const RadiusLoss& radius) { return !std::isfinite(radius.loss.turn); });
  layOut(world, options.area, options.step.value_or(defaultLatticeStep(options.area)), glides);
  LatticeStatistics counts;
  counts.step = glides.primitives.step;
  counts.states = glides.states();
  if (const Result<void> done = LatticeSearch(world, options.isPlain, glides, counts).run(job); !done) {
    return tl::unexpected(done.error());
  }
  counts.reached = std::count_if(glides.altitude.begin(), glides.altitude.end(), [](float altitude) { return altitude < kNone; });
  if (statistics != nullptr) {
    *statistics = counts;
  }
  return LatticeRoadmap(std::move(glides), approaches);
}

}  // namespace vp::landing
