#include "app/gui/edit_controller.h"

#include "core/formats/runway_names.h"
#include "ui/dialogs/aircraft_dialog.h"
#include "ui/dialogs/airspace_dialog.h"
#include "ui/dialogs/mission_settings_dialog.h"
#include "ui/dialogs/target_dialog.h"
#include "ui/dialogs/wind_dialog.h"
#include "ui/document/airspace_words.h"

#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

namespace vp::gui {
namespace {

constexpr double kDefaultTargetHeight = 150.0;  // m above ground: about 500 ft, the usual lowest height of visual flight (SERA.5005)

std::size_t at(int index) {
  return static_cast<std::size_t>(index);
}

QString fileName(const std::string& path) {
  return QFileInfo(QString::fromStdString(path)).fileName();
}

}  // namespace

std::string freshTargetName(const mission::Mission& mission) {
  for (int number = 1;; ++number) {
    const std::string name = QStringLiteral("T%1").arg(number, 2, 10, QLatin1Char('0')).toStdString();
    const bool taken = std::any_of(mission.targets.begin(), mission.targets.end(), [&](const mission::Target& t) { return t.name == name; });
    if (!taken) {
      return name;
    }
  }
}

EditController::EditController(jobs::Workspace& workspace, QWidget* window) : QObject(window), workspace_(workspace), window_(window) {}

bool EditController::hasTarget(int target) const {
  return target >= 0 && at(target) < workspace_.document().mission().targets.size();
}

QString EditController::nameOf(int target) const {
  return QString::fromStdString(workspace_.document().mission().targets[at(target)].name);
}

void EditController::addTarget(geo::LatLon place, int insertBefore) {
  const mission::Mission& mission = workspace_.document().mission();
  mission::Target target;
  target.name = freshTargetName(mission);
  target.position = place;
  target.height_m = kDefaultTargetHeight;
  if (!mission.targets.empty() && mission.targets.back().reference == mission::HeightReference::AboveGround) {
    target.height_m = mission.targets.back().height_m;
  }
  const auto count = static_cast<int>(mission.targets.size());
  const int index = insertBefore >= 0 && insertBefore < count ? insertBefore : count;
  workspace_.document().edit(tr("Add target %1").arg(QString::fromStdString(target.name)),
                             [&](mission::Mission& m) { m.targets.insert(m.targets.begin() + index, target); });
  workspace_.view().selectTarget(index);
}

void EditController::moveTarget(int target, geo::LatLon place) {
  if (hasTarget(target)) {
    workspace_.document().edit(tr("Move target %1").arg(nameOf(target)), [&](mission::Mission& m) { m.targets[at(target)].position = place; });
  }
}

void EditController::removeTarget(int target) {
  if (!hasTarget(target)) {
    return;
  }
  workspace_.document().edit(tr("Delete target %1").arg(nameOf(target)), [&](mission::Mission& m) { m.targets.erase(m.targets.begin() + target); });
  workspace_.view().selectTarget(-1);
}

void EditController::renameTarget(int target) {
  if (!hasTarget(target)) {
    return;
  }
  const QString old = nameOf(target);
  bool ok = false;
  const QString name = QInputDialog::getText(window_, tr("Rename target"), tr("Name of target %1").arg(old), QLineEdit::Normal, old, &ok).trimmed();
  mission::Target renamed = workspace_.document().mission().targets[at(target)];
  renamed.name = name.toStdString();
  if (ok) {
    replaceTarget(target, renamed);
  }
}

void EditController::editTarget(int target) {
  if (!hasTarget(target)) {
    return;
  }
  const mission::Mission& mission = workspace_.document().mission();
  QStringList taken;
  for (const mission::Target& other : mission.targets) {
    if (&other != &mission.targets[at(target)]) {
      taken << QString::fromStdString(other.name);
    }
  }
  dialogs::TargetDialog dialog(mission.targets[at(target)], taken, workspace_.view().units(), window_);
  if (dialog.exec() == QDialog::Accepted) {
    replaceTarget(target, dialog.result());
  }
}

void EditController::replaceTarget(int target, const mission::Target& value) {
  if (!hasTarget(target) || value.name.empty()) {
    return;
  }
  const std::vector<mission::Target>& targets = workspace_.document().mission().targets;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (i != at(target) && targets[i].name == value.name) {
      return;  // names are unique; the table shows the old one again
    }
  }
  if (!(targets[at(target)] == value)) {
    workspace_.document().edit(tr("Edit target %1").arg(nameOf(target)), [&](mission::Mission& m) { m.targets[at(target)] = value; });
  }
}

void EditController::reorderTarget(int from, int to) {
  if (!hasTarget(from) || !hasTarget(to) || from == to) {
    return;
  }
  workspace_.document().edit(tr("Reorder targets"), [&](mission::Mission& m) {
    const mission::Target moved = m.targets[at(from)];
    m.targets.erase(m.targets.begin() + from);
    m.targets.insert(m.targets.begin() + to, moved);
  });
  workspace_.view().selectTarget(to);
}

