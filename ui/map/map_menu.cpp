#include "ui/map/map_menu.h"

#include "ui/document/airspace_words.h"
#include "ui/map/site_marks.h"
#include "ui/map/target_marks.h"
#include "ui/map/weather_marks.h"
#include "ui/map/words.h"

namespace vp::map {
namespace {

/// An ampersand in a name is no mnemonic.
QString literal(QString text) {
  return text.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

void addTargetEntries(QMenu& menu, const MapScene& scene, int index, const MenuActions& actions) {
  const QString title = literal(targetTitle((*scene.situation.targets)[static_cast<std::size_t>(index)]));
  menu.addAction(Words::tr("Move %1…").arg(title), [=] { actions.moveTarget(index); });
  menu.addAction(Words::tr("Rename %1…").arg(title), [=] { actions.renameTarget(index); });
  menu.addAction(Words::tr("Edit height of %1…").arg(title), [=] { actions.editTarget(index); });
  menu.addAction(Words::tr("Delete %1").arg(title), [=] { actions.removeTarget(index); });
}

void addSiteEntries(QMenu& menu, const MapScene& scene, int index, const MenuActions& actions) {
  const document::ShownSite& shown = (*scene.situation.sites)[static_cast<std::size_t>(index)];
  const mission::LandingSite& site = shown.site.site;
  const QString id = QString::fromStdString(site.id);
  const QString airport = QString::fromStdString(site.airportIdent);
  const QString runway = literal(siteTitle(site));
  if (shown.usable) {
    const std::optional<mission::HomeBase>& home = scene.situation.home;
    menu.addAction(Words::tr("Start and end at %1").arg(runway), [=] { actions.setHome(id, id); });
    if (home && home->landing != site.id) {
      const QString takeoff = QString::fromStdString(home->takeoff);
      menu.addAction(Words::tr("Start at %1, end at %2").arg(literal(takeoff), runway), [=] { actions.setHome(takeoff, id); });
    }
    if (home && (home->takeoff == site.id || home->landing == site.id)) {
      menu.addAction(Words::tr("Plan the tour alone, without a home runway"), [=] { actions.setHome({}, {}); });
    }
    menu.addSeparator();
    menu.addAction(Words::tr("Exclude runway %1").arg(runway), [=] { actions.excludeSite(id, true); });
    if (!airport.isEmpty()) {
      menu.addAction(Words::tr("Exclude all runways of %1").arg(literal(airport)), [=] { actions.excludeSite(airport, true); });
    }
  } else {
    menu.addAction(Words::tr("Use runway %1 again").arg(runway), [=] { actions.excludeSite(id, false); });
  }
}

/// What is done about one airspace, or about its whole class.
void addUses(QMenu& menu, std::optional<mission::AirspaceUse> now, const QString& kind, const QString& name, const MenuActions& actions) {
  for (const mission::AirspaceUse use : document::kAirspaceUses) {
    QAction* entry = menu.addAction(document::airspaceUseText(use), [=] { actions.setAirspaceUse(kind, name, use); });
    entry->setCheckable(now.has_value());
    entry->setChecked(use == now);
  }
}

/// A submenu for each airspace over a place.
void addAirspaceEntries(QMenu& menu, const MapScene& scene, geo::Point place, const MenuActions& actions) {
  constexpr int kMost = 8;  // more would make the menu longer than the screen; the rest is in the dialog
  int count = 0;
  for (const document::ShownAirspace& shown : *scene.situation.airspaces) {
    if (count == kMost || !document::isInside(shown, place)) {
      continue;
    }
    ++count;
    const QString kind = QString::fromStdString(shown.airspace.kind);
    const QString name = QString::fromStdString(shown.airspace.name);
    QMenu* sub = menu.addMenu(Words::tr("Airspace %1").arg(literal(document::airspaceText(shown.airspace, scene.units).join(QStringLiteral(", ")))));
    if (!name.isEmpty()) {
      addUses(*sub, shown.use, {}, name, actions);
      addUses(*sub->addMenu(Words::tr("All of class %1").arg(literal(kind))), std::nullopt, kind, {}, actions);
    } else {
      addUses(*sub, shown.use, kind, {}, actions);
    }
    sub->addSeparator();
    sub->addAction(Words::tr("Airspace rules…"), [=] { actions.editAirspaceRules(); });
  }
  if (count > 0) {
    menu.addSeparator();
  }
}

}  // namespace

std::unique_ptr<QMenu> mapMenu(const MapScene& scene, const MapObject& object, geo::Point place, const MenuActions& actions) {
  auto menu = std::make_unique<QMenu>();
  QString zoomTitle = Words::tr("Zoom in here");
  switch (object.kind) {
    case MapObject::Kind::Target:
      addTargetEntries(*menu, scene, object.index, actions);
      zoomTitle = Words::tr("Zoom to %1").arg(literal(targetTitle((*scene.situation.targets)[static_cast<std::size_t>(object.index)])));
      break;
    case MapObject::Kind::Site:
      addSiteEntries(*menu, scene, object.index, actions);
      zoomTitle = Words::tr("Zoom to %1").arg(literal(siteTitle((*scene.situation.sites)[static_cast<std::size_t>(object.index)].site.site)));
      break;
    case MapObject::Kind::Tour: {
      menu->addAction(Words::tr("Show an engine failure here"), [=] { actions.pin(object.distance); });
      const int before = insertionIndex(scene, object.distance);
      if (before >= 0) {
        const QString next = literal(targetTitle((*scene.situation.targets)[static_cast<std::size_t>(before)]));
        menu->addAction(Words::tr("Insert target before %1").arg(next), [=] { actions.addTarget(place, before); });
      }
      break;
    }
    case MapObject::Kind::Ground:
      break;
  }
  if (scene.situation.airspaces != nullptr && (object.kind == MapObject::Kind::Ground || object.kind == MapObject::Kind::Tour)) {
    addAirspaceEntries(*menu, scene, place, actions);
  }
  if (const int cell = shownWeatherAt(scene, place); cell >= 0) {
    const QString title =
        literal(document::weatherTitle((*scene.situation.weather)[static_cast<std::size_t>(cell)].cell, static_cast<std::size_t>(cell)));
    menu->addAction(Words::tr("Edit weather %1…").arg(title), [=] { actions.editWeather(cell); });
    menu->addAction(Words::tr("Delete weather %1").arg(title), [=] { actions.removeWeather(cell); });
  }
  if (scene.situation.terrain != nullptr) {
    if (object.kind == MapObject::Kind::Ground || object.kind == MapObject::Kind::Tour) {
      const QString where = style::Units::position(scene.situation.terrain->frame.toLatLon(place));
      menu->addAction(Words::tr("Add target at %1").arg(where), [=] { actions.addTarget(place, -1); });
    }
    const std::optional<double> distance = object.kind == MapObject::Kind::Tour ? std::optional(object.distance) : std::nullopt;
    menu->addAction(Words::tr("Engine out here: where to?"), [=] { actions.engineOut(place, distance); });
    menu->addAction(Words::tr("Measure from here"), [=] { actions.measureFrom(place); });
    menu->addAction(actions.hasRings ? Words::tr("Remove the range rings here") : Words::tr("Range rings from here"),
                    [=] { actions.toggleRings(place); });
  }
  menu->addSeparator();
  menu->addAction(zoomTitle, [=] { actions.zoomTo(object, place); });
  menu->addAction(Words::tr("Centre here"), [=] { actions.centreOn(place); });
  menu->addAction(Words::tr("Show everything"), [=] { actions.showAll(); });
  return menu;
}

}  // namespace vp::map
