#include "ui/document/settings.h"

#include "ui/style/language.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace vp::document {
namespace {

const QString kUnits = QStringLiteral("units");
const QString kTheme = QStringLiteral("theme");
const QString kLanguage = QStringLiteral("language");
const QString kGeometry = QStringLiteral("window/geometry");
const QString kState = QStringLiteral("window/state");
const QString kFolders = QStringLiteral("folders/");
const QString kRecent = QStringLiteral("recentFiles");
const QString kScene = QStringLiteral("scene");
const QString kTerrainServer = QStringLiteral("servers/terrain");
const QString kClearance = QStringLiteral("newMissions/clearance_m");
const QString kArrival = QStringLiteral("newMissions/arrivalMargin_m");
const QString kReactionTime = QStringLiteral("newMissions/reactionTime_s");
const QString kReactionLoss = QStringLiteral("newMissions/reactionLoss_m");
const QString kDragFactor = QStringLiteral("newMissions/dragFactor");
const QString kHeadings = QStringLiteral("newMissions/headings");
const QString kStep = QStringLiteral("newMissions/step_m");
const QString kBeta = QStringLiteral("newMissions/beta");
const QString kMethod = QStringLiteral("newMissions/method");
const QString kLowTargets = QStringLiteral("newMissions/lowTargets");
const QString kRefine = QStringLiteral("newMissions/refine");
const QString kSamples = QStringLiteral("newMissions/roadmapSamples");
const QString kSeed = QStringLiteral("newMissions/seed");

/// A number within bounds, else `otherwise`; the bounds are those of resources/schema/mission.schema.json.
double numberOr(const QSettings& store, const QString& key, double least, double most, double otherwise) {
  bool ok = false;
  const double value = store.value(key).toString().toDouble(&ok);
  return ok && value >= least && value <= most ? value : otherwise;
}

}  // namespace

Settings::Settings(const QString& iniFile)
    : store_(iniFile.isEmpty() ? std::make_unique<QSettings>() : std::make_unique<QSettings>(iniFile, QSettings::IniFormat)) {}

Settings::~Settings() = default;

Result<void> Settings::save() {
  store_->sync();
  if (store_->status() == QSettings::NoError) {
    return {};
  }
  return fail(Errc::OutputFailed, "the settings cannot be remembered for the next start; free some disk space or allow writing to this file",
              store_->fileName().toStdString());
}

style::UnitSystem Settings::unitSystem() const {
  return store_->value(kUnits).toString() == QStringLiteral("metric") ? style::UnitSystem::Metric : style::UnitSystem::Aviation;
}

void Settings::setUnitSystem(style::UnitSystem system) {
  store_->setValue(kUnits, system == style::UnitSystem::Metric ? QStringLiteral("metric") : QStringLiteral("aviation"));
}

std::optional<style::Theme> Settings::theme() const {
  const QString value = store_->value(kTheme).toString();
  if (value == QStringLiteral("light")) {
    return style::Theme::Light;
  }
  return value == QStringLiteral("dark") ? std::optional(style::Theme::Dark) : std::nullopt;
}

void Settings::setTheme(std::optional<style::Theme> theme) {
  if (theme) {
    store_->setValue(kTheme, *theme == style::Theme::Light ? QStringLiteral("light") : QStringLiteral("dark"));
  } else {
    store_->remove(kTheme);
  }
}

QString Settings::language() const {
  const QString code = store_->value(kLanguage).toString();
  return style::languages().contains(code) ? code : QString();
}

void Settings::setLanguage(const QString& code) {
  if (code.isEmpty()) {
    store_->remove(kLanguage);
  } else {
    store_->setValue(kLanguage, code);
  }
}

QString Settings::terrainServer() const {
  return store_->value(kTerrainServer).toString();
}

void Settings::setTerrainServer(const QString& address) {
  store_->setValue(kTerrainServer, address);
}

