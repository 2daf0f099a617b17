#include "core/emergency/weather/weather_flight.h"

#include "core/aircraft/glide_bands.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/flight/pose_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vp::emergency {
namespace {

constexpr double kLongestSlice = 3704.0;  // m, two nautical miles, as [4] section 2.2 divides legs
constexpr double kShortest = 1e-3;        // m: slices shorter than this are rounding
constexpr double kRoom = 1.01;            // steepest descent against best glide: less is no choice

}  // namespace

WeatherFlight::WeatherFlight(const LandingRequest& request, DescentFlight& flight, std::shared_ptr<const risk::Weather> weather)
    : world_(*request.world), flight_(flight), risk_(std::move(weather)) {
  const DescentRange range = flight_.rangeOf(request.pose.heading, {flight::Turn::Straight, 0.0, 1.0}, request.altitude);
  hasRoom_ = range.most > kRoom * range.least;
}

double WeatherFlight::weatherAlong(const geo::Pose& pose, double altitude, const std::vector<mission::LandingLeg>& legs) const {
  double sum = 0.0;
  geo::Pose at = pose;
  for (const mission::LandingLeg& leg : legs) {
    sum += risk_.of(at, leg.piece, altitude, leg.endAltitude);
    at = flight::endOf(at, leg.piece);
    altitude = leg.endAltitude;
  }
  return sum;
}

void WeatherFlight::slicesOf(const geo::Pose& pose, const flight::Piece& piece, const DescentRange& range, std::vector<AltitudeSlice>& slices,
                             std::vector<flight::Piece>* pieces) const {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  std::vector<risk::WeatherStretch> stretches;
  weather().along(pose, piece, -kInfinite, kInfinite, stretches);
  std::vector<double> cuts{0.0, piece.length};
  for (const risk::WeatherStretch& stretch : stretches) {
    cuts.push_back(stretch.from);
    cuts.push_back(stretch.to);
  }
  const int parts = static_cast<int>(std::ceil(piece.length / kLongestSlice));
  for (int i = 1; i < parts; ++i) {
    cuts.push_back(piece.length * i / parts);
  }
  std::sort(cuts.begin(), cuts.end());
  double from = 0.0;
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    const bool isLast = i + 1 == cuts.size();
    if (!isLast && (cuts[i] - from < kShortest || piece.length - cuts[i] < kShortest)) {
      continue;
    }
    const double to = cuts[i];
    if (!(to > from)) {
      continue;
    }
    AltitudeSlice slice{to - from, range.least, range.most, 0.0, {}};
    slice.lowest = world_.terrain.upperIn(flight::boxOf(pose, piece, from, to).grown(1e-3)) + world_.clearance;
    const double middle = 0.5 * (from + to);
    for (const risk::WeatherStretch& stretch : stretches) {
      if (stretch.from <= middle && middle <= stretch.to) {
        const risk::Weather::Cell& cell = weather().cell(stretch.cell);
        slice.layers.push_back({cell.floor, cell.top, stretch.share * cell.rate});
      }
    }
    slices.push_back(std::move(slice));
    if (pieces != nullptr) {
      pieces->push_back({piece.turn, piece.radius, to - from});
    }
    from = to;
  }
}

std::optional<std::vector<mission::LandingLeg>> WeatherFlight::leastWeather(const geo::Pose& pose, double altitude,
                                                                            const std::vector<mission::LandingLeg>& legs, double end) {
  // where losses differ by altitude a slice has no one range of slopes
  if (!hasRoom_ || world_.glide.bands() != nullptr) {
    return std::nullopt;
  }
  std::vector<AltitudeSlice> slices;
  std::vector<flight::Piece> pieces;
  geo::Pose at = pose;
  for (const mission::LandingLeg& leg : legs) {
    slicesOf(at, leg.piece, flight_.rangeOf(at.heading, leg.piece, altitude), slices, &pieces);
    at = flight::endOf(at, leg.piece);
  }
  std::optional<std::vector<double>> altitudes = cheapestAltitudes(altitude, slices, end);
  if (!altitudes) {
    return std::nullopt;
  }
  std::vector<mission::LandingLeg> flown;
  double high = altitude;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    // rounding must not make a leg flatter than the glide
    const double low = std::min((*altitudes)[i], high - slices[i].least * slices[i].length);
    flown.push_back({pieces[i], low});
    high = low;
  }
  return flown;
}

flight::DubinsPath WeatherFlight::curve(const geo::Pose& from, const geo::Pose& to, double altitude) const {
  const aircraft::GlideBands* const bands = world_.glide.bands();
  const std::size_t band = bands == nullptr ? 0 : bands->below(altitude);
  const aircraft::GlideModel& model = bands == nullptr ? world_.glide : bands->between(band, band);
  const flight::PosePair pair(from, to);
  flight::DubinsPath best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t radius = 0; radius < world_.glide.glideRadii().size(); ++radius) {
    const flight::TurnLoss loss = flight::turnLossAt(model, radius);
    flight::DubinsPath path = pair.leastLoss(world_.glide.glideRadii()[radius], loss);
    if (const double lost = flight::lossOf(path, loss); lost < least || radius == 0) {
      least = lost;
      best = path;
    }
  }
  return best;
}

}  // namespace vp::emergency
