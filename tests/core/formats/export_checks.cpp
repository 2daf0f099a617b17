#include "tests/core/formats/export_checks.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QSet>
#include <QStringList>
#include <QXmlStreamReader>

#include <functional>
#include <map>

namespace vp::formats::checks {
namespace {

constexpr double kFoot = 0.3048;

struct Broken {
  std::string rule;
};

void demand(bool holds, const QString& rule) {
  if (!holds) {
    throw Broken{rule.toStdString()};
  }
}

bool matches(const QString& text, const char* pattern) {
  return QRegularExpression(QStringLiteral("^(?:%1)$").arg(QLatin1String(pattern))).match(text).hasMatch();
}

struct Node {
  QString name;
  QMap<QString, QString> attributes;
  QString text;
  QList<Node> children;

  [[nodiscard]] QStringList childNames() const {
    QStringList names;
    for (const Node& child : children) {
      names.append(child.name);
    }
    return names;
  }
  [[nodiscard]] const Node& child(const QString& wanted) const {
    for (const Node& c : children) {
      if (c.name == wanted) {
        return c;
      }
    }
    throw Broken{"missing element " + wanted.toStdString() + " in " + name.toStdString()};
  }
};

Node readNode(QXmlStreamReader& xml) {
  Node node;
  node.name = xml.qualifiedName().toString();
  for (const QXmlStreamAttribute& attribute : xml.attributes()) {
    node.attributes.insert(attribute.qualifiedName().toString(), attribute.value().toString());
  }
  while (!xml.atEnd()) {
    switch (xml.readNext()) {
      case QXmlStreamReader::StartElement:
        node.children.append(readNode(xml));
        break;
      case QXmlStreamReader::Characters:
        node.text += xml.text();
        break;
      case QXmlStreamReader::EndElement:
        return node;
      default:
        break;
    }
  }
  return node;
}

Node parseXml(const std::string& bytes) {
  QXmlStreamReader xml(QByteArray::fromStdString(bytes));
  xml.setNamespaceProcessing(false);
  Node root;
  if (xml.readNextStartElement()) {
    root = readNode(xml);
  }
  while (!xml.atEnd()) {
    xml.readNext();
  }
  demand(!xml.hasError(), "well-formed XML");
  return root;
}

double degrees(const QString& text, double most, const char* pattern = "-?[0-9]{1,3}\\.[0-9]{6}") {
  demand(matches(text, pattern), "degrees as a decimal number: " + text);
  demand(std::abs(text.toDouble()) <= most, "degrees in range: " + text);
  return text.toDouble();
}

QStringList lines(const std::string& bytes, const QString& end) {
  QStringList list = QString::fromStdString(bytes).split(end);
  demand(list.takeLast().isEmpty(), "a line end at the end");
  return list;
}

std::vector<ReadPoint> fms(const std::string& bytes) {
  demand(bytes.find('\r') == std::string::npos, "one kind of line end");
  const QStringList rows = lines(bytes, "\n");
  demand(rows.size() >= 8 && rows[0] == "I", "I in line 1");
  demand(rows[1] == "1100 Version", "version in line 2");
  demand(matches(rows[2], "CYCLE [0-9]{4}"), "cycle of four digits in line 3");
  qsizetype at = 3;
  const auto readEnd = [&](const QString& kind) {  // an airport with its runway, or a place
    const QString row = rows.value(at++);
    if (row.startsWith('A')) {
      demand(matches(row, qPrintable("A" + kind + " [A-Z0-9]{2,8}")), "airport: " + row);
      demand(matches(rows.value(at), qPrintable(kind + "RWY RW[0-9]{2}[LCR]?")), "runway of two digits: " + rows.value(at));
      ++at;
    } else {
      demand(matches(row, qPrintable(kind + " [A-Za-z0-9_+.-]+")), "end of the route: " + row);
    }
    return row;
  };
  const QString departure = readEnd("DEP");
  const QString destination = readEnd("DES");
  demand(rows.value(at) == QStringLiteral("NUMENR %1").arg(rows.size() - at - 1), "number of rows");
  const qsizetype first = at + 1;
  std::vector<ReadPoint> points;
  for (qsizetype i = first; i < rows.size(); ++i) {
    const QStringList fields = rows[i].split(' ');
    const QString end = i == first ? departure : i + 1 == rows.size() ? destination : QString();
    demand(fields.size() == 6, "six fields: " + rows[i]);
    demand(fields[0] == (end.startsWith('A') ? "1" : "28"), "type 1 of airports, 28 of places: " + rows[i]);
    demand(matches(fields[1], "[A-Za-z0-9_+.-]{1,10}"), "ident: " + fields[1]);
    demand(fields[2] == (end.isEmpty() ? "DRCT" : end.section(' ', 0, 0)), "via: " + fields[2]);
    demand(end.isEmpty() || fields[1] == end.section(' ', 1), "ends are the first and last rows");
    demand(matches(fields[3], "-?[0-9]+\\.[0-9]{6}"), "altitude: " + fields[3]);
    points.push_back({fields[1].toStdString(), degrees(fields[4], 90), degrees(fields[5], 180), fields[3].toDouble()});
  }
  return points;
}

std::vector<ReadPoint> fms3(const std::string& bytes) {
  const QStringList rows = lines(bytes, "\n");
  demand(rows.size() >= 6 && rows[0] == "I" && rows[1] == "3 version" && rows[2] == "1", "head of version 3");
  demand(rows[3] == QString::number(rows.size() - 5), "number of rows less one");
  std::vector<ReadPoint> points;
  for (qsizetype i = 4; i < rows.size(); ++i) {
    const QStringList fields = rows[i].split(' ');
    const bool isEnd = i == 4 || i + 1 == rows.size();
    demand(fields.size() == 5 && (fields[0] == "28" || (isEnd && fields[0] == "1" && matches(fields[1], "[A-Z0-9]{2,8}"))) &&
               matches(fields[1], "[A-Za-z0-9_+.-]{1,10}"),
           "five fields: " + rows[i]);
    demand(matches(fields[2], "-?[0-9]+\\.[0-9]{6}"), "altitude: " + fields[2]);
    points.push_back({fields[1].toStdString(), degrees(fields[3], 90), degrees(fields[4], 180), fields[2].toDouble()});
  }
  return points;
}

std::vector<ReadPoint> fpl(const std::string& bytes) {
  const QStringList head = QString::fromStdString(bytes).split('\n');
  demand(head.value(0).startsWith("<?xml version") && head.value(1).startsWith("<flight-plan"), "pretty-printed head");
  const Node root = parseXml(bytes);
  demand(root.attributes["xmlns"] == "http://www8.garmin.com/xmlschemas/FlightPlan/v1", "namespace");
  demand(root.childNames() == QStringList({"created", "waypoint-table", "route"}), "order in flight-plan");
  demand(matches(root.child("created").text, "[0-9]{4}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}Z"), "time of creation");
  std::map<QString, ReadPoint> table;
  for (const Node& waypoint : root.child("waypoint-table").children) {
    demand(waypoint.childNames() == QStringList({"identifier", "type", "country-code", "lat", "lon", "comment", "elevation"}), "order in waypoint");
    const QString ident = waypoint.child("identifier").text;
    const QString type = waypoint.child("type").text;
    demand(matches(ident, type == "AIRPORT" ? "[A-Z0-9]{2,8}" : "[A-Z0-9]{1,6}"), "identifier: " + ident);
    demand((type == "USER WAYPOINT" || type == "AIRPORT") && waypoint.child("country-code").text.isEmpty(), "waypoint without country");
    const QString comment = waypoint.child("comment").text;
    demand(matches(comment, "[A-Z0-9 /]{1,17}"), "comment: " + comment);
    const QRegularExpressionMatch altitude = QRegularExpression("ALT ([0-9]+)FT").match(comment);
    demand(altitude.hasMatch(), "altitude in the comment");
    const QString key = type + "/" + ident;
    demand(!table.contains(key), "identifier once in the table: " + ident);
    table[key] = {ident.toStdString(), degrees(waypoint.child("lat").text, 90), degrees(waypoint.child("lon").text, 180),
                  altitude.captured(1).toDouble()};
  }
  const Node& route = root.child("route");
  demand(route.childNames().mid(0, 2) == QStringList({"route-name", "flight-plan-index"}), "order in route");
  demand(matches(route.child("route-name").text, "[A-Z0-9 /]{1,25}"), "route name");
  const int index = route.child("flight-plan-index").text.toInt();
  demand(index >= 1 && index <= 98, "index of the flight plan");
  std::vector<ReadPoint> points;
  for (const Node& point : route.children.mid(2)) {
    demand(point.name == "route-point" && point.childNames() == QStringList({"waypoint-identifier", "waypoint-type", "waypoint-country-code"}),
           "order in route-point");
    const QString key = point.child("waypoint-type").text + "/" + point.child("waypoint-identifier").text;
    demand(table.contains(key), "route point of the table");
    points.push_back(table[key]);
  }
  demand(points.size() <= 99, "at most 99 points");
  return points;
}

std::vector<ReadPoint> wpt(const std::string& bytes) {
  std::vector<ReadPoint> points;
  QSet<QString> idents;
  for (const QString& row : lines(bytes, "\n")) {
    const QStringList fields = row.split(',');
    demand(fields.size() == 4 && matches(fields[0], "[A-Z0-9]{1,6}"), "ident and four fields: " + row);
    demand(!idents.contains(fields[0]), "ident once: " + row);
    idents.insert(fields[0]);
    demand(matches(fields[1], "[A-Z0-9 /]{1,25}"), "name: " + row);
    const QRegularExpressionMatch altitude = QRegularExpression("ALT ([0-9]+)FT").match(fields[1]);
    demand(altitude.hasMatch(), "altitude in the name");
    constexpr const char* kEight = "-?[0-9]{1,3}\\.[0-9]{8}";
    points.push_back({fields[0].toStdString(), degrees(fields[2], 90, kEight), degrees(fields[3], 180, kEight), altitude.captured(1).toDouble()});
  }
  return points;
}

ReadPoint worldPosition(const QString& text) {
  static const QRegularExpression pattern(
      "^([NS])([0-9]{1,2})\u00B0 ([0-9]{1,2})' ([0-9]{1,2}\\.[0-9]{2})\",([EW])([0-9]{1,3})\u00B0 ([0-9]{1,2})' "
      "([0-9]{1,2}\\.[0-9]{2})\",([+-][0-9]{6}\\.[0-9]{2})$");
  const QRegularExpressionMatch match = pattern.match(text);
  demand(match.hasMatch(), "position: " + text);
  const auto value = [&](int first, const char* negative) {
    demand(match.captured(first + 2).toInt() < 60 && match.captured(first + 3).toDouble() < 60.0, "minutes and seconds below 60: " + text);
    const double size =
        match.captured(first + 1).toDouble() + match.captured(first + 2).toDouble() / 60.0 + match.captured(first + 3).toDouble() / 3600.0;
    return match.captured(first) == negative ? -size : size;
  };
  return {"", value(1, "S"), value(5, "W"), match.captured(9).toDouble()};
}

std::vector<ReadPoint> pln(const std::string& bytes) {
  demand(bytes.substr(0, 3) == "\xEF\xBB\xBF", "byte order mark");
  const std::string text = bytes.substr(3);
  demand(QString::fromStdString(text).count('\n') == QString::fromStdString(text).count("\r\n"), "CRLF");
  const Node root = parseXml(text);
  demand(root.name == "SimBase.Document" && root.attributes["Type"] == "AceXML" && root.attributes["version"] == "1,0", "root");
  const Node& plan = root.child("FlightPlan.FlightPlan");
  demand(plan.childNames().mid(0, 12) == QStringList({"Title", "FPType", "RouteType", "CruisingAlt", "DepartureID", "DepartureLLA", "DestinationID",
                                                      "DestinationLLA", "Descr", "DepartureName", "DestinationName", "AppVersion"}),
         "order in FlightPlan");
  demand(matches(plan.child("FPType").text, "VFR|IFR") && matches(plan.child("CruisingAlt").text, "[0-9]+"), "type and whole feet");
  std::vector<ReadPoint> points;
  double highest = 0.0;
  for (const Node& waypoint : plan.children.mid(12)) {
    demand(waypoint.name == "ATCWaypoint" && matches(waypoint.attributes["id"], "[A-Za-z0-9_ ]{1,10}"), "waypoint id");
    const QString type = waypoint.child("ATCWaypointType").text;
    const bool isEnd = points.empty() || waypoint.attributes["id"] == plan.child("DestinationID").text;
    demand(type == "User" || (type == "Airport" && isEnd), "type of waypoint");
    demand(waypoint.childNames() == (waypoint.childNames().contains("RunwayNumberFP")
                                         ? QStringList({"ATCWaypointType", "WorldPosition", "RunwayNumberFP", "ICAO"})
                                         : QStringList({"ATCWaypointType", "WorldPosition", "ICAO"})),
           "order in ATCWaypoint");
    demand(waypoint.child("ICAO").child("ICAOIdent").text == waypoint.attributes["id"], "ICAOIdent");
    points.push_back(worldPosition(waypoint.child("WorldPosition").text));
    points.back().name = waypoint.attributes["id"].toStdString();
    highest = std::max(highest, points.back().feet);
  }
  demand(plan.child("CruisingAlt").text.toDouble() >= highest, "cruising altitude is the highest");
  demand(worldPosition(plan.child("DepartureLLA").text).latitude == points.front().latitude, "departure is the first waypoint");
  demand(worldPosition(plan.child("DestinationLLA").text).latitude == points.back().latitude, "destination is the last waypoint");
  demand(plan.child("DepartureID").text.toStdString() == points.front().name && plan.child("DestinationID").text.toStdString() == points.back().name,
         "idents of the ends");
  return points;
}

ReadPoint lnmPosition(const Node& node) {
  const Node& pos = node.child("Pos");
  demand(matches(pos.attributes["Alt"], "-?[0-9]+\\.[0-9]{2}"), "altitude of a position");
  return {"", degrees(pos.attributes["Lat"], 90), degrees(pos.attributes["Lon"], 180), pos.attributes["Alt"].toDouble()};
}

std::vector<ReadPoint> lnmpln(const std::string& bytes) {
  const QStringList head = QString::fromStdString(bytes).split('\n');
  demand(
      head.value(0).startsWith("<?xml") && head.value(1).trimmed().startsWith("<LittleNavmap") && head.value(2).trimmed().startsWith("<Flightplan"),
      "pretty-printed head");
  const Node plan = parseXml(bytes).child("Flightplan");
  const bool isHome = plan.childNames().contains("Departure");
  demand(plan.childNames() ==
             (isHome ? QStringList({"Header", "Departure", "Alternates", "Waypoints"}) : QStringList({"Header", "Alternates", "Waypoints"})),
         "order in Flightplan");
  if (isHome) {
    const Node& departure = plan.child("Departure");
    demand(departure.childNames() == QStringList({"Pos", "Start", "Type", "Heading"}) && departure.child("Type").text == "Runway" &&
               matches(departure.child("Start").text, "[0-9]{2}[LCR]?"),
           "departure");
    lnmPosition(departure);
  }
  demand(plan.child("Header").childNames() == QStringList({"FlightplanType", "CruisingAlt", "CruisingAltF", "Comment", "CreationDate", "FileVersion",
                                                           "ProgramName", "ProgramVersion", "Documentation"}),
         "order in Header");
  for (const Node& alternate : plan.child("Alternates").children) {
    demand(alternate.childNames() == QStringList({"Name", "Ident", "Type", "Pos"}) && alternate.child("Type").text == "AIRPORT", "alternate");
    lnmPosition(alternate);
  }
  std::vector<ReadPoint> points;
  for (const Node& waypoint : plan.child("Waypoints").children) {
    demand(waypoint.childNames() == QStringList({"Name", "Ident", "Type", "Comment", "Pos"}), "order in Waypoint");
    const bool isEnd = points.empty() || &waypoint == &plan.child("Waypoints").children.last();
    const QString type = waypoint.child("Type").text;
    demand(type == "USER" || (isHome && isEnd && type == "AIRPORT"), "type of waypoint");
    demand(matches(waypoint.child("Ident").text, "[A-Za-z0-9_]{1,10}"), "ident");
    points.push_back(lnmPosition(waypoint));
    points.back().name = waypoint.child("Ident").text.toStdString();
  }
  return points;
}

std::vector<ReadPoint> qgc(const std::string& bytes) {
  const QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(bytes)).object();
  demand(root["fileType"] == "Plan" && root["version"] == 1, "kind and version");
  demand(root["mission"].isObject() && root["geoFence"].isObject() && root["rallyPoints"].isObject(), "all three objects");
  const QJsonObject fence = root["geoFence"].toObject();
  demand(fence["circles"].isArray() && fence["polygons"].isArray() && fence["version"] == 2, "fence");
  const QJsonObject mission = root["mission"].toObject();
  demand(mission["version"] == 2 && mission["plannedHomePosition"].toArray().size() == 3, "version and home");
  for (const char* speed : {"cruiseSpeed", "hoverSpeed"}) {
    demand(matches(QString::number(mission[QLatin1String(speed)].toDouble(0.5), 'g', 15), "[0-9]+"), "whole speeds");
  }
  for (const QJsonValue& rally : root["rallyPoints"].toObject()["points"].toArray()) {
    demand(rally.toArray().size() == 3 && std::abs(rally.toArray()[0].toDouble(1e9)) <= 90.0, "rally point");
  }
  std::vector<ReadPoint> points;
  for (const QJsonValue& value : mission["items"].toArray()) {
    const QJsonObject item = value.toObject();
    const QJsonArray params = item["params"].toArray();
    demand(item["type"] == "SimpleItem" && item["command"] == 16 && item["frame"] == 0 && item["autoContinue"].isBool() && params.size() == 7,
           "item");
    demand(item.contains("AltitudeMode") && item.contains("Altitude") && item.contains("AMSLAltAboveTerrain"), "altitude: all three or none");
    demand(item["AltitudeMode"] == 2 && item["Altitude"] == params[6], "absolute altitude, the same twice");
    demand(item["doJumpId"] == static_cast<int>(points.size()) + 1, "numbers from 1");
    demand(std::abs(params[4].toDouble(1e9)) <= 90.0 && std::abs(params[5].toDouble(1e9)) <= 180.0, "place in range");
    points.push_back({"", params[4].toDouble(), params[5].toDouble(), params[6].toDouble() / kFoot});
  }
  return points;
}

double cupDegrees(const QString& text, const char* pattern, int width) {
  demand(matches(text, pattern), "degrees and minutes with three decimals: " + text);
  const double minutes = text.mid(width, 6).toDouble();
  demand(minutes < 60.0, "minutes below 60: " + text);
  const double size = text.left(width).toDouble() + minutes / 60.0;
  return text.endsWith('S') || text.endsWith('W') ? -size : size;
}

QString unquoted(const QString& field) {
  demand(field.size() >= 2 && field.startsWith('"') && field.endsWith('"') && !field.mid(1, field.size() - 2).contains('"'), "quoted text: " + field);
  return field.mid(1, field.size() - 2);
}

std::vector<ReadPoint> cup(const std::string& bytes) {
  const QStringList rows = lines(bytes, "\r\n");
  demand(rows.value(0) == "name,code,country,lat,lon,elev,style,rwdir,rwlen,freq,desc", "header of 2018");
  std::map<QString, ReadPoint> table;
  std::vector<ReadPoint> points;
  bool isTask = false;
  for (const QString& row : rows.mid(1)) {
    const QStringList fields = row.split(',');
    if (row == "-----Related Tasks-----") {
      isTask = true;
    } else if (!isTask) {
      demand(fields.size() == 11, "eleven fields: " + row);
      const QString name = unquoted(fields[0]);
      demand(!table.contains(name), "name once: " + name);
      demand(matches(fields[5], "-?[0-9]+(\\.[0-9]+)?(m|ft)"), "elevation with unit");
      demand(matches(fields[6], "[1-9]|1[0-9]|2[01]"), "style");
      demand(matches(fields[7], "|[0-9]{3}") && fields[7].toInt() <= 360, "runway direction");
      const double feet = fields[5].endsWith("ft") ? fields[5].chopped(2).toDouble() : fields[5].chopped(1).toDouble() / kFoot;
      table[name] = {name.toStdString(), cupDegrees(fields[3], "[0-9]{4}\\.[0-9]{3}[NS]", 2), cupDegrees(fields[4], "[0-9]{5}\\.[0-9]{3}[EW]", 3),
                     feet};
    } else if (row.startsWith('"')) {
      demand(fields.size() >= 5 && fields.size() <= 30, "columns of a task");
      for (qsizetype i = 1; i < fields.size(); ++i) {
        demand(table.contains(unquoted(fields[i])), "task point of the table: " + fields[i]);
        const bool isOnTask = i > 1 && i + 1 < fields.size();
        if (isOnTask && (i > 2 || points.empty())) {  // a task begins where the last one ended
          points.push_back(table[unquoted(fields[i])]);
        }
      }
    } else {
      demand(row.startsWith("Options,") || matches(row, "ObsZone=[0-9]+,Style=[0-4],R1=[0-9]+m,A1=[0-9]+"), "options: " + row);
    }
  }
  demand(isTask, "a task");
  return points;
}

std::vector<ReadPoint> gpx(const std::string& bytes) {
  const Node root = parseXml(bytes);
  demand(root.name == "gpx" && root.attributes["version"] == "1.1" && root.attributes["xmlns"] == "http://www.topografix.com/GPX/1/1" &&
             root.attributes.contains("creator"),
         "root");
  demand(root.childNames() == QStringList({"metadata", "rte", "trk"}), "order in gpx");
  std::vector<ReadPoint> points;
  for (const Node& point : root.child("rte").children) {
    if (point.name == "rtept") {
      demand(point.childNames() == QStringList({"ele", "name", "cmt", "type"}), "order in rtept");
      points.push_back({point.child("name").text.toStdString(), degrees(point.attributes["lat"], 90), degrees(point.attributes["lon"], 180),
                        point.child("ele").text.toDouble() / kFoot});
    }
  }
  demand(root.child("trk").child("trkseg").children.size() > 10, "a track of the arcs");
  for (const Node& point : root.child("trk").child("trkseg").children) {
    demand(point.name == "trkpt" && point.childNames() == QStringList({"ele"}), "track point with elevation");
    degrees(point.attributes["lat"], 90, "-?[0-9]{1,3}\\.[0-9]{7}");
  }
  return points;
}

void checkKmlNode(const Node& node, const QSet<QString>& styles, std::vector<ReadPoint>& points, bool isWaypoint) {
  const bool isHere = isWaypoint || (node.name == "Folder" && node.child("name").text == "Waypoints");
  if (node.name == "styleUrl") {
    demand(styles.contains(node.text), "style that is defined: " + node.text);
  }
  if (node.name == "LineString" || node.name == "Point") {
    demand(node.child("altitudeMode").text == "absolute", "absolute altitudes");
    const bool isCurtain = node.childNames().contains("extrude");
    demand(!isCurtain || node.child("tessellate").text == "0", "a curtain without tessellation");
    for (const QString& place : node.child("coordinates").text.split(' ', Qt::SkipEmptyParts)) {
      const QStringList parts = place.split(',');
      demand(parts.size() == 3 && std::abs(parts[0].toDouble()) <= 180.0 && std::abs(parts[1].toDouble()) <= 90.0,
             "longitude, latitude, altitude: " + place);
    }
  }
  if (isHere && node.name == "Placemark") {
    const QStringList parts = node.child("Point").child("coordinates").text.split(',');
    points.push_back(
        {node.child("name").text.toStdString(), parts.value(1).toDouble(), parts.value(0).toDouble(), parts.value(2).toDouble() / kFoot});
  }
  for (const Node& child : node.children) {
    checkKmlNode(child, styles, points, isHere);
  }
}

std::vector<ReadPoint> kml(const std::string& bytes) {
  const Node root = parseXml(bytes);
  demand(root.name == "kml" && root.attributes["xmlns"] == "http://www.opengis.net/kml/2.2", "root");
  const Node& document = root.child("Document");
  QSet<QString> styles;
  for (const Node& style : document.children) {
    if (style.name == "Style") {
      styles.insert("#" + style.attributes["id"]);
      demand(matches(style.child("LineStyle").child("color").text, "[0-9a-f]{8}"), "colour aabbggrr");
    }
  }
  demand(document.childNames().count("Folder") == 5, "folders: tour, waypoints, targets, runways, glides");
  std::vector<ReadPoint> points;
  checkKmlNode(root, styles, points, false);
  demand(bytes.find("<extrude>1</extrude>") != std::string::npos, "a curtain");
  return points;
}

std::vector<ReadPoint> fgfp(const std::string& bytes) {
  const QStringList head = QString::fromStdString(bytes).split('\n');
  demand(head.value(1).startsWith("<PropertyList") && head.value(2).trimmed().startsWith("<version"), "head that readers look for");
  const Node root = parseXml(bytes);
  demand(root.child("version").text == "2" && root.child("version").attributes["type"] == "int", "version");
  QStringList order{"version"};
  for (const char* end : {"departure", "destination"}) {
    if (root.childNames().contains(QLatin1String(end))) {
      order.append(end);
      demand(matches(root.child(end).child("airport").text, "[A-Z0-9]{2,8}"), "airport");
      demand(matches(root.child(end).child("runway").text, "[0-9]{2}[LCR]?"), "runway");
    }
  }
  demand(root.childNames() == order + QStringList{"route"}, "order in PropertyList");
  std::vector<ReadPoint> points;
  for (const Node& wp : root.child("route").children) {
    demand(wp.name == "wp", "only wp in route");
    demand(wp.attributes["n"] == QString::number(points.size()), "numbers without gaps");
    demand(wp.child("type").text == "basic" && wp.child("alt-restrict").text == "at", "type and restriction");
    demand(!wp.child("ident").text.isEmpty(), "ident");
    points.push_back({wp.child("ident").text.toStdString(), degrees(wp.child("lat").text, 90), degrees(wp.child("lon").text, 180),
                      wp.child("altitude-ft").text.toDouble()});
  }
  return points;
}

std::vector<ReadPoint> csv(const std::string& bytes) {
  const QStringList rows = lines(bytes, "\r\n");
  std::vector<ReadPoint> points;
  for (const QString& row : rows) {
    const QStringList fields = row.split(',');
    demand(fields.size() == 13, "thirteen fields: " + row);
    if (row == rows.first()) {
      demand(fields[0] == "kind" && fields[3] == "latitude_deg" && fields[5] == "altitude_msl_ft", "header");
      continue;
    }
    demand(matches(fields[0], "runway|target|waypoint|decisionPoint|departurePoint|arrivalPoint"), "kind: " + row);
    if (matches(fields[0], "runway|target|waypoint")) {
      demand(fields[1] == QString::number(points.size() + 1), "numbers from 1");
      points.push_back({fields[2].toStdString(), degrees(fields[3], 90), degrees(fields[4], 180), fields[5].toDouble()});
    }
  }
  return points;
}

std::vector<ReadPoint> geojson(const std::string& bytes) {
  const QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(bytes)).object();
  demand(root["type"] == "FeatureCollection", "feature collection");
  std::vector<ReadPoint> points;
  for (const QJsonValue& value : root["features"].toArray()) {
    const QJsonObject feature = value.toObject();
    demand(feature["type"] == "Feature" && feature["properties"].isObject() && feature["geometry"].isObject(), "feature");
    demand(feature["properties"].toObject().contains("alt_msl_m"), "height as a property");
    if (feature["properties"].toObject()["kind"] == "waypoint") {
      const QJsonArray place = feature["geometry"].toObject()["coordinates"].toArray();
      points.push_back(
          {feature["properties"].toObject()["name"].toString().toStdString(), place[1].toDouble(), place[0].toDouble(), place[2].toDouble() / kFoot});
    }
  }
  return points;
}

