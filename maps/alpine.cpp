#include "maps/alpine.h"

#include "core/base/quantity.h"
#include "maps/airstrip.h"
#include "maps/deterministic.h"
#include "maps/erosion.h"
#include "maps/mission_text.h"
#include "maps/valleys.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace vp::maps {
namespace {

constexpr int kSize = 669;           // posts: 60.1 km at 90 m
constexpr int kModelSize = 789;      // posts of the eroded country, of which the map is the middle
constexpr double kSpacing = 90.0;    // m
constexpr double kLowest = 300.0;    // m
constexpr double kHighest = 3600.0;  // m
constexpr std::uint64_t kSeed = 46;
constexpr double kRiverArea = 25e6;  // m^2, from here on valleys have flat floors

const geo::LocalFrame kFrame(geo::LatLon{46.5, -27.0});

/// A broad, crooked chain from WSW to ENE with foothills.
double uplift(double x, double y) {
  const double crooked = y - 0.25 * x + 9000.0 * fractalNoise(x / 22000.0, y / 22000.0, kSeed + 100, 3);
  const double chain = 1.0 - smoothStep(4000.0, 34000.0, std::abs(crooked));
  const double groups = 1.0 + 0.35 * fractalNoise(x / 14000.0, y / 14000.0, kSeed + 200, 2);
  return (0.3 + 0.7 * chain) * groups;
}

const std::vector<AirstripWish>& wishes() {
  static const std::vector<AirstripWish> list{
      {"VA01", "Middlemere", 1800.0, 30.0, "ASPH"},   {"VA02", "Larchwater", 1250.0, 23.0, "ASPH"},
      {"VA03", "Sorrelbridge", 950.0, 25.0, "GRASS"}, {"VA04", "Hallow Green", 800.0, 30.0, "GRASS"},
      {"VA05", "Quernford", 1450.0, 30.0, "ASPH"},    {"VA06", "Tarnmouth", 700.0, 25.0, "GRASS"},
      {"VA07", "Oxlea", 900.0, 20.0, "GRAVEL"},       {"VA08", "Fennimore Valley", 1100.0, 23.0, "ASPH"},
      {"VA09", "Brackenhurst", 650.0, 25.0, "GRASS"}, {"VA10", "Wildersee", 850.0, 25.0, "GRASS"},
      {"VA11", "Stonehollow", 600.0, 20.0, "GRASS"},  {"VA12", "Upper Merrow", 750.0, 18.0, "ASPH"},
  };
  return list;
}

HeightField alpine(std::vector<Airstrip>& strips) {
  Tectonics tectonics;
  tectonics.uplift = uplift;
  tectonics.hardness = [](double x, double y) {
    return 1.0 + 0.35 * fractalNoise(x / 6000.0, y / 6000.0, kSeed + 300, 3) + 0.35 * valueNoise(x / 220.0, y / 220.0, kSeed + 400);
  };
  tectonics.steepness = 360.0;
  tectonics.talus = 0.85;
  tectonics.diffusion = 0.06;
  HeightField model = erode(kModelSize, kSpacing, tectonics, {160, 24, 6}, kSeed);
  bend(model, 350.0, 1800.0, kSeed + 500);
  const Drainage drainage = drain(model);
  carveValleys(model, drainage, {kRiverArea, 0.022, 700.0, 6.0e-4, 0.8});
  HeightField field = cropped(model, kSize);
  field.stretchTo(kLowest, kHighest);
  strips = placeAirstrips(field, drainage, kModelSize, 2.0 * kRiverArea, wishes());
  for (Airstrip& strip : strips) {
    levelGround(field, strip, 260.0, 600.0, 1.0);
  }
  field.roundHeights(1.0);
  return field;
}

/// Feet upwards: the ground is never above the elevation that the file states.
long feetUp(double metres) {
  return static_cast<long>(std::ceil(metres / kMetresPerFoot - 1e-9));
}

std::string airportsCsv(const std::vector<Airstrip>& strips) {
  std::string text =
      "id,ident,type,name,latitude_deg,longitude_deg,elevation_ft,continent,iso_country,iso_region,municipality,scheduled_service,icao_code,"
      "iata_code,gps_code,local_code,home_link,wikipedia_link,keywords\n";
  int id = 900001;
  for (const Airstrip& strip : strips) {
    const geo::LatLon place = kFrame.toLatLon({(strip.first.x + strip.second.x) / 2.0, (strip.first.y + strip.second.y) / 2.0});
    text += fmt::format("{},{},{}_airport,{} Airfield,{:.6f},{:.6f},{},EU,ZZ,ZZ-VA,{},no,,,{},,,,\n", id++, strip.ident,
                        strip.length() > 1500.0 ? "medium" : "small", strip.name, place.latitude_deg, place.longitude_deg, feetUp(strip.elevation),
                        strip.name, strip.ident);
  }
  // A heliport and a field that was given up, as every real list has them.
  const geo::LatLon heliport = kFrame.toLatLon({1000.0, 3000.0});
  text += fmt::format("{},VAH1,heliport,Middlemere Hospital Heliport,{:.6f},{:.6f},,EU,ZZ,ZZ-VA,Middlemere,no,,,,,,,\n", id++, heliport.latitude_deg,
                      heliport.longitude_deg);
  return text;
}

std::string runwaysCsv(const std::vector<Airstrip>& strips) {
  std::string text =
      "id,airport_ref,airport_ident,length_ft,width_ft,surface,lighted,closed,le_ident,le_latitude_deg,le_longitude_deg,le_elevation_ft,"
      "le_heading_degT,le_displaced_threshold_ft,he_ident,he_latitude_deg,he_longitude_deg,he_elevation_ft,he_heading_degT,"
      "he_displaced_threshold_ft\n";
  int id = 910001;
  int airport = 900001;
  for (const Airstrip& strip : strips) {
    // The end with the lower number comes first in these files.
    const bool firstIsLow = landingCourse(kFrame, strip.first, strip.second) < 180.0;
    const geo::Point low = firstIsLow ? strip.first : strip.second;
    const geo::Point high = firstIsLow ? strip.second : strip.first;
    const double lowCourse = landingCourse(kFrame, low, high);
    const double highCourse = landingCourse(kFrame, high, low);
    const geo::LatLon lowEnd = kFrame.toLatLon(low);
    const geo::LatLon highEnd = kFrame.toLatLon(high);
    const bool hard = strip.surface == "ASPH";
    text += fmt::format("{},{},{},{},{},{},{},0,{},{:.8f},{:.8f},{},{:.1f},{},{},{:.8f},{:.8f},{},{:.1f},\n", id++, airport++, strip.ident,
                        std::lround(strip.length() / kMetresPerFoot), std::lround(strip.width / kMetresPerFoot), strip.surface, hard ? 1 : 0,
                        runwayNumber(lowCourse), lowEnd.latitude_deg, lowEnd.longitude_deg, feetUp(strip.elevation), lowCourse,
                        strip.ident == "VA01" ? "300" : "", runwayNumber(highCourse), highEnd.latitude_deg, highEnd.longitude_deg,
                        feetUp(strip.elevation), highCourse);
  }
  text += fmt::format("{},{},VAH1,82,82,CON,1,0,H1,,,,,,,,,,,\n", id++, airport);
  return text;
}

/// Places spread over the massif: random, 150 to 300 m above the ground, well apart, not on the highest summits.
std::vector<TargetText> targets(const HeightField& field, int count) {
  constexpr double kReach = 26000.0;         // m from the middle
  constexpr double kHighestGround = 2600.0;  // m: leaves room below the service ceiling of a light aircraft
  Random random(kSeed * 1000 + static_cast<std::uint64_t>(count));
  const double apart = 0.6 * 2.0 * kReach / std::sqrt(static_cast<double>(count));
  std::vector<geo::Point> points;
  std::vector<TargetText> result;
  while (points.size() < static_cast<std::size_t>(count)) {
    const geo::Point p{roundTo(random.uniform(-kReach, kReach), 10.0), roundTo(random.uniform(-kReach, kReach), 10.0)};
    bool free = field.at(field.nearest(p.x), field.nearest(p.y)) <= kHighestGround;
    for (const geo::Point& other : points) {
      free = free && (other.x - p.x) * (other.x - p.x) + (other.y - p.y) * (other.y - p.y) >= apart * apart;
    }
    if (free) {
      points.push_back(p);
      result.push_back({fmt::format("T{:02}", result.size() + 1), kFrame.toLatLon(p), roundTo(random.uniform(150.0, 300.0), 10.0)});
    }
  }
  return result;
}

}  // namespace

