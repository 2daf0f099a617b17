#include "ui/panels/site_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace vp::panels {
namespace {

QString text(const char* source) {
  return QCoreApplication::translate("SiteText", source);
}

}  // namespace

QString surfaceName(mission::Surface surface) {
  switch (surface) {
    case mission::Surface::Hard:
      return text("hard");
    case mission::Surface::Gravel:
      return text("gravel");
    case mission::Surface::Grass:
      return text("grass");
    case mission::Surface::Dirt:
      return text("dirt");
    case mission::Surface::Water:
      return text("water");
    case mission::Surface::Snow:
      return text("snow");
    case mission::Surface::Unknown:
      break;
  }
  return text("unknown surface");
}

QString runwayDetails(const mission::LandingSite& site, const style::Units& units) {
  QStringList parts{text("Landing course %1").arg(style::Units::course(site.landingCourse.degrees()))};
  parts << (site.length ? text("length %1").arg(units.shortDistance(site.length->si())) : text("length unknown"));
  parts << surfaceName(site.surface) << text("elevation %1").arg(units.altitudeMsl(site.elevation.metres()));
  if (site.isApproximate()) {
    parts << text("partly estimated");
  }
  return parts.join(QStringLiteral(" · "));
}

QString missingHeight(double metres, const style::Units& units) {
  return units.margin(-metres).mid(1);  // a margin is rounded down, so what is missing is rounded up
}

}  // namespace vp::panels
