#include "ui/panels/site_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace vp::panels {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(SiteText)
};

}  // namespace

QString surfaceName(mission::Surface surface) {
  switch (surface) {
    case mission::Surface::Hard:
      return Words::tr("hard");
    case mission::Surface::Gravel:
      return Words::tr("gravel");
    case mission::Surface::Grass:
      return Words::tr("grass");
    case mission::Surface::Dirt:
      return Words::tr("dirt");
    case mission::Surface::Water:
      return Words::tr("water");
    case mission::Surface::Snow:
      return Words::tr("snow");
    case mission::Surface::Unknown:
      break;
  }
  return Words::tr("unknown surface");
}

QString runwayDetails(const mission::LandingSite& site, const style::Units& units) {
  QStringList parts{Words::tr("Landing course %1").arg(style::Units::course(site.landingCourse.degrees()))};
  parts << (site.length ? Words::tr("length %1").arg(units.shortDistance(site.length->si())) : Words::tr("length unknown"));
  parts << surfaceName(site.surface) << Words::tr("elevation %1").arg(units.altitudeMsl(site.elevation.metres()));
  if (site.isApproximate()) {
    parts << Words::tr("partly estimated");
  }
  return parts.join(QStringLiteral(" · "));
}

QString missingHeight(double metres, const style::Units& units) {
  return units.margin(-metres).mid(1);  // a margin is rounded down, so what is missing is rounded up
}

}  // namespace vp::panels
