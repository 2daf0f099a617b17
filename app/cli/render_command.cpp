// volplane-cli render PLAN --view map|3d|profile -o FILE.png: the pictures of the window without one, and without a display.
#include "app/cli/commands.h"
#include "app/cli/json_text.h"
#include "app/cli/verification.h"
#include "core/formats/atomic_file.h"
#include "ui/document/plan_situation.h"
#include "ui/map/render_map.h"
#include "ui/profile/profile_renderer.h"
#include "ui/scene3d/scene_picture.h"

#include <CLI/CLI.hpp>
#include <QBuffer>
#include <QGuiApplication>
#include <QImage>
#include <QTemporaryDir>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <clocale>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace vp::cli {
namespace {

struct RenderArguments {
  std::string plan;
  std::string view;
  std::string output;
  int width = 1600;
  int height = 1000;
  double scale = 1.0;
  bool dark = false;
  bool metric = false;
  bool glides = false;
  std::optional<double> at_km;
  std::string from = "north";
  double exaggeration = 1.0;
};

const std::map<std::string, scene3d::Preset> kPresets{
    {"top", scene3d::Preset::Top}, {"north", scene3d::Preset::North}, {"tour", scene3d::Preset::AlongTour}, {"runway", scene3d::Preset::FromRunway}};

Result<QImage> draw(const RenderArguments& arguments, const document::Situation& situation) {
  const style::Theme theme = arguments.dark ? style::Theme::Dark : style::Theme::Light;
  const style::Units units(arguments.metric ? style::UnitSystem::Metric : style::UnitSystem::Aviation);
  const QSize size(arguments.width, arguments.height);
  std::optional<double> cursor;
  if (arguments.at_km) {
    cursor = *arguments.at_km * 1000.0;
  }
  if (arguments.view == "map") {
    map::MapScene scene;
    scene.situation = situation;
    scene.options.allGlides = arguments.glides;
    scene.theme = theme;
    scene.units = units;
    scene.cursor = cursor;
    return map::renderMap(scene, size, arguments.scale);
  }
  if (arguments.view == "profile") {
    return profile::renderProfile(situation, size, arguments.scale, theme, units, cursor);
  }
  scene3d::SceneOptions options;
  options.allGlides = arguments.glides;
  options.verticalExaggeration = arguments.exaggeration;
  scene3d::CameraSpec camera;
  camera.preset = kPresets.at(arguments.from);
  camera.cursor = cursor;
  return scene3d::renderScene(situation, options, camera, size, theme, units, arguments.scale);
}

int runRender(const RenderArguments& arguments, const Common& common) {
  qputenv("QT_QPA_PLATFORM", "offscreen");  // no display is needed, and none is asked for
  const QTemporaryDir runtime;
  if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) {
    qputenv("XDG_RUNTIME_DIR", runtime.path().toLocal8Bit());  // where nobody logged in; Qt would say so on every run
  }
  int argc = 1;
  char name[] = "volplane-cli";
  char* argv[] = {name, nullptr};
  const QGuiApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // QGuiApplication has taken the user's; libraries that read and write files want a point
  Console console(!common.quiet && !common.json);
  const Result<document::Situation> situation = document::loadPlanSituation(arguments.plan, console.job());
  console.finishProgress();
  if (!situation) {
    return report(situation.error(), common.json);
  }
  if (!situation->plan) {
    return report(Error{Errc::OutOfRange, "the plan has no tour to draw", arguments.plan}, common.json);
  }
  const Result<QImage> image = draw(arguments, *situation);
  if (!image) {
    return report(image.error(), common.json);
  }
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image->save(&buffer, "PNG");
  const std::string_view content(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  if (const Result<void> written = formats::writeFileAtomically(arguments.output, content); !written) {
    return report(written.error(), common.json);
  }
  if (common.json) {
    fmt::print("{}", jsonText(nlohmann::ordered_json{{"file", arguments.output}, {"width", image->width()}, {"height", image->height()}}));
  } else if (!common.quiet) {
    fmt::print("{} drawn to {} ({} x {})\n", arguments.view, arguments.output, image->width(), image->height());
  }
  return kDone;
}

}  // namespace

void addRenderCommand(CLI::App& app, Common& common, int& status) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = app.add_subcommand("render", "Draw a plan as a picture: map, profile or 3D view; needs no display");
  command->add_option("plan", arguments->plan, "Plan file (*.vpp)")->required();
  command->add_option("--view", arguments->view, "map, profile or 3d")->required()->check(CLI::IsMember({"map", "profile", "3d"}));
  command->add_option("-o,--output", arguments->output, "PNG file to write")->required();
  command->add_option("--from", arguments->from, "3d: seen from above (top), facing north, along the tour, or from the runway")
      ->check(CLI::IsMember({"top", "north", "tour", "runway"}));
  command->add_option("--exaggeration", arguments->exaggeration, "3d: heights drawn so many times larger")->check(CLI::Range(1.0, 5.0));
  command->add_option("--width", arguments->width, "Pixels")->check(CLI::Range(64, 8192));
  command->add_option("--height", arguments->height, "Pixels")->check(CLI::Range(64, 8192));
  command->add_option("--scale", arguments->scale, "Size of text and lines, and pixels per point")->check(CLI::Range(1.0, 4.0));
  command->add_option("--at", arguments->at_km, "Show the landing glide from this distance along the tour, km");
  command->add_flag("--glides", arguments->glides, "Show the landing glides of all decision points");
  command->add_flag("--dark", arguments->dark, "Dark instead of light");
  command->add_flag("--metric", arguments->metric, "Metres and kilometres instead of feet and nautical miles");
  command->callback([arguments, &common, &status] { status = runRender(*arguments, common); });
}

}  // namespace vp::cli
