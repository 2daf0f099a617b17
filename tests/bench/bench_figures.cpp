// The data of Figs. 11 to 15 of the source paper [1] on the bundled mountain, as CSV, SVG and PNG. Ten runs each, every run with
// random targets of its own (fixed seeds); lines are medians, bands the runs between the quantiles 20 and 80 %.
//   bench_figures [--short] [--out FOLDER]      --short: three runs, n up to 20, no BASE with k=16
#include "tests/bench/bench_support.h"
#include "tests/bench/plot.h"

#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QPainter>
#include <QSvgRenderer>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <tuple>

namespace {

using namespace vp;
using bench::Plot;
using bench::PlotLine;
using bench::PlotPoint;
using mission::Method;

constexpr const char* kBaseColor = "#b3261e";
constexpr const char* kLazyColor = "#1f5fa8";
constexpr const char* kThirdColor = "#2e7d32";
constexpr const char* kFourthColor = "#8e5a00";

/// What one run is made of.
struct Setup {
  Method method = Method::Lazy;
  int targets = 10;
  int headings = 8;
  double step = 50.0;  // m
  auto operator<=>(const Setup&) const = default;
};

/// What a run gave: processor seconds, counts, metres.
struct Run {
  double total = 0.0;
  tour::PlanTimes times;
  double queries = 0.0;
  double length = 0.0;
};

/// Targets at random places of the mountain, 100 m above ground and at least 200 m apart; the same for the same run and number.
tour::PlanInput withRandomTargets(tour::PlanInput input, int count, int run) {
  constexpr double kReach = 2200.0;  // m from the middle of the 5 x 5 km
  constexpr double kApart = 200.0;
  constexpr double kHeight = 100.0;
  std::mt19937_64 engine(static_cast<std::uint64_t>(1000 * count + run));
  const auto unit = [&engine] { return static_cast<double>(engine() >> 11) * 0x1.0p-53; };
  input.targets.clear();
  input.mission.targets.clear();
  while (static_cast<int>(input.targets.size()) < count) {
    const geo::Point point{kReach * (2.0 * unit() - 1.0), kReach * (2.0 * unit() - 1.0)};
    if (std::any_of(input.targets.begin(), input.targets.end(), [&](const auto& other) { return geo::distance(other.point, point) < kApart; })) {
      continue;
    }
    mission::TargetInFrame target;
    target.target.name = fmt::format("T{}", input.targets.size() + 1);
    target.target.position = input.frame.toLatLon(point);
    target.target.height_m = kHeight;
    target.point = input.frame.toPoint(target.target.position);
    target.altitude = input.terrain->upperAt(target.point) + kHeight;
    input.mission.targets.push_back(target.target);
    input.targets.push_back(target);
  }
  return input;
}

/// Makes runs once and keeps them, as figures share some.
class Runs {
public:
  Runs(tour::PlanInput mountain, int count) : mountain_(std::move(mountain)), count_(count) {
    mountain_.mission.planner.refine = mission::Refine::None;  // what the paper did
  }

  [[nodiscard]] int count() const { return count_; }

  /// Null if there is no plan.
  const Run* of(const Setup& setup, int run) {
    const auto key = std::make_tuple(setup, run);
    if (const auto known = runs_.find(key); known != runs_.end()) {
      return known->second ? &*known->second : nullptr;
    }
    tour::PlanInput input = withRandomTargets(mountain_, setup.targets, run);
    input.mission.planner.method = setup.method;
    input.mission.planner.headings = setup.headings;
    input.mission.planner.step = Length::fromSi(setup.step);
    input.mission.planner.seed = static_cast<std::uint64_t>(run) + 1;
    Run made;
    const double start = bench::cpuSeconds();
    const Result<mission::Plan> plan = tour::planTour(input, Job{}, &made.times);
    made.total = bench::cpuSeconds() - start;
    const std::string name = fmt::format("n={} k={} d_step={:g} run {}", setup.targets, setup.headings, setup.step, run);
    std::optional<Run>& kept = runs_[key];
    if (!plan) {
      bench::countFailure(name, plan.error());
      return nullptr;
    }
    bench::verify(name, input, *plan);
    made.queries = static_cast<double>(plan->metrics.safeQueries);
    made.length = plan->metrics.length;
    kept = made;
    return &*kept;
  }

