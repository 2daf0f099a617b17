#include "ui/briefing/condition_facts.h"

#include "ui/document/condition_words.h"

#include <QCoreApplication>

namespace vp::briefing {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Briefing)
};

QString propellerText(aircraft::Propeller propeller) {
  switch (propeller) {
    case aircraft::Propeller::AsInPolar:
      break;
    case aircraft::Propeller::Windmilling:
      return Words::tr("windmilling, turned by the air");
    case aircraft::Propeller::Stopped:
      return Words::tr("stopped: the glides hold only if it is");
  }
  return {};
}

QString approachText(const mission::ApproachSettings& approach, const style::Units& units) {
  if (approach == mission::ApproachSettings()) {
    return {};
  }
  const QString words = document::approachWords(approach, units);
  const QString surface = document::surfaceWords(approach, units);
  return surface.isEmpty() ? words : Words::tr("%1; on that last part only above %2, where that is less than the clearance").arg(words, surface);
}

}  // namespace

void addConditions(std::vector<Fact>& facts, const mission::Plan& plan, const style::Units& units) {
  const mission::Mission& mission = plan.mission;
  const auto add = [&facts](const QString& name, const QString& value, const QString& frame = QStringLiteral("%1")) {
    if (!value.isEmpty()) {
      facts.push_back({name, frame.arg(value)});
    }
  };
  add(Words::tr("Masses"), document::massWords(mission.aircraft),
      Words::tr("%1, each at its best glide speed, which goes with the root of the mass"));
  add(Words::tr("Air"), mission.atmosphere ? document::airWords(*mission.atmosphere) : QString());
  add(Words::tr("Altimeter"), document::altimeterWords(plan, units));
  add(Words::tr("Reaction"), document::reactionWords(mission.safety, units),
      Words::tr("%1; the aircraft flies on meanwhile, then the glide is established"));
  add(Words::tr("Drag"), mission.safety.dragFactor > 1.0 ? QString::number(mission.safety.dragFactor, 'g', 4) : QString(),
      Words::tr("%1 times that of the polar; the glide ratios are with it"));
  add(Words::tr("Propeller"), propellerText(mission.propeller));
  add(Words::tr("Power"), document::powerWords(mission, units));
  add(Words::tr("Approach"), approachText(mission.approach, units));
  add(Words::tr("Holds"), document::holdWords(plan, units).join(QStringLiteral("; ")));
}

QString reactionAssumption(const mission::Plan& plan, const style::Units& units) {
  const QString clearance = units.height(plan.mission.safety.clearance.si());
  const QString reaction = document::reactionWords(plan.mission.safety, units);
  if (plan.mission.aircraft.rollRate_dps && plan.certificate) {
    const QString rolling = document::rollingWords(plan, units);
    return reaction.isEmpty()
               ? Words::tr(
                     "The engine fails and the aircraft is at best-glide speed and in the right turn at once. Reaction and slowing down "
                     "are not modelled; they have to be paid from the clearance of %1. What is modelled: %2.")
                     .arg(clearance, rolling)
               : Words::tr(
                     "The engine fails and the aircraft flies on (%1); then it is at best-glide speed. A longer reaction is not modelled; "
                     "it has to be paid from the clearance of %2. What is modelled: %3.")
                     .arg(reaction, clearance, rolling);
  }
  if (reaction.isEmpty()) {
    return Words::tr(
               "The engine fails and the aircraft is at best-glide speed and in the right turn at once. Reaction, slowing down and rolling into "
               "turns "
               "are not modelled; they have to be paid from the clearance of %1.")
        .arg(clearance);
  }
  return Words::tr(
             "The engine fails and the aircraft flies on (%1); then it is at best-glide speed and in the right turn at once. A longer reaction and "
             "rolling into turns are not modelled; they have to be paid from the clearance of %2.")
      .arg(reaction, clearance);
}

QString approachAssumption(const mission::Plan& plan) {
  const QString surplus = plan.holds.empty() ? Words::tr("lost in a spiral above the runway")
                                             : Words::tr("lost in the circles of the line “Holds”, where the approach begins");
  return Words::tr(
             "The glide ends over the touchdown point on the landing course, with the height in the column “Arrives”. What is more than needed is "
             "%1; traffic, obstacles, surface state and closures are not known to the program.")
      .arg(surplus);
}

QString altimeterAssumption(const mission::Plan& plan, const style::Units& units) {
  if (document::altimeterWords(plan, units).isEmpty()) {
    return Words::tr(
        "Altitudes are above mean sea level in the datum of the terrain file, not pressure altitudes: a warm or cold day or a wrong QNH shifts "
        "them.");
  }
  return Words::tr(
      "Altitudes are above mean sea level in the datum of the terrain file, not what an altimeter shows: the line “Altimeter” says by how much it is "
      "wrong in the air of the plan; a colder day or a wrong QNH shifts them more.");
}

}  // namespace vp::briefing
