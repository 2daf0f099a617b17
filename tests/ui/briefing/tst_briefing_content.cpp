// What a briefing says about the racetrack, in a pilot's units.
#include "core/safety/checker.h"
#include "core/safety/rules.h"
#include "tests/support/plan_builder.h"
#include "tests/support/quick_plan.h"
#include "ui/briefing/briefing_content.h"
#include "ui/briefing/figure_text.h"
#include "ui/panels/guarantee_text.h"

#include <QRegularExpression>
#include <QTest>

using namespace vp;
using namespace vp::briefing;

namespace {

constexpr std::chrono::year_month_day kDay{std::chrono::year(2026), std::chrono::month(6), std::chrono::day(1)};
const QChar kThin(0x2009);

BriefingSource sourceOf(const mission::Plan& plan, const test::TestTerrain& terrain = test::TestTerrain()) {
  BriefingSource source;
  auto grid = std::make_shared<const terrain::ElevationGrid>(terrain.grid());
  source.report = *safety::check({plan, *grid, {std::string(64, 'a')}}, Job());
  mission::Plan copy = plan;
  copy.certificate = source.report.certificate;
  source.figures = *tourFigures(copy, *grid, kDay, Job());
  source.terrain = document::makeTerrainData(geo::LocalFrame(plan.frameOrigin), grid, plan.terrain);
  source.terrainFiles = {{"flat.tif", std::string(64, 'a'), "2026-03-01"}};
  source.plan = std::make_shared<const mission::Plan>(std::move(copy));
  return source;
}

BriefingOptions optionsIn(style::UnitSystem system) {
  BriefingOptions options;
  options.units = style::Units(system);
  options.date = kDay;
  options.program = QStringLiteral("test 1.0");
  return options;
}

/// Cells of a row by the heads of the columns; columns with the same head count on.
QString cell(const Table& table, std::size_t row, const QString& head) {
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].head == head) {
      return table.rows.at(row).cells.value(static_cast<qsizetype>(c));
    }
  }
  return QStringLiteral("no such column");
}

QString factOf(const BriefingContent& content, const QString& name) {
  for (const Fact& fact : content.facts) {
    if (fact.name == name) {
      return fact.value;
    }
  }
  return {};
}

}  // namespace

class TestBriefingContent : public QObject {
  Q_OBJECT

private slots:
  void racetrack_legs_sayWhatWasWorkedOutByHand() {
    const test::PlanBuilder builder(600.0);
    const BriefingContent content = briefingContent(sourceOf(builder.plan()), optionsIn(style::UnitSystem::Aviation));
    QVERIFY(content.isVerified);
    QCOMPARE(content.legs.rows.size(), std::size_t{3});  // two legs and the sum
    QCOMPARE(cell(content.legs, 0, "Leg"), QString("1→2"));
    QCOMPARE(cell(content.legs, 1, "Leg"), QString("2→1"));
    QCOMPARE(cell(content.legs, 0, "To target"), QString("bridge"));
    QCOMPARE(cell(content.legs, 0, "Track\n°T"), QString("090"));
    QCOMPARE(cell(content.legs, 0, "\n°M"), QString("086"));                         // 4 degrees east there in 2026
    QCOMPARE(cell(content.legs, 0, "Dist.\nNM"), QString("1.59"));                   // 2942.5 m
    QCOMPARE(cell(content.legs, 0, "Time\nmin"), QString("1:28"));                   // 88.1 s at 33.4 m/s
    QCOMPARE(cell(content.legs, 0, "Start\nft MSL"), QString("1") + kThin + "969");  // 1968.5
    QCOMPARE(cell(content.legs, 0, "Least\nft AGL"), QString("1") + kThin + "968");  // rounded down
    QCOMPARE(cell(content.legs, 2, "Dist.\nNM"), QString("3.18"));
  }

  void racetrack_metric_saysMetres() {
    const test::PlanBuilder builder(600.0);
    const BriefingContent content = briefingContent(sourceOf(builder.plan()), optionsIn(style::UnitSystem::Metric));
    QCOMPARE(cell(content.legs, 0, "Start\nm MSL"), QString("600"));
    QCOMPARE(cell(content.legs, 0, "Dist.\nkm"), QString("2.94"));
    QVERIFY(factOf(content, "Clearance").startsWith("100 m"));
  }

