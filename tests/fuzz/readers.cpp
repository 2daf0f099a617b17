#include "tests/fuzz/readers.h"

#include "core/aircraft/wind_check.h"
#include "core/formats/aircraft_file.h"
#include "core/formats/airfields.h"
#include "core/formats/airspace/openair.h"
#include "core/formats/mission_file.h"
#include "core/formats/plan_file.h"
#include "core/formats/population_file.h"
#include "core/formats/targets/target_import.h"
#include "core/formats/text_file.h"
#include "core/formats/weather_file.h"
#include "core/formats/wind_text.h"
#include "core/risk/population.h"
#include "core/risk/weather.h"
#include "core/terrain/terrain_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace vp::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestSentence = 2000;

bool isPlain(std::string_view text) {
  return formats::isUtf8(text) && std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

std::string faultOfNotes(const std::vector<std::string>& notes) {
  for (const std::string& note : notes) {
    if (note.empty() || note.size() > kLongestSentence || !isPlain(note)) {
      return "a note is no sentence: " + note.substr(0, 300);
    }
  }
  return notes.size() > 1000 ? "more than a thousand notes" : "";
}

bool isOnEarth(geo::LatLon place) {
  return std::abs(place.latitude_deg) <= 90.0 && std::abs(place.longitude_deg) <= 180.0;
}

template <typename T>
Outcome refused(const Result<T>& failed, const std::string& path) {
  return {failed.error(), faultOf(failed.error(), path)};
}

Outcome complaint(std::string text) {
  return {std::nullopt, std::move(text)};
}

// ---- terrain

Outcome readTerrain(const std::string& path) {
  const Result<terrain::TerrainInfo> info = terrain::inspectTerrain({path});
  if (!info) {
    return refused(info, path);
  }
  const terrain::TerrainInfo::File& file = info->files.front();
  if (!isOnEarth(info->southWest) || !isOnEarth(info->northEast) || !(file.spacing_m >= 0.0) || file.columns < 2 || file.rows < 2) {
    return complaint("terrain that is not on Earth");
  }
  constexpr double kMostPosts = 200'000.0;  // more is only slow
  if (static_cast<double>(file.columns) * file.rows > kMostPosts) {
    return {};
  }
  terrain::ReadOptions options;
  options.maxCells = 20'000;
  const Result<terrain::ElevationGrid> grid = terrain::readTerrain({path}, geo::LocalFrame(info->centre()), options, Job{});
  if (!grid) {  // the whole area is what is wrong then, and no file is named
    return {grid.error(), grid.error().where.empty() ? "" : faultOf(grid.error(), path)};
  }
  return {};
}

// ---- airfields

Outcome judged(const Result<formats::AirfieldReport>& report, const std::string& path) {
  if (!report) {
    return refused(report, path);
  }
  for (const mission::LandingSite& site : report->sites) {
    if (!isOnEarth(site.touchdown) || !std::isfinite(site.elevation.metres()) || !std::isfinite(site.landingCourse.degrees()) ||
        (site.length && !(site.length->si() > 0.0 && site.length->si() < 1e5)) || site.id.empty() || !isPlain(site.id) ||
        !isPlain(site.airportName)) {
      return complaint("a landing site that cannot be: " + site.id);
    }
  }
  return complaint(faultOfNotes(report->notes));
}

/// The airports end and the runways begin after a line of "=====".
Outcome readOurAirports(const std::string& path) {
  const Result<std::string> both = formats::readFile(path);
  constexpr std::string_view kBetween = "\n=====\n";
  const std::size_t at = both ? both->find(kBetween) : std::string::npos;
  const std::string runways = path + ".runways.csv";
  std::ofstream(runways, std::ios::binary) << (at == std::string::npos ? "" : both->substr(at + kBetween.size()));
  if (at != std::string::npos) {
    fs::resize_file(path, at + 1);
  }
  Outcome outcome = judged(formats::readOurAirports(path, runways, {}, std::nullopt), path);
  mission::SiteFilter all;
  all.water = all.closed = true;
  return outcome.complaint.empty() ? judged(formats::readOurAirports(path, runways, all, std::nullopt), path) : outcome;
}

Outcome readCup(const std::string& path) {
  return judged(formats::readCup(path, {}, std::nullopt), path);
}

Outcome readAptDat(const std::string& path) {
  return judged(formats::readAptDat(path, {}, std::nullopt), path);
}

Outcome readOwnFields(const std::string& path) {
  return judged(formats::readAirfields({path, ""}, "", {}, std::nullopt), path);
}

// ---- targets, airspaces

Outcome readTargets(const std::string& path) {
  formats::TargetImportOptions options;
  options.tracks = options.fileHeights = true;
  options.most = 300;
  const Result<formats::ImportedTargets> imported = formats::importTargets(path, options, {{"Target 1", {46.9, 8.2}, 100.0, {}}});
  if (!imported) {
    return refused(imported, path);
  }
  for (const mission::Target& target : imported->targets) {
    if (!isOnEarth(target.position) || !std::isfinite(target.height_m) || target.name.empty() || target.name.size() > 80 || !isPlain(target.name)) {
      return complaint("a target that cannot be: " + target.name);
    }
  }
  return complaint(faultOfNotes(imported->notes));
}

Outcome readOpenAir(const std::string& path) {
  formats::isOpenAir(path);
  const Result<formats::AirspaceReport> report = formats::readOpenAir(path);
  if (!report) {
    return refused(report, path);
  }
  for (const mission::Airspace& airspace : report->airspaces) {
    if (airspace.outline.size() < 3 || !isPlain(airspace.name) || !isPlain(airspace.kind) ||
        !std::all_of(airspace.outline.begin(), airspace.outline.end(), isOnEarth)) {
      return complaint("an airspace that cannot be: " + airspace.name);
    }
  }
  return complaint(faultOfNotes(report->notes));
}

// ---- our own files

Outcome readMission(const std::string& path) {
  const Result<mission::Mission> draft = formats::readDraft(path);
  const Result<mission::Mission> mission = formats::readMission(path);
  if (!mission) {
    return refused(mission, path);
  }
  const Result<mission::Mission> again = formats::parseMission(formats::missionToText(*mission), path);
  if (!draft || !again) {
    return complaint("a mission that was read is not read again: " + (draft ? again.error().message() : draft.error().message()));
  }
  return complaint(formats::missionToText(*again) == formats::missionToText(*mission) ? "" : "a mission comes back changed");
}

Outcome readPlan(const std::string& path) {
  const Result<mission::Plan> plan = formats::readPlan(path);
  if (!plan) {
    return refused(plan, path);
  }
  const std::string text = formats::planToJson(*plan);
  const Result<mission::Plan> again = formats::parsePlan(text, path);
  if (!again) {
    return complaint("a plan that was read is not read again: " + again.error().message());
  }
  return complaint(formats::planToJson(*again) == text ? "" : "a plan comes back changed");
}

Outcome readAircraft(const std::string& path) {
  const Result<aircraft::AircraftProfile> profile = formats::readAircraft(path);
  if (!profile) {
    return refused(profile, path);
  }
  const Result<aircraft::AircraftProfile> again = formats::parseAircraft(formats::aircraftToText(*profile), path);
  if (!again) {
    return complaint("a profile that was read is not read again: " + again.error().message());
  }
  return complaint(formats::aircraftToText(*again) == formats::aircraftToText(*profile) ? "" : "a profile comes back changed");
}

// ---- polygons

Outcome readPopulation(const std::string& path) {
  const Result<formats::PopulationReport> report = formats::readPopulation(path);
  if (!report) {
    return refused(report, path);
  }
  const Result<risk::Population> population = risk::Population::from(report->areas, geo::LocalFrame({46.9, 8.2}));
  return population ? complaint(faultOfNotes(report->notes)) : refused(population, path);
}

Outcome readWeather(const std::string& path) {
  const Result<formats::WeatherReport> report = formats::readWeather(path);
  if (!report) {
    return refused(report, path);
  }
  const auto weather = risk::Weather::from(report->cells, geo::LocalFrame({46.9, 8.2}));
  if (!weather) {  // says which cell of which file only where that was given a name
    return {weather.error(), faultOf(weather.error(), weather.error().where)};
  }
  return complaint(faultOfNotes(report->notes));
}

// ---- wind

Outcome readWind(const std::string& path) {
  const Result<std::string> text = formats::readFile(path);
  const Result<formats::WindReading> wind = text ? formats::parseWind(*text) : forward(text);
  if (!wind) {  // a text has no file; its place stands in the sentence
    return {wind.error(), faultOf(wind.error(), wind.error().where)};
  }
  if (aircraft::windFault(wind->layers)) {
    return complaint("a wind that cannot be");
  }
  const Result<formats::WindReading> again = formats::parseWind(formats::windText(wind->layers));
  if (!again || again->layers != wind->layers) {
    return complaint("wind comes back changed from " + formats::windText(wind->layers));
  }
  return complaint(faultOfNotes(wind->notes));
}

}  // namespace

