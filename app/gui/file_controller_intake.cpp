// What is added to a mission: terrain, airfields, airspaces, population, weather and targets.
#include "app/gui/file_controller.h"
#include "core/formats/mission_loader.h"
#include "ui/dialogs/import_targets_dialog.h"
#include "ui/style/core_text.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace vp::gui {
namespace {

using dialogs::MessageBanner;
using jobs::FileIntake;

constexpr int kLong = 500;  // ms of reading after which stopping is offered

bool isDocument(const QString& path) {
  return path.endsWith(QStringLiteral(".vpm"), Qt::CaseInsensitive) || path.endsWith(QStringLiteral(".vpp"), Qt::CaseInsensitive);
}

}  // namespace

void FileController::connectIntake() {
  stopDelay_.setSingleShot(true);
  stopDelay_.setInterval(kLong);
  connect(&stopDelay_, &QTimer::timeout, this, &FileController::offerStop);
  connect(&intake_, &FileIntake::working, this, &FileController::showReading);
  connect(&intake_, &FileIntake::targetsAdded, this, &FileController::tellTargets);
  connect(&intake_, &FileIntake::weatherAdded, this, &FileController::tellWeather);
  connect(&intake_, &FileIntake::refused, this, [this](const Error& error) { banner_.show(MessageBanner::Kind::Failure, style::coreText(error)); });
}

void FileController::addTerrainByDialog() {
  const QStringList paths = QFileDialog::getOpenFileNames(
      window_, tr("Add terrain"), folder(), tr("Elevation rasters (*.tif *.tiff *.hgt *.dt0 *.dt1 *.dt2 *.asc *.img *.bil);;All files (*)"));
  if (!paths.isEmpty()) {
    take(paths);
  }
}

void FileController::addAirfieldsByDialog() {
  const QStringList paths =
      QFileDialog::getOpenFileNames(window_, tr("Add airfields"), folder(),
                                    tr("Airfields: OurAirports csv (both files), X-Plane apt.dat, SeeYou cup, own csv or GeoJSON "
                                       "(*.csv *.csv.gz *.cup *.dat *.dat.gz *.geojson *.json);;All files (*)"));
  if (!paths.isEmpty()) {
    intake_.take(paths, FileIntake::Purpose::Map);
  }
}

void FileController::addAirspacesByDialog() {
  const QStringList paths =
      QFileDialog::getOpenFileNames(window_, tr("Add airspaces"), folder(), tr("Airspaces: OpenAir (*.txt *.air *.txt.gz *.air.gz);;All files (*)"));
  if (!paths.isEmpty()) {
    intake_.take(paths, FileIntake::Purpose::Map);
  }
}

void FileController::addWeatherByDialog() {
  const QStringList paths = QFileDialog::getOpenFileNames(window_, tr("Add weather"), folder(),
                                                          tr("Polygons of weather (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;All files (*)"));
  if (!paths.isEmpty()) {
    intake_.take(paths, FileIntake::Purpose::Weather);
  }
}

void FileController::addPopulationByDialog() {
  const QStringList paths = QFileDialog::getOpenFileNames(
      window_, tr("Add population"), folder(), tr("Polygons with people in them (*.geojson *.json *.shp *.gpkg *.kml *.kmz);;All files (*)"));
  if (!paths.isEmpty()) {
    intake_.take(paths, FileIntake::Purpose::Population);
  }
}

void FileController::importTargetsByDialog() {
  const QString path = QFileDialog::getOpenFileName(
      window_, tr("Import targets"), folder(),
      tr("Targets: SeeYou, GPX, KML, table, GeoJSON, QGroundControl, Little Navmap (*.cup *.gpx *.kml *.kmz *.csv *.geojson *.json *.plan *.lnmpln);;"
         "All files (*)"));
  if (!path.isEmpty()) {
    importTargets(path);
  }
}

void FileController::take(const QStringList& paths) {
  QStringList documents;
  QStringList others;
  for (const QString& path : paths) {
    (isDocument(path) ? documents : others) << path;
  }
  if (documents.size() > 1 || (!documents.isEmpty() && !others.isEmpty())) {
    banner_.show(MessageBanner::Kind::Warning, tr("Open one mission or plan at a time, and terrain and airfields after it."));
  } else if (!documents.isEmpty()) {
    open(documents.front());
  } else {
    intake_.take(others, FileIntake::Purpose::Any);
  }
}

