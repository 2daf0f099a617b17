// A briefing from a plan to a PDF in memory: bench_briefing [--real] PLAN|MISSION..., one JSON object per line. Missions are planned first, which is
// not counted; --real adds those over real terrain.
#include "core/formats/plan_file.h"
#include "tests/bench/bench_support.h"
#include "ui/briefing/write_briefing.h"

#include <QGuiApplication>
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <string>

namespace {

using namespace vp;

constexpr std::chrono::year_month_day kDay{std::chrono::year(2026), std::chrono::month(6), std::chrono::day(1)};

Result<mission::Plan> planOf(const Result<tour::PlanInput>& input) {
  return input ? tour::planTour(*input, Job()) : Result<mission::Plan>(forward(input));
}

void fail(const std::string& name, const Error& error) {
  fmt::print(stderr, "bench_briefing: {}: {}\n", name, error.message());
}

/// @param folder  where relative paths of the plan start   @return whether there is a briefing
bool run(const std::string& name, const Result<mission::Plan>& plan, const std::string& folder) {
  if (!plan) {
    fail(name, plan.error());
    return false;
  }
  briefing::BriefingOptions options;
  options.date = kDay;
  options.program = QStringLiteral("bench");
  const bench::Clock::time_point start = bench::Clock::now();
  const double cpu = bench::cpuSeconds();
  const auto source = briefing::briefingSource(*plan, folder, kDay, Job());
  if (!source) {
    fail(name, source.error());
    return false;
  }
  const double reading = bench::secondsSince(start);
  const auto pdf = briefing::writeBriefing(*source, options, Job());
  const double whole = bench::secondsSince(start);
  if (!pdf) {
    fail(name, pdf.error());
    return false;
  }
  bench::print("briefing " + name, "terrain, check and figures", reading, "s");
  bench::print("briefing " + name, "whole", whole, "s", "asked, for 10 pages", 3.0);
  bench::print("briefing " + name, "processor time", bench::cpuSeconds() - cpu, "s");
  bench::print("briefing " + name, "pages", briefing::pageCount(*pdf));
  bench::print("briefing " + name, "size", static_cast<double>(pdf->size()) / 1e6, "MB");
  return true;
}

bool runFile(const std::string& path) {
  const std::filesystem::path file = std::filesystem::absolute(path);
  return run(file.stem().string(), path.ends_with(".vpp") ? formats::readPlan(path) : planOf(bench::load(path)), file.parent_path().string());
}

bool runReal() {
  bool good = true;
  for (const auto& [name, mission] : bench::realMissions()) {
    good = run(name, planOf(bench::load(mission)), "") && good;
  }
  return good;
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication application(argc, argv);
  bool good = true;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    good = (argument == "--real" ? runReal() : runFile(argument)) && good;
  }
  return good ? 0 : 1;
}