  void heightsAreRounded_soThatNothingLooksSafer() {
    const test::PlanBuilder builder(600.0);
    const BriefingSource source = sourceOf(builder.plan());
    const BriefingContent content = briefingContent(source, optionsIn(style::UnitSystem::Aviation));
    const auto feet = [](QString text) { return text.remove(kThin).toDouble(); };
    const Divert& divert = source.figures.diverts[0];
    QVERIFY(feet(cell(content.engineOut, 0, "Margin\nft")) <= divert.margin / kMetresPerFoot);
    QVERIFY(feet(cell(content.engineOut, 0, "Clear.\nft AGL")) <= divert.leastClearance / kMetresPerFoot);
    QVERIFY(feet(cell(content.legs, 0, "Safe\nft MSL")) >= source.figures.legs[0].safeAltitude / kMetresPerFoot);
  }

  void engineOut_namesRunway_andWhatTheFileLacks() {
    const test::PlanBuilder builder(600.0);
    const BriefingContent content = briefingContent(sourceOf(builder.plan()), optionsIn(style::UnitSystem::Aviation));
    QCOMPARE(content.engineOut.rows.size(), std::size_t{2});
    QCOMPARE(cell(content.engineOut, 0, "Runway"), QString("TEST 09"));
    QCOMPARE(cell(content.engineOut, 0, "Stretch\nNM"), QString("0.00–1.59"));
    QCOMPARE(cell(content.engineOut, 0, "Lands\n°T"), QString("090"));
    QCOMPARE(cell(content.engineOut, 0, "Length\nft"), QString("?"));
    QCOMPARE(cell(content.engineOut, 0, "Surface"), QString("?"));
    QCOMPARE(content.runways.rows.size(), std::size_t{1});
    QCOMPARE(content.runways.rows[0].cells[0], QString("A"));
    QCOMPARE(cell(content.runways, 0, "Serves\nNM"), QString("3.18"));
  }

  void targets_standInTheOrderOfTheTour_withTheirPlaces() {
    const test::PlanBuilder builder(600.0);
    const BriefingContent content = briefingContent(sourceOf(builder.plan()), optionsIn(style::UnitSystem::Metric));
    QCOMPARE(content.targets.rows.size(), std::size_t{2});
    QCOMPARE(cell(content.targets, 0, "Target"), QString("mill"));
    QCOMPARE(cell(content.targets, 0, "Asked for"), QString("110 m AGL"));
    QCOMPARE(cell(content.targets, 0, "Above\nasked, m"), QString("490"));
    QCOMPARE(cell(content.targets, 1, "Asked for"), QString("300 m MSL"));
    QCOMPARE(cell(content.targets, 1, "Position"), style::Units::position(builder.plan().targets[1].target.position));
  }

  void unsafePlan_isUnverified_withItsViolationsFirst() {
    test::PlanBuilder builder(600.0);
    builder.flyAt(150.0);
    const BriefingContent content = briefingContent(sourceOf(builder.plan()), optionsIn(style::UnitSystem::Aviation));
    QVERIFY(!content.isVerified);
    QVERIFY(content.verdict.contains("UNVERIFIED"));
    QVERIFY(!content.findings.rows.empty());
    QCOMPARE(cell(content.findings, 0, "Weight"), QString("VIOLATED"));
    QVERIFY(cell(content.engineOut, 0, "Margin\nft").startsWith(QChar(0x2212)));
  }

  void findingAtAPoint_isPlacedOnItsLeg() {
    test::PlanBuilder builder(600.0);
    test::TestTerrain terrain;
    terrain.setCell(525.0, 1025.0, 580.0F);
    const BriefingContent content = briefingContent(sourceOf(builder.plan(), terrain), optionsIn(style::UnitSystem::Aviation));
    QVERIFY(!content.isVerified);
    QVERIFY2(cell(content.findings, 0, "Where").startsWith("leg 1→2, 0."), qPrintable(cell(content.findings, 0, "Where")));
  }

