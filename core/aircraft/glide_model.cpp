#include "core/aircraft/glide_model.h"

#include "core/air/wind_shear.h"
#include "core/aircraft/glide_bands.h"
#include "core/base/expect.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace vp::aircraft {

namespace {

/// Radius of a turn at this ground speed, m.
double radiusAt(double groundSpeed, Angle bank) {
  return groundSpeed * groundSpeed / (kGravity.si() * tan(bank));
}

}  // namespace

GlideModel::GlideModel(const AircraftProfile& profile, const GlideConditions& conditions)
    : dragFactor_(conditions.dragFactor),
      weight_(profile.mass_kg * kGravity.si()),
      dynamicPressureArea_(0.5 * profile.airDensity_kgm3 * profile.bestGlideSpeed.si() * profile.bestGlideSpeed.si() * profile.wingArea_m2),
      zeroLiftDrag_(zeroLiftDragOf(profile, conditions.propeller)),
      inducedDrag_(profile.inducedDrag) {
  const SpeedRange speeds = glideSpeeds(profile, conditions.air);
  airspeed_ = speeds.most;
  leastAirspeed_ = speeds.least;
  tourAirspeed_ = conditions.tourSpeed ? conditions.tourSpeed->si() : airspeed_;
  VP_EXPECT(speeds.least > 0.0 && weight_ > 0.0 && dynamicPressureArea_ > 0.0 && dragFactor_ >= 1.0 && tourAirspeed_ > 0.0);
  setWinds(conditions.winds, speeds);
  if (strongestWind_ == 0.0) {
    winds_.clear();
  }
  straightLoss_ = lossAt(0.0);
  for (const Angle bank : profile.glideBanks) {
    VP_EXPECT(bank.degrees() > 0.0 && bank.degrees() < 90.0);
    glideRadii_.push_back(radiusOf(bank));
  }
  std::sort(glideRadii_.begin(), glideRadii_.end(), std::greater<>());
  tourRadius_ = radiusAt(tourAirspeed_ + strongestWind_, profile.tourBank);
  minRadius_ = glideRadii_.empty() ? tourRadius_ : std::min(tourRadius_, glideRadii_.back());
  tabulate({});
  if (std::vector<double> edges = bandEdges(conditions); !edges.empty()) {
    bands_ = std::make_shared<const GlideBands>(*this, profile, conditions, std::move(edges));
  }
}

GlideModel::GlideModel(const GlideModel& whole, const Cover& cover) : GlideModel(whole) {
  firstBand_ = cover.first;
  lastBand_ = cover.last;
  holdsUpTo_ = cover.top;
  airspeed_ = cover.speeds.most;
  leastAirspeed_ = cover.speeds.least;
  if (!isCalm()) {
    setWinds(cover.winds, cover.speeds);
  }
  byRadius_.clear();
  stillTurnLoss_.clear();
  tabulate(cover.within);
}

GlideModel GlideModel::everywhere() const {
  GlideModel model = *this;
  model.bands_.reset();
  model.firstBand_ = model.lastBand_ = 0;
  model.holdsUpTo_ = std::numeric_limits<double>::infinity();
  return model;
}

void GlideModel::setWinds(const std::vector<air::WindLayer>& layers, const SpeedRange& speeds) {
  winds_.clear();
  strongestWind_ = 0.0;
  shear_ = air::mostShear(layers);
  for (const air::WindLayer& layer : layers) {
    winds_.push_back(layer.wind);
    winds_.back().mostSpeed *= speeds.most / speeds.least;
    strongestWind_ = std::max(strongestWind_, winds_.back().mostSpeed);
  }
}

/// @param within  whose losses these may not fall below
void GlideModel::tabulate(const std::vector<const GlideModel*>& within) {
  std::vector<double> radii = glideRadii_;
  radii.push_back(tourRadius_);
  std::transform(radii.begin(), radii.end(), std::back_inserter(stillTurnLoss_), [this](double radius) { return lossAt(radius); });
  leastLoss_ = straightLoss_;
  if (!isCalm()) {
    for (std::size_t i = 0; i < radii.size(); ++i) {
      std::vector<const CourseLoss*> parts;
      std::transform(within.begin(), within.end(), std::back_inserter(parts), [i](const GlideModel* one) { return one->byRadius_[i].get(); });
      byRadius_.push_back(makeCourseLoss(radii[i], parts));
    }
    leastLoss_ = byRadius_.back()->leastStraight();
  }
}

std::shared_ptr<const CourseLoss> GlideModel::makeCourseLoss(double radius, const std::vector<const CourseLoss*>& within) const {
  const GlidePolar polar{airspeed_, dragFactor_ * dynamicPressureArea_ * zeroLiftDrag_ / weight_,
                         dragFactor_ * inducedDrag_ * weight_ / dynamicPressureArea_, airspeed_ * shear_ / kGravity.si()};
  return std::make_shared<const CourseLoss>(polar, winds_, radius, within);
}

std::shared_ptr<const CourseLoss> GlideModel::courseLoss(double radius) const {
  if (isCalm()) {
    return nullptr;
  }
  const auto known = std::find_if(byRadius_.begin(), byRadius_.end(), [radius](const auto& one) { return one->radius() == radius; });
  return known != byRadius_.end() ? *known : makeCourseLoss(radius);
}

double GlideModel::mostTailwind(double course) const {
  double most = 0.0;  // along the course the part of a wind is linear, so what lies between layers has no greater one
  for (const air::WindSector& wind : winds_) {
    const double off = std::max(0.0, std::abs(wrapPi(wind.towards() - course)) - wind.spread());
    most = std::max(most, wind.mostSpeed * std::cos(off));
  }
  return most;
}

double GlideModel::mostStraightLoss() const {
  return isCalm() ? straightLoss_ : byRadius_.back()->mostStraight();
}

double GlideModel::mostTurnLoss(double radius) const {
  return isCalm() ? lossAt(radius) : courseLoss(radius)->mostTurn();
}

double GlideModel::mostInHalfTurn(double radius) const {
  if (isCalm()) {
    return lossAt(radius) * radius * Angle::kPi;
  }
  const std::shared_ptr<const CourseLoss> byCourse = courseLoss(radius);
  double most = 0.0;
  for (int degrees = 0; degrees < 360; ++degrees) {
    most = std::max(most, byCourse->turn(Angle::degrees(degrees).radians(), Angle::kPi));
  }
  return most;
}

double GlideModel::lossOver(double east, double north) const {
  return isCalm() ? straightLoss_ * std::sqrt(east * east + north * north) : byRadius_.back()->straight(east, north);
}

double GlideModel::radiusOf(Angle bank) const {
  return radiusAt(airspeed_ + strongestWind_, bank);
}

Angle GlideModel::bankOf(double radius) const {
  const double fastest = airspeed_ + strongestWind_;
  return Angle::radians(std::atan(fastest * fastest / (kGravity.si() * radius)));
}

double GlideModel::lossAt(double radius) const {
  const double loadFactor = radius > 0.0 ? 1.0 / cos(Angle::radians(std::atan(airspeed_ * airspeed_ / (kGravity.si() * radius)))) : 1.0;
  const double lift = loadFactor * weight_ / dynamicPressureArea_;  // C_L
  const double sinGamma = dragFactor_ * dynamicPressureArea_ * (zeroLiftDrag_ + inducedDrag_ * lift * lift) / weight_;
  if (sinGamma >= 1.0) {
    return std::numeric_limits<double>::infinity();
  }
  return sinGamma / std::sqrt(1.0 - sinGamma * sinGamma);
}

}  // namespace vp::aircraft
