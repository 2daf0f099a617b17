// KML 2.2, altitudes absolute (above sea level): the flown path with its curtain to the ground, waypoints, targets, runways, and the
// glide of every decision point, styled by its margin. Element order of ogckml22.xsd; colours are aabbggrr.
#include "core/formats/exports/diversions.h"
#include "core/formats/exports/gdal_file.h"
#include "core/formats/exports/writers.h"
#include "core/formats/exports/xml_writer.h"

#include <fmt/format.h>

#include <array>
#include <iterator>

namespace vp::formats::exports {
namespace {

constexpr double kChordError = 2.0;  // m

struct MarginClass {
  const char* id;
  const char* name;
  double below;  ///< m
  const char* color;
};
constexpr std::array<MarginClass, 4> kClasses{{{"glide0", "less than 50 m to spare", 50.0, "ff2a2ad9"},
                                               {"glide1", "50 to 150 m to spare", 150.0, "ff1f9df0"},
                                               {"glide2", "150 to 300 m to spare", 300.0, "ff4fb848"},
                                               {"glide3", "more than 300 m to spare", 1e9, "ffb8842b"}}};

void style(XmlWriter& xml, const char* id, const char* lineColor, const char* width, const char* polyColor) {
  xml.open("Style", {{"id", id}});
  xml.open("LineStyle");
  xml.element("color", lineColor);
  xml.element("width", width);
  xml.close();
  if (polyColor != nullptr) {
    xml.open("PolyStyle");
    xml.element("color", polyColor);
    xml.close();
  }
  xml.close();
}

void appendPlace(std::string& out, geo::LatLon place, double altitude) {
  fmt::format_to(std::back_inserter(out), "{}{:.7f},{:.7f},{:.2f}", out.empty() ? "" : " ", place.longitude_deg, place.latitude_deg, altitude);
}

void line(XmlWriter& xml, const std::string& coordinates, bool isCurtain) {
  xml.open("LineString");
  if (isCurtain) {
    xml.element("extrude", "1");
  }
  xml.element("tessellate", "0");
  xml.element("altitudeMode", "absolute");
  xml.element("coordinates", coordinates);
  xml.close();
}

void pointMark(XmlWriter& xml, const std::string& name, const std::string& text, geo::LatLon place, double altitude) {
  std::string coordinates;
  appendPlace(coordinates, place, altitude);
  xml.open("Placemark");
  xml.element("name", name);
  xml.element("description", text);
  xml.open("Point");
  xml.element("altitudeMode", "absolute");
  xml.element("coordinates", coordinates);
  xml.close();
  xml.close();
}

void folder(XmlWriter& xml, const std::string& name, bool isVisible = true) {
  xml.open("Folder");
  xml.element("name", name);
  if (!isVisible) {
    xml.element("visibility", "0");
  }
}

void addTour(XmlWriter& xml, const ExportInput& input) {
  std::string coordinates;
  for (const mission::RoutePoint& point : input.route->flown) {
    appendPlace(coordinates, point.place, point.altitude);
  }
  xml.open("Placemark");
  xml.element("name", titleOf(input));
  if (!input.route->guarantee.empty()) {
    xml.element("description", input.route->guarantee);
  }
  xml.element("styleUrl", "#tour");
  line(xml, coordinates, true);
  xml.close();
}

void addGlides(XmlWriter& xml, const mission::Plan& plan) {
  folder(xml, "Engine-out glides");
  std::array<std::vector<std::size_t>, kClasses.size()> byClass;
  for (std::size_t i = 0; i < plan.tour.size(); ++i) {
    const double margin = plan.tour[i].altitude - plan.tour[i].safeAltitude;
    std::size_t c = 0;
    while (c + 1 < kClasses.size() && margin >= kClasses[c].below) {
      ++c;
    }
    byClass[c].push_back(i);
  }
  for (std::size_t c = 0; c < kClasses.size(); ++c) {
    folder(xml, kClasses[c].name);
    for (const std::size_t i : byClass[c]) {
      const DrawnGlide glide = drawnGlide(plan, i, kChordError);
      if (glide.site < 0) {
        continue;
      }
      std::string coordinates;
      for (const GlidePoint& point : glide.points) {
        appendPlace(coordinates, point.place, point.altitude);
      }
      const mission::LandingSite& site = plan.sites[static_cast<std::size_t>(glide.site)].site;
      xml.open("Placemark");
      xml.element("name", fmt::format("{} to {}", i, site.id));
      xml.element("visibility", "0");
      xml.element("description", fmt::format("{:.0f} m to spare, over the runway at {:.0f} m MSL (elevation {:.0f} m)", glide.margin, glide.arrival,
                                             site.elevation.metres()));
      xml.element("styleUrl", std::string("#") + kClasses[c].id);
      line(xml, coordinates, false);
      xml.close();
    }
    xml.close();
  }
  xml.close();
}

}  // namespace

Result<std::string> kml(const ExportInput& input) {
  const mission::Plan& plan = input.plan;
  XmlWriter xml;
  xml.open("kml", {{"xmlns", "http://www.opengis.net/kml/2.2"}});
  xml.open("Document");
  xml.element("name", titleOf(input));
  style(xml, "tour", "ffd9541e", "3", "40d9541e");
  for (const MarginClass& c : kClasses) {
    style(xml, c.id, c.color, "2", nullptr);
  }
  folder(xml, "Tour");
  addTour(xml, input);
  xml.close();
  folder(xml, "Waypoints");
  for (const mission::RouteWaypoint* point : placesOf(input)) {
    pointMark(xml, point->name, altitudeNote(*point), point->place, point->altitude);
  }
  xml.close();
  folder(xml, "Targets");
  for (const mission::TargetInFrame& target : plan.targets) {
    pointMark(xml, target.target.name, fmt::format("target at {:.0f} m MSL", target.altitude), target.target.position, target.altitude);
  }
  xml.close();
  folder(xml, "Runways");
  for (const mission::SiteInFrame& site : plan.sites) {
    pointMark(xml, site.site.id, fmt::format("{}, {:.0f} m MSL", site.site.airportName, site.site.elevation.metres()), site.site.touchdown,
              site.site.elevation.metres());
  }
  xml.close();
  addGlides(xml, plan);
  return xml.finish();
}

Result<std::string> kmz(const ExportInput& input) {
  const Result<std::string> text = kml(input);
  return text ? zipped("doc.kml", *text) : text;
}

}  // namespace vp::formats::exports