  void spiral_isNamedWithItsSuspendedGuarantee() {
    test::PlanBuilder builder(600.0);
    mission::SpiralVisit spiral;
    spiral.target = 0;
    spiral.top = 600.0;
    spiral.bottom = 110.0;
    spiral.radius = 200.0;
    spiral.turnsDown = 3;
    spiral.turnsUp = 2;
    builder.plan().spirals = {spiral};
    const BriefingContent content = briefingContent(sourceOf(builder.plan()), optionsIn(style::UnitSystem::Metric));
    QVERIFY2(cell(content.targets, 0, "Target").contains("SPIRAL left, turns down: 3 to 110 m MSL, up: 2. NO GLIDE GUARANTEE"),
             qPrintable(cell(content.targets, 0, "Target")));
    QVERIFY(content.assumptions.join(' ').contains("Spirals"));
  }

  void statement_saysWhatTheCertificateSays_inThePilotsUnits() {
    test::PlanBuilder builder(600.0);
    builder.plan().mission.safety.arrivalMargin = Length::fromSi(20.0);
    const BriefingSource source = sourceOf(builder.plan());
    QVERIFY(source.report.isSafe());
    const QString certified = QString::fromStdString(source.report.certificate->statement);
    const QString feet = briefingContent(source, optionsIn(style::UnitSystem::Aviation)).statement;
    QVERIFY2(feet.contains("gliding at 65 kt TAS") && feet.contains("at least 328 ft above the terrain") &&
                 feet.contains("at least 65 ft above the runway on arrival"),  // 328.1 and 65.6, rounded down
             qPrintable(feet));
    QVERIFY(!feet.contains(QRegularExpression("\\d m\\b")));
    const QString metres = briefingContent(source, optionsIn(style::UnitSystem::Metric)).statement;
    QVERIFY2(metres.contains("at least 100 m above the terrain") && metres.contains("at least 20 m above the runway"), qPrintable(metres));
    const QRegularExpression runways("can reach (.*) on the landing course");
    QCOMPARE(runways.match(feet).captured(1), runways.match(certified).captured(1));
    const QRegularExpression numbers("\\((\\d+) decision points");
    QCOMPARE(numbers.match(feet).captured(1), numbers.match(certified).captured(1));
  }

  void airspaces_areListed_theForbiddenOnesInBold() {
    test::PlanBuilder builder(600.0);
    using Kind = mission::AirspaceLimit::Kind;
    builder.plan().airspaces = {{"RANGE", "R", {Kind::Surface, 0.0}, {Kind::FlightLevel, 1981.2}, {}}, {"ZONE", "CTR", {}, {Kind::Msl, 3048.0}, {}}};
    builder.plan().mission.airspace = {{"air.txt"}, {{"R", "", mission::AirspaceUse::Forbid}}, mission::AirspaceUse::Warn};
    const BriefingContent content = briefingContent(sourceOf(builder.plan()), optionsIn(style::UnitSystem::Aviation));
    QCOMPARE(content.airspaces.rows.size(), std::size_t{2});
    QCOMPARE(content.airspaces.rows[0].cells, QStringList({"R RANGE", "FL 65 / GND", "keeps out"}));
    QVERIFY(content.airspaces.rows[0].isStrong && !content.airspaces.rows[1].isStrong);
    QCOMPARE(content.airspaces.rows[1].cells[2], QString("may enter; a warning"));
  }

  void title_holdsAircraftSourcesAndDates() {
    const test::PlanBuilder builder(600.0);
    const BriefingContent content = briefingContent(sourceOf(builder.plan()), optionsIn(style::UnitSystem::Aviation));
    QCOMPARE(content.title, QString("racetrack"));
    QCOMPARE(content.date, QString("1 Jun 2026"));
    QVERIFY(factOf(content, "Aircraft").contains("Test 172"));
    QVERIFY(factOf(content, "Best glide").contains("65 kt"));
    QVERIFY(factOf(content, "Glide turns").contains("30° of bank"));
    QVERIFY(factOf(content, "Wind").contains("calm"));
    QCOMPARE(factOf(content, "Ceiling"), QString("none set"));
    QCOMPARE(content.sources.rows.size(), std::size_t{2});
    QCOMPARE(content.sources.rows[1].cells[1], QString("in the mission itself"));
    QCOMPARE(content.sources.rows[0].cells[2], QString("2026-03-01"));
    QCOMPARE(QString(content.sources.rows[0].cells[3]).remove(' '), QString(64, 'a'));
    QVERIFY(content.assumptions.join(' ').contains("WMM"));
  }

