#include "ui/document/condition_words.h"

#include "core/aircraft/energy.h"
#include "core/mission/glide_conditions.h"
#include "core/route/flight_totals.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace vp::document {
namespace {

constexpr double kPercent = 100.0;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Conditions)
};

/// Rounded down to tenths: what is promised.
QString tenths(double value) {
  constexpr double kTenth = 10.0;
  constexpr double kRounding = 1e-6;
  return QString::number(std::floor(value * kTenth + kRounding) / kTenth, 'f', 1);
}

/// Up to six digits, no zeros at the end.
QString plain(double value) {
  return QString::number(value, 'g', 6);
}

QString signedDegrees(double value) {
  const QString magnitude = plain(std::abs(value));
  return value < 0.0 ? QString(QChar(0x2212)) + magnitude : QLatin1Char('+') + magnitude;
}

QString energyWords(double value, aircraft::PowerSetting::Unit unit) {
  return QStringLiteral("%1 %2").arg(plain(value), QString::fromLatin1(aircraft::unitText(unit)));
}

/// Rounded up, to tenths where that can be seen.
QString takenWords(double value, aircraft::PowerSetting::Unit unit) {
  constexpr double kTenth = 10.0;
  constexpr double kRounding = 1e-6;
  return energyWords(value < 100.0 ? std::ceil(value * kTenth - kRounding) / kTenth : std::ceil(value - kRounding), unit);
}

/// Rounded down.
QString usableWords(double value, aircraft::PowerSetting::Unit unit) {
  return energyWords(std::floor(value), unit);
}

}  // namespace

QString glideSpeedWords(const mission::Plan& plan, const style::Units& units) {
  const aircraft::SpeedRange speeds = aircraft::glideSpeeds(plan.mission.aircraft, mission::glideConditionsOf(plan.mission, plan.sites).air);
  const QString most = units.speed(speeds.most);
  if (units.speed(speeds.least) == most) {
    return most;
  }
  return Words::tr("%1 to %2").arg(QString::number(std::floor(units.speedFromSi(speeds.least))), most);
}

QString massWords(const aircraft::AircraftProfile& aircraft) {
  if (!aircraft.leastMass_kg && !aircraft.mostMass_kg) {
    return {};
  }
  return Words::tr("%1 to %2 kg")
      .arg(plain(aircraft.leastMass_kg.value_or(aircraft.mass_kg)), plain(aircraft.mostMass_kg.value_or(aircraft.mass_kg)));
}

QString airWords(const air::Atmosphere& air) {
  const QString standard = air.temperatureOffset_K == 0.0 ? Words::tr("ISA") : Words::tr("ISA %1 °C").arg(signedDegrees(air.temperatureOffset_K));
  return Words::tr("%1, QNH %2 hPa").arg(standard, plain(air.qnh_hPa));
}

QString reactionWords(const mission::SafetySettings& safety, const style::Units& units) {
  const bool isTimed = safety.reactionTime.si() > 0.0;
  const QString time = Words::tr("%1 s").arg(tenths(safety.reactionTime.si()));
  if (safety.reactionLoss.si() <= 0.0) {
    return isTimed ? time : QString();
  }
  const QString loss = units.margin(safety.reactionLoss.si()).mid(1);  // rounded down, without its sign
  return isTimed ? Words::tr("%1, %2 lost in it").arg(time, loss) : Words::tr("%1 lost at once").arg(loss);
}

QString rollingWords(const mission::Plan& plan, const style::Units& units) {
  const std::optional<double>& rate = plan.mission.aircraft.rollRate_dps;
  if (rate && plan.certificate) {
    const std::vector<mission::Margin>& margins = plan.certificate->margins;
    const auto left = std::find_if(margins.begin(), margins.end(), [](const mission::Margin& one) { return one.kind == "glide.dynamics"; });
    if (left != margins.end()) {
      return Words::tr(
                 "rolling into turns and out of them, at %1° per second, at its worst leaves every glide from the tour at least %2 above the ground")
          .arg(plain(*rate), units.height(std::max(0.0, std::floor(left->value))));
    }
  }
  return Words::tr("rolling into turns is not modelled and is covered by the clearance only");
}

QString approachWords(const mission::ApproachSettings& approach, const style::Units& units) {
  switch (approach.kind) {
    case mission::ApproachKind::Threshold:
      break;
    case mission::ApproachKind::Straight: {
      const QString straight = Words::tr("after a straight of %1 on the landing course").arg(units.shortDistance(approach.finalLength.si()));
      return approach.slope ? Words::tr("%1, descending %2 over ground").arg(straight, style::Units::angle(approach.slope->degrees())) : straight;
    }
    case mission::ApproachKind::Overhead:
      return approach.keyHeight ? Words::tr("by a full circle from overhead, at least %1 above the runway where it begins")
                                      .arg(units.height(approach.keyHeight->si()))
                                : Words::tr("by a full circle from overhead");
  }
  return Words::tr("at the threshold on the landing course, by whatever curve leads there");
}

