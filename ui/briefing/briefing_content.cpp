#include "ui/briefing/briefing_content.h"

#include "core/aircraft/glide_model.h"
#include "core/geo/magnetic_field.h"
#include "core/mission/glide_conditions.h"
#include "core/safety/rules.h"
#include "ui/briefing/condition_facts.h"
#include "ui/briefing/figure_text.h"
#include "ui/briefing/home_text.h"
#include "ui/document/airspace_words.h"
#include "ui/document/condition_words.h"
#include "ui/document/wind_words.h"
#include "ui/panels/guarantee_text.h"
#include "ui/profile/plot_text.h"
#include "ui/profile/tour_curves.h"
#include "ui/style/core_text.h"
#include "ui/style/language.h"

#include <QCoreApplication>
#include <QDate>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace vp::briefing {
namespace {

constexpr qsizetype kGroup = 8;         // digits of a checksum
constexpr double kPolarTooGood = 65.0;  // m lower per km with a polar of 6.6 instead of 4.9 degrees (DESIGN section 2), the larger figure

QString dateText(std::chrono::year_month_day date) {
  const QDate day(static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
                  static_cast<int>(static_cast<unsigned>(date.day())));
  return style::languageLocale().toString(day, QCoreApplication::translate("Briefing", "d MMM yyyy", "date, as QDate::toString takes it"));
}

QString inGroups(QString digits) {
  for (qsizetype at = digits.size() / kGroup * kGroup; at > 0; at -= kGroup) {
    digits.insert(at, QLatin1Char(' '));
  }
  return digits.trimmed();
}

QString number(double value, int decimals) {
  return profile::groupedNumber(value, decimals);
}

class Words {
  Q_DECLARE_TR_FUNCTIONS(Briefing)

public:
  Words(const BriefingSource& source, const BriefingOptions& options)
      : source_(source), plan_(*source.plan), options_(options), units_(options.units) {}

  [[nodiscard]] std::vector<Fact> facts() const;
  [[nodiscard]] Table sources() const;
  [[nodiscard]] Table margins() const;
  [[nodiscard]] Table findings() const;
  [[nodiscard]] Table airspaces() const;
  [[nodiscard]] QStringList assumptions() const;
  [[nodiscard]] std::vector<Fact> abbreviations() const;
  void judge(BriefingContent& content) const;

private:
  [[nodiscard]] QString flightText() const;
  [[nodiscard]] QString aircraftText() const;
  [[nodiscard]] QString polarText(const aircraft::GlideModel& glide) const;
  [[nodiscard]] static QString ratioText(const aircraft::GlideModel& glide);
  [[nodiscard]] QString turnsText(const aircraft::GlideModel& glide) const;
  [[nodiscard]] QString ceilingText() const;
  [[nodiscard]] QString windText(const aircraft::GlideModel& glide) const;
  [[nodiscard]] QString airText() const;
  [[nodiscard]] QString placeOf(const safety::Finding& finding) const;
  void addMagnetic(QStringList& lines) const;