  void settings_ofThePapers_takeNoRoom() {
    const test::PlanBuilder builder(600.0);
    const BriefingContent content = briefingContent(sourceOf(builder.plan()), optionsIn(style::UnitSystem::Aviation));
    for (const char* name : {"Masses", "Air", "Altimeter", "Reaction", "Drag", "Propeller", "Power", "Approach", "Holds"}) {
      QVERIFY2(factOf(content, name).isEmpty(), name);
    }
    QVERIFY(content.assumptions.join(' ').contains("Reaction, slowing down and rolling into turns are not modelled"));
  }

  void settings_areStatedInThePilotsUnits() {
    test::PlanBuilder builder(600.0);
    BriefingSource source = sourceOf(builder.plan());
    mission::Plan plan = *source.plan;
    mission::Mission& mission = plan.mission;
    mission.safety.reactionTime = Duration::fromSi(4.0);
    mission.safety.reactionLoss = Length::fromSi(30.0);
    mission.safety.dragFactor = 1.1;
    mission.atmosphere = air::Atmosphere{-30.0, 1005.0};
    mission.ceiling = geo::HeightMsl::fromMetres(3048.0);
    mission.approach.kind = mission::ApproachKind::Straight;
    mission.approach.finalLength = Length::fromSi(1524.0);
    mission.approach.surfaceSlope = 0.05;
    mission.approach.hold = true;
    mission.propeller = aircraft::Propeller::Stopped;
    mission.aircraft.stoppedDrag = 0.03;
    mission.aircraft.leastMass_kg = 700.0;
    mission.aircraft.powerSettings = {{"65 %", Speed::fromSi(115.0 * kMpsPerKnot), 27.6, aircraft::PowerSetting::Unit::Litres}};
    mission.powerSetting = "65 %";
    plan.holds = {{0, flight::Turn::Left, 304.8, 914.4}};
    source.plan = std::make_shared<const mission::Plan>(plan);
    const BriefingContent content = briefingContent(source, optionsIn(style::UnitSystem::Aviation));
    const auto said = [&](const char* name) { return factOf(content, name).remove(kThin).replace(QChar(QChar::Nbsp), ' '); };
    QVERIFY2(said("Masses").startsWith("700 to 1111 kg, each at its best glide speed"), qPrintable(said("Masses")));
    QCOMPARE(said("Air"), QString("ISA \u221230 \u00b0C, QNH 1005 hPa"));
    const double error = air::altimeterError(*mission.atmosphere, geo::HeightMsl::fromMetres(600.0), plan.sites[0].site.elevation);
    const QString feet = QString::number(std::ceil(error / kMetresPerFoot)) + " ft";
    QVERIFY2(error > 0.0 && said("Altimeter").contains("up to " + feet + " too much at 1969 ft MSL"), qPrintable(said("Altimeter")));
    QVERIFY2(said("Reaction").startsWith("4.0 s, 98 ft lost in it;"), qPrintable(said("Reaction")));  // 98.4, rounded down
    QVERIFY(said("Drag").startsWith("1.1 times that of the polar"));
    QVERIFY(said("Propeller").startsWith("stopped"));
    QCOMPARE(said("Power"), QString("65 %: 115 kt TAS, 27.6 l per hour"));
    QVERIFY2(said("Approach")
                 .startsWith("after a straight of 5000 ft on the landing course; on that last part only above an obstacle surface that begins "
                             "197 ft before the touchdown point and rises by 5.0 %"),
             qPrintable(said("Approach")));
    QCOMPARE(said("Holds"), QString("TEST 09: left circles of 1000 ft radius, no lower than 3000 ft MSL"));
    QVERIFY(said("Best glide").contains("+ "));
    QVERIFY2(said("Best glide").contains("0.03 + "), qPrintable(said("Best glide")));  // the stopped propeller's drag, not the polar's
    QVERIFY(said("Tour").contains("at 115 kt TAS"));
    const QString assumed = content.assumptions.join(' ');
    QVERIFY(assumed.contains("the aircraft flies on (4.0 s, 98 ft lost in it)") && assumed.contains("lost in the circles of the line"));
    QVERIFY(assumed.contains("not what an altimeter shows"));
    const QString statement = panels::guaranteeStatement(plan, style::Units(style::UnitSystem::Aviation)).remove(kThin);
    for (const char* part : {" It holds for masses of 700 to 1111 kg", "QNH 1005 hPa, from the lowest runway up to 10000 ft MSL.",
                             "flying on: 4.0 s, 98 ft lost in it.", " Drag counts 1.1 times", " It holds with the propeller stopped only.",
                             " The tour is flown at 65 %: 115 kt TAS", " Every glide ends after a straight of 5000 ft",
                             " On that last part it keeps only above an obstacle surface that begins 197 ft", " there is room for circles"}) {
      QVERIFY2(statement.contains(QLatin1String(part)), qPrintable(statement));
    }
    QVERIFY2(statement.contains(QRegularExpression("gliding at \\d+ to \\d+ kt TAS")), qPrintable(statement));
  }

