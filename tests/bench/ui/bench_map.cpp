// Map redraw while panning and zooming terrain of 20 million cells: bench_map [RASTER], one JSON object per terrain and line.
// Times are those of repaint() on the GUI thread; tiles are painted on workers meanwhile.
#include "core/terrain/terrain_reader.h"
#include "ui/document/terrain_data.h"
#include "ui/document/view_state.h"
#include "ui/map/map_view.h"

#include <QApplication>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <sys/resource.h>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kSide = 4472;     // 4472^2 = 20.0 million cells
constexpr double kCell = 30.0;  // m
constexpr int kFrames = 300;
constexpr int kWidth = 1280;
constexpr int kHeight = 800;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double peakMegabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

std::shared_ptr<const vp::document::TerrainData> rollingHills() {
  std::vector<float> heights(static_cast<std::size_t>(kSide) * kSide);
  for (int j = 0; j < kSide; ++j) {
    for (int i = 0; i < kSide; ++i) {
      const double x = i * 0.011;
      const double y = j * 0.013;
      heights[static_cast<std::size_t>(j) * kSide + static_cast<std::size_t>(i)] =
          static_cast<float>(1500.0 + 700.0 * std::sin(x) * std::cos(y) + 250.0 * std::sin(5.1 * x + 2.0 * y) + 60.0 * std::sin(23.0 * y - 17.0 * x));
    }
  }
  auto grid = std::make_shared<const vp::terrain::ElevationGrid>(-0.5 * kSide * kCell, -0.5 * kSide * kCell, kCell, kSide, kSide, std::move(heights));
  return vp::document::makeTerrainData(vp::geo::LocalFrame({46.5, 9.0}), std::move(grid), {});
}

std::shared_ptr<const vp::document::TerrainData> readRaster(const std::string& path) {
  const auto info = vp::terrain::inspectTerrain({path});
  if (!info) {
    fmt::print(stderr, "bench_map: {}\n", info.error().message());
    return nullptr;
  }
  const vp::geo::LocalFrame frame(info->centre());
  auto grid = vp::terrain::readTerrain({path}, frame, {}, vp::Job());
  if (!grid) {
    fmt::print(stderr, "bench_map: {}\n", grid.error().message());
    return nullptr;
  }
  return vp::document::makeTerrainData(frame, std::make_shared<const vp::terrain::ElevationGrid>(std::move(*grid)), {});
}

/// Targets and runways all over the terrain, so that labels count too.
vp::document::Situation crowded(const std::shared_ptr<const vp::document::TerrainData>& terrain) {
  vp::document::Situation situation;
  situation.terrain = terrain;
  auto targets = std::make_shared<std::vector<vp::document::ShownTarget>>();
  auto sites = std::make_shared<std::vector<vp::document::ShownSite>>();
  const vp::geo::Box box = terrain->grid->extent();
  for (int i = 0; i < 200; ++i) {
    const vp::geo::Point at{box.minX + (box.maxX - box.minX) * std::fmod(0.5 + i * 0.754877666, 1.0),
                            box.minY + (box.maxY - box.minY) * std::fmod(0.5 + i * 0.569840291, 1.0)};
    if (i % 2 == 0) {
      vp::document::ShownTarget target;
      target.target.name = "T" + std::to_string(i);
      target.point = at;
      targets->push_back(target);
    } else {
      vp::document::ShownSite site;
      site.site.site.id = "LS" + std::to_string(i) + "/09";
      site.site.site.airportIdent = "LS" + std::to_string(i);
      site.site.site.runwayIdent = "09";
      site.site.pose = {at.x, at.y, 0.0};
      sites->push_back(site);
    }
  }
  situation.targets = targets;
  situation.sites = sites;
  return situation;
}

void waitForTiles(vp::map::MapView& view) {
  do {
    view.repaint();
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
  } while (!view.isComplete());
}

void measure(const std::string& name, const std::shared_ptr<const vp::document::TerrainData>& terrain) {
  vp::document::ViewState state;
  vp::map::MapView view(state);
  view.resize(kWidth, kHeight);
  view.show();
  const auto start = Clock::now();
  view.setSituation(crowded(terrain));
  view.setCamera(vp::map::MapCamera({}, 64.0, {}));
  waitForTiles(view);
  const double first = millisecondsSince(start);

  double sum = 0.0;
  double worst = 0.0;
  int complete = 0;
  for (int frame = 0; frame < kFrames; ++frame) {
    view.setCamera(view.camera().panned({-11.0 * std::cos(0.02 * frame), 7.0}));
    const auto begin = Clock::now();
    view.repaint();
    const double took = millisecondsSince(begin);
    sum += took;
    worst = std::max(worst, took);
    complete += view.isComplete() ? 1 : 0;
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
  }

  double zoomSum = 0.0;
  constexpr int kZooms = 40;
  for (int frame = 0; frame < kZooms; ++frame) {
    view.setCamera(view.camera().zoomedAt({400.0, 300.0}, frame < kZooms / 2 ? 1.2 : 1.0 / 1.2));
    const auto begin = Clock::now();
    view.repaint();
    zoomSum += millisecondsSince(begin);
    QCoreApplication::processEvents(QEventLoop::AllEvents, 5);
  }
  const auto print = [&name](const char* metric, double value, const char* unit, double reference) {
    fmt::print("{{\"bench\": \"map {}\", \"metric\": \"{}\", \"value\": {:.4g}, \"unit\": \"{}\", \"reference\": {:.4g}, \"note\": \"{}x{}\"}}\n",
               name, metric, value, unit, reference, kWidth, kHeight);
  };
  print("cells", static_cast<double>(terrain->grid->values().size()), "", 0.0);
  print("first complete picture", first, "ms", 0.0);
  print("redraw while panning, mean", sum / kFrames, "ms", 16.0);
  print("redraw while panning, worst", worst, "ms", 0.0);
  print("complete pictures while panning", static_cast<double>(complete) / kFrames, "", 1.0);
  print("redraw while zooming, mean", zoomSum / kZooms, "ms", 0.0);
  print("peak memory", peakMegabytes(), "MB", 1500.0);
}

}  // namespace

int main(int argc, char** argv) {
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  const QApplication application(argc, argv);
  measure("rolling hills", rollingHills());
  for (int i = 1; i < argc; ++i) {
    const auto terrain = readRaster(argv[i]);
    if (terrain == nullptr) {
      return 1;
    }
    measure(argv[i], terrain);
  }
  return 0;
}
