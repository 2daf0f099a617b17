// The tables of a briefing that come from its figures.
#include "ui/briefing/briefing_content.h"
#include "ui/briefing/figure_text.h"
#include "ui/map/target_marks.h"
#include "ui/panels/site_text.h"
#include "ui/profile/tour_curves.h"

#include <QCoreApplication>

#include <algorithm>

namespace vp::briefing {
namespace {

constexpr std::size_t kWorst = 3;
constexpr qsizetype kLongestName = 100;  // characters; what is longer is shortened in its middle
constexpr qsizetype kLongestLeg = 32;    // the same, of a name that stands whole in the table of targets

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Briefing)
};

QString named(const std::string& name, qsizetype longest = kLongestName) {
  const QString whole = QString::fromStdString(name).simplified();
  return whole.size() <= longest ? whole : whole.left(longest / 2) + QChar(0x2026) + whole.right(longest / 2 - 1);
}

class Tables {
public:
  Tables(BriefingContent& content, const BriefingSource& source, const BriefingOptions& options)
      : content_(content),
        plan_(*source.plan),
        figures_(source.figures),
        frame_(plan_.frameOrigin),
        numbers_(options.units, source.figures.length),
        worst_(worstDiverts(source.figures, kWorst)) {}

  void add();

private:
  void nameRunways();
  void addRunways();
  void addTargets();
  void addLegs();
  void addEngineOut();
  void addGlides();
  [[nodiscard]] QString height() const { return numbers_.units().heightUnit(); }
  [[nodiscard]] QString far() const { return numbers_.units().distanceUnit(); }
  [[nodiscard]] QString targetName(int visit) const;
  [[nodiscard]] QString legName(int leg) const;
  [[nodiscard]] std::vector<const std::vector<Divert>*> allDiverts() const;
  [[nodiscard]] QStringList legCells(const QString& name, const QString& to, const Leg& leg) const;
  void addDeparture(Table& table) const;
  void addArrival(Table& table) const;
  [[nodiscard]] Row divertRow(const QString& name, const Divert& divert) const;
  void addWayDiverts(const QString& name, const std::optional<WayFigures>& way, Table& table) const;
  [[nodiscard]] const mission::SiteInFrame& site(int index) const { return plan_.sites[static_cast<std::size_t>(index)]; }
  [[nodiscard]] QString letterOf(int site) const { return FigureText::letter(content_.letterOf[static_cast<std::size_t>(site)]); }
  [[nodiscard]] const Track& landing(int site) const { return figures_.siteTracks[static_cast<std::size_t>(site)]; }
  [[nodiscard]] QString remark(const Visit& visit) const;

  BriefingContent& content_;
  const mission::Plan& plan_;
  const TourFigures& figures_;
  geo::LocalFrame frame_;
  FigureText numbers_;
  std::vector<std::size_t> worst_;  ///< into TourFigures::diverts
};

QString Tables::targetName(int visit) const {
  if (visit < 0) {
    return Words::tr("start");
  }
  const int target = figures_.visits[static_cast<std::size_t>(visit)].target;
  return named(plan_.targets[static_cast<std::size_t>(target)].target.name, kLongestLeg);
}

QString Tables::legName(int leg) const {
  const Leg& flown = figures_.legs[static_cast<std::size_t>(leg)];
  return flown.from < 0 ? Words::tr("all") : QStringLiteral("%1→%2").arg(flown.from + 1).arg(flown.to + 1);
}

void Tables::nameRunways() {
  content_.letterOf.assign(plan_.sites.size(), -1);
  int next = 0;
  for (const std::vector<Divert>* diverts : allDiverts()) {
    for (const Divert& divert : *diverts) {
      int& letter = content_.letterOf[static_cast<std::size_t>(divert.site)];
      letter = letter < 0 ? next++ : letter;
    }
  }
}

/// In the order flown.
std::vector<const std::vector<Divert>*> Tables::allDiverts() const {
  std::vector<const std::vector<Divert>*> all{&figures_.diverts};
  if (figures_.departure && figures_.arrival) {
    all.insert(all.begin(), &figures_.departure->diverts);
    all.push_back(&figures_.arrival->diverts);
  }
  return all;
}

