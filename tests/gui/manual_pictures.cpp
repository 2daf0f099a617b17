// The pictures of the manual: one of each view and dialog, cropped to what a chapter speaks of.
#include "tests/gui/shooting.h"
#include "ui/dialogs/export_review.h"
#include "ui/dialogs/message_banner.h"
#include "ui/document/landing_case.h"
#include "ui/exports/prepare_export.h"
#include "ui/map/map_view.h"
#include "ui/panels/decision_table.h"
#include "ui/panels/engine_out_panel.h"
#include "ui/panels/landing_panel.h"
#include "ui/panels/plan_summary_panel.h"
#include "ui/panels/site_panel.h"
#include "ui/panels/target_panel.h"
#include "ui/profile/profile_view.h"
#include "ui/scene3d/scene_view.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTextStream>
#include <QTreeWidget>

#include <cmath>

using namespace vp;

namespace {

constexpr QSize kWindow{1480, 920};
const QString kFolder = QStringLiteral("/home/pilot/flights");  // shown instead of a folder of the machine that makes the pictures
constexpr int kLong = 10;                                       // times as patient, for what plans or compares runways

void waitLong(const std::function<bool()>& condition) {
  for (int i = 0; i < kLong && !waitFor(condition); ++i) {
  }
}

void raise(gui::MainWindow& window, const char* dock) {
  window.findChild<QDockWidget*>(QLatin1String(dock))->raise();
}

void choosePage(QDialog& dialog, int page) {
  auto* tabs = dialog.findChild<QTabWidget*>();
  tabs->setCurrentIndex(page);
  QCoreApplication::processEvents();
}

/// The window, each view of the tour, and the panels beside them.
void shootViews(gui::MainWindow& window, const QDir& folder) {
  document::ViewState& view = window.workspace().view();
  view.setPinned(window.workspace().situation().plan->length() * 0.45);
  auto* engineOut = window.findChild<panels::EngineOutPanel*>();
  waitLong([&] { return engineOut->findChild<QTableView*>()->model()->rowCount() > 0; });
  settle(window);
  shoot(window, folder, QStringLiteral("window"));
  shoot(window, folder, QStringLiteral("map"), &window.mapView());
  shoot(window, folder, QStringLiteral("engine-out"), engineOut);
  shoot(window, folder, QStringLiteral("profile"), &window.profileView());
  shoot(window, folder, QStringLiteral("targets"), window.findChild<panels::TargetPanel*>());
  raise(window, "runwaysDock");
  raise(window, "planDock");
  raise(window, "decisionsDock");
  settle(window);
  shoot(window, folder, QStringLiteral("runways"), window.findChild<panels::SitePanel*>());
  shoot(window, folder, QStringLiteral("plan"), window.findChild<panels::PlanSummaryPanel*>());
  shoot(window, folder, QStringLiteral("decision-points"), window.findChild<panels::DecisionTable*>());
  raise(window, "targetsDock");
  raise(window, "profileDock");
  window.action(QStringLiteral("overlaySafe"))->setChecked(true);
  window.action(QStringLiteral("overlayMargin"))->setChecked(true);
  waitFor([&] { return window.workspace().situation().safeAltitudes && window.workspace().situation().safeAltitudes->columns > 100; });
  settle(window);
  shoot(window, folder, QStringLiteral("overlays"), &window.mapView());
  window.action(QStringLiteral("overlaySafe"))->setChecked(false);
  window.action(QStringLiteral("overlayMargin"))->setChecked(false);
}

void shootScene(gui::MainWindow& window, const QDir& folder) {
  window.showScene(true);
  waitLong([&] { return window.sceneView()->isSettled(); });
  settle(window);
  window.mapView().hide();
  settle(window);
  shoot(window, folder, QStringLiteral("scene"), window.sceneView()->parentWidget());
  window.mapView().show();
  window.showScene(false);
}

/// Weather, people, and an engine failure between them.
void shootLandingNow(gui::MainWindow& window, const QDir& folder, const QString& scratch) {
  document::ViewState& view = window.workspace().view();
  addWeatherAndPeople(window, scratch + QStringLiteral("/people.geojson"));
  view.setPinned(std::nullopt);
  view.selectWeather(0);
  window.mapView().showAll();
  settle(window);
  shoot(window, folder, QStringLiteral("weather"), &window.mapView());
  window.action(QStringLiteral("missionWeather"))->trigger();
  if (auto* list = window.findChild<QDialog*>(QStringLiteral("weatherListDialog"))) {
    QCoreApplication::processEvents();
    write(list->grab(), folder, QStringLiteral("weather-list"));
    list->close();
  }
  const geo::Box box = window.workspace().situation().terrain->grid->extent();
  emit window.mapView().engineOutRequested({0.35 * box.minX + 0.65 * box.maxX, 0.28 * box.minY + 0.72 * box.maxY}, std::nullopt);
  window.findChild<QDoubleSpinBox*>(QStringLiteral("landingAltitude"))->setValue(9500.0);
  waitFor([&] { return view.landing() != nullptr && !view.landing()->isRunning; });
  auto* panel = window.findChild<panels::LandingPanel*>();
  auto* tabs = window.findChild<QTabWidget*>(QStringLiteral("landingTabs"));
  settle(window);
  shoot(window, folder, QStringLiteral("landing-map"), &window.mapView());
  const char* const names[] = {"landing-planners", "landing-runways", "landing-terms"};
  for (int i = 0; i < 3; ++i) {
    tabs->setCurrentIndex(i);
    settle(window);
    shoot(window, folder, QLatin1String(names[i]), panel);
  }
  tabs->setCurrentIndex(0);
  window.findChild<QPushButton*>(QStringLiteral("landingClear"))->click();
  raise(window, "engineOutDock");
  window.workspace().document().undoStack().undo();
}

/// Two airspaces over the example, one of them forbidden.
void shootAirspace(gui::MainWindow& window, const QDir& folder, const QString& scratch) {
  const geo::LocalFrame frame = window.workspace().situation().terrain->frame;
  const geo::Box box = window.workspace().situation().terrain->grid->extent();
  const QString path = scratch + QStringLiteral("/airspace.txt");
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) {
    return;
  }
  QTextStream out(&file);
  const auto add = [&](const char* kind, const char* name, const char* floor, const char* ceiling, double x, double y, double side) {
    out << "AC " << kind << "\nAN " << name << "\nAL " << floor << "\nAH " << ceiling << "\n";
    for (const auto& [dx, dy] : {std::pair{-1.0, -0.6}, {1.0, -0.8}, {0.8, 0.9}, {-0.7, 0.6}}) {
      const geo::LatLon at = frame.toLatLon({box.minX + (x + side * dx) * (box.maxX - box.minX), box.minY + (y + side * dy) * (box.maxY - box.minY)});
      const auto degrees = [](double value, char positive, char negative) {
        const double all = std::round(std::abs(value) * 3600.0);
        return QStringLiteral("%1:%2:%3 %4")
            .arg(static_cast<int>(all / 3600.0))
            .arg(static_cast<int>(all / 60.0) % 60, 2, 10, QLatin1Char('0'))
            .arg(static_cast<int>(all) % 60, 2, 10, QLatin1Char('0'))
            .arg(value >= 0.0 ? positive : negative);
      };
      out << "DP " << degrees(at.latitude_deg, 'N', 'S') << ' ' << degrees(at.longitude_deg, 'E', 'W') << "\n";
    }
    out << "\n";
  };
  add("R", "Quernford firing range", "GND", "11000 FT MSL", 0.33, 0.52, 0.10);
  add("D", "Valley control zone", "2500 FT MSL", "FL110", 0.66, 0.45, 0.14);
  add("TMZ", "Northern TMZ", "7500 FT MSL", "FL195", 0.58, 0.80, 0.12);
  out.flush();
  file.close();
  window.workspace().document().edit(QStringLiteral("airspace"), [&](mission::Mission& m) {
    m.airspace.files = {path.toStdString()};
    mission::setRule(m.airspace, "R", {}, mission::AirspaceUse::Forbid);
    mission::setRule(m.airspace, "D", {}, mission::AirspaceUse::Warn);
  });
  waitFor([&] { return window.workspace().situation().airspaces != nullptr && window.workspace().situation().airspaces->size() >= 3; });
  window.action(QStringLiteral("planStart"))->trigger();
  waitLong([&] { return window.workspace().activity() == jobs::Workspace::Activity::Idle && window.banner().isVisible(); });
  window.banner().hide();
  window.mapView().showAll();
  settle(window);
  shoot(window, folder, QStringLiteral("airspace"), &window.mapView());
  inModal(window, "editAirspaces", [&](QDialog& dialog) {
    dialog.findChild<QTreeWidget*>()->expandAll();
    dialog.resize(700, 360);
    QCoreApplication::processEvents();
    write(dialog.grab(), folder, QStringLiteral("airspace-rules"));
  });
  window.workspace().document().undoStack().undo();
  waitLong([&] { return window.workspace().activity() == jobs::Workspace::Activity::Idle; });
}

