// The 108 cases of [3] section 6.3 beside its Tables 3 to 5: solved within 1 s, time, overflown population risk per altitude of the search and of the
// best Dubins way. Every path is judged by the checker outside the timed part; one that it refuses counts as not solved and ends the program with 1.
//   bench_contingency [--cases]      --cases: a line for each case on stderr
#include "core/emergency/contingency.h"
#include "core/emergency/gradient_planner.h"
#include "core/emergency/landing_outcome.h"
#include "core/emergency/verified_answer.h"
#include "core/risk/people_under.h"
#include "tests/bench/bench_support.h"
#include "tests/support/contingency_cases.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <vector>

using namespace vp;

namespace {

struct Published {
  double search = 0.0;  ///< median population risk, Table 3
  double dubins = 0.0;
  double searchMs = 0.0;  ///< median runtime, Table 4
  int solved = 0;         ///< of 36 within 1 s, Table 5
};

const std::map<double, Published> kPublished{
    {4000.0, {0.0223, 0.0446, 466.3, 28}}, {6000.0, {0.0153, 0.0433, 598.3, 22}}, {10000.0, {0.0239, 0.0244, 567.6, 25}}};

double quantile(std::vector<double> values, double share) {
  if (values.empty()) {
    return NAN;
  }
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
}

double median(const std::vector<double>& values) {
  return 0.5 * (quantile(values, 0.5) + quantile(values, 0.4999999));
}

struct Figures {
  std::vector<double> search;    ///< population risk of the search alone
  std::vector<double> dubins;    ///< of the best Dubins way
  std::vector<double> planned;   ///< of Algorithm 2: the better of both
  std::vector<double> ms;        ///< processor time of Algorithm 2
  std::vector<double> searchMs;  ///< of Algorithm 1
  std::vector<double> dubinsMs;
  int solved = 0;     ///< by the search, within 1 s and verified
  int available = 0;  ///< by Algorithm 2
};

bool isVerified(const emergency::LandingRequest& request, const std::optional<mission::LandingPath>& path, const char* what) {
  emergency::LandingAnswer answer;
  answer.planner = what;
  answer.path = path;
  answer = emergency::verifiedAnswer(request, std::move(answer));
  if (!answer.verified) {
    fmt::print(stderr, "{} from {:.0f}, {:.0f} at {:.0f} m: {}\n", what, request.pose.x, request.pose.y, request.altitude, answer.whyNot);
  }
  return answer.verified;
}

}  // namespace

