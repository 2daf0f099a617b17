#pragma once

#include "core/base/result.h"
#include "core/flight/curve.h"
#include "core/geo/local_frame.h"
#include "core/mission/weather.h"
#include "core/risk/leg_risk.h"
#include "core/risk/ring_check.h"

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace vp::risk {

/** A part of a leg over or under one weather cell: [from, to] in metres along it. Where cells overlap, so do their stretches. */
struct WeatherStretch {
  double from = 0.0;
  double to = 0.0;
  std::size_t cell = 0;  ///< Weather::cell
  double share = 1.0;    ///< 1, or 0.5 along a side of the cell
};

/** Bad weather in the local frame: the soft obstacles of [4] section 2, in an R*-tree.
 *
 *  Where cells overlap their risks add up: what is in one is another danger than what is in the other (icing in turbulence), and who draws a cell in
 *  two halves changes nothing. A side belongs half to the cell, as Population has it; floor and top belong to it.
 *  @threads const members are pure
 *  @source [4] section 2; its assumption 2 (the most expensive obstacle alone) is that of one planner: core/emergency/WHY-weather.md */
class Weather {
public:
  /** A cell as it lies in the frame. */
  struct Cell {
    std::string name;  ///< never empty: "cell 3" where it was
    Ring ring;
    double floor = -std::numeric_limits<double>::infinity();  ///< m MSL
    double top = std::numeric_limits<double>::infinity();     ///< m MSL
    double rate = 0.0;                                        ///< -log of the probability of coming through, per metre [1/m]

    /** Whether an altitude is in it [m MSL]. */
    [[nodiscard]] bool holds(double altitude) const { return altitude >= floor && altitude <= top; }
  };

  ~Weather();
  Weather(const Weather&) = delete;
  Weather& operator=(const Weather&) = delete;
  Weather(Weather&&) = delete;
  Weather& operator=(Weather&&) = delete;

  /** @param frame  that all else is asked in
   *  @errors BadFormat - sides that cross, less than three corners, a probability outside (0, 1], no distance for it, a floor above its top, a number
   *  that is none; the sentence names cell, place and remedy */
  static Result<std::shared_ptr<const Weather>> from(const std::vector<mission::WeatherCell>& cells, const geo::LocalFrame& frame);

  [[nodiscard]] std::size_t size() const;
  /** In the order that they were given in. */
  [[nodiscard]] const Cell& cell(std::size_t i) const;
  /** All floors and tops, ascending, each once [m MSL]: between two of them altitude does not matter. */
  [[nodiscard]] const std::vector<double>& levels() const;

  /** The parts of a leg over or under cells whose altitudes it may meet, exact: the leg is clipped at every side that it crosses.
   *  @param low, high  altitudes of the leg [m MSL]: cells that lie above or below are left out
   *  @param out  is emptied first   @cost O(log cells + sides near the leg), some microseconds   @accuracy rounding, 1e-6 m */
  void along(const geo::Pose& from, const flight::Piece& piece, double low, double high, std::vector<WeatherStretch>& out) const;

  /** 1 within the outline of a cell, 0 outside, 0.5 on a side. */
  [[nodiscard]] double shareAt(std::size_t cell, geo::Point place) const;
  /** -log of the probability of coming through a metre at a place and altitude, all cells together [1/m]. */
  [[nodiscard]] double rateAt(geo::Point place, double altitude) const;

private:
  struct Index;
  explicit Weather(std::unique_ptr<const Index> index);
  std::unique_ptr<const Index> index_;
};

/** Length of the part of a stretch that lies within the altitudes of its cell, where altitude is linear along the leg [m].
 *  @param start  m MSL where the leg begins   @param slope  m per metre, negative down */
double lengthInside(const Weather::Cell& cell, const WeatherStretch& stretch, double start, double slope);

/** Weather on a flight: -log of the probability of coming through, so that legs add up; exp(-risk) is that probability. Exact along lines and arcs
 * with linear altitude. Distances are those over ground, [4] assumption 1: a slope of 1 : 9 makes 0.6 %.
 *  @threads const members are pure */
class WeatherRisk : public LegRisk {
public:
  /** @param weather  not null */
  explicit WeatherRisk(std::shared_ptr<const Weather> weather);

  [[nodiscard]] double of(const geo::Pose& from, const flight::Piece& piece, double startAltitude, double endAltitude) const override;
  [[nodiscard]] std::string name() const override { return "weather"; }
  [[nodiscard]] std::string unit() const override { return ""; }

  [[nodiscard]] const std::shared_ptr<const Weather>& weather() const { return weather_; }

private:
  std::shared_ptr<const Weather> weather_;
};

}  // namespace vp::risk
