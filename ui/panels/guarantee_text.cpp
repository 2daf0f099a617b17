#include "ui/panels/guarantee_text.h"

#include "core/aircraft/glide_model.h"
#include "core/mission/glide_conditions.h"
#include "ui/document/condition_words.h"
#include "ui/document/wind_words.h"
#include "ui/profile/plot_text.h"
#include "ui/profile/tour_curves.h"

#include <QCoreApplication>

#include <cmath>
#include <set>

namespace vp::panels {
namespace {

constexpr double kRounding = 1e-6;  // of a unit: what is whole but for rounding stays as it is

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Guarantee)
};

/// A height that is promised.
QString promised(double metres, const style::Units& units) {
  return profile::groupedNumber(std::floor(units.heightFromSi(metres) + kRounding), 0) + QLatin1Char(' ') + units.heightUnit();
}

std::size_t runwaysUsed(const mission::Plan& plan) {
  std::set<int> used;
  for (const mission::DecisionPoint& point : plan.tour) {
    used.insert(point.witness.site);
  }
  for (const std::optional<mission::HomePath>* way : {&plan.departure, &plan.arrival}) {
    for (std::size_t i = *way ? static_cast<std::size_t>((*way)->guaranteed) : 0; *way && i < (*way)->points.size(); ++i) {
      used.insert((*way)->points[i].witness.site);
    }
  }
  return used.size();
}

QString exceptionOf(const mission::Plan& plan, const mission::SpiralVisit& spiral, const style::Units& units) {
  return Words::tr(
             " Exception: between %1 and %2 at target %3 the tour leaves the safe altitude in a spiral of %4 circles: there the gliding guarantee is "
             "suspended.")
      .arg(units.altitudeMsl(spiral.bottom), units.altitudeMsl(spiral.top),
           QString::fromStdString(plan.targets[static_cast<std::size_t>(spiral.target)].target.name).simplified(),
           QString::number(spiral.turnsDown + spiral.turnsUp));
}

QString homeException(const mission::Plan& plan, const style::Units& units) {
  const HomeWay out(plan, *plan.departure);
  const HomeWay in(plan, *plan.arrival);
  return Words::tr(
             " The same holds on the ways from and to the runway, but for the climb-out: after taking off from %1 it begins %2 past the far end of "
             "the runway, at %3 (%4 above the runway), and it ends above the threshold of %5 at %6 (%7 above the runway), from where the landing is "
             "the pilot's.")
      .arg(out.name(), unguardedText(out.unguarded, units), units.requiredMsl(out.begins()), units.required(out.begins() - out.elevation()),
           in.name(), units.requiredMsl(in.ends()), units.required(in.ends() - in.elevation()));
}

/// How glides end, and where they keep less than the clearance.
QString approachOf(const mission::ApproachSettings& approach, const style::Units& units) {
  QString said;
  if (approach.kind != mission::ApproachKind::Threshold) {
    said += Words::tr(" Every glide ends %1.").arg(document::approachWords(approach, units));
  }
  if (const QString surface = document::surfaceWords(approach, units); !surface.isEmpty()) {
    said += Words::tr(" On that last part it keeps only above %1, where that is less than the clearance.").arg(surface);
  }
  if (approach.hold) {
    said += Words::tr(" Where each approach begins there is room for circles in which height left over can be lost.");
  }
  return said;
}

