// Time of one connection in wind, over random connections with a fixed seed: the quickest path and the one of least height loss.
// Every connection is timed alone, the clock's own time included. One line for each reach and figure, as JSON for packaging/bench.
//   bench_wind [CONNECTIONS]      20000 unless told
#include "core/base/quantity.h"
#include "core/flight/wind_dubins.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

namespace {

using namespace vp;
using namespace vp::flight;

constexpr double kRadius = 65.7;    // m
constexpr double kAirspeed = 33.4;  // m/s
constexpr TurnLoss kLoss{0.0857, 0.232};

struct Connection {
  geo::Pose from;
  geo::Pose to;
  air::Wind wind;
};

/// Places up to `reach` radii apart, winds up to 0.9 airspeeds, all directions.
std::vector<Connection> randomConnections(int count, double reach) {
  std::mt19937_64 engine(20201116);
  const auto unit = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  const auto angle = [&unit] { return 2.0 * Angle::kPi * unit(); };
  std::vector<Connection> connections;
  for (int i = 0; i < count; ++i) {
    const double distance = reach * kRadius * unit();
    const double direction = angle();
    const double speed = 0.9 * kAirspeed * unit();
    const double towards = angle();
    connections.push_back({{0.0, 0.0, angle()},
                           {distance * std::cos(direction), distance * std::sin(direction), angle()},
                           {speed * std::cos(towards), speed * std::sin(towards)}});
  }
  return connections;
}

/// Times each connection and writes median and quantile 99 %. @return false if one was refused
template <typename Connect>
bool measure(const char* name, double reach, const std::vector<Connection>& connections, const Connect& connect) {
  std::vector<double> microseconds;
  bool isComplete = true;
  for (const Connection& connection : connections) {
    const auto start = std::chrono::steady_clock::now();
    const Result<WindPath> path = connect(connection);
    microseconds.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
    isComplete = isComplete && path.has_value();
  }
  std::sort(microseconds.begin(), microseconds.end());
  const auto quantile = [&microseconds](double q) {
    return microseconds[static_cast<std::size_t>(q * static_cast<double>(microseconds.size() - 1))];
  };
  constexpr const char* kLine = R"~({{"bench": "wind, up to {:g} radii", "metric": "{}, {}", "value": {:.3f}, "unit": "us"{}}})~"
                                "\n";
  fmt::print(kLine, reach, name, "median", quantile(0.5), R"~(, "reference": 3, "note": "to reach")~");
  fmt::print(kLine, reach, name, "quantile 99 %", quantile(0.99), "");
  return isComplete;
}

}  // namespace

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::max(1, std::atoi(argv[1])) : 20000;
  bool isComplete = true;
  for (const double reach : {5.0, 50.0}) {
    const std::vector<Connection> connections = randomConnections(count, reach);
    isComplete =
        measure("quickest", reach, connections, [](const Connection& c) { return shortestTime(c.from, c.to, kRadius, kAirspeed, c.wind); }) &&
        isComplete;
    isComplete =
        measure("least loss", reach, connections, [](const Connection& c) { return leastLoss(c.from, c.to, kRadius, kAirspeed, c.wind, kLoss); }) &&
        isComplete;
  }
  if (!isComplete) {
    fmt::print(stderr, "bench_wind: a connection was refused\n");
  }
  return isComplete ? 0 : 1;
}
