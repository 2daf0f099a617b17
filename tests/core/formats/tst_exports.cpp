// All export formats: the strict checkers accept what is written and refuse files in which one rule is broken; what is read back is
// the route within the precision of the format.
#include "core/formats/exports/export_formats.h"
#include "core/formats/exports/writers.h"
#include "core/formats/exports/xml_writer.h"
#include "core/route/build_route.h"
#include "tests/core/formats/export_checks.h"
#include "tests/core/formats/format_samples.h"

#include <QRegularExpression>
#include <QXmlStreamReader>

#include <map>
#include <random>
#include <set>

using namespace vp;
using namespace vp::formats;

namespace {

mission::Route routeOf(const mission::Plan& plan, double steps) {
  route::RouteOptions options;
  options.stepsPerDegree = steps;
  const auto built = route::buildRoute(plan, nullptr, options, Job{});
  if (!built) {
    throw std::runtime_error(built.error().what);
  }
  return built->route;
}

struct Mutation {
  const char* format;
  const char* what;
  const char* pattern;
  const char* replacement;
};

/// A file without names is told by the checkers that can read it.
bool hasPoints(const std::string& format) {
  return format != "kmz" && format != "gpkg";
}

bool isClosed(const std::string& format) {
  return format != "wpt" && format != "kml" && format != "geojson";
}

bool holdsFeet(const std::string& format) {
  return hasPoints(format);
}

}  // namespace

class TestExports : public QObject {
  Q_OBJECT
private slots:
  void everyFormat_isAcceptedAndReadBackToTheRoute_data() {
    QTest::addColumn<QString>("format");
    for (const ExportFormat& format : exportFormats()) {
      QTest::newRow(format.name.c_str()) << QString::fromStdString(format.name);
    }
  }

  void everyFormat_isAcceptedAndReadBackToTheRoute() {
    QFETCH(QString, format);
    const ExportFormat& writer = *findExportFormat(format.toStdString());
    for (const bool isSouthWest : {false, true}) {
      mission::Plan plan = samples::sampleTour();
      if (isSouthWest) {
        plan.frameOrigin = {-33.999999, -70.000001};
      }
      const mission::Route route = routeOf(plan, writer.stepsPerDegree);
      const auto bytes = writer.write({plan, &route});
      QVERIFY(bytes);
      const checks::Checked checked = checks::check(writer.name, *bytes);
      QVERIFY2(checked.fault.empty(), checked.fault.c_str());
      if (!hasPoints(writer.name)) {
        continue;
      }
      QCOMPARE(checked.points.size(), route.waypoints.size() + (isClosed(writer.name) ? 1 : 0));
      const double within = 0.51 / writer.stepsPerDegree * 1.01 + 1e-9;
      for (std::size_t i = 0; i < checked.points.size(); ++i) {
        const mission::RouteWaypoint& wanted = route.waypoints[i % route.waypoints.size()];
        QVERIFY(std::abs(checked.points[i].latitude - wanted.place.latitude_deg) < within);
        QVERIFY(std::abs(checked.points[i].longitude - wanted.place.longitude_deg) < within);
        QVERIFY(!holdsFeet(writer.name) || std::abs(checked.points[i].feet - wanted.altitude / kMetresPerFoot) < 0.02);
      }
    }
  }

  void unverifiedRoute_saysSoInItsFile_data() { everyFormat_isAcceptedAndReadBackToTheRoute_data(); }

