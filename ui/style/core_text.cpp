#include "ui/style/core_text.h"

#include <QCoreApplication>

#include <array>

namespace vp::style {
namespace {

// These lists are there for the collector of texts alone; tests/ui/style/tst_core_text.cpp holds them against the core.

// core/formats/exports/export_formats.cpp: what it is, and what it loses
[[maybe_unused]] constexpr std::array kFormats{
    QT_TRANSLATE_NOOP("Core", "X-Plane 11/12 flight plan (1100)"),
    QT_TRANSLATE_NOOP("Core", "X-Plane 10 flight plan (version 3)"),
    QT_TRANSLATE_NOOP("Core", "Garmin flight plan (G1000, GTN)"),
    QT_TRANSLATE_NOOP("Core", "Garmin user waypoints"),
    QT_TRANSLATE_NOOP("Core", "Microsoft Flight Simulator flight plan"),
    QT_TRANSLATE_NOOP("Core", "Little Navmap flight plan"),
    QT_TRANSLATE_NOOP("Core", "QGroundControl plan"),
    QT_TRANSLATE_NOOP("Core", "SeeYou waypoints and tasks"),
    QT_TRANSLATE_NOOP("Core", "GPX route and track"),
    QT_TRANSLATE_NOOP("Core", "KML for Google Earth"),
    QT_TRANSLATE_NOOP("Core", "KMZ for Google Earth"),
    QT_TRANSLATE_NOOP("Core", "FlightGear flight plan"),
    QT_TRANSLATE_NOOP("Core", "GeoJSON for maps and GIS"),
    QT_TRANSLATE_NOOP("Core", "GeoPackage for GIS"),
    QT_TRANSLATE_NOOP("Core", "Table of waypoints and decision points"),
    QT_TRANSLATE_NOOP("Core",
                      "turns are fly-by turns of the navigator, altitudes are rounded up to whole feet and some readers replace all by the highest, "
                      "glides and margins are left out"),
    QT_TRANSLATE_NOOP("Core",
                      "altitudes and home runways are in the comments alone, a second runway of the home airport is a user waypoint, glides and "
                      "margins are left out"),
    QT_TRANSLATE_NOOP("Core", "altitudes are in the names alone, the order is that of the rows, glides and margins are left out"),
    QT_TRANSLATE_NOOP("Core", "targets beyond ten letters are shortened, glides and margins are left out"),
    QT_TRANSLATE_NOOP("Core", "its reader moves places by up to half a metre, glides and margins are left out"),
    QT_TRANSLATE_NOOP("Core", "names are left out, rally points stand for runways, glides and margins are left out"),
    QT_TRANSLATE_NOOP(
        "Core",
        "places are rounded to 1.85 m, a task has no altitudes: they are in the names and in the elevation column, glides and margins are left out"),
    QT_TRANSLATE_NOOP("Core", "glides and margins are left out"),
    QT_TRANSLATE_NOOP("Core", "turns are those of its autopilot, glides and margins are left out"),
    QT_TRANSLATE_NOOP("Core", "the paths of the glides are left out"),
};

// core/emergency/landing_outcome.cpp and the risks in core/risk
[[maybe_unused]] constexpr std::array kTerms{
    QT_TRANSLATE_NOOP("Core", "weather"),
    QT_TRANSLATE_NOOP("Core", "success probability in weather"),
    QT_TRANSLATE_NOOP("Core", "overflown population risk"),
    QT_TRANSLATE_NOOP("Core", "people under the path"),
    QT_TRANSLATE_NOOP("Core", "height lost to the approach"),
    QT_TRANSLATE_NOOP("Core", "approach higher than the lowest in range"),
    QT_TRANSLATE_NOOP("Core", "manoeuvres"),
    QT_TRANSLATE_NOOP("Core", "how far away it ends"),
    QT_TRANSLATE_NOOP("Core", "distance"),
    QT_TRANSLATE_NOOP("Core", "time"),
};

// of long work, all over the core
[[maybe_unused]] constexpr std::array kSteps{
    QT_TRANSLATE_NOOP("Core", "airfields"),
    QT_TRANSLATE_NOOP("Core", "asking for sizes"),
    QT_TRANSLATE_NOOP("Core", "contours"),
    QT_TRANSLATE_NOOP("Core", "joining the tiles"),
    QT_TRANSLATE_NOOP("Core", "lowest safe altitudes"),
    QT_TRANSLATE_NOOP("Core", "planned"),
    QT_TRANSLATE_NOOP("Core", "reading the airfields"),
    QT_TRANSLATE_NOOP("Core", "terrain: read"),
    QT_TRANSLATE_NOOP("Core", "terrain: reading heights"),
    QT_TRANSLATE_NOOP("Core", "terrain: warping to the local frame"),
    QT_TRANSLATE_NOOP("Core", "waiting for another program that fetches the same"),
};

}  // namespace

QString coreText(const std::string& text) {
  return text.empty() ? QString() : QCoreApplication::translate("Core", text.c_str());
}

}  // namespace vp::style
