// The OurAirports files of the whole world (85 k airports, 48 k runways): reading and filtering them, as the list of airfields does.
//   bench_airfields [AIRPORTS.csv[.gz] RUNWAYS.csv[.gz]]     without files those of the folder with real data
#include "core/formats/airfields.h"
#include "tests/bench/bench_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace vp;

constexpr int kRuns = 3;
constexpr double kAsked = 1.0;  // s

bool measure(const std::string& name, const mission::AirfieldSource& source, const mission::SiteFilter& filter) {
  double best = INFINITY;
  std::size_t sites = 0;
  for (int run = 0; run < kRuns; ++run) {
    const auto start = bench::Clock::now();
    const Result<formats::AirfieldReport> report = formats::readAirfields(source, ".", filter, {});
    best = std::min(best, bench::secondsSince(start));
    if (!report) {
      fmt::print(stderr, "{}\n", report.error().message());
      return false;
    }
    sites = report->sites.size();
  }
  bench::print(name, "read and filter", best, "s", fmt::format("asked; best of {}", kRuns), kAsked);
  bench::print(name, "landing sites", static_cast<double>(sites), "");
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  mission::AirfieldSource source;
  if (argc == 3) {
    source = {argv[1], argv[2]};
  } else if (const std::string folder = bench::dataFolder(); !folder.empty()) {
    source = {folder + "/airports/ourairports_airports.csv.gz", folder + "/airports/ourairports_runways.csv.gz"};
  } else {
    fmt::print(stderr, "bench_airfields: the folder with real airfields is not here; set VOLPLANE_DATA to it\n");
    return 0;
  }
  mission::SiteFilter strict;
  strict.minLength = Length::fromSi(600.0);
  strict.minWidth = Length::fromSi(15.0);
  strict.surfaces = {mission::Surface::Hard, mission::Surface::Grass};
  return measure("airfields, all", source, {}) && measure("airfields, long and paved or grass", source, strict) ? 0 : 1;
}
