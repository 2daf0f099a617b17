#include "core/safety/glide_rates.h"

#include "core/base/expect.h"

#include <utility>

namespace vp::safety {
namespace {

/// The profile at its own mass: where masses range, so do the airspeeds of the conditions.
aircraft::GlideModel ofOneMass(aircraft::AircraftProfile profile) {
  profile.leastMass_kg.reset();
  profile.mostMass_kg.reset();
  return aircraft::GlideModel(profile);
}

/// At the ends of a range of airspeeds.
std::vector<WindGlide> glidesOf(const aircraft::AircraftProfile& profile, const PlanConditions& conditions, const Airspeeds& speeds,
                                const ShearCost& shear) {
  std::vector<WindGlide> glides{WindGlide(profile, conditions, speeds.least, shear)};
  if (speeds.most > speeds.least) {
    glides.emplace_back(profile, conditions, speeds.most, shear);
  }
  return glides;
}

}  // namespace

GlideRates::GlideRates(const aircraft::GlideModel& model) : all_(model) {
  VP_EXPECT(model.isCalm());
  conditions_.glide = {model.airspeed(), model.airspeed()};
  conditions_.tour = conditions_.glide;
  leastGlideRadius_ = model.glideRadii().back();
  leastTourRadius_ = model.tourRadius();
  stillStraight_ = all_.stillLoss({});
}

GlideRates::GlideRates(const aircraft::AircraftProfile& profile, const std::vector<air::WindLayer>& winds)
    : GlideRates(conditionsOf(profile, winds), profile) {}

GlideRates::GlideRates(const PlanConditions& conditions, const aircraft::AircraftProfile& profile) : conditions_(conditions) {
  const aircraft::GlideModel model = ofOneMass(profile);
  const bool isAsInProfile = conditions.isAsInProfile(profile);
  HeightBands bands = heightBands(conditions, profile);
  edges_ = std::move(bands.edges);
  for (std::size_t i = 0; isLayered() && i < bands.bands.size(); ++i) {
    const HeightBand& band = bands.bands[i];
    WindSet winds(band.winds);
    const ShearCost shear = shearCost(profile, conditions, band.glide, winds.strongest(), band.shear);
    bands_.emplace_back(model, isAsInProfile, glidesOf(profile, conditions, band.glide, shear), std::move(winds));
    shear_ = shear_.with(shear);
  }
  all_ = BandRates(model, isAsInProfile, glidesOf(profile, conditions, conditions.glide, shear_), WindSet(conditions.winds));
  stillStraight_ = BandRates(model, isAsInProfile, glidesOf(profile, conditions, conditions.glide, {}), {}).stillLoss({});
  // ((airspeed + strongest wind) / airspeed)^2, of the airspeed of the model's radii
  const auto widening = [&](double airspeed) {
    const double faster = (airspeed + this->winds().strongest()) / model.airspeed();
    return faster * faster;
  };
  leastGlideRadius_ = widening(conditions.glide.most) * model.glideRadii().back();
  leastTourRadius_ = widening(conditions.tour.most) * model.tourRadius();
}

double GlideRates::mostStraightBetween(double course, double bottom, double top) {
  const flight::Piece straight;
  if (!isLayered()) {
    return all_.along(course, straight).upTo(1.0);
  }
  const auto first = static_cast<std::size_t>(std::upper_bound(edges_.begin(), edges_.end(), bottom) - edges_.begin());
  const auto last = static_cast<std::size_t>(std::lower_bound(edges_.begin(), edges_.end(), top) - edges_.begin());
  double most = 0.0;
  for (std::size_t band = std::min(first, last); band <= std::max(first, last); ++band) {
    most = std::max(most, bands_[band].along(course, straight).upTo(1.0));
  }
  return most;
}

double GlideRates::shareOf(const Airspeeds& speeds, double course, const flight::Piece& piece) const {
  if (isCalm()) {
    return 1.0;
  }
  const double along = winds().mostAlong(coursesOf(course, piece));
  return std::min(speeds.least / (speeds.least + along), speeds.most / (speeds.most + along));
}

double GlideRates::descentShare(double course, const flight::Piece& piece) const {
  return shear_.least * shareOf(conditions_.glide, course, piece);
}

double GlideRates::mostStraight() const {
  return isCalm() ? all_.stillLoss({}) : glide().lossAt(glide().straightSine(), -winds().strongest(), 0.0);
}

}  // namespace vp::safety