  void unverifiedRoute_saysSoInItsFile() {
    QFETCH(QString, format);
    const ExportFormat& writer = *findExportFormat(format.toStdString());
    const bool isPacked = format == "kmz" || format == "gpkg";
    for (const char* name : {"", "A mission whose name is longer than any format takes, by far"}) {
      mission::Plan plan = samples::sampleTour();
      plan.mission.name = name;
      const mission::Route verified = routeOf(plan, writer.stepsPerDegree);
      const mission::Route route = markedUnverified(verified);
      const auto marked = writer.write({plan, &route});
      const auto plain = writer.write({plan, &verified});
      QVERIFY(marked && plain);
      const checks::Checked checked = checks::check(writer.name, *marked);
      QVERIFY2(checked.fault.empty(), checked.fault.c_str());
      const QRegularExpression mark("UNVERIFIED[ -]+DO NOT FLY|DO NOT FLY ALT [0-9]+FT");
      const auto count = [&](const std::string& bytes) { return QString::fromStdString(bytes).count(mark); };
      QCOMPARE(count(*plain), 0);
      QVERIFY(isPacked || (count(*marked) > 0) == writer.holdsMark);
      QVERIFY(!writer.holdsMark || *marked != *plain);
    }
  }

  void unverifiedTasks_sayItEachAndKeepTheirNumber() {
    mission::Plan plan = samples::sampleTour();
    plan.mission.name = "A mission whose name is longer than forty characters";
    mission::Route route;
    for (int i = 0; i < 60; ++i) {
      route.waypoints.push_back({"W" + std::to_string(i), {46.0, 9.0 + i * 1e-3}, 304.8, -1, 100.0, 0.0, i * 76.0, -1, ""});
    }
    route = markedUnverified(std::move(route));
    const auto bytes = findExportFormat("cup")->write({plan, &route});
    QVERIFY(bytes);
    for (const char* title :
         {"UNVERIFIED - DO NOT FLY  A missio 1 of 3", "UNVERIFIED - DO NOT FLY  A missio 2 of 3", "UNVERIFIED - DO NOT FLY  A missio 3 of 3"}) {
      QVERIFY2(bytes->find(title) != std::string::npos, bytes->c_str());
    }
    QVERIFY(bytes->find("fly at 1000 ft MSL UNVERIFIED  DO NOT FLY") != std::string::npos);
  }

