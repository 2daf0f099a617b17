#include "core/aircraft/glide_bands.h"

#include "core/base/expect.h"

#include <iterator>
#include <mutex>
#include <utility>

namespace vp::aircraft {
namespace {

/// Sums of the same losses in another order may come out this much lower [relative].
constexpr double kRounding = 1.0 - 1e-12;

bool isLower(const air::WindLayer& a, const air::WindLayer& b) {
  return a.altitude.metres() < b.altitude.metres();
}

/// The layers that count between two altitudes: all in it, and the next ones below and above it. @pre layers by ascending altitude
std::vector<air::WindLayer> layersBetween(const std::vector<air::WindLayer>& layers, double bottom, double top) {
  std::vector<air::WindLayer> found;
  if (layers.empty()) {
    return found;
  }
  double lowest = layers.front().altitude.metres();
  double highest = layers.back().altitude.metres();
  for (const air::WindLayer& layer : layers) {
    const double altitude = layer.altitude.metres();
    lowest = altitude <= bottom ? std::max(lowest, altitude) : lowest;
    highest = altitude >= top ? std::min(highest, altitude) : highest;
  }
  std::copy_if(layers.begin(), layers.end(), std::back_inserter(found),
               [&](const air::WindLayer& layer) { return layer.altitude.metres() >= lowest && layer.altitude.metres() <= highest; });
  return found;
}

}  // namespace

struct GlideBands::Slot {
  std::once_flag once;
  std::unique_ptr<const GlideModel> model;
};

std::vector<double> bandEdges(const GlideConditions& conditions) {
  std::vector<double> edges;
  const bool isCalm = std::all_of(conditions.winds.begin(), conditions.winds.end(), [](const air::WindLayer& layer) { return layer.wind.isCalm(); });
  if (!isCalm && conditions.winds.size() > 1) {
    std::transform(conditions.winds.begin(), conditions.winds.end(), std::back_inserter(edges),
                   [](const air::WindLayer& layer) { return layer.altitude.metres(); });
  }
  if (conditions.air) {
    const int first = static_cast<int>(std::floor(conditions.air->lowest.metres() / GlideBands::kInterval)) + 1;
    for (int i = first; i * GlideBands::kInterval < conditions.air->highest.metres(); ++i) {
      edges.push_back(i * GlideBands::kInterval);
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

GlideBands::GlideBands(const GlideModel& whole, AircraftProfile profile, GlideConditions conditions, std::vector<double> edges)
    : whole_(std::make_unique<const GlideModel>(whole)),
      profile_(std::move(profile)),
      conditions_(std::move(conditions)),
      edges_(std::move(edges)),
      covers_(count() * count()) {
  VP_EXPECT(!edges_.empty() && whole.bands() == nullptr);
  std::stable_sort(conditions_.winds.begin(), conditions_.winds.end(), isLower);
}

GlideBands::~GlideBands() = default;

const GlideModel& GlideBands::between(std::size_t first, std::size_t last) const {
  Slot& slot = covers_[first * count() + last];
  std::call_once(slot.once, [&] { slot.model = make(first, last); });
  return *slot.model;
}

std::unique_ptr<const GlideModel> GlideBands::make(std::size_t first, std::size_t last) const {
  GlideModel::Cover cover;
  cover.first = first;
  cover.last = last;
  cover.top = top(last);
  std::optional<AirRange> air = conditions_.air;
  if (air) {
    const double lowest = conditions_.air->lowest.metres();
    const double highest = conditions_.air->highest.metres();
    air->lowest = geo::HeightMsl::fromMetres(std::clamp(bottom(first), lowest, std::max(lowest, highest)));
    air->highest = geo::HeightMsl::fromMetres(std::clamp(top(last), lowest, std::max(lowest, highest)));
  }
  cover.speeds = glideSpeeds(profile_, air);
  cover.winds = layersBetween(conditions_.winds, bottom(first), top(last));
  for (std::size_t band = first; first < last && band <= last; ++band) {
    cover.within.push_back(&between(band, band));
  }
  return std::unique_ptr<const GlideModel>(new GlideModel(*whole_, cover));
}

double GlideBands::leastLoss() const {
  double least = between(0, 0).leastLoss();
  for (std::size_t band = 1; band < count(); ++band) {
    least = std::min(least, between(band, band).leastLoss());
  }
  return least * kRounding;
}

double GlideModel::leastLoss() const {
  return bands_ != nullptr ? bands_->leastLoss() : leastLoss_;
}

double GlideModel::leastLossOver(double east, double north) const {
  if (bands_ == nullptr) {
    return lossOver(east, north);
  }
  double least = bands_->between(0, 0).lossOver(east, north);
  for (std::size_t band = 1; band < bands_->count(); ++band) {
    least = std::min(least, bands_->between(band, band).lossOver(east, north));
  }
  return least * kRounding;
}

}  // namespace vp::aircraft