MissionDefaults Settings::missionDefaults() const {
  MissionDefaults read;
  mission::SafetySettings& safety = read.safety;
  mission::PlannerSettings& planner = read.planner;
  safety.clearance = Length::fromSi(numberOr(*store_, kClearance, 0.0, 5000.0, safety.clearance.si()));
  safety.arrivalMargin = Length::fromSi(numberOr(*store_, kArrival, 0.0, 5000.0, safety.arrivalMargin.si()));
  const auto within = [this](const QString& key, const mission::Limits& limits, double otherwise) {
    return numberOr(*store_, key, limits.least, limits.most, otherwise);
  };
  safety.reactionTime = Duration::fromSi(within(kReactionTime, mission::kReactionTime, safety.reactionTime.si()));
  safety.reactionLoss = Length::fromSi(within(kReactionLoss, mission::kReactionLoss, safety.reactionLoss.si()));
  safety.dragFactor = within(kDragFactor, mission::kDragFactor, safety.dragFactor);
  planner.headings = static_cast<int>(numberOr(*store_, kHeadings, 1.0, 64.0, planner.headings));
  planner.step = Length::fromSi(numberOr(*store_, kStep, 1.0, 1000.0, planner.step.si()));
  planner.beta = numberOr(*store_, kBeta, 2.0, 1000.0, planner.beta);
  planner.method = store_->value(kMethod).toString() == QStringLiteral("base") ? mission::Method::Base : mission::Method::Lazy;
  planner.lowTargets =
      store_->value(kLowTargets).toString() == QStringLiteral("descend") ? mission::LowTargets::Descend : mission::LowTargets::PassAbove;
  if (const double samples = numberOr(*store_, kSamples, 1.0, 100'000'000.0, 0.0); samples > 0.0) {
    planner.roadmap = mission::RoadmapKind::RrtStar;
    planner.roadmapSamples = static_cast<int>(samples);
  }
  planner.refine = store_->value(kRefine).toString() == QStringLiteral("none") ? mission::Refine::None : mission::Refine::Full;
  bool isSeed = false;
  if (const qulonglong seed = store_->value(kSeed).toString().toULongLong(&isSeed); isSeed) {
    planner.seed = seed;
  }
  return read;
}

void Settings::setMissionDefaults(const MissionDefaults& defaults) {
  const auto number = [](double value) { return QString::number(value, 'g', 17); };
  store_->setValue(kClearance, number(defaults.safety.clearance.si()));
  store_->setValue(kArrival, number(defaults.safety.arrivalMargin.si()));
  store_->setValue(kReactionTime, number(defaults.safety.reactionTime.si()));
  store_->setValue(kReactionLoss, number(defaults.safety.reactionLoss.si()));
  store_->setValue(kDragFactor, number(defaults.safety.dragFactor));
  store_->setValue(kHeadings, defaults.planner.headings);
  store_->setValue(kStep, number(defaults.planner.step.si()));
  store_->setValue(kBeta, number(defaults.planner.beta));
  store_->setValue(kMethod, defaults.planner.method == mission::Method::Base ? QStringLiteral("base") : QStringLiteral("lazy"));
  store_->setValue(kLowTargets,
                   defaults.planner.lowTargets == mission::LowTargets::Descend ? QStringLiteral("descend") : QStringLiteral("passAbove"));
  if (defaults.planner.roadmap == mission::RoadmapKind::RrtStar && defaults.planner.roadmapSamples) {
    store_->setValue(kSamples, *defaults.planner.roadmapSamples);
  } else {
    store_->remove(kSamples);
  }
  store_->setValue(kRefine, defaults.planner.refine == mission::Refine::None ? QStringLiteral("none") : QStringLiteral("full"));
  store_->setValue(kSeed, QString::number(defaults.planner.seed));
}

QVariantMap Settings::sceneOptions() const {
  QVariantMap options;
  store_->beginGroup(kScene);
  for (const QString& key : store_->childKeys()) {
    options.insert(key, store_->value(key));
  }
  store_->endGroup();
  return options;
}

void Settings::setSceneOptions(const QVariantMap& options) {
  store_->beginGroup(kScene);
  for (auto option = options.begin(); option != options.end(); ++option) {
    store_->setValue(option.key(), option.value());
  }
  store_->endGroup();
}

QByteArray Settings::windowGeometry() const {
  return store_->value(kGeometry).toByteArray();
}

void Settings::setWindowGeometry(const QByteArray& geometry) {
  store_->setValue(kGeometry, geometry);
}

QByteArray Settings::windowState() const {
  return store_->value(kState).toByteArray();
}

void Settings::setWindowState(const QByteArray& state) {
  store_->setValue(kState, state);
}

QStringList Settings::recentFiles() const {
  QStringList files = store_->value(kRecent).toStringList();
  files.erase(std::remove_if(files.begin(), files.end(), [](const QString& file) { return !QFileInfo::exists(file); }), files.end());
  return files;
}

void Settings::addRecentFile(const QString& path) {
  const QString absolute = QDir::cleanPath(QFileInfo(path).absoluteFilePath());
  QStringList files = recentFiles();
  files.removeAll(absolute);
  files.prepend(absolute);
  store_->setValue(kRecent, QStringList(files.mid(0, kMostRecent)));
}

void Settings::clearRecentFiles() {
  store_->remove(kRecent);
}

QString Settings::lastFolder(const QString& kind) const {
  const QString folder = store_->value(kFolders + kind).toString();
  return !folder.isEmpty() && QFileInfo(folder).isDir() ? folder : QString();
}

void Settings::setLastFolder(const QString& kind, const QString& folder) {
  store_->setValue(kFolders + kind, folder);
}

}  // namespace vp::document