  const BriefingSource& source_;
  const mission::Plan& plan_;
  const BriefingOptions& options_;
  const style::Units& units_;
};

QString Words::aircraftText() const {
  const aircraft::AircraftProfile& craft = plan_.mission.aircraft;
  return QString::fromStdString(craft.name.empty() ? craft.id : craft.name) + Words::tr(", %1 kg").arg(number(craft.mass_kg, 0));
}

QString Words::flightText() const {
  const QString beyond = document::beyondUsableWords(plan_);
  return document::flightWords(plan_, units_) + (beyond.isEmpty() ? QString() : QStringLiteral(". ") + Words::tr("NOT ENOUGH: %1").arg(beyond));
}

QString Words::polarText(const aircraft::GlideModel& glide) const {
  const aircraft::AircraftProfile& craft = plan_.mission.aircraft;
  return Words::tr(
             "%1 TAS, glide ratio %2 straight ahead (%3 down, %4); polar: drag coefficient %5 + %6 × lift coefficient², wing %7 m², air %8 kg/m³")
      .arg(document::glideSpeedWords(plan_, units_))
      .arg(ratioText(glide))
      .arg(style::Units::angle(std::atan(glide.straightLoss()) * 180.0 / Angle::kPi))
      .arg(units_.verticalSpeed(-glide.airspeed() * std::sin(std::atan(glide.straightLoss()))))
      .arg(aircraft::zeroLiftDragOf(craft, plan_.mission.propeller))
      .arg(craft.inducedDrag)
      .arg(craft.wingArea_m2)
      .arg(craft.airDensity_kgm3);
}

QString Words::ratioText(const aircraft::GlideModel& glide) {
  const auto ratio = [](double loss) { return QStringLiteral("%1 : 1").arg(1.0 / loss, 0, 'f', 1); };
  if (glide.isCalm()) {
    return ratio(glide.straightLoss());
  }
  return Words::tr("%1 in still air and %2 over ground against the strongest wind,")
      .arg(ratio(glide.straightLoss()), ratio(glide.mostStraightLoss()));
}

QString Words::turnsText(const aircraft::GlideModel& glide) const {
  QStringList turns;
  for (const Angle bank : plan_.mission.aircraft.glideBanks) {
    const double radius = glide.radiusOf(bank);
    const double lost = glide.mostInHalfTurn(radius);
    turns << (glide.isCalm()
                  ? Words::tr("%1° of bank: radius %2, a half turn loses %3").arg(bank.degrees()).arg(units_.height(radius), units_.height(lost))
                  : Words::tr("at most %1° of bank: radius over ground %2, a half turn loses up to %3")
                        .arg(bank.degrees())
                        .arg(units_.height(radius), units_.required(lost)));
  }
  return turns.join(QStringLiteral("; "));
}

QString Words::ceilingText() const {
  const std::optional<geo::HeightMsl> ceiling = mission::ceilingOf(plan_.mission);
  return ceiling ? units_.altitudeMsl(ceiling->metres()) : Words::tr("none set");
}

QString Words::windText(const aircraft::GlideModel& glide) const {
  if (glide.isCalm()) {
    return Words::tr("calm assumed: wind, up- and downdrafts are not in the figures");
  }
  return Words::tr(
             "%1 (directions true). The glides hold in every such wind with the track over ground kept; up- and downdrafts are not in the figures")
      .arg(document::windLines(plan_.mission.wind, units_).join(QStringLiteral("; ")));
}

QString Words::airText() const {
  if (aircraft::GlideModel(plan_.mission.aircraft, mission::glideConditionsOf(plan_.mission, plan_.sites)).isCalm()) {
    return Words::tr(
        "Calm air. A headwind on the glide, or sinking air, costs height that is nowhere in the figures. With wind, keep more height or do not "
        "rely on this plan.");
  }
  return Words::tr(
             "The glides hold in %1, if the track over ground is kept by crabbing and by banking with the ground speed. Stronger wind, wind from "
             "elsewhere, gusts and sinking air cost height that is nowhere in the figures.")
      .arg(document::airPhrase(plan_.mission.wind, units_));
}

std::vector<Fact> Words::facts() const {
  const aircraft::AircraftProfile& craft = plan_.mission.aircraft;
  const aircraft::GlideModel glide(craft, mission::glideConditionsOf(plan_.mission, plan_.sites));
  const TourFigures& figures = source_.figures;
  const FigureText numbers(units_, figures.length);
  double low = 1e300;
  double high = -1e300;
  for (const mission::DecisionPoint& point : plan_.tour) {
    low = std::min(low, point.altitude);
    high = std::max(high, point.altitude);
  }
  const auto clearance = plan_.mission.safety.clearance.si();
  std::vector<Fact> list{
      {Words::tr("Tour"),
       Words::tr("%1 targets, %2, %3 at %7 in %6, between %4 and %5")
           .arg(QString::number(figures.visits.size()), numbers.distanceWithUnit(figures.length), style::Units::duration(figures.seconds),
                units_.altitudeMsl(low), units_.altitudeMsl(high),
                glide.isCalm() ? Words::tr("calm air") : Words::tr("the middle of the forecast wind"),
                mission::powerSettingOf(plan_.mission) != nullptr
                    ? Words::tr("%1 TAS").arg(units_.speed(mission::tourAirspeedAt(plan_.mission, geo::HeightMsl::fromMetres(0.5 * (low + high)))))
                    : Words::tr("the glide speed"))},
      {Words::tr("Flight"), flightText()},
      {Words::tr("Aircraft"), aircraftText()},
      {Words::tr("Best glide"), polarText(glide)},
      {Words::tr("Glide turns"), turnsText(glide)},
      {Words::tr("Tour limits"), Words::tr("%1° of bank (radius %2), climb %3°, descent %4°")
                                     .arg(craft.tourBank.degrees())
                                     .arg(units_.height(glide.tourRadius()))
                                     .arg(craft.maxClimb.degrees())
                                     .arg(craft.maxDescent.degrees())},
      {Words::tr("Home"), homeText(source_, units_)},
      {Words::tr("Wind"), windText(glide)},
      {Words::tr("Clearance"),
       Words::tr("%1 above the ground on tour and glides, what the glide model leaves out included").arg(units_.height(clearance))},
      {Words::tr("On arrival"), Words::tr("at least %1 above the runway").arg(units_.height(plan_.mission.safety.arrivalMargin.si()))},
      {Words::tr("Ceiling"), ceilingText()},
  };
  addConditions(list, plan_, units_);
  list.push_back({Words::tr("Made by"), Words::tr("plan: %1; briefing: %2").arg(QString::fromStdString(plan_.createdBy), options_.program)});
  return list;
}

Table Words::sources() const {
  Table table;
  table.title = Words::tr("Sources");
  table.columns = {{QString(), true}, {Words::tr("File"), true}, {Words::tr("Last changed"), true}, {Words::tr("SHA-256"), true}};
  const auto add = [&table](const QString& kind, const SourceFile& file, const QString& lead) {
    table.rows.push_back(
        {{kind, QString::fromStdString(file.path), file.changed.empty() ? Words::tr("not here") : QString::fromStdString(file.changed),
          file.sha256.empty() ? Words::tr("not known") : lead + inGroups(QString::fromStdString(file.sha256))}});
  };
  for (const SourceFile& file : source_.terrainFiles) {
    add(Words::tr("Terrain"), file, {});
  }
  for (const SourceFile& file : source_.airfieldFiles) {
    add(Words::tr("Airfields"), file, Words::tr("now: "));
  }
  if (!plan_.mission.sites.empty()) {
    table.rows.push_back({{Words::tr("Airfields"), Words::tr("in the mission itself"), {}, {}}});
  }
  table.note = Words::tr(
                   "Terrain is used in cells of %1 m, each with the highest ground inside it. Runways are as the plan holds them; check them "
                   "against current publications.")
                   .arg(number(plan_.terrainCell, 1));
  return table;
}

void Words::judge(BriefingContent& content) const {
  content.isVerified = source_.report.isSafe();
  content.isCalm = aircraft::GlideModel(plan_.mission.aircraft, mission::glideConditionsOf(plan_.mission, plan_.sites)).isCalm();
  if (content.isVerified) {
    content.verdict = Words::tr("VERIFIED SAFE");
    content.statement = panels::guaranteeStatement(*source_.plan, units_);
    return;
  }
  const auto bad = std::count_if(source_.report.findings.begin(), source_.report.findings.end(), [](const safety::Finding& finding) {
    return finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown;
  });
  content.verdict = Words::tr("UNVERIFIED – DO NOT FLY");
  content.statement =
      Words::tr(
          "The independent checker refused this plan: %1 findings, listed below. No one has shown that a glide to a runway exists from every point "
          "of it, and the figures in this briefing may be wrong.")
          .arg(bad);
}

Table Words::margins() const {
  static constexpr std::array<std::pair<const char*, const char*>, 10> kWords{{
      {"tour.clearance", QT_TRANSLATE_NOOP("Briefing", "Tour above ground and clearance")},
      {"tour.glide", QT_TRANSLATE_NOOP("Briefing", "Tour above what the glides need")},
      {"glide.clearance", QT_TRANSLATE_NOOP("Briefing", "Glides above ground and clearance")},
      {"glide.dynamics", QT_TRANSLATE_NOOP("Briefing", "Glides above ground less what rolling may cost")},
      {"glide.arrival", QT_TRANSLATE_NOOP("Briefing", "Glides above what is asked for on arrival")},
      {"tour.climb", QT_TRANSLATE_NOOP("Briefing", "Climb below the steepest allowed")},
      {"tour.descent", QT_TRANSLATE_NOOP("Briefing", "Descent below the steepest allowed")},
      {"tour.ceiling", QT_TRANSLATE_NOOP("Briefing", "Tour below the ceiling")},
      {"target.height", QT_TRANSLATE_NOOP("Briefing", "Tour above the targets")},
      {"spiral.clearance", QT_TRANSLATE_NOOP("Briefing", "Spirals above ground and clearance")},
  }};
  Table table;
  table.title = Words::tr("Least margins of the whole plan");
  table.note = Words::tr("As the independent checker found them: what is left beyond the requirement.");
  table.columns = {{Words::tr("What"), true}, {Words::tr("Margin")}, {Words::tr("Where"), true}};
  for (const mission::Margin& margin : source_.report.margins) {
    const auto* const known = std::find_if(kWords.begin(), kWords.end(), [&](const auto& words) { return margin.kind == words.first; });
    const QString value = margin.unit == "m"     ? units_.margin(margin.value)
                          : margin.unit == "deg" ? style::Units::angle(std::floor(margin.value * 10.0) / 10.0)
                                                 : number(margin.value, 1) + QLatin1Char(' ') + QString::fromStdString(margin.unit);
    table.rows.push_back({{known == kWords.end() ? QString::fromStdString(margin.kind) : QCoreApplication::translate("Briefing", known->second),
                           value, style::Units::position(margin.where)}});
  }
  return table;
}

QString Words::placeOf(const safety::Finding& finding) const {
  if (finding.tourPoint < 0) {
    return finding.where ? style::Units::position(*finding.where) : Words::tr("whole plan");
  }
  const std::size_t count = plan_.tour.size();
  for (const Leg& leg : source_.figures.legs) {
    const std::size_t after = (static_cast<std::size_t>(finding.tourPoint) + count - leg.firstPoint) % count;
    if (after < leg.intervals) {
      double along = 0.0;
      for (std::size_t k = 0; k < after; ++k) {
        along += plan_.tour[(leg.firstPoint + k) % count].onward.length;
      }
      const FigureText numbers(units_, source_.figures.length);
      return leg.from < 0
                 ? Words::tr("at %1").arg(numbers.distanceWithUnit(along))
                 : Words::tr("leg %1→%2, %3").arg(QString::number(leg.from + 1), QString::number(leg.to + 1), numbers.distanceWithUnit(along));
    }
  }
  return {};
}

Table Words::findings() const {
  Table table;
  table.title = Words::tr("Findings");
  table.note = Words::tr("What the checker wants a pilot to know; in its own words, heights in metres.");
  table.columns = {{Words::tr("Weight"), true}, {Words::tr("Where"), true}, {Words::tr("What"), true}};
  for (const safety::Severity severity : {safety::Severity::Violated, safety::Severity::Unknown, safety::Severity::Warning, safety::Severity::Note}) {
    const QString name = severity == safety::Severity::Violated  ? Words::tr("VIOLATED")
                         : severity == safety::Severity::Unknown ? Words::tr("UNKNOWN")
                         : severity == safety::Severity::Warning ? Words::tr("Warning")
                                                                 : Words::tr("Note");
    for (const safety::Finding& finding : source_.report.findings) {
      const bool isInStatement = source_.report.isSafe() && finding.rule == safety::rule::kHomeGuarantee;
      if (finding.severity == severity && !isInStatement) {
        table.rows.push_back({{name, placeOf(finding), style::coreText(finding.text)},
                              false,
                              severity == safety::Severity::Violated || severity == safety::Severity::Unknown});
      }
    }
  }
  return table;
}

Table Words::airspaces() const {
  Table table;
  table.title = Words::tr("Airspaces");
  table.note =
      Words::tr("Those near the tour that the mission keeps the tour out of or warns of. A glide after an engine failure may enter any of them.");
  table.columns = {{Words::tr("Airspace"), true}, {Words::tr("Ceiling / floor"), true}, {Words::tr("The tour"), true}};
  for (const mission::Airspace& airspace : plan_.airspaces) {
    const bool isForbidden = mission::useOf(airspace, plan_.mission.airspace) == mission::AirspaceUse::Forbid;
    QStringList cells = document::airspaceText(airspace, units_);
    cells << (isForbidden ? Words::tr("keeps out") : Words::tr("may enter; a warning"));
    table.rows.push_back({cells, false, isForbidden});
  }
  return table;
}

void Words::addMagnetic(QStringList& lines) const {
  lines << Words::tr("Magnetic tracks are true tracks corrected by the %1, for %2; iron in the ground and in the aircraft comes on top.")
               .arg(QString::fromStdString(geo::magneticModelName()), dateText(options_.date));
  if (!source_.figures.fieldIsCovered) {
    lines << Words::tr("The magnetic model is not made for this date: its rates were carried on, so expect errors of some degrees.");
  }
  if (source_.figures.compassIsUnreliable) {
    lines << Words::tr(
        "So near a magnetic pole compasses are unreliable: fly true tracks. Where no magnetic track is given, a compass is of no use at all.");
  }
}

QStringList Words::assumptions() const {
  QStringList lines{
      airText(),
      reactionAssumption(plan_, units_),
      Words::tr(
          "A simulated Cessna 172 that flew such glides ended up to %1 lower at 30° of bank and %2 at 45°: that part of the clearance is spoken "
          "for. A worse polar than the one on the first page (propeller windmilling, dirty wing, flaps, wrong speed) costs more: 35 % more sink "
          "ended up to %3 lower per %4 of glide.")
          .arg(units_.required(15.0), units_.required(30.0), units_.required(kPolarTooGood * units_.distanceToSi(1.0) / 1000.0),
               units_.distanceUnit()),
      Words::tr(
          "Between two decision points the aircraft first glides on along the tour to the next one, then turns for the runway: at most %1 further.")
          .arg(units_.height(plan_.mission.planner.step.si())),
      approachAssumption(plan_),
      Words::tr(
          "Ground is the highest of each terrain cell, from the file named on the first page. Masts, cables, trees, buildings and errors of that "
          "file are in it only if the file has them."),
      altimeterAssumption(plan_, units_),
  };
  if (plan_.departure && plan_.arrival) {
    lines << homeGuarantee(source_, units_);
  }
  if (!plan_.spirals.empty()) {
    lines << Words::tr(
        "Spirals down to low targets suspend the guarantee from the moment they are entered until the tour's altitude is reached again.");
  }
  addMagnetic(lines);
  lines << Words::tr("The pilot in command decides. This briefing replaces no official source.");
  return lines;
}

std::vector<Fact> Words::abbreviations() const {
  std::vector<Fact> list{{Words::tr("MSL"), Words::tr("above mean sea level")},
                         {Words::tr("AGL"), Words::tr("above ground level: the highest ground of the terrain cell below")},
                         {Words::tr("°T, °M"), Words::tr("true and magnetic degrees; magnetic = true − east variation, + west variation")},
                         {Words::tr("Var."), Words::tr("magnetic variation, E east, W west")},
                         {Words::tr("TAS"), Words::tr("true airspeed")},
                         {Words::tr("1→2"), Words::tr("leg from target 1 to target 2")},
                         {Words::tr("Safe"), Words::tr("lowest altitude from which the plan's glides work, on a whole leg")},
                         {Words::tr("Margin"), Words::tr("height above the lowest from which the glide works")},
                         {Words::tr("Clear."), Words::tr("clearance: height above the highest ground of the cells below")},
                         {Words::tr("?"), Words::tr("the airfield file does not say")}};
  if (plan_.departure && plan_.arrival) {
    list.push_back({Words::tr("out, in"), Words::tr("way from the home runway to the tour, way from the tour to the home runway")});
  }
  return list;
}

}  // namespace

BriefingContent briefingContent(const BriefingSource& source, const BriefingOptions& options) {
  const Words words(source, options);
  BriefingContent content;
  content.title = QString::fromStdString(source.plan->mission.name).simplified();
  content.title = content.title.isEmpty() ? Words::tr("Unnamed mission") : content.title;
  content.date = dateText(options.date);
  words.judge(content);
  content.facts = words.facts();
  content.sources = words.sources();
  content.margins = words.margins();
  content.findings = words.findings();
  content.airspaces = words.airspaces();
  content.assumptions = words.assumptions();
  content.abbreviations = words.abbreviations();
  addTables(content, source, options);
  return content;
}

}  // namespace vp::briefing