Result<void> writeAlpine(const std::string& folder) {
  std::vector<Airstrip> strips;
  const HeightField field = alpine(strips);
  if (strips.size() < wishes().size()) {
    return fail(Errc::NoSolution,
                fmt::format("only {} of {} airfields found a level place in the valleys; change the seed", strips.size(), wishes().size()),
                "alpine.tif");
  }
  if (const auto written = writeGeoTiff(field, kFrame, SampleType::Int16, folder + "/alpine.tif"); !written) {
    return written;
  }
  if (const auto written = writeText(airportsCsv(strips), folder + "/alpine-airports.csv"); !written) {
    return written;
  }
  if (const auto written = writeText(runwaysCsv(strips), folder + "/alpine-runways.csv"); !written) {
    return written;
  }
  MissionText mission;
  mission.terrain = "alpine.tif";
  mission.airports = "alpine-airports.csv";
  mission.runways = "alpine-runways.csv";
  mission.aircraft = "cessna172-operational";
  mission.step = 100.0;
  mission.roadmapSamples = 0;
  for (const int count : {10, 30}) {
    mission.name = fmt::format("Alpine massif, {} targets", count);
    mission.targets = targets(field, count);
    if (const auto written = writeMission(mission, fmt::format("{}/alpine-n{}.vpm", folder, count)); !written) {
      return written;
    }
  }
  return {};
}

}  // namespace vp::maps
