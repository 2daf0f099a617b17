// volplane-cli fetch-terrain: terrain of an area from the public server or the cache, as one GeoTIFF.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/values.h"
#include "core/fetch/airfield_fetch.h"
#include "core/fetch/download.h"
#include "core/fetch/terrain_area.h"
#include "core/fetch/terrain_fetch.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdlib>
#include <memory>

namespace vp::cli {
namespace {

using Json = nlohmann::ordered_json;

struct FetchArguments {
  std::string box;
  std::string around;
  std::string radius = "30km";
  std::string airports;
  fetch::TerrainRequest request;
  std::string output;
  bool dryRun = false;
};

/// A place given by its coordinates or by the code of an airfield.
Result<geo::LatLon> placeOf(const FetchArguments& arguments) {
  if (const Result<std::vector<double>> numbers = numbersIn(arguments.around, 2); numbers) {
    return placeFrom((*numbers)[0], (*numbers)[1], "--around");
  }
  std::string file = arguments.airports;
  if (file.empty()) {
    fetch::AirfieldRequest request;
    request.cache = arguments.request.cache;
    const Result<std::optional<fetch::AirfieldFiles>> cached = fetch::cachedAirfields(request);
    if (!cached) {
      return forward(cached);
    }
    if (!*cached) {
      return fail(
          Errc::BadFile,
          fmt::format("\"{}\" is neither latitude,longitude nor can it be looked up: no airfields are here yet; run `volplane-cli fetch-airfields` "
                      "first, or name a file with --airports",
                      arguments.around),
          "--around");
    }
    file = (*cached)->airports;
  }
  return fetch::placeOfAirfield(file, arguments.around);
}

Result<geo::GeoBox> areaOf(const FetchArguments& arguments) {
  if (!arguments.box.empty()) {
    const Result<std::vector<double>> numbers = numbersIn(arguments.box, 4);
    if (!numbers) {
      return fail(Errc::OutOfRange, "give the area as WEST,SOUTH,EAST,NORTH in degrees, for example 8.2,46.3,8.9,46.8", "--bbox");
    }
    return geo::GeoBox{{(*numbers)[1], (*numbers)[0]}, {(*numbers)[3], (*numbers)[2]}};
  }
  const Result<geo::LatLon> place = placeOf(arguments);
  if (!place) {
    return forward(place);
  }
  const Result<double> radius = distanceIn(arguments.radius, "--radius");
  return radius ? fetch::boxAround(*place, *radius) : forward(radius);
}

/// "terrain-N46.20E008.30.tif" in the folder the program runs in.
std::string defaultOutput(const geo::GeoBox& area) {
  const double south = area.southWest.latitude_deg;
  const double west = area.southWest.longitude_deg;
  return fmt::format("terrain-{}{:05.2f}{}{:06.2f}.tif", south < 0.0 ? 'S' : 'N', std::abs(south), west < 0.0 ? 'W' : 'E', std::abs(west));
}

const char* wordOf(fetch::TileState state) {
  switch (state) {
    case fetch::TileState::Cached:
      return "cached";
    case fetch::TileState::OnServer:
      return "onServer";
    case fetch::TileState::Ocean:
      return "ocean";
    default:
      return "notPublished";
  }
}

Json estimateToJson(const fetch::TerrainEstimate& estimate, const geo::GeoBox& area) {
  Json tiles = Json::array();
  for (const fetch::TileOffer& offer : estimate.tiles) {
    tiles.push_back({{"name", fetch::nameOf(offer.tile)}, {"state", wordOf(offer.state)}, {"bytes", offer.bytes}, {"haveBytes", offer.have}});
  }
  return {{"server", estimate.server},
          {"cache", estimate.folder},
          {"west_deg", area.southWest.longitude_deg},
          {"south_deg", area.southWest.latitude_deg},
          {"east_deg", area.northEast.longitude_deg},
          {"north_deg", area.northEast.latitude_deg},
          {"tiles", tiles},
          {"bytesToFetch", estimate.bytesToFetch},
          {"posts", estimate.posts}};
}

void printEstimate(const fetch::TerrainEstimate& estimate, const geo::GeoBox& area) {
  fmt::print("area {:.4f} to {:.4f} east, {:.4f} to {:.4f} north: {}\n", area.southWest.longitude_deg, area.northEast.longitude_deg,
             area.southWest.latitude_deg, area.northEast.latitude_deg, estimate.inWords());
  fmt::print("  from {}, kept in {}\n", estimate.server, estimate.folder);
}

int runFetchTerrain(const FetchArguments& arguments, const Common& common) {
  Console console(!common.quiet && !common.json);
  const Job job = console.job();
  const auto failed = [&](const Error& error) {
    console.finishProgress();
    return report(error, common.json);
  };
  const Result<geo::GeoBox> area = areaOf(arguments);
  if (!area) {
    return failed(area.error());
  }
  fetch::TerrainRequest request = arguments.request;
  request.area = *area;
  const Result<fetch::TerrainEstimate> estimate = fetch::estimateTerrain(request, job.part(0.0, 0.02));
  if (!estimate) {
    return failed(estimate.error());
  }
  console.finishProgress();
  if (!common.quiet && !common.json) {
    printEstimate(*estimate, *area);
    std::fflush(stdout);  // before the wait
  }
  Json json = estimateToJson(*estimate, *area);
  if (arguments.dryRun) {
    if (common.json) {
      fmt::print("{}", jsonText(json));
    }
    return kDone;
  }
  const std::string output = arguments.output.empty() ? defaultOutput(*area) : arguments.output;
  const Result<fetch::FetchedTerrain> fetched = fetch::fetchTerrain(request, *estimate, output, job.part(0.02, 1.0));
  if (!fetched) {
    return failed(fetched.error());
  }
  console.finishProgress();
  if (common.json) {
    json["files"] = fetched->files;
    json["notes"] = fetched->notes;
    fmt::print("{}", jsonText(json));
    return kDone;
  }
  for (const std::string& note : fetched->notes) {
    fmt::print("note: {}\n", note);
  }
  if (!common.quiet) {
    std::string terrain;
    for (const std::string& file : fetched->files) {
      fmt::print("wrote {}\n", file);
      terrain += " --terrain " + file;
    }
    fmt::print("Terrain: Copernicus GLO-30, {}\n", fetch::kTerrainCredit);
    fmt::print("next: volplane-cli new-mission{} --target LAT,LON --target ... -o mission.vpm\n", terrain);
  }
  return kDone;
}

}  // namespace

void addFetchTerrainCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<FetchArguments>();
  CLI::App* command = app.add_subcommand("fetch-terrain", "Fetch the terrain of an area (Copernicus GLO-30) and write it as one GeoTIFF");
  CLI::Option_group* where = command->add_option_group("area");
  where->add_option("--bbox", arguments->box, "The area as WEST,SOUTH,EAST,NORTH in degrees");
  where->add_option("--around", arguments->around, "The area around an airfield's code or LAT,LON");
  where->require_option(1);
  command->add_option("--radius", arguments->radius, "With --around: 30km (default), 20nm, 25000m");
  command->add_option("--airports", arguments->airports,
                      "Where to look an airfield up: airports.csv or a .cup; default: what fetch-airfields fetched");
  command->add_option("--cache", arguments->request.cache, "Folder for what is fetched; default $XDG_CACHE_HOME/volplane or ~/.cache/volplane");
  command->add_option("-o,--output", arguments->output, "GeoTIFF to write; default terrain-CORNER.tif in this folder");
  command->add_option("--base-url", arguments->request.server, "Another server of the same layout; default VOLPLANE_TERRAIN_URL or the public one");
  command->add_flag("--dry-run", arguments->dryRun, "Only say what would be fetched, and how much");
  command->callback([arguments, &common, &status] { status = runFetchTerrain(*arguments, common); });
}

}  // namespace vp::cli
