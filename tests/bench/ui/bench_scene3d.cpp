// Measures the 3D view as a processor draws it: frames of a camera that circles a map, and what the terrain costs to load.
#include "core/formats/mission_loader.h"
#include "core/formats/plan_file.h"
#include "core/terrain/terrain_reader.h"
#include "ui/scene3d/camera_presets.h"
#include "ui/scene3d/offscreen_scene.h"

#include <QGuiApplication>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

using namespace vp;

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double residentMegabytes() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line)) {
    if (line.rfind("VmRSS:", 0) == 0) {
      return std::stod(line.substr(6)) / 1024.0;
    }
  }
  return 0.0;
}

void print(const std::string& bench, const char* metric, double value, const char* unit, const char* reference = nullptr) {
  fmt::print("{{\"bench\": \"{}\", \"metric\": \"{}\", \"value\": {:.1f}, \"unit\": \"{}\"", bench, metric, value, unit);
  if (reference != nullptr) {
    fmt::print(", \"reference\": {}, \"note\": \"wanted\"", reference);
  }
  fmt::print("}}\n");
}

/// Ridges and valleys on several scales, from formulas.
std::shared_ptr<const document::TerrainData> syntheticTerrain(int columns, int rows) {
  std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      double height = 1200.0;
      double amplitude = 900.0;
      double wave = 0.0021;
      for (int octave = 0; octave < 6; ++octave) {
        height += amplitude *
                  (1.0 - 2.0 * std::abs(std::sin(wave * i + 0.7 * octave + 0.4 * std::sin(wave * j)) * std::cos(1.3 * wave * j - 0.9 * octave)));
        amplitude *= 0.48;
        wave *= 2.13;
      }
      values[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i)] = static_cast<float>(height);
    }
  }
  constexpr double kCell = 25.0;
  auto grid = std::make_shared<const terrain::ElevationGrid>(-0.5 * columns * kCell, -0.5 * rows * kCell, kCell, columns, rows, std::move(values));
  return document::makeTerrainData(geo::LocalFrame({46.5, 9.9}), std::move(grid), {});
}

/// A terrain file alone or, for a plan, everything.
document::Situation situationOf(const std::string& path) {
  document::Situation situation;
  if (path.ends_with(".vpp")) {
    auto plan = formats::readPlan(path);
    std::vector<std::string> checksums;
    auto grid = plan ? formats::readPlanTerrain(*plan, path.substr(0, path.find_last_of('/') + 1), checksums, Job())
                     : Result<terrain::ElevationGrid>(forward(plan));
    if (grid) {
      situation.terrain =
          document::makeTerrainData(geo::LocalFrame(plan->frameOrigin), std::make_shared<const terrain::ElevationGrid>(std::move(*grid)), {});
      situation.plan = std::make_shared<document::PlanView>(std::make_shared<const mission::Plan>(std::move(*plan)), situation.terrain);
    }
    return situation;
  }
  const auto info = terrain::inspectTerrain({path});
  if (info) {
    const geo::LocalFrame frame(info->centre());
    auto grid = terrain::readTerrain({path}, frame, {}, Job());
    if (grid) {
      situation.terrain = document::makeTerrainData(frame, std::make_shared<const terrain::ElevationGrid>(std::move(*grid)), {});
    }
  }
  return situation;
}

/// A full circle in `frames` pictures, tiles built meanwhile on their own threads as in the window.
void measure(const std::string& name, const document::Situation& situation, double nearer, int frames) {
  const double before = residentMegabytes();
  const auto start = Clock::now();
  const auto model = scene3d::TerrainModel::build(situation.terrain);
  auto layer = std::make_shared<scene3d::TerrainLayer>(model, scene3d::SceneStyle{}, nullptr);
  print(name, "terrain ready", millisecondsSince(start), "ms");
  auto offscreen = scene3d::OffscreenScene::create();
  if (!offscreen) {
    fmt::print(stderr, "bench_scene3d: {}\n", offscreen.error().message());
    return;
  }
  scene3d::CameraController controller;
  controller.setPicture(1280.0, 720.0);
  controller.setGround(scene3d::cameraGround(model, 1.0));
  scene3d::CameraOrbit orbit = scene3d::presetOrbit(scene3d::Preset::North, situation, model.get(), 1.0, {}, controller);
  orbit.distance /= nearer;
  orbit.pitch = 0.5;
  scene3d::SceneRenderer& renderer = (*offscreen)->renderer();
  renderer.setDetail({});  // as in the window while the camera moves
  renderer.setTerrain(layer);
  if (const auto scene = scene3d::buildScene(situation, model, {}, {})) {
    renderer.setScene(scene3d::buildSceneNodes(*scene, 1.0));
  }
  std::vector<double> times;
  std::clock_t processor = std::clock();
  for (int i = 0; i < 2 * frames; ++i) {
    orbit.azimuth = 2.0 * std::numbers::pi * i / frames;
    controller.jumpTo(orbit);
    const auto frame = Clock::now();
    const QImage image = (*offscreen)->render(controller.camera(), 1.0, false, false);
    times.push_back(millisecondsSince(frame));
    processor = i == frames ? std::clock() : processor;  // the second time around all tiles are there
    if (image.isNull()) {
      return;
    }
  }
  print(name, "processor time of a frame", 1000.0 * static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC / (frames - 1), "ms");
  const double first = times.front();
  std::sort(times.begin(), times.end());
  double sum = 0.0;
  for (const double t : times) {
    sum += t;
  }
  print(name, "first frame", first, "ms");
  print(name, "frame, mean", sum / static_cast<double>(times.size()), "ms", "33");
  print(name, "frame, 95 %", times[times.size() * 95 / 100], "ms");
  print(name, "frame, worst", times.back(), "ms");
  print(name, "tiles shown", static_cast<double>(layer->tilesShown()), "");
  print(name, "memory for 3D", residentMegabytes() - before, "MB", "500");
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QGuiApplication app(argc, argv);
  for (int i = 1; i < argc; ++i) {
    const document::Situation situation = situationOf(argv[i]);
    if (situation.terrain == nullptr) {
      fmt::print(stderr, "bench_scene3d: cannot read {}\n", argv[i]);
      return 1;
    }
    const std::string path = argv[i];
    measure("3D " + path.substr(path.find_last_of('/') + 1), situation, 1.0, 240);
  }
  document::Situation large;
  large.terrain = syntheticTerrain(5000, 4000);
  measure("3D 20 M cells, all of it", large, 1.0, 240);
  measure("3D 20 M cells, near", large, 12.0, 240);
  return 0;
}
