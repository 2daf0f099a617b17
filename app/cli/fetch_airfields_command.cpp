// volplane-cli fetch-airfields: OurAirports' tables from their server.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "core/fetch/airfield_fetch.h"
#include "core/fetch/download.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <memory>

namespace vp::cli {
namespace {

using Json = nlohmann::ordered_json;

struct FetchAirfieldsArguments {
  fetch::AirfieldRequest request;
  bool dryRun = false;
};

int runDry(const FetchAirfieldsArguments& arguments, const Common& common, Console& console) {
  const Result<std::uint64_t> bytes = fetch::airfieldBytes(arguments.request, console.job());
  const Result<std::optional<fetch::AirfieldFiles>> cached = fetch::cachedAirfields(arguments.request);
  console.finishProgress();
  if (!bytes || !cached) {
    return report(!bytes ? bytes.error() : cached.error(), common.json);
  }
  const std::string since = *cached ? (*cached)->fetched : "";
  if (common.json) {
    fmt::print("{}", jsonText(Json{{"bytesToFetch", *bytes}, {"fetched", since}}));
  } else {
    fmt::print("{} to fetch; {}\n", *bytes == 0 ? "nothing" : fetch::bytesInWords(*bytes),
               since.empty() ? "no airfields are here yet" : "the airfields here are of " + since);
  }
  return kDone;
}

int runFetchAirfields(const FetchAirfieldsArguments& arguments, const Common& common) {
  Console console(!common.quiet && !common.json);
  if (arguments.dryRun) {
    return runDry(arguments, common, console);
  }
  const Result<fetch::AirfieldFiles> files = fetch::updateAirfields(arguments.request, console.job());
  console.finishProgress();
  if (!files) {
    return report(files.error(), common.json);
  }
  if (common.json) {
    fmt::print("{}", jsonText(Json{{"airports", files->airports},
                                   {"runways", files->runways},
                                   {"fetched", files->fetched},
                                   {"wasUpToDate", files->wasUpToDate},
                                   {"landingSites", files->sites},
                                   {"bytes", files->bytes}}));
  } else if (!common.quiet) {
    if (files->wasUpToDate) {
      fmt::print("the airfields of {} are up to date\n", files->fetched);
    } else {
      fmt::print("airfields of {}: {} landing sites ({})\n", files->fetched, files->sites, fetch::bytesInWords(files->bytes));
    }
    fmt::print("  {}\n  {}\nAirfields: OurAirports, public domain.\n", files->airports, files->runways);
    fmt::print("new-mission and fetch-terrain --around use them unless told otherwise\n");
  }
  return kDone;
}

}  // namespace

void addFetchAirfieldsCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<FetchAirfieldsArguments>();
  CLI::App* command = app.add_subcommand("fetch-airfields", "Fetch or update the airfields of the world (OurAirports)");
  command->add_option("--cache", arguments->request.cache, "Folder for what is fetched; default $XDG_CACHE_HOME/volplane or ~/.cache/volplane");
  command->add_option("--base-url", arguments->request.server,
                      "Another server with airports.csv and runways.csv; default VOLPLANE_AIRFIELDS_URL or OurAirports");
  command->add_flag("--dry-run", arguments->dryRun, "Only say what would be fetched");
  command->callback([arguments, &common, &status] { status = runFetchAirfields(*arguments, common); });
}

}  // namespace vp::cli