void EditController::setHome(const QString& takeoff, const QString& landing) {
  const bool isSet = !takeoff.isEmpty();
  const QString what = !isSet               ? tr("Plan without a home runway")
                       : takeoff == landing ? tr("Start and end at %1").arg(takeoff)
                                            : tr("Start at %1, end at %2").arg(takeoff, landing);
  workspace_.document().edit(what, [&](mission::Mission& m) {
    m.home = isSet ? std::optional(mission::HomeBase{takeoff.toStdString(), landing.toStdString()}) : std::nullopt;
  });
}

void EditController::excludeSite(const QString& siteId, bool exclude) {
  const std::string id = siteId.toStdString();
  std::string airport;            // of the runway end that is meant
  std::vector<std::string> ends;  // of that airport, or of the airport that is meant
  if (const auto& sites = workspace_.situation().sites) {
    const auto meant = std::find_if(sites->begin(), sites->end(), [&](const document::ShownSite& s) { return s.site.site.id == id; });
    airport = meant != sites->end() ? meant->site.site.airportIdent : id;
    for (const document::ShownSite& shown : *sites) {
      if (shown.site.site.airportIdent == airport) {
        ends.push_back(shown.site.site.id);
      }
    }
  }
  workspace_.document().edit(exclude ? tr("Exclude runway %1").arg(siteId) : tr("Include runway %1").arg(siteId), [&](mission::Mission& m) {
    std::vector<std::string>& list = m.siteFilter.exclude;
    std::erase(list, id);
    if (exclude) {
      list.push_back(id);
    } else if (id == airport) {
      std::erase_if(list, [&](const std::string& entry) { return std::find(ends.begin(), ends.end(), entry) != ends.end(); });
    } else if (std::erase(list, airport) > 0) {  // the whole airport was excluded: its other ends stay so
      std::copy_if(ends.begin(), ends.end(), std::back_inserter(list), [&](const std::string& end) { return end != id; });
    }
  });
}

void EditController::setAirspaceUse(const QString& kind, const QString& name, mission::AirspaceUse use) {
  const QString which = name.isEmpty() ? tr("class %1").arg(kind) : name;
  mission::AirspaceSettings changed = workspace_.document().mission().airspace;
  mission::setRule(changed, name.isEmpty() ? kind.toStdString() : std::string(), name.toStdString(), use);
  const bool hasRule = !kind.isEmpty() || !name.isEmpty();  // what has neither only goes with the rest
  if (hasRule && !(changed == workspace_.document().mission().airspace)) {
    workspace_.document().edit(tr("Airspace %1: %2").arg(which, document::airspaceUseText(use)), [&](mission::Mission& m) { m.airspace = changed; });
  }
}

void EditController::editAirspaces() {
  std::vector<mission::Airspace> airspaces;
  if (const auto& shown = workspace_.situation().airspaces) {
    std::transform(shown->begin(), shown->end(), std::back_inserter(airspaces), [](const document::ShownAirspace& one) { return one.airspace; });
  }
  std::vector<std::string> kinds;
  if (const auto& found = workspace_.situation().foundAirspaces) {
    airspaces.insert(airspaces.end(), found->hidden.begin(), found->hidden.end());
    kinds = found->kinds;
  }
  dialogs::AirspaceDialog dialog(airspaces, kinds, workspace_.document().mission().airspace, workspace_.view().units(), window_);
  bool wantsFiles = false;
  connect(&dialog, &dialogs::AirspaceDialog::addFilesRequested, &dialog, [&] {
    wantsFiles = true;
    dialog.accept();
  });
  if (dialog.exec() == QDialog::Accepted && !(dialog.result() == workspace_.document().mission().airspace)) {
    workspace_.document().edit(tr("Change airspace rules"), [&](mission::Mission& m) { m.airspace = dialog.result(); });
  }
  if (wantsFiles) {
    emit airspaceFilesRequested();
  }
}

void EditController::setFilter(const mission::SiteFilter& filter) {
  if (!(workspace_.document().mission().siteFilter == filter)) {
    workspace_.document().edit(
        tr("Change runway filter"), [&](mission::Mission& m) { m.siteFilter = filter; }, QStringLiteral("siteFilter"));
  }
}

void EditController::setOneWay(const QString& siteId, bool oneWay) {
  const std::string id = siteId.toStdString();
  const std::size_t slash = id.rfind('/');
  const std::string other = slash == std::string::npos ? std::string() : id.substr(0, slash + 1) + formats::oppositeIdent(id.substr(slash + 1));
  workspace_.document().edit(oneWay ? tr("Land %1 one way only").arg(siteId) : tr("Land both ways of %1").arg(siteId), [&](mission::Mission& m) {
    std::vector<std::string>& list = m.siteFilter.oneWay;
    std::erase(list, id);
    if (oneWay) {
      std::erase(list, other);  // both one way would leave neither
      list.push_back(id);
    }
  });
}

void EditController::setSiteNote(const QString& siteId, const QString& text) {
  workspace_.document().edit(tr("Note on runway %1").arg(siteId), [&](mission::Mission& m) {
    std::vector<mission::SiteNote>& notes = m.siteFilter.notes;
    std::erase_if(notes, [&](const mission::SiteNote& note) { return note.site == siteId.toStdString(); });
    if (!text.isEmpty()) {
      notes.push_back({siteId.toStdString(), text.toStdString()});
    }
  });
}

