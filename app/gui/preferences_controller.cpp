#include "app/gui/preferences_controller.h"

#include "ui/document/settings.h"
#include "ui/style/core_text.h"
#include "ui/style/theme.h"

#include <array>
#include <utility>

namespace vp::gui {
namespace {

using Flag = std::pair<const char*, bool scene3d::SceneOptions::*>;
constexpr std::array kSceneFlags{
    Flag{"curtain", &scene3d::SceneOptions::curtain}, Flag{"allGlides", &scene3d::SceneOptions::allGlides},
    Flag{"runways", &scene3d::SceneOptions::runways}, Flag{"excludedRunways", &scene3d::SceneOptions::excludedRunways},
    Flag{"labels", &scene3d::SceneOptions::labels},
};
constexpr const char* kExaggeration = "verticalExaggeration";
constexpr double kMostExaggeration = 5.0;  // as SceneOptions says

QVariantMap toMap(const scene3d::SceneOptions& options) {
  QVariantMap map{{QLatin1String(kExaggeration), options.verticalExaggeration}};
  for (const auto& [name, flag] : kSceneFlags) {
    map.insert(QLatin1String(name), options.*flag);
  }
  return map;
}

/// Entries that are missing or senseless keep their defaults.
scene3d::SceneOptions sceneOptions(const QVariantMap& map) {
  scene3d::SceneOptions options;
  bool ok = false;
  const double exaggeration = map.value(QLatin1String(kExaggeration)).toString().toDouble(&ok);
  if (ok && exaggeration >= 1.0 && exaggeration <= kMostExaggeration) {
    options.verticalExaggeration = exaggeration;
  }
  for (const auto& [name, flag] : kSceneFlags) {
    const QString text = map.value(QLatin1String(name)).toString();
    if (text == QLatin1String("true") || text == QLatin1String("false")) {
      options.*flag = text == QLatin1String("true");
    }
  }
  return options;
}

}  // namespace

PreferencesController::PreferencesController(jobs::Workspace& workspace, const QString& iniFile, QWidget* window)
    : QObject(window), workspace_(workspace), iniFile_(iniFile), window_(window) {
  const document::Settings settings(iniFile_);
  now_.units = settings.unitSystem();
  now_.theme = settings.theme();
  now_.language = settings.language();
  now_.newMissions = settings.missionDefaults();
  now_.scene = sceneOptions(settings.sceneOptions());
  apply();
}

void PreferencesController::apply() {
  workspace_.view().setUnits(style::Units(now_.units));
  workspace_.view().setTheme(now_.theme.value_or(style::systemTheme()));
  workspace_.document().setDefaults(now_.newMissions);
}

void PreferencesController::set(const dialogs::Preferences& preferences) {
  if (preferences == now_) {
    return;
  }
  const dialogs::Preferences before = std::exchange(now_, preferences);
  document::Settings settings(iniFile_);
  settings.setUnitSystem(now_.units);
  settings.setTheme(now_.theme);
  settings.setLanguage(now_.language);
  settings.setMissionDefaults(now_.newMissions);
  if (!(now_.scene == before.scene)) {
    settings.setSceneOptions(toMap(now_.scene));
  }
  const Result<void> saved = settings.save();
  apply();
  emit changed();
  if (!saved) {
    emit notRemembered(style::coreText(saved.error()));
  }
}

void PreferencesController::setUnits(style::UnitSystem units) {
  dialogs::Preferences next = now_;
  next.units = units;
  set(next);
}

void PreferencesController::setTheme(std::optional<style::Theme> theme) {
  dialogs::Preferences next = now_;
  next.theme = theme;
  set(next);
}

void PreferencesController::setScene(const scene3d::SceneOptions& options) {
  dialogs::Preferences next = now_;
  next.scene = options;
  set(next);
}

void PreferencesController::openDialog() {
  dialogs::PreferencesDialog dialog(now_, workspace_.document().title(), window_);
  connect(&dialog, &dialogs::PreferencesDialog::changed, this, &PreferencesController::set);
  bool leadsToMission = false;
  connect(&dialog, &dialogs::PreferencesDialog::missionSettingsRequested, &dialog, [&] {
    leadsToMission = true;
    dialog.accept();
  });
  dialog.exec();
  if (leadsToMission) {
    emit missionSettingsRequested();
  }
}

}  // namespace vp::gui
