#include "ui/style/units.h"

#include "ui/style/core_text.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace vp::style {
namespace {

constexpr double kMetresPerKilometre = 1000.0;
constexpr double kSecondsPerMinute = 60.0;
constexpr double kMpsPerKmh = 1.0 / 3.6;
const QChar kMinus(0x2212);
const QChar kThinSpace(0x2009);
/// Absorbs the rounding of unit conversion, so that 100 m of margin do not read 99 m.
constexpr double kConversionNoise = 1e-6;

QString grouped(double rounded) {
  const bool negative = rounded < 0.0;
  QString digits = QString::number(std::abs(rounded), 'f', 0);
  for (qsizetype i = digits.size() - 3; i > 0; i -= 3) {
    digits.insert(i, kThinSpace);
  }
  return negative && digits != QStringLiteral("0") ? kMinus + digits : digits;
}

/// A figure of `digits` decimals, its whole part grouped.
QString groupedDecimal(double value, int digits) {
  const QString text = QString::number(std::abs(value), 'f', digits);
  const QString fraction = digits > 0 ? text.mid(text.indexOf(QLatin1Char('.'))) : QString();
  const QString whole = grouped(digits > 0 ? std::trunc(text.toDouble()) : text.toDouble());
  return (value < 0.0 && text.toDouble() != 0.0 ? QString(kMinus) : QString()) + whole + fraction;
}

QString decimal(double value, int digits) {
  QString text = QString::number(std::abs(value), 'f', digits);
  return value < 0.0 && text.toDouble() != 0.0 ? kMinus + text : text;
}

}  // namespace

QString Units::heightUnit() const {
  return system_ == UnitSystem::Aviation ? QStringLiteral("ft") : QStringLiteral("m");
}
QString Units::distanceUnit() const {
  return system_ == UnitSystem::Aviation ? QStringLiteral("NM") : QStringLiteral("km");
}
double Units::heightFromSi(double metres) const {
  return system_ == UnitSystem::Aviation ? metres / kMetresPerFoot : metres;
}
double Units::heightToSi(double shown) const {
  return system_ == UnitSystem::Aviation ? shown * kMetresPerFoot : shown;
}
double Units::distanceFromSi(double metres) const {
  return metres / (system_ == UnitSystem::Aviation ? kMetresPerNauticalMile : kMetresPerKilometre);
}
double Units::distanceToSi(double shown) const {
  return shown * (system_ == UnitSystem::Aviation ? kMetresPerNauticalMile : kMetresPerKilometre);
}
QString Units::speedUnit() const {
  return system_ == UnitSystem::Aviation ? QStringLiteral("kt") : QStringLiteral("km/h");
}
double Units::speedFromSi(double mps) const {
  return mps / (system_ == UnitSystem::Aviation ? kMpsPerKnot : kMpsPerKmh);
}
double Units::speedToSi(double shown) const {
  return shown * (system_ == UnitSystem::Aviation ? kMpsPerKnot : kMpsPerKmh);
}

QString Units::altitudeMsl(double metres) const {
  return QStringLiteral("%1 %2 MSL").arg(grouped(std::round(heightFromSi(metres))), heightUnit());
}
QString Units::requiredMsl(double metres) const {
  return QStringLiteral("%1 %2 MSL").arg(grouped(std::ceil(heightFromSi(metres) - kConversionNoise)), heightUnit());
}
QString Units::heightAboveGround(double metres) const {
  return QStringLiteral("%1 %2 AGL").arg(grouped(std::floor(heightFromSi(metres) + kConversionNoise)), heightUnit());
}
QString Units::margin(double metres) const {
  const double shown = std::floor(heightFromSi(metres) + kConversionNoise);
  return QStringLiteral("%1%2 %3").arg(shown > 0.0 ? QStringLiteral("+") : QString(), grouped(shown), heightUnit());
}
QString Units::height(double metres) const {
  return QStringLiteral("%1 %2").arg(grouped(std::round(heightFromSi(metres))), heightUnit());
}
QString Units::required(double metres) const {
  return QStringLiteral("%1 %2").arg(grouped(std::ceil(heightFromSi(metres) - kConversionNoise)), heightUnit());
}
QString Units::distance(double metres) const {
  const double shown = distanceFromSi(metres);
  return QStringLiteral("%1 %2").arg(decimal(shown, std::abs(shown) < 100.0 ? 1 : 0), distanceUnit());
}
QString Units::shortDistance(double metres) const {
  return height(metres);
}
QString Units::speed(double mps) const {
  return system_ == UnitSystem::Aviation ? QStringLiteral("%1 kt").arg(decimal(mps / kMpsPerKnot, 0))
                                         : QStringLiteral("%1 km/h").arg(decimal(mps / kMpsPerKmh, 0));
}
QString Units::verticalSpeed(double mps) const {
  return system_ == UnitSystem::Aviation
             ? QStringLiteral("%1 ft/min").arg(grouped(std::round(mps / kMetresPerFoot * kSecondsPerMinute / 10.0) * 10.0))
             : QStringLiteral("%1 m/s").arg(decimal(mps, 1));
}