void shootDialogs(gui::MainWindow& window, const QDir& folder) {
  inModal(window, "editWind", [&](QDialog& dialog) {
    dialog.findChild<QLineEdit*>(QStringLiteral("windText"))->setText(QStringLiteral("2000ft 270±20/10-16kt; 8000ft 290±10/25kt"));
    dialog.findChild<QPushButton*>(QStringLiteral("readWind"))->click();
    QCoreApplication::processEvents();
    write(dialog.grab(), folder, QStringLiteral("wind"));
  });
  const char* const settings[] = {"settings-safety", "settings-approach", "settings-air", "settings-planner"};
  inModal(window, "editSettings", [&](QDialog& dialog) {
    for (int page = 0; page < 4; ++page) {
      choosePage(dialog, page);
      write(dialog.grab(), folder, QLatin1String(settings[page]));
    }
  });
  inModal(window, "editAircraft", [&](QDialog& dialog) {
    auto* choice = dialog.findChild<QComboBox*>(QStringLiteral("aircraftChoice"));
    choice->setCurrentIndex(choice->findData(QStringLiteral("cessna172-handbook")));
    emit choice->activated(choice->currentIndex());
    dialog.findChild<QPushButton*>(QStringLiteral("duplicateAircraft"))->click();
    QCoreApplication::processEvents();
    write(dialog.grab(), folder, QStringLiteral("aircraft"));
  });
  inModal(window, "editPreferences", [&](QDialog& dialog) {
    choosePage(dialog, 1);
    write(dialog.grab(), folder, QStringLiteral("preferences"));
  });
  inModal(window, "fileFetchTerrain", [&](QDialog& dialog) {
    for (auto* field : dialog.findChildren<QLineEdit*>()) {
      if (field->text().endsWith(QStringLiteral(".tif"))) {
        field->setText(kFolder + QStringLiteral("/alpine-terrain.tif"));
      }
    }
    QCoreApplication::processEvents();
    write(dialog.grab(), folder, QStringLiteral("fetch-terrain"));
  });
  inModal(window, "fileBriefing", [&](QDialog& dialog) { write(dialog.grab(), folder, QStringLiteral("briefing-dialog")); });
  inModal(window, "export-safe-altitude", [&](QDialog& dialog) { write(dialog.grab(), folder, QStringLiteral("safe-altitude-dialog")); });
  inModal(window, "exportSeveral", [&](QDialog& dialog) {
    dialog.findChild<QLineEdit*>(QStringLiteral("exportFolder"))->setText(QStringLiteral("/home"));
    auto* formats = dialog.findChild<QListWidget*>(QStringLiteral("exportFormats"));
    for (int i = 0; i < 3; ++i) {
      formats->item(i)->setCheckState(i != 1 ? Qt::Checked : Qt::Unchecked);
    }
    QCoreApplication::processEvents();
    write(dialog.grab(), folder, QStringLiteral("export"));
  });
  shootImport(window, folder, QStringLiteral("import-targets"), false);
  window.action(QStringLiteral("missionFiles"))->trigger();
  if (auto* files = window.findChild<QDialog*>(QStringLiteral("missionFilesDialog"))) {
    auto* table = files->findChild<QTableWidget*>();
    for (int row = 0; row < table->rowCount(); ++row) {
      table->item(row, table->columnCount() - 1)->setText(kFolder);
    }
    QCoreApplication::processEvents();
    write(files->grab(), folder, QStringLiteral("mission-files"));
    files->close();
  }
}