void Tables::addRunways() {
  Table& table = content_.runways;
  table.title = Words::tr("Runways that the glides lead to");
  table.note = Words::tr(
      "Letters as on the map, in the order in which the tour needs them. “Serves” is the length of tour from which the glides lead here. "
      "What is approximate stands under Findings.");
  table.columns = {{QString()},
                   {Words::tr("Runway"), true},
                   {Words::tr("Airfield"), true},
                   {Words::tr("Elev.\n%1 MSL").arg(height())},
                   {Words::tr("Lands\n°T")},
                   {Words::tr("\n°M")},
                   {Words::tr("Length\n%1").arg(height())},
                   {Words::tr("Width\n%1").arg(height())},
                   {Words::tr("Surface"), true},
                   {Words::tr("Lights"), true},
                   {Words::tr("Serves\n%1").arg(far())},
                   {Words::tr("Remarks"), true}};
  std::vector<double> served(plan_.sites.size(), 0.0);
  for (const std::vector<Divert>* diverts : allDiverts()) {
    for (const Divert& divert : *diverts) {
      served[static_cast<std::size_t>(divert.site)] += divert.to - divert.from;
    }
  }
  std::vector<int> order;
  for (std::size_t i = 0; i < plan_.sites.size(); ++i) {
    if (content_.letterOf[i] >= 0) {
      order.push_back(static_cast<int>(i));
    }
  }
  std::sort(order.begin(), order.end(),
            [this](int a, int b) { return content_.letterOf[static_cast<std::size_t>(a)] < content_.letterOf[static_cast<std::size_t>(b)]; });
  const auto lengthText = [&](const std::optional<Length>& length) { return length ? numbers_.altitude(length->si()) : Words::tr("?"); };
  for (const int index : order) {
    const mission::LandingSite& runway = site(index).site;
    table.rows.push_back(
        {{letterOf(index), profile::runwayName(runway), named(runway.airportName), numbers_.altitude(runway.elevation.metres()),
          FigureText::trueCourse(landing(index)), FigureText::magneticCourse(landing(index)), lengthText(runway.length), lengthText(runway.width),
          runway.surface == mission::Surface::Unknown ? Words::tr("?") : panels::surfaceName(runway.surface),
          runway.lighted ? Words::tr("yes") : Words::tr("no"), numbers_.distance(served[static_cast<std::size_t>(index)]),
          runway.isApproximate() ? Words::tr("approximate") : QString()}});
  }
}

QString Tables::remark(const Visit& visit) const {
  if (visit.spiral < 0) {
    return {};
  }
  const mission::SpiralVisit& spiral = plan_.spirals[static_cast<std::size_t>(visit.spiral)];
  return Words::tr("SPIRAL %1, turns down: %2 to %3, up: %4. NO GLIDE GUARANTEE inside it")
      .arg(spiral.turn == flight::Turn::Left ? Words::tr("left") : Words::tr("right"))
      .arg(spiral.turnsDown)
      .arg(numbers_.units().altitudeMsl(spiral.bottom))
      .arg(spiral.turnsUp);
}

void Tables::addTargets() {
  Table& table = content_.targets;
  table.title = Words::tr("Targets in the order of the tour");
  table.columns = {{Words::tr("No.")},
                   {Words::tr("Target"), true},
                   {Words::tr("Position"), true, true},
                   {Words::tr("Asked for"), true},
                   {Words::tr("Passed at\n%1 MSL").arg(height())},
                   {Words::tr("\n%1 AGL").arg(height())},
                   {Words::tr("Above\nasked, %1").arg(height())},
                   {Words::tr("At\n%1").arg(far())}};
  for (std::size_t i = 0; i < figures_.visits.size(); ++i) {
    const Visit& visit = figures_.visits[i];
    const mission::TargetInFrame& placed = plan_.targets[static_cast<std::size_t>(visit.target)];
    document::ShownTarget shown;
    shown.target = placed.target;
    QString name = named(placed.target.name);
    if (visit.spiral >= 0) {
      name += QLatin1Char('\n') + remark(visit);
    }
    table.rows.push_back({{QString::number(i + 1), name, style::Units::position(placed.target.position), map::targetHeight(shown, numbers_.units()),
                           numbers_.altitude(visit.altitude), numbers_.clearance(visit.clearance),
                           numbers_.altitude(visit.altitude - placed.altitude), numbers_.distance(visit.distance)},
                          false,
                          visit.spiral >= 0});
  }
}