const std::vector<Reader>& readers() {
  static const std::vector<Reader> list{
      {"terrain_tif", ".tif", &readTerrain, 16384},
      {"terrain_asc", ".asc", &readTerrain, 4096},
      {"terrain_dted", ".dt1", &readTerrain, 16384},
      {"our_airports", ".csv", &readOurAirports, 8192},
      {"cup", ".cup", &readCup, 8192},
      {"apt_dat", ".dat", &readAptDat, 8192},
      {"own_table", ".csv", &readOwnFields, 4096},
      {"own_geojson", ".geojson", &readOwnFields, 8192},
      {"openair", ".txt", &readOpenAir, 4096},
      {"targets_cup", ".cup", &readTargets, 8192},
      {"targets_gpx", ".gpx", &readTargets, 8192},
      {"targets_kml", ".kml", &readTargets, 8192},
      {"targets_kmz", ".kmz", &readTargets, 8192},
      {"targets_plan", ".plan", &readTargets, 8192},
      {"targets_lnmpln", ".lnmpln", &readTargets, 8192},
      {"targets_table", ".csv", &readTargets, 4096},
      {"targets_geojson", ".geojson", &readTargets, 8192},
      {"mission", ".vpm", &readMission, 16384},
      {"plan", ".vpp", &readPlan, 32768},
      {"aircraft", ".json", &readAircraft, 8192},
      {"population", ".geojson", &readPopulation, 8192},
      {"weather", ".geojson", &readWeather, 8192},
      {"population_kml", ".kml", &readPopulation, 8192},
      {"wind", ".txt", &readWind, 512},
  };
  return list;
}

