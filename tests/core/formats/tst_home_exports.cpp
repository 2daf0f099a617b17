// Routes from a home runway over the tour to a home runway, in every format: accepted by the strict checkers, read back to the route, and the
// airports, their runways and the ends of the gliding guarantee told where a format can.
#include "core/formats/aircraft_file.h"
#include "core/formats/exports/export_formats.h"
#include "core/route/build_route.h"
#include "tests/core/formats/export_checks.h"
#include "tests/core/formats/format_samples.h"
#include "tests/support/quick_plan.h"

#include <QRegularExpression>
#include <QTest>

#include <map>

using namespace vp;
using namespace vp::formats;

namespace {

/// A planned mission and its routes by precision.
struct Flight {
  test::QuickPlan made;
  std::map<double, mission::Route> routes;

  const mission::Route& route(double steps) {
    const auto known = routes.find(steps);
    if (known != routes.end()) {
      return known->second;
    }
    if (!ground_) {
      ground_ = route::prepareGround(*made.plan, made.loaded.terrain, Job{}).value();
    }
    route::RouteOptions options;
    options.stepsPerDegree = steps;
    const route::BuiltRoute built = route::buildRoute(*made.plan, &*ground_, options, Job{}).value();
    isSafe_ = isSafe_ && safety::check({built.reflown, *made.loaded.terrain, checksums()}, Job{})->isSafe();
    return routes[steps] = built.route;
  }
  [[nodiscard]] bool isSafe() const { return isSafe_; }

private:
  [[nodiscard]] std::vector<std::string> checksums() const {
    std::vector<std::string> list;
    for (const mission::TerrainReference& file : made.plan->terrain) {
      list.push_back(file.sha256);
    }
    return list;
  }
  std::optional<route::Ground> ground_;
  bool isSafe_ = true;
};

mission::Mission bundled(const char* name, const char* aircraft, const char* takeoff, const char* landing) {
  mission::Mission mission = test::quickMission(std::string(VOLPLANE_SOURCE_DIR "/maps/") + name + ".vpm");
  mission.aircraft = findAircraft(aircraft, ".").value();
  mission.home = mission::HomeBase{takeoff, landing};
  return mission;
}

/// Canberra, on SRTM terrain and the airfields of OurAirports.
mission::Mission canberra(const std::string& data) {
  mission::Mission mission;
  mission.name = "Canberra";
  mission.terrain = {data + "/dem/canberra_S36E149_srtm3.tif"};
  mission.airfields = {{data + "/airports/ourairports_airports.csv.gz", data + "/airports/ourairports_runways.csv.gz"}};
  mission.aircraft = findAircraft("cessna172-elasp", ".").value();
  mission.targets = {{"Tuggeranong", {-35.35, 149.10}, 200.0, mission::HeightReference::AboveGround},
                     {"Williamsdale", {-35.55, 149.15}, 200.0, mission::HeightReference::AboveGround},
                     {"Hall", {-35.25, 149.35}, 200.0, mission::HeightReference::AboveGround}};
  mission.planner.headings = 4;
  mission.planner.step = Length::fromSi(100.0);
  mission.home = mission::HomeBase{"YSCB/17", "YSCB/35"};
  return mission;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

class TestHomeExports : public QObject {
  Q_OBJECT

private slots:
  void everyFormat_withHome_isReadBackToTheRoute_data() {
    QTest::addColumn<QString>("flight");
    QTest::addColumn<QString>("format");
    for (const char* flight : {"mountain", "alpine", "real"}) {
      for (const ExportFormat& format : exportFormats()) {
        QTest::newRow((std::string(flight) + " " + format.name).c_str()) << flight << QString::fromStdString(format.name);
      }
    }
  }

  void everyFormat_withHome_isReadBackToTheRoute() {
    QFETCH(QString, flight);
    QFETCH(QString, format);
    const std::optional<std::string> data = samples::dataFolder();
    if (flight == "real" && !data) {
      QSKIP("the folder with real terrain is not here; set VOLPLANE_DATA to it");
    }
    Flight& flown = flightOf(flight.toStdString(), data.value_or(""));
    const mission::Plan& plan = *flown.made.plan;
    QVERIFY(plan.certificate && plan.departure && plan.arrival);
    const ExportFormat& writer = *findExportFormat(format.toStdString());
    const mission::Route& route = flown.route(writer.stepsPerDegree);
    QVERIFY(flown.isSafe());
    const auto bytes = writer.write({plan, &route});
    QVERIFY(bytes);
    const checks::Checked checked = checks::check(writer.name, *bytes);
    QVERIFY2(checked.fault.empty() || (writer.name == "fpl" && checked.fault == "at most 99 points"), checked.fault.c_str());
    if (writer.name == "kmz" || writer.name == "gpkg" || !checked.fault.empty()) {
      return;
    }
    std::vector<const mission::RouteWaypoint*> wanted;
    for (const mission::RouteWaypoint& waypoint : route.waypoints) {
      if (waypoint.site < 0 || (writer.name != "plan" && writer.name != "cup")) {  // whose runways stand elsewhere
        wanted.push_back(&waypoint);
      }
    }
    QCOMPARE(checked.points.size(), wanted.size());
    const double within = 0.51 / writer.stepsPerDegree * 1.01 + 1e-9;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      QVERIFY(std::abs(checked.points[i].latitude - wanted[i]->place.latitude_deg) < within);
      QVERIFY(std::abs(checked.points[i].longitude - wanted[i]->place.longitude_deg) < within);
      QVERIFY(std::abs(checked.points[i].feet - wanted[i]->altitude / kMetresPerFoot) < 0.02);
    }
  }

  void airportsAndRunways_standWhereAFormatHasThem() {
    Flight& flown = flightOf("mountain", "");
    const mission::Plan& plan = *flown.made.plan;
    const auto text = [&](const char* name) {
      const ExportFormat& format = *findExportFormat(name);
      return *format.write({plan, &flown.route(format.stepsPerDegree)});
    };
    VP_CONTAINS(text("fms"),
                {"\nADEP MTSW\nDEPRWY RW13\nADES MTNE\nDESRWY RW12\n", "\n1 MTSW ADEP ", "\n1 MTNE ADES ", " SAFE_BEGIN ", " SAFE_END "});
    VP_CONTAINS(text("fms3"), {"\n1 MTSW ", "\n1 MTNE "});
    VP_CONTAINS(text("fpl"), {"<type>AIRPORT</type>", "<waypoint-identifier>MTNE<", "FT BEGIN<", "FT END<", "FT RW13<", "FT RW12<"});
    VP_CONTAINS(text("lnmpln"), {"<Start>13</Start>", "<Ident>MTNE</Ident>", "gliding guarantee begins", "gliding guarantee ends"});
    VP_CONTAINS(text("pln"), {"<DepartureID>MTSW<", "<DestinationID>MTNE<", "<RunwayNumberFP>13<", "The gliding guarantee begins"});
    VP_CONTAINS(text("fgfp"), {"<departure>", ">MTSW<", ">13<", "<destination>", ">MTNE<", ">12<"});
    VP_CONTAINS(text("cup"), {"\"MTSW/13\",", ",\"MTNE/12\"\r\nOptions", "gliding guarantee begins"});
    VP_CONTAINS(text("gpx"), {"The gliding guarantee begins", "gliding guarantee ends", "<type>runway</type>"});
    VP_CONTAINS(text("kml"), {"The gliding guarantee begins", "SAFE-END"});
    VP_CONTAINS(text("geojson"), {"\"kind\": \"departure\"", "\"guaranteed\": false", "\"kind\": \"arrival\"", "gliding guarantee begins"});
    VP_CONTAINS(text("csv"), {"\r\nrunway,1,MTSW/13,", "departurePoint,1,", "arrivalPoint,1,", "gliding guarantee ends"});
    VP_CONTAINS(text("wpt"), {"SAFEBE,", "SAFEEN,"});
    const std::string qgc = text("plan");
    const mission::RouteWaypoint& threshold = flown.route(1e6).waypoints.front();
    QVERIFY(contains(qgc, "plannedHomePosition"));
    QVERIFY(contains(qgc.substr(qgc.find("plannedHomePosition"), 200), QByteArray::number(threshold.place.latitude_deg, 'f', 6).toStdString()));
  }

  void brokenEnd_isRefused_data() {
    QTest::addColumn<QString>("format");
    QTest::addColumn<QString>("pattern");
    QTest::addColumn<QString>("replacement");
    const auto row = [](const char* name, const char* format, const char* pattern, const char* replacement) {
      QTest::newRow(name) << format << pattern << replacement;
    };
    row("runway of one digit", "fms", "DEPRWY RW13", "DEPRWY RW3");
    row("no runway", "fms", "DESRWY RW12\n", "");
    row("airport as a place", "fms", "\n1 MTSW ADEP", "\n28 MTSW ADEP");
    row("another airport in the last row", "fms", "1 MTNE ADES", "1 MTSW ADES");
    row("airport on the way", "fms3", "28 SAFE_BEGIN ", "1 SAFEB ");
    row("small letters of an airport", "fpl", "<identifier>MTSW<", "<identifier>Mtsw<");
    row("route point of another type", "fpl", "<waypoint-identifier>MTNE</waypoint-identifier>\n *<waypoint-type>AIRPORT",
        "<waypoint-identifier>MTNE</waypoint-identifier>\n<waypoint-type>USER WAYPOINT");
    row("departure of another name", "pln", "<DepartureID>MTSW<", "<DepartureID>MTNE<");
    row("airport on the way", "pln", "<ATCWaypointType>User", "<ATCWaypointType>Airport");
    row("runway without a number", "lnmpln", "<Start>13<", "<Start>x<");
    row("start of another kind", "lnmpln", "<Type>Runway<", "<Type>Grass<");
    row("no airport", "fgfp", "<airport type=\"string\">MTSW<", "<airport type=\"string\"><");
    row("takeoff from no row", "cup", "\",\"MTSW/13\",\"RWY-END", "\",\"MTSW/99\",\"RWY-END");
  }

  void brokenEnd_isRefused() {
    QFETCH(QString, format);
    QFETCH(QString, pattern);
    QFETCH(QString, replacement);
    Flight& flown = flightOf("mountain", "");
    const ExportFormat& writer = *findExportFormat(format.toStdString());
    QString text = QString::fromStdString(*writer.write({*flown.made.plan, &flown.route(writer.stepsPerDegree)}));
    if (format == "pln" && !text.startsWith(QChar(0xFEFF))) {
      text.prepend(QChar(0xFEFF));  // which reading UTF-8 takes away
    }
    QVERIFY(checks::check(writer.name, text.toStdString()).fault.empty());
    const QString original = text;
    text.replace(QRegularExpression(pattern), replacement);
    QVERIFY2(text != original, "the mutation changes nothing");
    QVERIFY(!checks::check(writer.name, text.toStdString()).fault.empty());
  }

  void unknownAirport_isAPlace() {
    Flight& flown = flightOf("mountain", "");
    mission::Plan plan = *flown.made.plan;
    for (mission::SiteInFrame& site : plan.sites) {
      site.site.airportIdent = "CH-0023";
    }
    const auto fms = findExportFormat("fms")->write({plan, &flown.route(1e6)});
    QVERIFY(checks::check("fms", *fms).fault.empty());
    VP_CONTAINS(*fms, {"\nDEP MTSW_13\n", "\n28 MTSW_13 DEP "});
    const auto fgfp = findExportFormat("fgfp")->write({plan, &flown.route(1e6)});
    QVERIFY(!contains(*fgfp, "<departure>"));
  }

  void twoRunwaysOfOneAirport_areToldApartByGarmin() {
    Flight& flown = flightOf("mountain", "");
    mission::Plan plan = *flown.made.plan;
    for (mission::SiteInFrame& site : plan.sites) {
      site.site.airportIdent = "MTSW";
    }
    const mission::Route& route = flown.route(1e6);
    const auto fpl = findExportFormat("fpl")->write({plan, &route});
    const checks::Checked checked = checks::check("fpl", *fpl);
    QVERIFY2(checked.fault.empty(), checked.fault.c_str());
    QCOMPARE(checked.points.size(), route.waypoints.size());
    QVERIFY(std::abs(checked.points.front().latitude - route.waypoints.front().place.latitude_deg) < 1e-6);
    QVERIFY(std::abs(checked.points.back().latitude - route.waypoints.back().place.latitude_deg) < 1e-6);
    QVERIFY(std::abs(checked.points.back().longitude - route.waypoints.back().place.longitude_deg) < 1e-6);
    QCOMPARE(checked.points.back().name, std::string("MTNE12"));
    VP_CONTAINS(*fpl, {"<identifier>MTSW</identifier>", "FT RW13<", "FT RW12<"});
  }

  void longFlight_inParts_hasItsAirportsAtItsEnds() {
    Flight& flown = flightOf("alpine", "");
    const mission::Plan& plan = *flown.made.plan;
    const mission::Route& route = flown.route(1e6);
    const std::vector<RoutePart> parts = partsOf(route, 30);
    QVERIFY(parts.size() >= 3);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const auto fms =
          findExportFormat("fms")->write({plan, &route, parts[i].first, parts[i].count, static_cast<int>(i) + 1, static_cast<int>(parts.size())});
      const checks::Checked checked = checks::check("fms", *fms);
      QVERIFY2(checked.fault.empty(), checked.fault.c_str());
      QCOMPARE(contains(*fms, "ADEP "), i == 0);
      QCOMPARE(contains(*fms, "ADES "), i + 1 == parts.size());
    }
    QCOMPARE(parts.back().first + parts.back().count, route.waypoints.size());
  }

private:
  Flight& flightOf(const std::string& name, const std::string& data) {
    Flight& flight = flights_[name];
    if (!flight.made.plan) {
      flight.made = test::quickPlan(name == "mountain" ? bundled("mountain-n5", "cessna172-elasp", "MTSW/13", "MTNE/12")
                                    : name == "alpine" ? bundled("alpine-n10", "cessna172-operational", "VA01/21", "VA02/08")
                                                       : canberra(data));
    }
    return flight;
  }
  std::map<std::string, Flight> flights_;
};

QTEST_APPLESS_MAIN(TestHomeExports)
#include "tst_home_exports.moc"