void Tables::addLegs() {
  Table& table = content_.legs;
  table.title = Words::tr("Legs");
  table.note =
      Words::tr(
          "Track: of the longest straight part; i: the leg is all turns, heading at its start. Time in %1. “Safe”: fly at or above it and the "
          "glides of the whole leg work; it is the highest that any point of the leg needs.")
          .arg(plan_.mission.wind.empty() ? Words::tr("calm air") : Words::tr("the middle of the forecast wind"));
  table.columns = {{Words::tr("Leg")},
                   {Words::tr("To target"), true},
                   {Words::tr("Track\n°T")},
                   {Words::tr("\n°M")},
                   {Words::tr("Var.")},
                   {Words::tr("Dist.\n%1").arg(far())},
                   {Words::tr("Time\nmin")},
                   {Words::tr("Start\n%1 MSL").arg(height())},
                   {Words::tr("Highest\n%1 MSL").arg(height())},
                   {Words::tr("End\n%1 MSL").arg(height())},
                   {Words::tr("Least\n%1 AGL").arg(height())},
                   {Words::tr("Safe\n%1 MSL").arg(height())},
                   {Words::tr("Least\nmargin %1").arg(height())},
                   {Words::tr("at\n%1").arg(far())}};
  addDeparture(table);
  for (std::size_t i = 0; i < figures_.legs.size(); ++i) {
    const Leg& leg = figures_.legs[i];
    table.rows.push_back({legCells(legName(static_cast<int>(i)), targetName(leg.to), leg), i == 0 && figures_.departure.has_value()});
  }
  table.rows.push_back({{figures_.departure ? Words::tr("tour") : Words::tr("sum"), figures_.departure ? Words::tr("sum, once around") : QString(),
                         QString(), QString(), QString(), numbers_.distance(figures_.length), FigureText::time(figures_.seconds)},
                        true,
                        true});
  addArrival(table);
}

QStringList Tables::legCells(const QString& name, const QString& to, const Leg& leg) const {
  return {name,
          to,
          (leg.isStraightPart ? QString() : QStringLiteral("i ")) + FigureText::trueCourse(leg.track),
          FigureText::magneticCourse(leg.track),
          FigureText::variation(leg.track),
          numbers_.distance(leg.length),
          FigureText::time(leg.seconds),
          numbers_.altitude(leg.startAltitude),
          numbers_.altitude(leg.highestAltitude),
          numbers_.altitude(leg.endAltitude),
          numbers_.clearance(leg.leastClearance),
          numbers_.needed(leg.safeAltitude),
          numbers_.margin(leg.leastMargin),
          numbers_.distance(leg.leastMarginAt)};
}

void Tables::addDeparture(Table& table) const {
  if (!figures_.departure) {
    return;
  }
  const WayFigures& way = *figures_.departure;
  if (way.unguarded.intervals > 0) {
    QStringList cells = legCells(Words::tr("out"), Words::tr("climb-out, NO GLIDE GUARANTEE"), way.unguarded);
    for (qsizetype i = 10; i < cells.size(); ++i) {
      cells[i] = QStringLiteral("–");
    }
    table.rows.push_back({cells, false, true});
  }
  table.rows.push_back({legCells(Words::tr("out"), Words::tr("the tour, on leg %1").arg(legName(way.joinLeg)), way.leg)});
}

void Tables::addArrival(Table& table) const {
  if (figures_.arrival) {
    const mission::LandingSite& runway = site(plan_.arrival->site).site;
    table.rows.push_back(
        {legCells(Words::tr("in"), Words::tr("above %1, from leg %2").arg(profile::runwayName(runway), legName(figures_.arrival->joinLeg)),
                  figures_.arrival->leg)});
  }
}

