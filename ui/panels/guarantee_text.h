#pragma once

#include "core/mission/plan.h"
#include "ui/style/units.h"

#include <QString>

namespace vp::panels {

/** What the certificate says, in the pilot's units: from where the aircraft reaches which runways, with what is kept clear and
 *  every exception. Heights that are promised are rounded down, distances and altitudes up to which nothing is promised up.
 *  @pre the plan is certified */
QString guaranteeStatement(const mission::Plan& plan, const style::Units& units);

/** What there is to say of a way from or to home; metres, altitudes MSL. */
struct HomeWay {
  HomeWay(const mission::Plan& plan, const mission::HomePath& way);
  [[nodiscard]] QString name() const;  ///< "LSZS 21"
  [[nodiscard]] double begins() const { return path.points[static_cast<std::size_t>(path.guaranteed)].altitude; }
  [[nodiscard]] double ends() const { return path.points.back().altitude; }
  [[nodiscard]] double elevation() const { return runway.elevation.metres(); }

  const mission::LandingSite& runway;
  const mission::HomePath& path;
  double length = 0.0;
  double unguarded = 0.0;  ///< without any glide
};

/** "0.43 NM", a distance without promise: rounded up to a hundredth of a unit. */
QString unguardedText(double metres, const style::Units& units);

}  // namespace vp::panels
