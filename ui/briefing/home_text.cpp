#include "ui/briefing/home_text.h"

#include "ui/briefing/figure_text.h"
#include "ui/panels/guarantee_text.h"

#include <QCoreApplication>

namespace vp::briefing {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Briefing)
};

QString wayFact(const panels::HomeWay& way, const BriefingSource& source, const style::Units& units) {
  const FigureText numbers(units, source.figures.length);
  QString said = Words::tr("%1, %2").arg(way.name(), numbers.distanceWithUnit(way.length));
  if (way.path.guaranteed > 0) {
    said += Words::tr(" (NO GLIDE GUARANTEE on the first %1, up to %2)")
                .arg(panels::unguardedText(way.unguarded, units), units.requiredMsl(way.begins()));
  }
  return said;
}

}  // namespace

QString homeText(const BriefingSource& source, const style::Units& units) {
  const mission::Plan& plan = *source.plan;
  if (!plan.departure || !plan.arrival) {
    return Words::tr("none: the plan is the tour alone; the guarantee holds on the tour only");
  }
  return Words::tr("from %1; to %2. In the tables the ways from and to it are called “out” and “in”")
      .arg(wayFact({plan, *plan.departure}, source, units), wayFact({plan, *plan.arrival}, source, units));
}

QString homeGuarantee(const BriefingSource& source, const style::Units& units) {
  const panels::HomeWay out(*source.plan, *source.plan->departure);
  const panels::HomeWay in(*source.plan, *source.plan->arrival);
  return Words::tr(
             "After taking off from %1 there is NO gliding guarantee on the first %2 of flight past the far end of the runway, up to %3 (%4 above "
             "the runway): if the engine stops there, this plan has no glide, and the aircraft lands ahead as after any takeoff. The guarantee ends "
             "above the threshold of %5 at %6; from there the landing is the pilot's.")
      .arg(out.name(), panels::unguardedText(out.unguarded, units), units.requiredMsl(out.begins()), units.required(out.begins() - out.elevation()),
           in.name(), units.requiredMsl(in.ends()));
}

}  // namespace vp::briefing