void EditController::includeAllSites() {
  workspace_.document().edit(tr("Include excluded runways"), [](mission::Mission& m) {
    m.siteFilter.exclude.clear();
    m.siteFilter.oneWay.clear();
    m.siteFilter.approximate = true;
    m.siteFilter.minLength.reset();
    m.siteFilter.minWidth.reset();
    m.siteFilter.surfaces.clear();
    m.siteFilter.lighted = false;
    m.siteFilter.maxDistance.reset();
  });
}

void EditController::allowPassingAbove() {
  workspace_.document().edit(tr("Allow passing above targets"), [](mission::Mission& m) { m.planner.lowTargets = mission::LowTargets::PassAbove; });
}

void EditController::raiseCeiling(double byMetres) {
  workspace_.document().edit(tr("Raise ceiling"), [&](mission::Mission& m) {
    if (m.ceiling) {
      m.ceiling = geo::HeightMsl::fromMetres(m.ceiling->metres() + byMetres);
    }
  });
}

void EditController::removeCeiling() {
  workspace_.document().edit(tr("Remove ceiling"), [](mission::Mission& m) { m.ceiling.reset(); });
}

void EditController::editMissionSettings() {
  QStringList runways;
  if (const auto& sites = workspace_.situation().sites) {
    for (const document::ShownSite& shown : *sites) {
      if (shown.usable) {
        runways.push_back(QString::fromStdString(shown.site.site.id));
      }
    }
  }
  runways.sort();
  dialogs::MissionSettingsDialog dialog(workspace_.document().mission(), runways, workspace_.view().units(), window_);
  if (dialog.exec() == QDialog::Accepted) {
    const mission::Mission changed = dialog.result();
    const mission::Mission& now = workspace_.document().mission();
    if (changed.name != now.name || !document::samePlanInputs(changed, now)) {
      workspace_.document().edit(tr("Change mission settings"), [&](mission::Mission& m) { m = changed; });
    }
  }
}

void EditController::editAircraft() {
  const mission::Mission& mission = workspace_.document().mission();
  dialogs::AircraftDialog dialog(mission.aircraft, mission.aircraftReference, workspace_.view().units(), workspace_.view().theme(), window_);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  mission::Mission changed = mission;
  changed.aircraft = dialog.profile();
  changed.aircraftReference = dialog.reference();
  if (!document::samePlanInputs(changed, mission)) {
    workspace_.document().edit(tr("Change aircraft"), [&](mission::Mission& m) { m = changed; });
  }
}

void EditController::editWind() {
  const mission::Mission& mission = workspace_.document().mission();
  dialogs::WindDialog dialog(mission.wind, mission.aircraft, workspace_.view().units(), window_);
  if (dialog.exec() == QDialog::Accepted && dialog.result() != mission.wind) {
    workspace_.document().edit(tr("Change wind"), [&](mission::Mission& m) { m.wind = dialog.result(); });
  }
}

void EditController::removeTerrain(int index) {
  const std::vector<std::string>& files = workspace_.document().mission().terrain;
  if (index >= 0 && at(index) < files.size()) {
    workspace_.document().edit(tr("Remove terrain %1").arg(fileName(files[at(index)])),
                               [&](mission::Mission& m) { m.terrain.erase(m.terrain.begin() + index); });
  }
}

void EditController::removeAirspaces(int index) {
  const std::vector<std::string>& files = workspace_.document().mission().airspace.files;
  if (index >= 0 && at(index) < files.size()) {
    workspace_.document().edit(tr("Remove airspaces %1").arg(fileName(files[at(index)])),
                               [&](mission::Mission& m) { m.airspace.files.erase(m.airspace.files.begin() + index); });
  }
}

void EditController::removePopulation(int index) {
  const std::vector<std::string>& files = workspace_.document().mission().populationFiles;
  if (index >= 0 && at(index) < files.size()) {
    workspace_.document().edit(tr("Remove population %1").arg(fileName(files[at(index)])),
                               [&](mission::Mission& m) { m.populationFiles.erase(m.populationFiles.begin() + index); });
  }
}

void EditController::removeAirfields(int index) {
  const std::vector<mission::AirfieldSource>& sources = workspace_.document().mission().airfields;
  if (index < 0 || at(index) >= sources.size()) {
    return;
  }
  workspace_.document().edit(tr("Remove airfields %1").arg(fileName(sources[at(index)].airports)), [&](mission::Mission& m) {
    m.airfields.erase(m.airfields.begin() + index);
    if (m.airfields.empty()) {  // what the filter names can only be a site of the mission itself now
      const auto isGone = [&m](const std::string& entry) {
        return std::none_of(m.sites.begin(), m.sites.end(),
                            [&entry](const mission::LandingSite& site) { return site.id == entry || site.airportIdent == entry; });
      };
      std::erase_if(m.siteFilter.exclude, isGone);
      std::erase_if(m.siteFilter.oneWay, isGone);
    }
  });
}

}  // namespace vp::gui
