#include "core/charts/safe_altitude_chart.h"

#include "core/formats/atomic_file.h"
#include "core/formats/height_map.h"
#include "core/formats/wind_text.h"
#include "core/landing/safe_altitude_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <limits>

namespace vp::charts {
namespace {

std::string endingOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".tiff" ? ".tif" : ending;
}

/// True courses of the bands, degrees.
std::vector<double> coursesOf(const ChartRequest& request) {
  if (request.courses == Courses::One) {
    return {request.course_deg};
  }
  std::vector<double> courses;
  courses.reserve(static_cast<std::size_t>(request.count));
  for (int i = 0; i < request.count; ++i) {
    courses.push_back(360.0 * i / request.count);
  }
  return courses;
}

formats::HeightMap::Band bandFor(const std::string& name, const std::string& course, double range_deg, std::vector<float> values) {
  return {name, std::move(values), {{"VOLPLANE_COURSE", course}, {"VOLPLANE_COURSE_RANGE_DEG", fmt::format("{:.2f}", range_deg)}}};
}

std::vector<formats::HeightMap::Band> bandsOf(const landing::SafeAltitudeMap& map, const ChartRequest& request, const std::vector<double>& courses) {
  const double range = Angle::radians(map.courseRange).degrees();
  std::vector<formats::HeightMap::Band> bands;
  if (request.courses == Courses::All || request.courses == Courses::Worst) {
    bands.push_back(bandFor("Lowest safe altitude on any course, m MSL", "any", 180.0, map.worst()));
  }
  if (request.courses == Courses::Best) {
    bands.push_back(bandFor("Lowest safe altitude on the best course, m MSL", "best", range, map.best()));
  }
  for (std::size_t i = 0; i < courses.size() && (request.courses == Courses::All || request.courses == Courses::One); ++i) {
    const std::string name = fmt::format("Lowest safe altitude on true course {:05.1f} and {:.2f} degrees to each side, m MSL", courses[i], range);
    bands.push_back(bandFor(name, fmt::format("{:.1f}", courses[i]), range, map.need[i]));
  }
  return bands;
}

/// How glides end.
std::string approachPhrase(const mission::ApproachSettings& approach) {
  switch (approach.kind) {
    case mission::ApproachKind::Straight:
      return fmt::format("straight for the last {:g} m", approach.finalLength.si());
    case mission::ApproachKind::Overhead:
      return "a full circle down from above the touchdown point";
    case mission::ApproachKind::Threshold:
      break;
  }
  return "at the touchdown point, by any curve";
}

std::map<std::string, std::string> wordsFor(const landing::World& world, const mission::Mission& mission) {
  std::string terrain;
  for (const std::string& file : mission.terrain) {
    terrain += (terrain.empty() ? "" : ", ") + std::filesystem::path(file).filename().string();
  }
  return {
      {"VOLPLANE_KIND", "lowest safe altitude"},
      {"VOLPLANE_MISSION", mission.name},
      {"VOLPLANE_AIRCRAFT", mission.aircraft.name},
      {"VOLPLANE_GLIDE_RATIO", fmt::format("{:.2f}", 1.0 / world.glide.straightLoss())},
      {"VOLPLANE_CLEARANCE_M", fmt::format("{:g}", world.clearance)},
      {"VOLPLANE_ARRIVAL_MARGIN_M", fmt::format("{:g}", world.arrivalMargin)},
      {"VOLPLANE_REACTION_TIME_S", fmt::format("{:g}", mission.safety.reactionTime.si())},
      {"VOLPLANE_REACTION_LOSS_M", fmt::format("{:g}", world.reactionLoss)},
      {"VOLPLANE_APPROACH", approachPhrase(world.approach)},
      {"VOLPLANE_LANDING_SITES", std::to_string(world.sites.size())},
      {"VOLPLANE_TERRAIN", terrain},
      {"VOLPLANE_UNITS", "metres above mean sea level, the datum of the terrain"},
      {"VOLPLANE_MEANING",
       fmt::format("upper bound: from every place in the cell, on every course of the band, at this altitude or above, engine off and in {}, a glide "
                   "reaches a landing site with the clearance; no data where there is none or the ground is unknown",
                   formats::airPhrase(mission.wind))}};
}

ChartSummary summaryOf(const formats::HeightMap& map) {
  ChartSummary summary{map.columns, map.rows, map.cell, 0.0, 0.0, 0.0, map.bands.size(), 0, {}};
  double lowest = std::numeric_limits<double>::infinity();
  std::size_t known = 0;
  for (const float value : map.bands.front().values) {
    if (std::isfinite(value)) {
      ++known;
      lowest = std::min(lowest, static_cast<double>(value));
      summary.highest = std::max(summary.highest, static_cast<double>(value));
    }
  }
  summary.lowest = known > 0 ? lowest : 0.0;
  summary.knownShare = static_cast<double>(known) / static_cast<double>(map.bands.front().values.size());
  return summary;
}

}  // namespace