  void brokenRule_isRefused_data() {
    QTest::addColumn<QString>("format");
    QTest::addColumn<QString>("pattern");
    QTest::addColumn<QString>("replacement");
    static const std::vector<Mutation> list{
        {"fms", "windows line ends mixed in", "\n28", "\r\n28"},
        {"fms", "no cycle", "CYCLE 1710\n", ""},
        {"fms", "wrong number of rows", "NUMENR [0-9]+", "NUMENR 3"},
        {"fms", "space in an ident", "28 TARGET_1 DEP", "28 TARGET 1 DEP"},
        {"fms", "departure of another name", "DEP TARGET_1\n", "DEP TARGET_2\n"},
        {"fms", "latitude out of range", " 46\\.", " 96."},
        {"fms", "five decimals", "(\\.[0-9]{5})[0-9]\n", "\\1\n"},
        {"fms3", "wrong count", "\n1\n[0-9]+\n", "\n1\n1\n"},
        {"fms3", "row of the later version", "28 TARGET_1 ", "28 TARGET_1 DRCT "},
        {"fpl", "a place twice in the table", "<identifier>V[0-9]+</identifier>", "<identifier>TARGET</identifier>"},
        {"fpl", "small letters", "<identifier>TARGET<", "<identifier>Target<"},
        {"fpl", "country of a user waypoint", "<country-code></country-code>", "<country-code>LS</country-code>"},
        {"fpl", "comment with a point", "FT</comment>", "FT.</comment>"},
        {"fpl", "route point that is not in the table", "<waypoint-identifier>TARGET<", "<waypoint-identifier>TARGXX<"},
        {"fpl", "index 99", "<flight-plan-index>1<", "<flight-plan-index>99<"},
        {"fpl", "comment before longitude", "(<lon>[^\n]*\n)( *<comment>[^\n]*\n)", "\\2\\1"},
        {"fpl", "all on one line", "\n", ""},
        {"wpt", "seven letters", "^TARGET,", "TARGETS,"},
        {"wpt", "six decimals", "(\\.[0-9]{6})00\n", "\\1\n"},
        {"wpt", "an ident twice", "\nV[0-9]+,", "\nTARGET,"},
        {"pln", "no byte order mark", "^\uFEFF", ""},
        {"pln", "line ends of one character", "\r\n", "\n"},
        {"pln", "sixty seconds", "' [0-9]{1,2}\\.[0-9]{2}\"", "' 60.00\""},
        {"pln", "no ident", "<ICAOIdent>[^<]*</ICAOIdent>", "<ICAOIdent></ICAOIdent>"},
        {"pln", "short altitude", ",\\+00", ",+"},
        {"pln", "cruising altitude of nothing", "<CruisingAlt>[0-9]+", "<CruisingAlt>0"},
        {"lnmpln", "not pretty-printed", "\n *", ""},
        {"lnmpln", "ident before name", "(<Name>[^\n]*\n)( *<Ident>[^\n]*\n)", "\\2\\1"},
        {"lnmpln", "unknown type", "<Type>USER<", "<Type>PLACE<"},
        {"lnmpln", "no altitude", " Alt=\"[0-9.]*\"", ""},
        {"plan", "no fence", "\"geoFence\"", "\"fence\""},
        {"plan", "fraction of speed", "\"cruiseSpeed\": 33", "\"cruiseSpeed\": 33.4"},
        {"plan", "relative altitude", "\"AltitudeMode\": 2", "\"AltitudeMode\": 1"},
        {"plan", "two of three altitude members", "\"AMSLAltAboveTerrain\": null,", ""},
        {"plan", "six parameters", "\"params\": \\[0, ", "\"params\": ["},
        {"plan", "numbers from 0", "\"doJumpId\": 1,", "\"doJumpId\": 0,"},
        {"cup", "two decimals of minutes", "([0-9]{4}\\.[0-9]{2})[0-9]N", "\\1N"},
        {"cup", "sixty minutes", "4[0-9]{3}\\.", "4660."},
        {"cup", "altitude without unit", "ft,1,", ",1,"},
        {"cup", "comma in a name", "\"Target 1 ", "\"Target, 1 "},
        {"cup", "task point of no row", ",\"Target 2 ", ",\"Target 9 "},
        {"cup", "header of no year", "^name,code", "name,ident"},
        {"gpx", "name before elevation", "(<ele>[^\n]*\n)( *<name>[^\n]*\n)", "\\2\\1"},
        {"gpx", "latitude out of range", "lat=\"46", "lat=\"96"},
        {"gpx", "no track", "(?s)<trk>.*</trk>", ""},
        {"gpx", "version of no schema", "version=\"1.1\"", "version=\"1.0\""},
        {"kml", "relative altitudes", "<altitudeMode>absolute<", "<altitudeMode>relativeToGround<"},
        {"kml", "curtain that follows the ground", "<tessellate>0<", "<tessellate>1<"},
        {"kml", "style of no name", "#tour", "#turn"},
        {"kml", "longitude out of range", "<coordinates>[0-9.]+,", "<coordinates>999,"},
        {"kml", "not closed", "</Document>", ""},
        {"kmz", "not an archive", "^PK", "KP"},
        {"fgfp", "gap in the numbers", "n=\"3\"", "n=\"4\""},
        {"fgfp", "something else in the route", "<route>", "<route><name>x</name>"},
        {"fgfp", "no ident", "<ident type=\"string\">[^<]*<", "<ident type=\"string\"><"},
        {"csv", "comma in a name", "Target 1", "Target, 1"},
        {"csv", "number left out", "\nwaypoint,2,", "\nwaypoint,3,"},
        {"geojson", "no height", "\"alt_msl_m\"", "\"height\""},
        {"geojson", "no JSON", "\\]\\}\\}", "]}"},
        {"gpkg", "another database", "GPKG", "GPKX"},
    };
    for (const Mutation& mutation : list) {
      QTest::newRow((std::string(mutation.format) + ": " + mutation.what).c_str())
          << mutation.format << QString::fromUtf8(mutation.pattern) << QString::fromUtf8(mutation.replacement);
    }
  }

