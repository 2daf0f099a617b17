#include "ui/briefing/condition_facts.h"

#include "ui/document/condition_words.h"

#include <QCoreApplication>

namespace vp::briefing {
namespace {

QString text(const char* source) {
  return QCoreApplication::translate("Briefing", source);
}

QString propellerText(aircraft::Propeller propeller) {
  switch (propeller) {
    case aircraft::Propeller::AsInPolar:
      break;
    case aircraft::Propeller::Windmilling:
      return text("windmilling, turned by the air");
    case aircraft::Propeller::Stopped:
      return text("stopped: the glides hold only if it is");
  }
  return {};
}

QString approachText(const mission::ApproachSettings& approach, const style::Units& units) {
  if (approach == mission::ApproachSettings()) {
    return {};
  }
  const QString words = document::approachWords(approach, units);
  const QString surface = document::surfaceWords(approach, units);
  return surface.isEmpty() ? words : text("%1; on that last part only above %2, where that is less than the clearance").arg(words, surface);
}

}  // namespace

void addConditions(std::vector<Fact>& facts, const mission::Plan& plan, const style::Units& units) {
  const mission::Mission& mission = plan.mission;
  const auto add = [&facts](const QString& name, const QString& value, const QString& frame = QStringLiteral("%1")) {
    if (!value.isEmpty()) {
      facts.push_back({name, frame.arg(value)});
    }
  };
  add(text("Masses"), document::massWords(mission.aircraft), text("%1, each at its best glide speed, which goes with the root of the mass"));
  add(text("Air"), mission.atmosphere ? document::airWords(*mission.atmosphere) : QString());
  add(text("Altimeter"), document::altimeterWords(plan, units));
  add(text("Reaction"), document::reactionWords(mission.safety, units), text("%1; the aircraft flies on meanwhile, then the glide is established"));
  add(text("Drag"), mission.safety.dragFactor > 1.0 ? QString::number(mission.safety.dragFactor, 'g', 4) : QString(),
      text("%1 times that of the polar; the glide ratios are with it"));
  add(text("Propeller"), propellerText(mission.propeller));
  add(text("Power"), document::powerWords(mission, units));
  add(text("Approach"), approachText(mission.approach, units));
  add(text("Holds"), document::holdWords(plan, units).join(QStringLiteral("; ")));
}

QString reactionAssumption(const mission::Plan& plan, const style::Units& units) {
  const QString clearance = units.height(plan.mission.safety.clearance.si());
  const QString reaction = document::reactionWords(plan.mission.safety, units);
  if (plan.mission.aircraft.rollRate_dps && plan.certificate) {
    const QString rolling = document::rollingWords(plan, units);
    return reaction.isEmpty()
               ? text(
                     "The engine fails and the aircraft is at best-glide speed and in the right turn at once. Reaction and slowing down "
                     "are not modelled; they have to be paid from the clearance of %1. What is modelled: %2.")
                     .arg(clearance, rolling)
               : text(
                     "The engine fails and the aircraft flies on (%1); then it is at best-glide speed. A longer reaction is not modelled; "
                     "it has to be paid from the clearance of %2. What is modelled: %3.")
                     .arg(reaction, clearance, rolling);
  }
  if (reaction.isEmpty()) {
    return text(
               "The engine fails and the aircraft is at best-glide speed and in the right turn at once. Reaction, slowing down and rolling into "
               "turns "
               "are not modelled; they have to be paid from the clearance of %1.")
        .arg(clearance);
  }
  return text(
             "The engine fails and the aircraft flies on (%1); then it is at best-glide speed and in the right turn at once. A longer reaction and "
             "rolling into turns are not modelled; they have to be paid from the clearance of %2.")
      .arg(reaction, clearance);
}

QString approachAssumption(const mission::Plan& plan) {
  const QString surplus =
      plan.holds.empty() ? text("lost in a spiral above the runway") : text("lost in the circles of the line “Holds”, where the approach begins");
  return text(
             "The glide ends over the touchdown point on the landing course, with the height in the column “Arrives”. What is more than needed is "
             "%1; traffic, obstacles, surface state and closures are not known to the program.")
      .arg(surplus);
}

QString altimeterAssumption(const mission::Plan& plan, const style::Units& units) {
  if (document::altimeterWords(plan, units).isEmpty()) {
    return text(
        "Altitudes are above mean sea level in the datum of the terrain file, not pressure altitudes: a warm or cold day or a wrong QNH shifts "
        "them.");
  }
  return text(
      "Altitudes are above mean sea level in the datum of the terrain file, not what an altimeter shows: the line “Altimeter” says by how much it is "
      "wrong in the air of the plan; a colder day or a wrong QNH shifts them more.");
}

}  // namespace vp::briefing