int main(int argc, char** argv) {
  const bool showsCases = argc > 1 && std::strcmp(argv[1], "--cases") == 0;
  const std::string data = bench::dataFolder();
  if (data.empty()) {
    fmt::print(stderr, "bench_contingency: no folder with real data (VOLPLANE_DATA), nothing measured\n");
    return 0;
  }
  const auto setting = test::contingencySetting(data + "/census/suffolk_tracts_pop.geojson");
  if (!setting) {
    fmt::print(stderr, "bench_contingency: {}\n", setting.error().message());
    return 1;
  }
  const emergency::GradientOptions options;
  const auto before = bench::Clock::now();
  const auto holds = std::make_shared<const emergency::HoldingAreas>(*setting->population, emergency::searchRadius(*setting->world, options));
  bench::print("[3] holding areas, offline", "time", 1e3 * bench::secondsSince(before), "ms", fmt::format("{} areas", holds->all().size()));
  const emergency::GradientPlanner planner(options, holds);
  std::map<double, Figures> figures;
  int refused = 0;
  for (const test::ContingencyCase& one : test::contingencyCases(*setting)) {
    emergency::LandingRequest request = test::requestOf(*setting, one);
    request.risk = std::make_shared<const risk::PeopleUnder>(setting->population, setting->world->glide.airspeed(), options.crossover.si());
    request.risk = emergency::descentRiskOf(request, setting->approach, options);
    Figures& at = figures[one.altitude_ft];

    double cpu = bench::cpuSeconds();
    emergency::Contingency direct(request, setting->approach, options, nullptr);
    const emergency::BestDescent& dubins = direct.dubins();
    at.dubinsMs.push_back(1e3 * (bench::cpuSeconds() - cpu));
    const auto start = bench::Clock::now();
    cpu = bench::cpuSeconds();
    emergency::Contingency algorithm1(request, setting->approach, options, holds.get());
    const emergency::BestDescent& search = algorithm1.search({}, emergency::Countdown(request));
    const double searchSeconds = bench::secondsSince(start);
    at.searchMs.push_back(1e3 * (bench::cpuSeconds() - cpu));
    cpu = bench::cpuSeconds();
    const emergency::LandingAnswer answer = planner.plan(request);
    at.ms.push_back(1e3 * (bench::cpuSeconds() - cpu));

    const bool isSearched = search.path().has_value() && isVerified(request, search.path(), "search");
    refused += search.path().has_value() && !isSearched ? 1 : 0;
    const bool isDirect = dubins.path().has_value() && isVerified(request, dubins.path(), "dubins");
    refused += dubins.path().has_value() && !isDirect ? 1 : 0;
    const bool isPlanned = answer.reachesRunway() && isVerified(request, answer.path, "gradient");
    refused += answer.reachesRunway() && !isPlanned ? 1 : 0;
    if (isSearched) {
      at.search.push_back(search.risk());
      at.solved += searchSeconds <= 1.0 ? 1 : 0;
    }
    if (isDirect) {
      at.dubins.push_back(dubins.risk());
    }
    if (isPlanned) {
      at.planned.push_back(emergency::riskOf(request, *answer.path));
      at.available += answer.seconds <= 1.0 ? 1 : 0;
    }
    if (showsCases) {
      fmt::print(stderr,
                 "{:6.0f} ft {:6.0f} {:6.0f} {:4.0f} deg: search {:.4f} ({:.1f} ms, {} expanded, {} connected{}, {:.0f} m high), Dubins {:.4f} "
                 "({:.1f} ms, {:.0f} m high)\n",
                 one.altitude_ft, one.pose.x, one.pose.y, Angle::radians(one.pose.heading).degrees(), search.risk(), at.searchMs.back(),
                 algorithm1.count().expanded, algorithm1.count().connected, algorithm1.isHolding() ? ", hold" : "", search.surplus(), dubins.risk(),
                 at.dubinsMs.back(), dubins.surplus());
    }
  }
  int solved = 0;
  int available = 0;
  std::vector<double> ms;
  std::vector<double> searchMs;
  for (const auto& [altitude, at] : figures) {
    const Published& published = kPublished.at(altitude);
    const std::string name = fmt::format("[3] {:.0f} ft", altitude);
    bench::print(name, "search: median population risk", median(at.search), "", "Table 3", published.search);
    bench::print(name, "best Dubins: median population risk", median(at.dubins), "", "Table 3", published.dubins);
    bench::print(name, "planned, the better of both: median population risk", median(at.planned));
    bench::print(name, "search: solved within 1 s of 36", at.solved, "", "Table 5", published.solved);
    bench::print(name, "search: median processor time", median(at.searchMs), "ms", "Table 4", published.searchMs);
    bench::print(name, "search: longest processor time", quantile(at.searchMs, 1.0), "ms");
    bench::print(name, "Dubins: median processor time", median(at.dubinsMs), "ms");
    solved += at.solved;
    available += at.available;
    ms.insert(ms.end(), at.ms.begin(), at.ms.end());
    searchMs.insert(searchMs.end(), at.searchMs.begin(), at.searchMs.end());
  }
  bench::print("[3] 108 cases", "search: solved within 1 s", solved, "of 108", "Table 5", 75);
  bench::print("[3] 108 cases", "planned: available within 1 s", available, "of 108");
  bench::print("[3] 108 cases", "search: median processor time", median(searchMs), "ms", "to reach", 30);
  bench::print("[3] 108 cases", "planned: median processor time", median(ms), "ms", "to reach", 30);
  bench::print("[3] 108 cases", "paths that the checker refused", refused, "", "to reach", 0);
  return refused == 0 ? 0 : 1;
}
