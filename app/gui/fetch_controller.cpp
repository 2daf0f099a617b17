#include "app/gui/fetch_controller.h"

#include "app/gui/suggested_file.h"
#include "core/charts/safe_altitude_chart.h"
#include "core/fetch/airfield_fetch.h"
#include "ui/dialogs/fetch_terrain_dialog.h"
#include "ui/dialogs/safe_altitude_dialog.h"
#include "ui/document/settings.h"
#include "ui/style/core_text.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <thread>

namespace vp::gui {

using dialogs::MessageBanner;

FetchController::FetchController(jobs::Workspace& workspace, MessageBanner& banner, QString iniFile, QWidget* window)
    : QObject(window), workspace_(workspace), banner_(banner), iniFile_(std::move(iniFile)), window_(window) {
  connect(&runner_, &jobs::JobRunner::progressed, this,
          [this](double fraction, const QString& text) { emit working(tr("%1 %: %2").arg(static_cast<int>(100.0 * fraction)).arg(text)); });
}

/// A name that no file has yet, beside the mission or among the documents.
QString FetchController::outputFor(const QString& ending) const {
  const QDir folder(suggestedFolder(workspace_.document()));
  const QString name = suggestedName(workspace_.document());
  QString path = folder.filePath(name + ending);
  for (int number = 2; QFileInfo::exists(path); ++number) {
    path = folder.filePath(name + QLatin1Char('-') + QString::number(number) + ending);
  }
  return path;
}

void FetchController::fetchTerrainByDialog(const std::optional<geo::GeoBox>& mapArea) {
  document::Settings settings(iniFile_);
  dialogs::FetchTerrainDialog::Offer offer;
  offer.mapArea = mapArea;
  for (const mission::AirfieldSource& source : workspace_.document().mission().airfields) {
    offer.airportFiles.push_back(source.airports);
  }
  if (const auto cached = fetch::cachedAirfields({}); cached && *cached) {
    offer.airportFiles.push_back((*cached)->airports);
  }
  offer.server = settings.terrainServer();
  offer.output = outputFor(QStringLiteral("-terrain.tif"));
  dialogs::FetchTerrainDialog dialog(std::move(offer), terrainRunner_, window_);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  settings.setTerrainServer(dialog.server());
  jobs::NewFiles files;
  for (const QString& file : dialog.files()) {
    files.terrain.push_back(QFileInfo(file).absoluteFilePath().toStdString());
  }
  addToMission(files, tr("Terrain fetched and added to the mission: %1.").arg(QFileInfo(dialog.files().front()).fileName()), dialog.notes());
}

void FetchController::addToMission(const jobs::NewFiles& files, const QString& told, const QStringList& notes) {
  if (const Result<void> added = workspace_.add(files); !added) {
    banner_.show(MessageBanner::Kind::Failure, style::coreText(added.error()));
    return;
  }
  banner_.show(notes.isEmpty() ? MessageBanner::Kind::Success : MessageBanner::Kind::Warning, (QStringList{told} + notes).join(QLatin1Char(' ')));
}

void FetchController::offerStop(const QString& text) {
  banner_.show(MessageBanner::Kind::Hint, text, {{tr("Stop"), [this] { runner_.requestStop(); }}});
}

void FetchController::updateAirfields() {
  const Result<std::optional<fetch::AirfieldFiles>> cached = fetch::cachedAirfields({});
  if (!cached) {
    banner_.show(MessageBanner::Kind::Failure, style::coreText(cached.error()));
    return;
  }
  const QString here = *cached ? tr("The ones here are of %1.").arg(QString::fromStdString((*cached)->fetched).left(10)) : tr("None are here yet.");
  QMessageBox box(QMessageBox::Question, tr("Update airfields"), tr("Fetch the airfields of the world from OurAirports?"), QMessageBox::Cancel,
                  window_);
  box.setInformativeText(here + QLatin1Char(' ') + tr("About 17 MB are fetched, less if nothing is new."));
  QPushButton* proceed = box.addButton(tr("Fetch"), QMessageBox::AcceptRole);
  box.exec();
  if (box.clickedButton() == proceed) {
    startUpdate();
  }
}

void FetchController::startUpdate() {
  offerStop(tr("Fetching the airfields…"));
  runner_.start<fetch::AirfieldFiles>([](const Job& job) { return fetch::updateAirfields({}, job); },
                                      [this](const Result<fetch::AirfieldFiles>& files) {
                                        emit working({});
                                        if (!files) {
                                          banner_.show(MessageBanner::Kind::Failure, style::coreText(files.error()));
                                          emit finished(false);
                                          return;
                                        }
                                        const QString told = files->wasUpToDate ? tr("The airfields are up to date.")
                                                                                : tr("Airfields of %1: %L2 landing sites in the world.")
                                                                                      .arg(QString::fromStdString(files->fetched).left(10))
                                                                                      .arg(static_cast<qulonglong>(files->sites));
                                        const mission::AirfieldSource source{files->airports, files->runways};
                                        const auto& had = workspace_.document().mission().airfields;
                                        if (std::find(had.begin(), had.end(), source) != had.end()) {
                                          banner_.show(MessageBanner::Kind::Success,
                                                       told + QLatin1Char(' ') + tr("Open the mission again to use them."));
                                        } else {
                                          addToMission({{}, {source}, {}, {}}, told, {});
                                        }
                                        emit finished(true);
                                      });
}

void FetchController::writeSafeAltitudesByDialog() {
  const auto world = workspace_.world();
  const auto roadmap = workspace_.roadmap();
  const auto terrain = workspace_.situation().terrain;
  if (!world || !roadmap || !terrain) {
    banner_.show(MessageBanner::Kind::Warning,
                 tr("The landing glides are not known yet: the mission needs terrain and runways, and a moment to compute."));
    return;
  }
  dialogs::SafeAltitudeDialog dialog(window_);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  QString path = QFileDialog::getSaveFileName(window_, tr("Write lowest safe altitudes to"), outputFor(QStringLiteral("-safe-altitude.tif")),
                                              QStringLiteral("GeoTIFF (*.tif);;KML (*.kml);;GeoPackage (*.gpkg)"));
  if (path.isEmpty()) {
    return;
  }
  path += QFileInfo(path).suffix().isEmpty() ? QStringLiteral(".tif") : QString();
  charts::ChartRequest request = dialog.request();
  request.area = workspace_.glideArea();
  request.threads = static_cast<int>(std::max(1U, std::thread::hardware_concurrency() / 2));  // the window wants some too
  offerStop(tr("Computing the lowest safe altitudes…"));
  runner_.start<charts::ChartSummary>(
      [world, roadmap, frame = terrain->frame, mission = workspace_.document().mission(), request, path](const Job& job) {
        return charts::writeSafeAltitudeChart(*world, *roadmap, frame, mission, request, path.toStdString(), job);
      },
      [this, path](const Result<charts::ChartSummary>& summary) {
        emit working({});
        if (summary) {
          banner_.show(MessageBanner::Kind::Success, tr("Written to %1: cells of %2 m, %3 % of the area has a lowest safe altitude.")
                                                         .arg(path)
                                                         .arg(summary->cell)
                                                         .arg(static_cast<int>(100.0 * summary->knownShare)));
        } else {
          banner_.show(summary.error().code == Errc::Cancelled ? MessageBanner::Kind::Hint : MessageBanner::Kind::Failure,
                       style::coreText(summary.error()));
        }
        emit finished(summary.has_value());
      });
}

}  // namespace vp::gui
