#include "ui/document/wind_words.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace vp::document {
namespace {

// The same sentences as formats::windWords and formats::airPhrase make, which are English and for files and terminals; tst_wind_words holds
// the two against each other.
struct Words {
  Q_DECLARE_TR_FUNCTIONS(Wind)
};

constexpr double kTenths = 10.0;

QString speedWords(const air::WindSector& wind, const style::Units& units) {
  const auto rounded = [&units](double speed) {
    return QString::number(std::round(units.speedFromSi(speed) * kTenths) / kTenths, 'f', QLocale::FloatingPointShortest);
  };
  const QString least = rounded(wind.leastSpeed);
  const QString most = rounded(wind.mostSpeed);
  return least == most ? QStringLiteral("%1 %2").arg(most, units.speedUnit()) : Words::tr("%1 to %2 %3").arg(least, most, units.speedUnit());
}

QString degreesWords(double value) {
  const double around = std::fmod(value + 360.0, 360.0);
  return QStringLiteral("%1").arg(static_cast<int>(around == 0.0 ? 360.0 : around), 3, 10, QLatin1Char('0'));
}

QString sectorWords(const air::WindSector& wind, const style::Units& units) {
  if (wind.isCalm()) {
    return Words::tr("calm");
  }
  const QString speed = speedWords(wind, units);
  if (wind.spread_deg >= 180.0) {
    return Words::tr("%1 from any direction").arg(speed);
  }
  if (wind.spread_deg == 0.0) {
    return Words::tr("%1 from %2 degrees").arg(speed, degreesWords(std::round(wind.from_deg)));
  }
  return Words::tr("%1 from %2 to %3 degrees")
      .arg(speed, degreesWords(std::floor(wind.from_deg - wind.spread_deg)), degreesWords(std::ceil(wind.from_deg + wind.spread_deg)));
}

}  // namespace

formats::WindUnits windUnits(const style::Units& units) {
  return units.system() == style::UnitSystem::Aviation
             ? formats::WindUnits{formats::WindUnits::Speed::Knots, formats::WindUnits::Height::Feet}
             : formats::WindUnits{formats::WindUnits::Speed::KilometresPerHour, formats::WindUnits::Height::Metres};
}

QString airPhrase(const std::vector<air::WindLayer>& winds, const style::Units& units) {
  if (std::all_of(winds.begin(), winds.end(), [](const air::WindLayer& layer) { return layer.wind.isCalm(); })) {
    return Words::tr("calm air");
  }
  if (winds.size() > 1) {
    return Words::tr("every wind between the layers of the forecast (%1; true)").arg(windLines(winds, units).join(QStringLiteral("; ")));
  }
  const air::WindSector& wind = winds.front().wind;
  const QString words = sectorWords(wind, units);
  if (wind.spread_deg >= 180.0) {
    return Words::tr("every wind of %1").arg(words);
  }
  return wind.spread_deg == 0.0 && wind.leastSpeed == wind.mostSpeed ? Words::tr("a wind of %1 true").arg(words)
                                                                     : Words::tr("every wind of %1 true").arg(words);
}

QStringList windLines(const std::vector<air::WindLayer>& winds, const style::Units& units) {
  if (winds.empty()) {
    return {Words::tr("still air")};
  }
  if (winds.size() == 1) {
    return {Words::tr("%1 at every height").arg(sectorWords(winds.front().wind, units))};
  }
  QStringList lines;
  for (const air::WindLayer& layer : winds) {
    lines << QStringLiteral("%1 %2: %3")
                 .arg(QString::number(units.heightFromSi(layer.altitude.metres()), 'f', 0), units.heightUnit(), sectorWords(layer.wind, units));
  }
  return lines;
}

}  // namespace vp::document