  void warmAir_needsNoCorrectionOfTheAltimeter() {
    test::PlanBuilder builder(600.0);
    BriefingSource source = sourceOf(builder.plan());
    mission::Plan plan = *source.plan;
    plan.mission.atmosphere = air::Atmosphere{10.0, 1013.25};
    source.plan = std::make_shared<const mission::Plan>(plan);
    const BriefingContent content = briefingContent(source, optionsIn(style::UnitSystem::Metric));
    QVERIFY(factOf(content, "Altimeter").isEmpty());
    QCOMPARE(factOf(content, "Air"), QString("ISA +10 \u00b0C, QNH 1013.25 hPa"));
  }

  void home_isNamed_withTheStretchThatHasNoGuarantee() {
    test::PlanBuilder builder(600.0);
    mission::HomePath departure;
    departure.site = 0;
    departure.guaranteed = 1;
    departure.points.resize(3);
    departure.points[0].onward.length = 1852.0;
    departure.points[1].altitude = 304.8;
    departure.points[1].onward.length = 1852.0;
    mission::HomePath arrival;
    arrival.site = 0;
    arrival.points.resize(2);
    arrival.points[0].onward.length = 926.0;
    BriefingSource source = sourceOf(builder.plan());
    mission::Plan plan = *source.plan;
    plan.departure = departure;
    plan.arrival = arrival;
    source.plan = std::make_shared<const mission::Plan>(plan);
    const QString said =
        factOf(briefingContent(source, optionsIn(style::UnitSystem::Aviation)), "Home").replace(QChar(QChar::Nbsp), ' ').remove(kThin);
    QVERIFY2(said.startsWith("from TEST 09, 2.00 NM (NO GLIDE GUARANTEE on the first 1.00 NM, up to 1000 ft MSL); to TEST 09, 0.50 NM."),
             qPrintable(said));
  }