void shootReview(gui::MainWindow& window, const QDir& folder) {
  const auto plan = window.workspace().document().plan();
  std::vector<std::string> sums;
  for (const mission::TerrainReference& file : plan->terrain) {
    sums.push_back(file.sha256);
  }
  const exports::ExportRequest request{*plan, window.workspace().situation().terrain->grid, sums, {"fms"}};
  const auto prepared = exports::prepareExport(request, Job{});
  if (!prepared) {
    std::fprintf(stderr, "no export: %s\n", prepared.error().message().c_str());
    return;
  }
  dialogs::ExportReview review(*prepared, window.workspace().view().units(), &window);
  review.show();
  QCoreApplication::processEvents();
  write(review.grab(), folder, QStringLiteral("export-review"));
}

/// A ceiling that is too low: what the message says, and its remedies.
void shootRemedies(gui::MainWindow& window, const QDir& folder) {
  window.workspace().document().edit(QStringLiteral("ceiling"), [](mission::Mission& m) { m.ceiling = geo::HeightMsl::fromMetres(2133.6); });
  window.action(QStringLiteral("planStart"))->trigger();
  waitLong([&] { return window.workspace().activity() == jobs::Workspace::Activity::Idle && window.banner().isVisible(); });
  settle(window);
  shoot(window, folder, QStringLiteral("remedies"), &window.banner());
  window.banner().hide();
  window.workspace().document().undoStack().undo();
}

}  // namespace

int shootManual(gui::MainWindow& window, const QDir& folder, const QString& scratch) {
  window.resize(kWindow);
  settle(window);
  window.mapView().showAll();
  shootViews(window, folder);
  shootScene(window, folder);
  shootDialogs(window, folder);
  shootReview(window, folder);
  shootLandingNow(window, folder, scratch);
  shootAirspace(window, folder, scratch);
  shootRemedies(window, folder);
  return 0;
}