void Tables::addEngineOut() {
  Table& table = content_.engineOut;
  table.title = Words::tr("If the engine stops");
  table.note =
      Words::tr(
          "From every place on the stretch the glides lead to this runway end. Glide and time: shortest and longest, best-glide speed, %1, to the "
          "touchdown point without the spiral that loses height left over. Margin: least height above the lowest from which the glide works. "
          "Clearance: "
          "least above the ground on all glides of the row. Bold: the worst places, drawn further on: least margin, and among margins alike within a "
          "metre the longest glide.")
          .arg(plan_.mission.wind.empty() ? Words::tr("calm air") : Words::tr("the slowest wind of the forecast"));
  if (figures_.departure) {
    table.note += QLatin1Char(' ') + Words::tr(
                                         "“out” and “in”: the ways from and to the home runway; the stretches of “out” are counted from where the "
                                         "guarantee begins. Before that there is no glide to brief.");
  }
  table.columns = {{Words::tr("Leg")},
                   {Words::tr("Stretch\n%1").arg(far())},
                   {QString()},
                   {Words::tr("Runway"), true},
                   {Words::tr("Elev.\n%1 MSL").arg(height())},
                   {Words::tr("Lands\n°T")},
                   {Words::tr("\n°M")},
                   {Words::tr("Length\n%1").arg(height())},
                   {Words::tr("Surface"), true},
                   {Words::tr("Glide\n%1").arg(far())},
                   {Words::tr("Time\nmin")},
                   {Words::tr("Margin\n%1").arg(height())},
                   {Words::tr("Clear.\n%1 AGL").arg(height())},
                   {Words::tr("Arrives\n%1 above").arg(height())}};
  addWayDiverts(Words::tr("out"), figures_.departure, table);
  int last = -1;
  for (std::size_t i = 0; i < figures_.diverts.size(); ++i) {
    const Divert& divert = figures_.diverts[i];
    Row row = divertRow(legName(divert.leg), divert);
    row.startsGroup = divert.leg != last;
    row.isStrong = std::find(worst_.begin(), worst_.end(), i) != worst_.end();
    table.rows.push_back(row);
    last = divert.leg;
  }
  addWayDiverts(Words::tr("in"), figures_.arrival, table);
}

Row Tables::divertRow(const QString& name, const Divert& divert) const {
  const mission::LandingSite& runway = site(divert.site).site;
  return {{name, numbers_.stretch(divert.from, divert.to), letterOf(divert.site), profile::runwayName(runway),
           numbers_.altitude(runway.elevation.metres()), FigureText::trueCourse(landing(divert.site)),
           FigureText::magneticCourse(landing(divert.site)), runway.length ? numbers_.altitude(runway.length->si()) : Words::tr("?"),
           runway.surface == mission::Surface::Unknown ? Words::tr("?") : panels::surfaceName(runway.surface),
           numbers_.distances(divert.leastGlide, divert.greatestGlide), FigureText::times(divert.leastSeconds, divert.greatestSeconds),
           numbers_.margin(divert.margin), numbers_.clearance(divert.leastClearance), numbers_.clearance(divert.leastArrival)}};
}

/// A stretch of “out” begins where the guarantee does.
void Tables::addWayDiverts(const QString& name, const std::optional<WayFigures>& way, Table& table) const {
  for (std::size_t i = 0; way && i < way->diverts.size(); ++i) {
    Row row = divertRow(name, way->diverts[i]);
    row.startsGroup = i == 0;
    table.rows.push_back(row);
  }
}

void Tables::addGlides() {
  for (std::size_t k = 0; k < worst_.size(); ++k) {
    const Divert& divert = figures_.diverts[worst_[k]];
    const Leg& leg = figures_.legs[static_cast<std::size_t>(divert.leg)];
    double along = divert.marginAt - leg.start;
    along = along < -1e-6 ? along + figures_.length : along;
    const style::Units& units = numbers_.units();
    GlideCaption caption;
    caption.distance = divert.marginAt;
    caption.title = Words::tr("Worst place %1: leg %2, %3 from its start, to runway %4 (%5)")
                        .arg(QString::number(k + 1), legName(divert.leg), numbers_.distanceWithUnit(along),
                             profile::runwayName(site(divert.site).site), letterOf(divert.site));
    const Track& course = landing(divert.site);
    caption.facts = {
        {Words::tr("Margin"), units.margin(profile::shownMargin(divert.margin))},
        {Words::tr("glide"), numbers_.distanceWithUnit(divert.worst.length) + QStringLiteral(", ") + style::Units::duration(divert.worst.seconds)},
        {Words::tr("least clearance"), units.heightAboveGround(divert.worst.clearance)},
        {Words::tr("arrives"), Words::tr("%1 above the runway").arg(units.margin(divert.worst.arrival))},
        {Words::tr("lands"), Words::tr("%1° T, %2° M").arg(FigureText::trueCourse(course), FigureText::magneticCourse(course))},
        {Words::tr("elevation"), units.altitudeMsl(site(divert.site).site.elevation.metres())}};
    content_.glides.push_back(caption);
  }
}

void Tables::add() {
  nameRunways();
  addRunways();
  addTargets();
  addLegs();
  addEngineOut();
  addGlides();
}

}  // namespace

void addTables(BriefingContent& content, const BriefingSource& source, const BriefingOptions& options) {
  Tables(content, source, options).add();
}

}  // namespace vp::briefing
