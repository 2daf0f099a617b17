#include "ui/document/settings.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace vp::document {
namespace {

const QString kUnits = QStringLiteral("units");
const QString kTheme = QStringLiteral("theme");
const QString kGeometry = QStringLiteral("window/geometry");
const QString kState = QStringLiteral("window/state");
const QString kFolders = QStringLiteral("folders/");
const QString kRecent = QStringLiteral("recentFiles");

}  // namespace

Settings::Settings(const QString& iniFile)
    : store_(iniFile.isEmpty() ? std::make_unique<QSettings>() : std::make_unique<QSettings>(iniFile, QSettings::IniFormat)) {}

Settings::~Settings() = default;

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