std::vector<ReadPoint> kmz(const std::string& bytes) {
  demand(bytes.substr(0, 4) == "PK\x03\x04" && bytes.substr(30, 7) == "doc.kml", "zip archive that begins with doc.kml");
  demand(bytes.find("PK\x05\x06") != std::string::npos, "end of the archive");
  return {};
}

std::vector<ReadPoint> gpkg(const std::string& bytes) {
  demand(bytes.substr(0, 15) == "SQLite format 3" && bytes.substr(68, 4) == "GPKG", "GeoPackage");
  return {};
}

}  // namespace

Checked check(const std::string& format, const std::string& bytes) {
  static const std::map<std::string, std::function<std::vector<ReadPoint>(const std::string&)>> checkers{
      {"fms", fms}, {"fms3", fms3}, {"fpl", fpl}, {"wpt", wpt},   {"pln", pln}, {"lnmpln", lnmpln},   {"plan", qgc}, {"cup", cup},
      {"gpx", gpx}, {"kml", kml},   {"kmz", kmz}, {"fgfp", fgfp}, {"csv", csv}, {"geojson", geojson}, {"gpkg", gpkg}};
  try {
    return {"", checkers.at(format)(bytes)};
  } catch (const Broken& broken) {
    return {broken.rule, {}};
  }
}

}  // namespace vp::formats::checks