void FileController::importTargets(const QString& path) {
  intake_.take({path}, FileIntake::Purpose::Targets);
}

FileIntake::Holds FileController::askWhich(const QString& path) {
  QMessageBox ask(QMessageBox::Question, tr("Airfields or targets?"),
                  tr("%1 can be taken for airfields or for targets.").arg(QFileInfo(path).fileName()), QMessageBox::NoButton, window_);
  const QPushButton* airfields = ask.addButton(tr("&Airfields"), QMessageBox::AcceptRole);
  const QPushButton* targets = ask.addButton(tr("&Targets"), QMessageBox::ActionRole);
  ask.addButton(tr("&Leave it out"), QMessageBox::RejectRole);
  connect(&workspace_.document(), &document::MissionDocument::replaced, &ask, &QDialog::reject);
  ask.exec();
  return ask.clickedButton() == targets     ? FileIntake::Holds::Targets
         : ask.clickedButton() == airfields ? FileIntake::Holds::Airfields
                                            : FileIntake::Holds::Neither;
}

std::optional<formats::ImportedTargets> FileController::askTargets(const jobs::TargetsOfFile& file) {
  dialogs::ImportTargetsDialog dialog(file, workspace_.view().units(), window_);
  connect(&workspace_.document(), &document::MissionDocument::replaced, &dialog, &QDialog::reject);
  return dialog.exec() == QDialog::Accepted ? std::optional(dialog.chosen()) : std::nullopt;
}

void FileController::showReading(const QString& text) {
  emit working(text);
  reading_ = text;
  if (!text.isEmpty()) {
    if (!stopDelay_.isActive() && offeredStop_.isEmpty()) {
      stopDelay_.start();
    }
    return;
  }
  stopDelay_.stop();
  if (!offeredStop_.isEmpty() && banner_.text() == offeredStop_) {
    banner_.hide();
  }
  offeredStop_.clear();
}

void FileController::offerStop() {
  offeredStop_ = reading_ + QStringLiteral("…");
  banner_.show(MessageBanner::Kind::Hint, offeredStop_, {{tr("Stop"), [this] { intake_.cancel(); }}});
}

void FileController::tellTargets(const QString& path, const formats::ImportedTargets& added) {
  QStringList sentences{tr("%n target(s) imported from %1.", nullptr, static_cast<int>(added.targets.size())).arg(QFileInfo(path).fileName())};
  for (const std::string& note : added.notes) {
    sentences << style::coreText(note) + QLatin1Char('.');
  }
  QStringList outside;
  if (const auto& terrain = workspace_.situation().terrain) {
    for (const mission::Target& target : added.targets) {
      if (!formats::placeTarget(target, terrain->frame, *terrain->grid)) {
        outside << QString::fromStdString(target.name);
      }
    }
  }
  if (!outside.isEmpty()) {
    constexpr qsizetype kNamed = 5;
    sentences << tr("%n of them cannot be planned on this terrain: %1.", nullptr, static_cast<int>(outside.size()))
                     .arg(outside.mid(0, kNamed).join(QStringLiteral(", ")) + (outside.size() > kNamed ? QStringLiteral(", …") : QString()));
  }
  banner_.show(sentences.size() > 1 ? MessageBanner::Kind::Warning : MessageBanner::Kind::Success, sentences.join(QLatin1Char(' ')));
}

void FileController::tellWeather(const QString& path, int count, const QStringList& notes) {
  constexpr qsizetype kNamed = 4;
  QStringList sentences{tr("%n weather cell(s) added from %1.", nullptr, count).arg(QFileInfo(path).fileName())};
  sentences += notes.mid(0, kNamed);
  if (notes.size() > kNamed) {
    sentences << tr("And %n more note(s).", nullptr, static_cast<int>(notes.size() - kNamed));
  }
  banner_.show(notes.isEmpty() ? MessageBanner::Kind::Success : MessageBanner::Kind::Warning, sentences.join(QLatin1Char(' ')));
}

}  // namespace vp::gui