  /// Median and band of some figure of the runs of a setup; with the number of the run.
  PlotPoint over(const Setup& setup, double x, const std::function<double(const Run&, int)>& figure) {
    std::vector<double> values;
    for (int run = 0; run < count_; ++run) {
      if (const Run* made = of(setup, run)) {
        values.push_back(figure(*made, run));
      }
    }
    std::sort(values.begin(), values.end());
    const auto quantile = [&](double q) {
      const double place = q * static_cast<double>(values.size() - 1);
      const auto below = static_cast<std::size_t>(place);
      const std::size_t above = std::min(below + 1, values.size() - 1);
      return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
    };
    return values.empty() ? PlotPoint{x, NAN, NAN, NAN} : PlotPoint{x, quantile(0.2), quantile(0.5), quantile(0.8)};
  }

private:
  tour::PlanInput mountain_;
  int count_;
  std::map<std::tuple<Setup, int>, std::optional<Run>> runs_;
};

double totalOf(const Run& run, int) {
  return run.total;
}

PlotLine paper(const char* name, const char* color, std::vector<std::pair<double, double>> values) {
  PlotLine line{name, color, true, {}};
  for (const auto& [x, y] : values) {
    line.points.push_back({x, y, y, y});
  }
  return line;
}

std::vector<double> asDoubles(const std::vector<int>& values) {
  return {values.begin(), values.end()};
}

std::string noteOf(const Runs& runs, const std::string& text) {
  return fmt::format("{}; median of {} runs, band: quantiles 20 and 80 %", text, runs.count());
}

Plot figure11(Runs& runs, bool isShort) {
  Plot plot{"Fig. 11: time by heading samples, n = 10",
            noteOf(runs, "d_step = 50 m, roadmap included"),
            "heading samples k",
            "processor time [s]",
            {4, 8, 16},
            true,
            true,
            {}};
  PlotLine base{"BASE", kBaseColor, false, {}};
  PlotLine lazy{"LAZY", kLazyColor, false, {}};
  for (const int k : {4, 8, 16}) {
    if (!isShort || k < 16) {
      base.points.push_back(runs.over({Method::Base, 10, k, 50.0}, k, totalOf));
    }
    lazy.points.push_back(runs.over({Method::Lazy, 10, k, 50.0}, k, totalOf));
  }
  plot.lines = {base, lazy};
  return plot;
}

Plot figure12(Runs& runs, const std::vector<int>& sizes) {
  Plot plot{"Fig. 12: time by number of targets, k = 8",
            noteOf(runs, "d_step = 50 m, roadmap included"),
            "targets n",
            "processor time [s]",
            asDoubles(sizes),
            true,
            true,
            {}};
  PlotLine base{"BASE", kBaseColor, false, {}};
  PlotLine lazy{"LAZY", kLazyColor, false, {}};
  for (const int n : sizes) {
    if (n <= 20) {  // where BASE of [1] ended within 24 hours, too
      base.points.push_back(runs.over({Method::Base, n, 8, 50.0}, n, totalOf));
    }
    lazy.points.push_back(runs.over({Method::Lazy, n, 8, 50.0}, n, totalOf));
  }
  plot.lines = {base, lazy, paper("BASE, [1] Table 2", kBaseColor, {{5, 1507}, {20, 15044}}),
                paper("LAZY, [1] Table 2", kLazyColor, {{5, 533}, {20, 385}})};
  return plot;
}

Plot figure13(Runs& runs, const std::vector<int>& sizes) {
  Plot plot{"Fig. 13: time of the steps of LAZY, k = 8", noteOf(runs, "d_step = 30 m"), "targets n", "time [s]", asDoubles(sizes), true, true, {}};
  PlotLine roadmap{"roadmap", kThirdColor, false, {}};
  PlotLine safe{"safe trajectories", kBaseColor, false, {}};
  PlotLine solver{"tour solver", kLazyColor, false, {}};
  PlotLine rest{"pitch limits, loop", kFourthColor, false, {}};
  for (const int n : sizes) {
    const Setup setup{Method::Lazy, n, 8, 30.0};
    roadmap.points.push_back(runs.over(setup, n, [](const Run& run, int) { return run.times.roadmap; }));
    safe.points.push_back(runs.over(setup, n, [](const Run& run, int) { return run.times.terrainSegments + run.times.safeSegments; }));
    solver.points.push_back(runs.over(setup, n, [](const Run& run, int) { return run.times.tourSolver; }));
    rest.points.push_back(runs.over(setup, n, [](const Run& run, int) { return run.times.assembly; }));
  }
  plot.lines = {roadmap,
                safe,
                solver,
                rest,
                paper("safe, [1] Table 2*", kBaseColor, {{5, 497}, {20, 268}}),
                paper("solver, [1] Table 2*", kLazyColor, {{5, 6}, {20, 87}})};
  plot.note += "; * with d_step = 50 m";
  return plot;
}

Plot figure14(Runs& runs, bool isShort) {
  Plot plot{"Fig. 14: safe-altitude queries of LAZY, relative to BASE",
            noteOf(runs, "d_step = 50 m"),
            "heading samples k",
            "queries of LAZY / BASE [%]",
            {4, 8, 16},
            true,
            true,
            {}};
  const char* const colors[] = {kBaseColor, kLazyColor, kThirdColor};
  int color = 0;
  for (const int n : {5, 10, 20}) {
    PlotLine line{fmt::format("n = {}", n), colors[color++], false, {}};
    for (const int k : {4, 8, 16}) {
      if (k == 16 && (isShort || n == 20)) {  // BASE n=20 k=16: half a minute a run
        continue;
      }
      line.points.push_back(runs.over({Method::Lazy, n, k, 50.0}, k, [&](const Run& run, int number) {
        const Run* base = runs.of({Method::Base, n, k, 50.0}, number);
        return base != nullptr ? 100.0 * run.queries / base->queries : NAN;
      }));
    }
    plot.lines.push_back(line);
  }
  plot.lines.push_back(paper("n = 5, [1] Table 3", kBaseColor, {{4, 38.9}, {8, 41.9}}));
  plot.lines.push_back(paper("n = 20, [1] Table 3", kThirdColor, {{8, 1.76}}));
  return plot;
}

Plot figure15(Runs& runs, bool isShort) {
  Plot plot{"Fig. 15: length of the tour, n = 10",
            noteOf(runs, "against LAZY with k = 8, d_step = 50 m on the same targets"),
            "d_step [m]",
            "length [% more]",
            {10, 30, 50, 70, 90, 100},
            false,
            false,
            {}};
  const auto relative = [&](const Run& run, int number) {
    const Run* reference = runs.of({Method::Lazy, 10, 8, 50.0}, number);
    return reference != nullptr ? 100.0 * (run.length / reference->length - 1.0) : NAN;
  };
  const char* const colors[] = {kThirdColor, kLazyColor, kFourthColor};
  int color = 0;
  for (const int k : {4, 8, 16}) {
    PlotLine line{fmt::format("LAZY k = {}", k), colors[color++], false, {}};
    for (const double step : plot.xTicks) {
      line.points.push_back(runs.over({Method::Lazy, 10, k, step}, step, relative));
    }
    plot.lines.push_back(line);
  }
  PlotLine base{"BASE k = 8", kBaseColor, false, {}};
  for (const double step : {50.0, 70.0, 90.0}) {
    if (!isShort || step == 50.0) {
      base.points.push_back(runs.over({Method::Base, 10, 8, step}, step, relative));
    }
  }
  plot.lines.push_back(base);
  return plot;
}

bool write(const Plot& plot, const std::string& stem) {
  const std::string svg = bench::toSvg(plot);
  std::string csv = fmt::format("line,source,{},low_20,median,high_80\n", plot.xLabel);
  for (const PlotLine& line : plot.lines) {
    for (const PlotPoint& point : line.points) {
      csv += fmt::format("\"{}\",{},{:g},{:.6g},{:.6g},{:.6g}\n", line.name, line.isPaper ? "paper" : "measured", point.x, point.low, point.median,
                         point.high);
    }
  }
  const auto save = [](const std::string& path, const std::string& text) {
    QFile file(QString::fromStdString(path));
    return file.open(QIODevice::WriteOnly) && file.write(text.data(), static_cast<qint64>(text.size())) == static_cast<qint64>(text.size());
  };
  QSvgRenderer renderer(QByteArray::fromStdString(svg));
  QImage image(renderer.defaultSize(), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  renderer.render(&painter);
  painter.end();
  return save(stem + ".csv", csv) && save(stem + ".svg", svg) && image.save(QString::fromStdString(stem + ".png"));
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");  // fonts only; nothing is shown
  }
  QGuiApplication application(argc, argv);
  bool isShort = false;
  std::string folder = "out/figures";
  const std::vector<std::string> words(argv + 1, argv + argc);
  for (std::size_t i = 0; i < words.size(); ++i) {
    isShort = isShort || words[i] == "--short";
    if (words[i] == "--out" && i + 1 < words.size()) {
      folder = words[++i];
    }
  }
  Result<tour::PlanInput> mountain = bench::load(VOLPLANE_SOURCE_DIR "/maps/mountain-n10.vpm");
  if (!mountain) {
    fmt::print(stderr, "{}\n", mountain.error().message());
    return 2;
  }
  std::filesystem::create_directories(folder);
  Runs runs(std::move(*mountain), isShort ? 3 : 10);
  const std::vector<int> sizes = isShort ? std::vector<int>{5, 10, 20} : std::vector<int>{5, 10, 20, 50, 100};
  const std::pair<const char*, std::function<Plot()>> figures[] = {{"fig11", [&] { return figure11(runs, isShort); }},
                                                                   {"fig12", [&] { return figure12(runs, sizes); }},
                                                                   {"fig13", [&] { return figure13(runs, sizes); }},
                                                                   {"fig14", [&] { return figure14(runs, isShort); }},
                                                                   {"fig15", [&] { return figure15(runs, isShort); }}};
  for (const auto& [name, make] : figures) {
    const auto start = bench::Clock::now();
    if (!write(make(), folder + "/" + name)) {
      fmt::print(stderr, "{}/{}: cannot be written\n", folder, name);
      return 2;
    }
    bench::print(fmt::format("figure {}", name), "time to make it", bench::secondsSince(start), "s",
                 fmt::format("{}/{}.csv, .svg, .png", folder, name));
  }
  return bench::verdict("bench_figures");
}