  void homeWays_areRowsOfTheTables_andTheClimbOutHasNoGlide() {
    mission::Mission mission = test::quickMission(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm");
    mission.home = mission::HomeBase{"MTSW/13", "MTNE/12"};
    const test::QuickPlan made = test::quickPlan(mission);
    BriefingSource source;
    source.plan = made.plan;
    source.report.certificate = made.plan->certificate;
    source.figures = *tourFigures(*made.plan, *made.loaded.terrain, kDay, Job());
    source.terrain = document::makeTerrainData(geo::LocalFrame(made.plan->frameOrigin), made.loaded.terrain, made.plan->terrain);
    const BriefingContent content = briefingContent(source, optionsIn(style::UnitSystem::Metric));
    const std::size_t legs = content.legs.rows.size();
    QCOMPARE(cell(content.legs, 0, "Leg"), QString("out"));
    QVERIFY(cell(content.legs, 0, "To target").contains("NO GLIDE GUARANTEE"));
    QCOMPARE(cell(content.legs, 0, "Safe\nm MSL"), QString("–"));
    QCOMPARE(cell(content.legs, 0, "Least\nmargin m"), QString("–"));
    QCOMPARE(cell(content.legs, 1, "Leg"), QString("out"));
    QVERIFY(cell(content.legs, 1, "To target").startsWith("the tour, on leg "));
    QCOMPARE(cell(content.legs, 2, "Leg"), QString("1→2"));
    QCOMPARE(cell(content.legs, legs - 1, "Leg"), QString("in"));
    QVERIFY(cell(content.legs, legs - 1, "To target").startsWith("above MTNE 12, from leg "));
    const WayFigures& out = *source.figures.departure;
    const mission::HomePath& path = *made.plan->departure;
    double flown = 0.0;
    for (const mission::DecisionPoint& point : path.points) {
      flown += point.onward.length;
    }
    QVERIFY(std::abs(out.unguarded.length + out.leg.length - flown) < 1e-6);
    QCOMPARE(out.leg.startAltitude, path.points[static_cast<std::size_t>(path.guaranteed)].altitude);
    QVERIFY(out.leg.leastMargin >= 0.0 && source.figures.arrival->leg.leastMargin >= 0.0);
    QVERIFY(!out.diverts.empty());
    QCOMPARE(out.diverts.front().from, 0.0);
    QCOMPARE(out.diverts.back().to, out.leg.length);
    QCOMPARE(cell(content.engineOut, 0, "Leg"), QString("out"));
    QCOMPARE(cell(content.engineOut, content.engineOut.rows.size() - 1, "Leg"), QString("in"));
    QVERIFY(content.assumptions.join(' ').contains("there is NO gliding guarantee on the first"));
    source.report.findings = {{safety::Severity::Note, safety::rule::kHomeGuarantee, "in metres", -1, {}, {}}};
    const BriefingContent feet = briefingContent(source, optionsIn(style::UnitSystem::Aviation));
    QVERIFY(feet.findings.rows.empty());  // it stands in the statement
    QVERIFY2(feet.statement.contains("The same holds on the ways from and to the runway, but for the climb-out: after taking off from MTSW 13"),
             qPrintable(feet.statement));
    const double begins = path.points[static_cast<std::size_t>(path.guaranteed)].altitude;
    QVERIFY(feet.statement.contains(style::Units(style::UnitSystem::Aviation).requiredMsl(begins)));
    QVERIFY(!feet.statement.contains(QRegularExpression("\\d m\\b")));
  }

  void unguardedStretch_isRoundedUp() {
    test::PlanBuilder builder(600.0);
    BriefingSource source = sourceOf(builder.plan());
    mission::Plan plan = *source.plan;
    plan.departure.emplace();
    plan.departure->site = 0;
    plan.departure->guaranteed = 1;
    plan.departure->points.resize(2);
    plan.departure->points[0].onward.length = 413.0;  // 0.2230 NM
    plan.arrival.emplace();
    plan.arrival->site = 0;
    plan.arrival->points.resize(2);
    source.plan = std::make_shared<const mission::Plan>(plan);
    const BriefingContent content = briefingContent(source, optionsIn(style::UnitSystem::Aviation));
    QVERIFY2(factOf(content, "Home").contains(QString("on the first 0.23") + QChar(QChar::Nbsp) + "NM"), qPrintable(factOf(content, "Home")));
  }

  void farFuture_isSaidToBeBeyondTheMagneticModel() {
    const test::PlanBuilder builder(600.0);
    BriefingSource source = sourceOf(builder.plan());
    source.figures = *tourFigures(*source.plan, *source.terrain->grid, std::chrono::year(2035) / 1 / 1, Job());
    QVERIFY(briefingContent(source, optionsIn(style::UnitSystem::Aviation)).assumptions.join(' ').contains("not made for this date"));
  }

  void letters_goOnBehindZ() {
    QCOMPARE(FigureText::letter(0), QString("A"));
    QCOMPARE(FigureText::letter(25), QString("Z"));
    QCOMPARE(FigureText::letter(26), QString("AA"));
    QCOMPARE(FigureText::letter(52), QString("BA"));
  }

  void courses_northIs360_magneticWrapsAround() {
    Track track;
    track.trueCourse = Angle::degrees(1.0);
    track.variation = Angle::degrees(3.4);
    QCOMPARE(FigureText::trueCourse(track), QString("001"));
    QCOMPARE(FigureText::magneticCourse(track), QString("358"));
    QCOMPARE(FigureText::variation(track), QString("3.4° E"));
    track.variation = Angle::degrees(-0.8);
    QCOMPARE(FigureText::magneticCourse(track), QString("002"));
    track.variation.reset();
    QCOMPARE(FigureText::magneticCourse(track), QString("–"));
  }
};

QTEST_APPLESS_MAIN(TestBriefingContent)
#include "tst_briefing_content.moc"