  void brokenRule_isRefused() {
    QFETCH(QString, format);
    QFETCH(QString, pattern);
    QFETCH(QString, replacement);
    const ExportFormat& writer = *findExportFormat(format.toStdString());
    const mission::Plan plan = samples::sampleTour();
    const mission::Route route = routeOf(plan, writer.stepsPerDegree);
    const auto bytes = writer.write({plan, &route});
    QVERIFY(bytes);
    const bool isBinary = !hasPoints(writer.name);
    const QString text = isBinary ? QString::fromLatin1(bytes->data(), static_cast<qsizetype>(bytes->size()))
                                  : QString::fromUtf8(bytes->data(), static_cast<qsizetype>(bytes->size()));
    const QString original = format == "pln" && !text.startsWith(QChar(0xFEFF)) ? QChar(0xFEFF) + text : text;
    QString broken = original;
    broken.replace(QRegularExpression(pattern), replacement);
    QVERIFY2(broken != original, "the mutation changes nothing");
    const QByteArray raw = isBinary ? broken.toLatin1() : broken.toUtf8();
    QVERIFY(!checks::check(writer.name, raw.toStdString()).fault.empty());
  }

  void formats_haveTheNamesOfTheCommandLine() {
    std::vector<std::string> names;
    for (const ExportFormat& format : exportFormats()) {
      names.push_back(format.name);
      QVERIFY(!format.what.empty() && !format.extension.empty());
    }
    QCOMPARE(names, (std::vector<std::string>{"fms", "fms3", "fpl", "wpt", "pln", "lnmpln", "plan", "cup", "gpx", "kml", "kmz", "fgfp", "geojson",
                                              "gpkg", "csv"}));
  }

  void route_coversTheTourAndIsNeverBelowIt() {
    std::mt19937_64 random(7);
    qInfo("seed 7");
    std::uniform_real_distribution<double> side(800.0, 6000.0);
    std::uniform_real_distribution<double> radius(114.0, 400.0);
    for (int i = 0; i < 40; ++i) {
      const mission::Plan plan = samples::sampleTour(side(random), radius(random));
      const auto built = route::buildRoute(plan, nullptr, {}, Job{});
      QVERIFY(built);
      QVERIFY2(built->route.lateral < 3.0 && built->route.visit < 0.5, std::to_string(built->route.lateral).c_str());
      for (const mission::DecisionPoint& point : plan.tour) {
        double nearest = 1e9;
        double above = 0.0;
        for (const mission::DecisionPoint& flown : built->reflown.tour) {
          const double distance = geo::distance(flown.pose.point(), point.pose.point());
          if (distance < nearest) {
            nearest = distance;
            above = flown.altitude - point.altitude;
          }
        }
        QVERIFY(nearest < 60.0);
        QVERIFY(above > -0.3 * nearest - 1e-6);
      }
    }
  }

