// Measures reading and filtering the whole OurAirports data: bench_airfields AIRPORTS RUNWAYS, one JSON object.
#include "core/formats/airfields.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

int main(int argc, char** argv) {
  using namespace vp;
  using Clock = std::chrono::steady_clock;
  if (argc != 3) {
    std::fputs("bench_airfields AIRPORTS.csv[.gz] RUNWAYS.csv[.gz]\n", stderr);
    return 2;
  }
  mission::SiteFilter strict;
  strict.minLength = Length::fromSi(600.0);
  strict.minWidth = Length::fromSi(15.0);
  strict.surfaces = {mission::Surface::Hard, mission::Surface::Grass};
  std::string line = "{";
  for (const auto& [name, filter] : {std::pair("all", mission::SiteFilter()), std::pair("filtered", strict)}) {
    double best = 1e9;
    std::size_t sites = 0;
    std::ptrdiff_t unknown = 0;
    for (int run = 0; run < 3; ++run) {
      const auto start = Clock::now();
      const Result<formats::AirfieldReport> report = formats::readAirfields({argv[1], argv[2]}, ".", filter, {});
      best = std::min(best, std::chrono::duration<double>(Clock::now() - start).count());
      if (!report) {
        std::fputs((report.error().message() + "\n").c_str(), stderr);
        return 1;
      }
      sites = report->sites.size();
      unknown = std::count_if(report->sites.begin(), report->sites.end(), [](const auto& s) { return s.surface == mission::Surface::Unknown; });
    }
    line += fmt::format("{}\"{}\": {{\"seconds\": {:.3f}, \"sites\": {}, \"unknown_surface\": {}}}", line.size() > 1 ? ", " : "", name, best, sites,
                        unknown);
  }
  std::puts((line + "}").c_str());
  return 0;
}
