#include "ui/document/airspace_words.h"

#include "core/base/quantity.h"

#include <QCoreApplication>

#include <cmath>

namespace vp::document {
namespace {

using mission::AirspaceLimit;
using mission::AirspaceUse;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(vp::document::Words)
};

QString limitText(const AirspaceLimit& limit, const style::Units& units) {
  switch (limit.kind) {
    case AirspaceLimit::Kind::Surface:
      return QStringLiteral("GND");
    case AirspaceLimit::Kind::Msl:
      return units.altitudeMsl(limit.metres);
    case AirspaceLimit::Kind::AboveGround:
      return units.height(limit.metres) + QStringLiteral(" AGL");
    case AirspaceLimit::Kind::FlightLevel:
      return QStringLiteral("FL %1").arg(std::lround(limit.metres / kMetresPerFoot / 100.0));
    case AirspaceLimit::Kind::Unlimited:
      return QStringLiteral("UNL");
    case AirspaceLimit::Kind::Unknown:
      break;
  }
  return QStringLiteral("?");
}

}  // namespace

QString airspaceUseText(AirspaceUse use) {
  switch (use) {
    case AirspaceUse::Hide:
      return Words::tr("Hide");
    case AirspaceUse::Show:
      return Words::tr("Show only");
    case AirspaceUse::Warn:
      return Words::tr("Warn when entered");
    case AirspaceUse::Forbid:
      break;
  }
  return Words::tr("Keep the tour out");
}

QStringList airspaceText(const mission::Airspace& airspace, const style::Units& units) {
  return {QStringLiteral("%1 %2").arg(QString::fromStdString(airspace.kind), QString::fromStdString(airspace.name)),
          limitText(airspace.ceiling, units) + QStringLiteral(" / ") + limitText(airspace.floor, units)};
}

}  // namespace vp::document