double defaultCell(const geo::Box& area) {
  constexpr double kMostCells = 250.0;
  const double side = std::max(area.maxX - area.minX, area.maxY - area.minY);
  return std::max(50.0, 10.0 * std::ceil(side / kMostCells / 10.0));
}

Result<void> checkChartName(const std::string& path) {
  const std::string ending = endingOf(path);
  if (ending != ".tif" && ending != ".kml" && ending != ".gpkg") {
    return fail(Errc::OutOfRange, "the name says what to write: .tif for values, .kml or .gpkg for contours", path);
  }
  return {};
}

Result<ChartSummary> writeSafeAltitudeChart(const landing::World& world, const landing::Roadmap& roadmap, const geo::LocalFrame& frame,
                                            const mission::Mission& mission, const ChartRequest& request, const std::string& path, const Job& job) {
  if (const Result<void> named = checkChartName(path); !named) {
    return forward(named);
  }
  const geo::LatLon middle = frame.toLatLon({0.5 * (request.area.minX + request.area.maxX), 0.5 * (request.area.minY + request.area.maxY)});
  const std::vector<double> courses = coursesOf(request);
  landing::MapRequest asked{
      request.area, request.cell > 0.0 ? request.cell : defaultCell(request.area), {}, Angle::kPi / std::max(1, request.count), request.threads};
  for (const double course : courses) {
    asked.headings.push_back(frame.headingOf(Angle::degrees(course), middle));
  }
  const Result<landing::SafeAltitudeMap> computed = landing::safeAltitudeMap(world, roadmap, asked, job.part(0.0, 0.95));
  if (!computed) {
    return forward(computed);
  }
  formats::HeightMap map{mission.name.empty() ? "Lowest safe altitude" : mission.name + ": lowest safe altitude",
                         frame,
                         computed->originX,
                         computed->originY,
                         computed->cell,
                         computed->columns,
                         computed->rows,
                         bandsOf(*computed, request, courses),
                         wordsFor(world, mission)};
  ChartSummary summary = summaryOf(map);
  summary.air = formats::airPhrase(mission.wind);
  if (endingOf(path) == ".tif") {
    const Result<void> written = formats::writeHeightMapTiff(map, path);
    return written ? Result<ChartSummary>(summary) : forward(written);
  }
  const Result<std::vector<formats::Contour>> contours = formats::contoursOf(map, 0, request.interval, job.part(0.95, 1.0));
  if (!contours) {
    return forward(contours);
  }
  summary.contours = contours->size();
  const Result<void> written = endingOf(path) == ".kml" ? formats::writeFileAtomically(path, formats::contoursToKml(map, 0, *contours))
                                                        : formats::writeContoursGpkg(map, 0, *contours, path);
  return written ? Result<ChartSummary>(summary) : forward(written);
}

}  // namespace vp::charts
