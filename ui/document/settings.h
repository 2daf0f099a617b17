#pragma once

#include "core/base/result.h"
#include "ui/document/mission_defaults.h"
#include "ui/style/chart_colors.h"
#include "ui/style/units.h"

#include <QByteArray>
#include <QString>
#include <QStringList>
#include <QVariantMap>

#include <memory>
#include <optional>

class QSettings;

namespace vp::document {

/** What the program remembers between starts: units, theme, language, values of new missions, window layout, recent files. Unknown or broken entries
 * read as their defaults. @threads one object per thread */
class Settings {
public:
  static constexpr int kMostRecent = 10;

  /** @param iniFile  for tests; empty: the user's own settings */
  explicit Settings(const QString& iniFile = {});
  ~Settings();

  /** Writes what was set; otherwise the end of this object does, and nobody learns of a failure.
   *  @errors OutputFailed - full disk, read-only folder; what was remembered before stays */
  Result<void> save();

  [[nodiscard]] style::UnitSystem unitSystem() const;
  void setUnitSystem(style::UnitSystem system);
  /** Nothing: follow the desktop. */
  [[nodiscard]] std::optional<style::Theme> theme() const;
  void setTheme(std::optional<style::Theme> theme);
  /** Code of the language of the window, as style::languages() has them; empty: that of the system. */
  [[nodiscard]] QString language() const;
  void setLanguage(const QString& code);
  /** What new missions start with; an entry that no mission may have reads as its default. */
  [[nodiscard]] MissionDefaults missionDefaults() const;
  void setMissionDefaults(const MissionDefaults& defaults);
  /** Options of the 3D view by name; whoever knows them judges the values. */
  [[nodiscard]] QVariantMap sceneOptions() const;
  void setSceneOptions(const QVariantMap& options);
  /** Server that terrain is fetched from; empty: the default. */
  [[nodiscard]] QString terrainServer() const;
  void setTerrainServer(const QString& address);
  [[nodiscard]] QByteArray windowGeometry() const;
  void setWindowGeometry(const QByteArray& geometry);
  [[nodiscard]] QByteArray windowState() const;
  void setWindowState(const QByteArray& state);
  /** Latest first; files that are gone are left out. */
  [[nodiscard]] QStringList recentFiles() const;
  void addRecentFile(const QString& path);
  void clearRecentFiles();
  /** Where files of a kind ("missions", "terrain", ...) were last taken from or put; empty if nowhere or that is gone. */
  [[nodiscard]] QString lastFolder(const QString& kind) const;
  void setLastFolder(const QString& kind, const QString& folder);

private:
  std::unique_ptr<QSettings> store_;
};

}  // namespace vp::document
