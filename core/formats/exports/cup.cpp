// SeeYou waypoints and task, header of 2018, as XCSoar reads it. Minutes with exactly three decimals; no comma and no quote in
// names, as some readers split inside quotes; tasks name points by name and hold 25 at most here (readers: 30 columns), so a long
// tour is several tasks, each from where the last one ended. A task holds no altitude: it stands in the name and in the description.
#include "core/formats/exports/diversions.h"
#include "core/formats/exports/writers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

namespace vp::formats::exports {
namespace {

constexpr std::size_t kTaskPoints = 25;
const IdentRules kTitle{40, true, " -_./()+", " "};
const IdentRules kName{24, true, " -_./()+", " "};

std::string sexagesimal(double degrees, const char* hemispheres, int width) {
  constexpr long long kPerDegree = 60000;
  const long long thousandths = std::llround(degrees * static_cast<double>(kPerDegree));
  const long long size = std::llabs(thousandths);
  return fmt::format("{:0{}}{:02}.{:03}{}", size / kPerDegree, width, size % kPerDegree / 1000, size % 1000, hemispheres[thousandths < 0 ? 1 : 0]);
}

std::string place(geo::LatLon at) {
  return sexagesimal(at.latitude_deg, "NS", 2) + "," + sexagesimal(at.longitude_deg, "EW", 3);
}

std::string runwayRow(const mission::LandingSite& site, const std::string& name) {
  const int course = static_cast<int>(std::lround(site.landingCourse.degrees())) % 360;
  const int style = site.surface == mission::Surface::Hard ? 5 : 2;
  const std::string length = site.length ? fmt::format("{:.0f}m", std::floor(site.length->si())) : "";
  return fmt::format("\"{}\",\"{}\",,{},{:.1f}m,{},{:03},{},,\"{}\"\r\n", name, restrictedTo(site.airportIdent, {8, false, "", ""}),
                     place(site.touchdown), std::ceil(site.elevation.metres() * 10.0) / 10.0, style, course == 0 ? 360 : course, length,
                     restrictedTo(fmt::format("runway {} of {}", site.runwayIdent, site.airportName), {60, true, " -_./()+", " "}));
}

/// @param takeoff  name of the runway, or "" @param landing  the same
std::string taskRow(const std::string& title, const std::vector<std::string>& names, std::size_t first, std::size_t end, const std::string& takeoff,
                    const std::string& landing) {
  std::string row = "\"" + restrictedTo(title, kTitle) + "\",\"" + (takeoff.empty() ? names[first] : takeoff) + "\"";
  for (std::size_t i = first; i < end; ++i) {
    row += ",\"" + names[i] + "\"";
  }
  row += ",\"" + (landing.empty() ? names[end - 1] : landing) + "\"\r\nOptions,WpDis=True\r\n";
  for (std::size_t i = first; i < end; ++i) {
    row += fmt::format("ObsZone={},Style={},R1=500m,A1=180\r\n", i - first, i == first ? 2 : i + 1 == end ? 3 : 1);
  }
  return row;
}

/// Points without the thresholds of home runways, which are rows of their own and the task's takeoff and landing.
std::vector<const mission::RouteWaypoint*> airborne(std::vector<const mission::RouteWaypoint*> points) {
  std::erase_if(points, [](const mission::RouteWaypoint* point) { return point->site >= 0; });
  return points;
}

/// Runways that glides lead to, those of home first.
std::vector<const mission::SiteInFrame*> runwaysOf(const ExportInput& input) {
  std::vector<const mission::SiteInFrame*> runways;
  for (const mission::RouteWaypoint* point : pointsOf(input)) {
    if (point->site >= 0) {
      runways.push_back(&input.plan.sites[static_cast<std::size_t>(point->site)]);
    }
  }
  const std::vector<const mission::SiteInFrame*> more = diversionSites(input.plan);
  runways.insert(runways.end(), more.begin(), more.end());
  return runways;
}

std::string runwayName(const ExportInput& input, const mission::RouteWaypoint& point) {
  return point.site < 0 ? "" : restrictedTo(input.plan.sites[static_cast<std::size_t>(point.site)].site.id, kName);
}

}  // namespace

Result<std::string> cup(const ExportInput& input) {
  const std::vector<const mission::RouteWaypoint*> places = airborne(placesOf(input));
  const std::vector<const mission::RouteWaypoint*> points = airborne(pointsOf(input));
  const IdentRules rules{14, true, " -_.", " "};
  const auto named = [&](const std::vector<const mission::RouteWaypoint*>& of) {
    std::vector<std::string> names = identsOf(input, of, rules);
    for (std::size_t i = 0; i < names.size(); ++i) {
      names[i] += fmt::format(" {}ft", feetOf(of[i]->altitude));
    }
    return names;
  };
  const std::vector<std::string> table = named(places);
  std::string text = "name,code,country,lat,lon,elev,style,rwdir,rwlen,freq,desc\r\n";
  std::set<std::string> used;
  for (std::size_t i = 0; i < places.size(); ++i) {
    used.insert(table[i]);
    text += fmt::format("\"{}\",\"{}\",,{},{}ft,1,,,,\"fly at {}\"\r\n", table[i], i + 1, place(places[i]->place), feetOf(places[i]->altitude),
                        restrictedTo(altitudeNote(*places[i]), {60, true, " ", ""}));
  }
  for (const mission::SiteInFrame* site : runwaysOf(input)) {
    const std::string name = restrictedTo(site->site.id, kName);
    if (used.insert(name).second) {
      text += runwayRow(site->site, name);
    }
  }
  const std::vector<std::string> names = named(points);
  text += "-----Related Tasks-----\r\n";
  const std::size_t legs = std::max<std::size_t>(1, names.size() - 1);
  const std::size_t tasks = (legs + kTaskPoints - 2) / (kTaskPoints - 1);
  for (std::size_t task = 0; task < tasks; ++task) {
    const std::size_t first = legs * task / tasks;
    const std::size_t end = legs * (task + 1) / tasks + 1;
    const std::string number = tasks > 1 ? fmt::format(" {} of {}", task + 1, tasks) : "";
    const std::string title = restrictedTo(titleOf(input), {kTitle.longest - number.size(), kTitle.lower, kTitle.others, kTitle.filler}) + number;
    text += taskRow(title, names, first, std::min(end, names.size()), task == 0 ? runwayName(input, *pointsOf(input).front()) : "",
                    task + 1 == tasks ? runwayName(input, *pointsOf(input).back()) : "");
  }
  return text;
}

}  // namespace vp::formats::exports
