#include "ui/document/wind_words.h"

namespace vp::document {

formats::WindUnits windUnits(const style::Units& units) {
  return units.system() == style::UnitSystem::Aviation
             ? formats::WindUnits{formats::WindUnits::Speed::Knots, formats::WindUnits::Height::Feet}
             : formats::WindUnits{formats::WindUnits::Speed::KilometresPerHour, formats::WindUnits::Height::Metres};
}

QString airPhrase(const std::vector<air::WindLayer>& winds, const style::Units& units) {
  return QString::fromStdString(formats::airPhrase(winds, windUnits(units)));
}

QStringList windLines(const std::vector<air::WindLayer>& winds, const style::Units& units) {
  QStringList lines;
  for (const std::string& words : formats::windWords(winds, windUnits(units))) {
    lines << QString::fromStdString(words);
  }
  return lines;
}

}  // namespace vp::document