const Reader* readerOf(std::string_view name) {
  const auto found = std::find_if(readers().begin(), readers().end(), [&](const Reader& reader) { return name == reader.name; });
  return found == readers().end() ? nullptr : &*found;
}

std::string faultOf(const Error& error, const std::string& path) {
  if (error.what.empty() || error.message().size() > kLongestSentence || !isPlain(error.message())) {
    return "an error is no sentence: " + error.message().substr(0, 300);
  }
  return error.where.find(path) == std::string::npos ? "an error does not name the file: " + error.message() : "";
}

InputFile::InputFile(const Reader& reader) : reader_(&reader) {
  std::error_code code;
  const fs::path memory("/dev/shm");
  const fs::path base = ::access(memory.c_str(), W_OK) == 0 ? memory : fs::temp_directory_path();
  static int count = 0;
  folder_ = (base / ("volplane-" + std::to_string(::getpid()) + "-" + std::to_string(count++))).string();
  fs::create_directory(folder_, code);
  path_ = folder_ + "/input" + reader.ending;
  if (reader.read == &readTerrain) {  // an ASCII grid keeps its coordinate system beside itself; other formats take no notice
    std::ofstream(folder_ + "/input.prj") << "PROJCS[\"UTM 32\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
                                             "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
                                             "PARAMETER[\"central_meridian\",9],PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\","
                                             "500000],UNIT[\"metre\",1]]";
  }
}

InputFile::~InputFile() {
  std::error_code code;
  fs::remove_all(folder_, code);
}

Outcome InputFile::read(std::string_view bytes) {
  if (bytes.size() > reader_->longest) {
    return {};
  }
  std::ofstream(path_, std::ios::binary | std::ios::trunc).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  try {
    return reader_->read(path_);
  } catch (const std::exception& exception) {
    return complaint(std::string("an exception escaped: ") + exception.what());
  }
}

}  // namespace vp::fuzz