/// What else it holds for, where it differs from the setting of the source papers.
QString conditionsOf(const mission::Plan& plan, const style::Units& units) {
  const mission::Mission& mission = plan.mission;
  QString said;
  if (const QString masses = document::massWords(mission.aircraft); !masses.isEmpty()) {
    said += Words::tr(" It holds for masses of %1, each at its best glide speed.").arg(masses);
  }
  if (mission.atmosphere) {
    said += Words::tr(" It holds in air of %1, from the lowest runway up to %2.")
                .arg(document::airWords(*mission.atmosphere), units.altitudeMsl(mission::ceilingOf(mission)->metres()));
  }
  if (const QString reaction = document::reactionWords(mission.safety, units); !reaction.isEmpty()) {
    said += Words::tr(" It allows for a reaction after the engine stops, with the aircraft flying on: %1.").arg(reaction);
  }
  if (mission.safety.dragFactor > 1.0) {
    said += Words::tr(" Drag counts %1 times that of the polar; the glide ratios are with it.").arg(mission.safety.dragFactor, 0, 'g', 4);
  }
  if (mission.propeller != aircraft::Propeller::AsInPolar) {
    said += mission.propeller == aircraft::Propeller::Stopped ? Words::tr(" It holds with the propeller stopped only.")
                                                              : Words::tr(" It holds with the propeller windmilling.");
  }
  if (const QString power = document::powerWords(mission, units); !power.isEmpty()) {
    said += Words::tr(" The tour is flown at %1.").arg(power);
  }
  return said + approachOf(mission.approach, units);
}

}  // namespace

QString unguardedText(double metres, const style::Units& units) {
  constexpr double kPerUnit = 100.0;
  return profile::groupedNumber(std::ceil(units.distanceFromSi(metres) * kPerUnit - kRounding) / kPerUnit, 2) + QChar(QChar::Nbsp) +
         units.distanceUnit();
}

HomeWay::HomeWay(const mission::Plan& plan, const mission::HomePath& way) : runway(plan.sites[static_cast<std::size_t>(way.site)].site), path(way) {
  for (std::size_t i = 0; i + 1 < way.points.size(); ++i) {
    unguarded += static_cast<int>(i) < way.guaranteed ? way.points[i].onward.length : 0.0;
    length += way.points[i].onward.length;
  }
}

QString HomeWay::name() const {
  return profile::runwayName(runway);
}

QString guaranteeStatement(const mission::Plan& plan, const style::Units& units) {
  const aircraft::GlideModel glide(plan.mission.aircraft, mission::glideConditionsOf(plan.mission, plan.sites));
  const QString ratio = QString::number(1.0 / glide.straightLoss(), 'f', 1);
  const QString glides = glide.isCalm() ? Words::tr("glide ratio %1 straight ahead").arg(ratio)
                                        : Words::tr("glide ratio %1 straight ahead in still air, %2 over ground against the strongest wind")
                                              .arg(ratio, QString::number(1.0 / glide.mostStraightLoss(), 'f', 1));
  const std::size_t runways = runwaysUsed(plan);
  const std::string& profile = plan.mission.aircraft.name.empty() ? plan.mission.aircraft.id : plan.mission.aircraft.name;
  QString said =
      Words::tr(
          "From every point of this tour (%1 decision points and all points between them) the aircraft, its engine stopped and gliding at %2 TAS in "
          "%9 with the polar of %3 (%4), can reach %5 on the landing course, at least %6 above the terrain on all "
          "the way and at least %7 above the runway on arrival. Terrain is the highest ground of each cell of %8, runways are as listed in the "
          "plan; ")
          .arg(QString::number(plan.tour.size()), document::glideSpeedWords(plan, units), QString::fromStdString(profile), glides,
               runways == 1 ? Words::tr("the one runway end used") : Words::tr("one of %1 runway ends").arg(runways),
               promised(plan.mission.safety.clearance.si(), units), promised(plan.mission.safety.arrivalMargin.si(), units),
               units.height(plan.terrainCell), document::airPhrase(plan.mission.wind, units));
  said += document::rollingWords(plan, units) + QLatin1Char('.');
  said += conditionsOf(plan, units);
  if (plan.departure && plan.arrival) {
    said += homeException(plan, units);
  }
  for (const mission::SpiralVisit& spiral : plan.spirals) {
    said += exceptionOf(plan, spiral, units);
  }
  return said;
}

}  // namespace vp::panels