  void longRoute_isSplitWithoutLoss() {
    mission::Route route;
    for (int i = 0; i < 230; ++i) {
      route.waypoints.push_back({"W" + std::to_string(i), {46.0, 9.0 + i * 1e-3}, 304.8, i % 7 == 0 ? i / 7 : -1, 100.0, 0.0, i * 76.0, -1, ""});
    }
    const std::vector<RoutePart> parts = partsOf(route, 99);
    QVERIFY(parts.size() >= 3);
    std::size_t next = 0;
    for (const RoutePart& part : parts) {
      QCOMPARE(part.first, next);
      QVERIFY(part.count <= 99 && part.count >= 2);
      next = part.first + part.count - 1;
    }
    QCOMPARE(next, route.waypoints.size());
    QCOMPARE(partsOf(route, 0).size(), std::size_t{1});
    const mission::Plan plan = samples::sampleTour();
    for (const char* name : {"fms", "fpl"}) {
      std::size_t points = 0;
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto bytes =
            findExportFormat(name)->write({plan, &route, parts[i].first, parts[i].count, static_cast<int>(i) + 1, static_cast<int>(parts.size())});
        const checks::Checked checked = checks::check(name, *bytes);
        QVERIFY2(checked.fault.empty(), checked.fault.c_str());
        points += checked.points.size() - 1;
      }
      QCOMPARE(points, route.waypoints.size());
    }
  }

  void names_becomeUniqueIdents() {
    mission::Plan plan = samples::sampleTour();
    const char* const names[] = {"V001", "Fl\u00FCela Pass north", "Fl\u00FCela Pass south", "\u6771\u4EAC <&> \"x\", y\nz"};
    for (std::size_t i = 0; i < 4; ++i) {
      plan.targets[i].target.name = names[i];
    }
    for (const ExportFormat& format : exportFormats()) {
      const mission::Route route = routeOf(plan, format.stepsPerDegree);
      const auto bytes = format.write({plan, &route});
      QVERIFY(bytes);
      if (format.name != "csv") {  // whose checker takes no quoted fields
        const checks::Checked checked = checks::check(format.name, *bytes);
        QVERIFY2(checked.fault.empty(), (format.name + ": " + checked.fault).c_str());
        std::set<std::string> seen;
        for (std::size_t i = 0; i + 1 < checked.points.size() && format.name != "plan"; ++i) {
          QVERIFY2(seen.insert(checked.points[i].name).second, checked.points[i].name.c_str());
        }
      }
    }
    const mission::Route route = routeOf(plan, 1e6);
    const auto points = pointsOf({plan, &route});
    const std::vector<std::string> idents = identsOf({plan, &route}, points, {10, false, "_", "_"});
    const std::set<std::string> all(idents.begin(), idents.end());
    QVERIFY(all.contains("V001") && all.contains("FLUELA_PAS") && all.contains("FLUELA_PA2"));
  }

  void seconds_neverReadSixty() {
    mission::Plan plan = samples::sampleTour();
    mission::Route route = routeOf(plan, 360000.0);
    for (const double degrees : {46.0 - 1e-9, 9.0 + 59.9999999 / 3600.0, 0.0, -1e-9, 89.99999999, -0.99999999}) {
      route.waypoints[1].place = {degrees, degrees};
      for (const char* name : {"pln", "cup"}) {
        const auto bytes = findExportFormat(name)->write({plan, &route});
        const checks::Checked checked = checks::check(name, *bytes);
        QVERIFY2(checked.fault.empty(), checked.fault.c_str());
        QVERIFY(std::abs(checked.points[1].latitude - degrees) < 1e-5);
      }
    }
  }

  void xmlText_isEscapedAndClean() {
    QCOMPARE(escapedXml("a<b>&\"c\""), std::string("a&lt;b&gt;&amp;&quot;c&quot;"));
    QCOMPARE(escapedXml(std::string_view("\x01\xFF\xC3\xA9\xED\xA0\x80", 7)),
             std::string("\xEF\xBF\xBD\xEF\xBF\xBD\xC3\xA9\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD"));
    std::mt19937_64 random(11);
    for (int i = 0; i < 10000; ++i) {
      std::string text(random() % 12, ' ');
      for (char& c : text) {
        c = static_cast<char>(random());
      }
      QXmlStreamReader xml(QByteArray::fromStdString("<a>" + escapedXml(text) + "</a>"));
      while (!xml.atEnd()) {
        xml.readNext();
      }
      QVERIFY(!xml.hasError());
    }
  }

  void planWithoutTour_isRefused() {
    mission::Plan plan = samples::sampleTour();
    plan.tour.clear();
    const auto built = route::buildRoute(plan, nullptr, {}, Job{});
    QVERIFY(!built);
    VP_CONTAINS(built.error().what, {"no tour to export", "at least one target"});
  }
};

QTEST_APPLESS_MAIN(TestExports)
#include "tst_exports.moc"