QString surfaceWords(const mission::ApproachSettings& approach, const style::Units& units) {
  if (!approach.surfaceSlope || approach.kind == mission::ApproachKind::Threshold) {
    return {};
  }
  return Words::tr("an obstacle surface that begins %1 before the touchdown point and rises by %2 %")
      .arg(units.height(approach.surfaceStart.si()), QString::number(kPercent * *approach.surfaceSlope, 'f', 1));
}

QString powerWords(const mission::Mission& mission, const style::Units& units) {
  const aircraft::PowerSetting* power = mission::powerSettingOf(mission);
  if (power == nullptr) {
    return {};
  }
  return Words::tr("%1: %2 TAS, %3 per hour")
      .arg(QString::fromStdString(power->name), units.speed(power->trueAirspeed.si()), energyWords(power->perHour, power->unit));
}

QString flightWords(const mission::Plan& plan, const style::Units& units) {
  const route::FlightTotals totals = route::flightTotals(plan);
  const QString time = style::Units::duration(totals.seconds);
  QString said = Words::tr("%1, %2 of climb")
                     .arg(plan.departure ? Words::tr("%1 with the ways from and to home").arg(time) : time, units.height(totals.climbed));
  if (totals.energy) {
    said += QStringLiteral(", ") + takenWords(*totals.energy, mission::powerSettingOf(plan.mission)->unit);
    if (const std::optional<double>& usable = plan.mission.aircraft.usableEnergy) {
      said += Words::tr(" of %1 usable").arg(usableWords(*usable, mission::powerSettingOf(plan.mission)->unit));
    }
  }
  return said;
}

QString beyondUsableWords(const mission::Plan& plan) {
  const route::FlightTotals totals = route::flightTotals(plan);
  const std::optional<double>& usable = plan.mission.aircraft.usableEnergy;
  if (!totals.energy || !usable || *totals.energy <= *usable) {
    return {};
  }
  const aircraft::PowerSetting::Unit unit = mission::powerSettingOf(plan.mission)->unit;
  return Words::tr("the flight takes %1, and %2 are usable").arg(takenWords(*totals.energy, unit), usableWords(*usable, unit));
}

QStringList holdWords(const mission::Plan& plan, const style::Units& units) {
  QStringList lines;
  for (const mission::Hold& hold : plan.holds) {
    if (hold.site < 0 || static_cast<std::size_t>(hold.site) >= plan.sites.size()) {
      continue;
    }
    QString name = QString::fromStdString(plan.sites[static_cast<std::size_t>(hold.site)].site.id);
    lines << Words::tr("%1: %2 circles of %3 radius, no lower than %4")
                 .arg(name.replace(QLatin1Char('/'), QLatin1Char(' ')), hold.turn == flight::Turn::Left ? Words::tr("left") : Words::tr("right"),
                      units.height(hold.radius), units.requiredMsl(hold.lowest));
  }
  return lines;
}

QString altimeterWords(const mission::Plan& plan, const style::Units& units) {
  const std::optional<air::Atmosphere>& air = plan.mission.atmosphere;
  if (!air || air->temperatureOffset_K >= 0.0 || plan.tour.empty() || plan.sites.empty()) {
    return {};
  }
  const auto [low, high] = std::minmax_element(
      plan.tour.begin(), plan.tour.end(), [](const mission::DecisionPoint& a, const mission::DecisionPoint& b) { return a.altitude < b.altitude; });
  const auto station = std::min_element(plan.sites.begin(), plan.sites.end(), [](const mission::SiteInFrame& a, const mission::SiteInFrame& b) {
    return a.site.elevation < b.site.elevation;
  });
  const auto error = [&](double altitude) {
    return units.required(std::max(0.0, air::altimeterError(*air, geo::HeightMsl::fromMetres(altitude), station->site.elevation)));
  };
  return Words::tr(
             "in this cold air it shows up to %1 too much at %2 and %3 at %4, set to the QNH of a runway at %5: fly so much higher than the "
             "altitudes of this "
             "briefing say")
      .arg(error(low->altitude), units.altitudeMsl(low->altitude), error(high->altitude), units.altitudeMsl(high->altitude),
           units.altitudeMsl(station->site.elevation.metres()));
}

}  // namespace vp::document