QString Units::inSentence(const std::string& sentence) const {
  QString text = coreText(sentence);
  if (system_ == UnitSystem::Metric) {
    return text;
  }
  // a length, or two with one unit: "between 300 and 400 m", "von 300 bis 400 m", "mezi 300 a 400 m", "46 x 67 km"
  static const QRegularExpression lengths(
      QStringLiteral(
          R"((?<![\w.\-])(?:(?<=between |from |zwischen |von |mezi |od )(-?\d+(?:\.\d+)?)( and | to | und | bis | a | do )|(\d+(?:\.\d+)?)( x ))?(?<![\d.])(-?\d+(?:\.\d+)?) (km|m)(?![\w/²³]))"),
      QRegularExpression::UseUnicodePropertiesOption);
  const auto figure = [this](const QString& number, bool isFar) {
    const auto point = number.indexOf(QLatin1Char('.'));
    const int digits = point < 0 ? 0 : static_cast<int>(number.size() - point - 1);
    const double metres = number.toDouble() * (isFar ? kMetresPerKilometre : 1.0);
    return isFar ? groupedDecimal(distanceFromSi(metres), std::max(digits, 1)) : groupedDecimal(heightFromSi(metres), digits);
  };
  qsizetype at = 0;
  for (QRegularExpressionMatch match = lengths.match(text, at); match.hasMatch(); match = lengths.match(text, at)) {
    const bool isFar = match.captured(6) == QStringLiteral("km");
    QString shown;
    for (const int first : {1, 3}) {
      if (!match.captured(first).isEmpty()) {
        shown = figure(match.captured(first), isFar) + match.captured(first + 1);
      }
    }
    shown += QStringLiteral("%1 %2").arg(figure(match.captured(5), isFar), isFar ? distanceUnit() : heightUnit());
    text.replace(match.capturedStart(), match.capturedLength(), shown);
    at = match.capturedStart() + shown.size();
  }
  return text;
}

QString Units::duration(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  const long long hours = whole / 3600;
  const long long minutes = whole / 60 % 60;
  const QString twoDigits = QStringLiteral("%1").arg(whole % 60, 2, 10, QLatin1Char('0'));
  return hours > 0 ? QStringLiteral("%1:%2:%3 h").arg(hours).arg(minutes, 2, 10, QLatin1Char('0')).arg(twoDigits)
                   : QStringLiteral("%1:%2 min").arg(minutes).arg(twoDigits);
}

QString Units::course(double trueCourse_deg) {
  int whole = static_cast<int>(std::lround(trueCourse_deg)) % 360;
  whole = whole <= 0 ? whole + 360 : whole;
  return QStringLiteral("%1° T").arg(whole, 3, 10, QLatin1Char('0'));
}

QString Units::position(geo::LatLon place) {
  const auto part = [](double degrees, int width, QChar positive, QChar negative) {
    const auto hundredths = std::llround(std::abs(degrees) * 6000.0);  // of a minute
    return QStringLiteral("%1°%2.%3′ %4")
        .arg(hundredths / 6000, width, 10, QLatin1Char('0'))
        .arg(hundredths / 100 % 60, 2, 10, QLatin1Char('0'))
        .arg(hundredths % 100, 2, 10, QLatin1Char('0'))
        .arg(degrees < 0.0 ? negative : positive);
  };
  return part(place.latitude_deg, 2, QLatin1Char('N'), QLatin1Char('S')) + QStringLiteral("  ") +
         part(place.longitude_deg, 3, QLatin1Char('E'), QLatin1Char('W'));
}

QString Units::angle(double degrees) {
  return QStringLiteral("%1°").arg(decimal(degrees, 1));
}

QString Units::variation(double east_deg) {
  return QStringLiteral("%1° %2").arg(std::abs(east_deg), 0, 'f', 1).arg(east_deg < 0.0 ? QLatin1Char('W') : QLatin1Char('E'));
}

}  // namespace vp::style
