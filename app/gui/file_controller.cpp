#include "app/gui/file_controller.h"

#include "core/formats/airfields.h"
#include "core/formats/mission_loader.h"
#include "ui/dialogs/import_targets_dialog.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include <algorithm>
#include <utility>

namespace vp::gui {
namespace {

bool isDocument(const QString& path) {
  return path.endsWith(QStringLiteral(".vpm"), Qt::CaseInsensitive) || path.endsWith(QStringLiteral(".vpp"), Qt::CaseInsensitive);
}

}  // namespace

using dialogs::MessageBanner;

FileController::FileController(jobs::Workspace& workspace, MessageBanner& banner, QWidget* window)
    : QObject(window), workspace_(workspace), banner_(banner), window_(window) {
  connect(&workspace_.document(), &document::MissionDocument::replaced, this, [this] { isReplaced_ = true; });
}

QString FileController::folder() const {
  const QString path = workspace_.document().path();
  return path.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : QFileInfo(path).absolutePath();
}

FileController::Answer FileController::askAboutChanges() {
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), tr("“%1” has changes that are not saved.").arg(workspace_.document().title()),
                  QMessageBox::NoButton, window_);
  box.setInformativeText(tr("Save them first?"));
  QPushButton* saveButton = box.addButton(QMessageBox::Save);
  QPushButton* discard = box.addButton(QMessageBox::Discard);
  box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(saveButton);
  box.exec();
  return box.clickedButton() == saveButton ? Answer::Save : box.clickedButton() == discard ? Answer::Discard : Answer::Cancel;
}

/// Goes on when nothing is unsaved any more, or the operator gives it up.
void FileController::whenDiscardable(const Next& next) {
  if (writer_.isRunning()) {
    afterWriting_.emplace_back([this, next] { whenDiscardable(next); });
    return;
  }
  const Answer answer = workspace_.document().isModified() ? askAboutChanges() : Answer::Discard;
  if (answer == Answer::Save) {
    save([this, next] { whenDiscardable(next); });  // it may have been edited again by then
  } else if (answer == Answer::Discard) {
    next();
  }
}

void FileController::startNew() {
  whenDiscardable([this] {
    reader_.cancel();
    workspace_.document().startNew();
    banner_.hide();
    emit working({});
  });
}

void FileController::openByDialog() {
  const QString path =
      QFileDialog::getOpenFileName(window_, tr("Open mission or plan"), folder(), tr("Missions and plans (*.vpm *.vpp);;All files (*)"));
  if (!path.isEmpty()) {
    open(path);
  }
}

void FileController::open(const QString& path, std::function<void(bool)> done) {
  whenDiscardable([this, path, done = std::move(done)] { read(path, done); });
}

void FileController::read(const QString& path, const std::function<void(bool)>& done) {
  using Contents = document::DocumentContents;
  const document::DocumentContents before = workspace_.document().snapshot();
  emit working(tr("Reading %1").arg(QFileInfo(path).fileName()));
  reader_.start<Contents>([path](const Job&) { return document::readDocument(path); },
                          [this, path, done, before](const Result<Contents>& contents) {
                            emit working({});
                            if (!contents) {
                              banner_.show(MessageBanner::Kind::Failure, QString::fromStdString(contents.error().message()));
                              if (done) {
                                done(false);
                              }
                              return;
                            }
                            const document::MissionDocument& now = workspace_.document();
                            if (now.sharedMission() == before.mission && now.plan() == before.plan) {
                              adopt(*contents, path, done);
                            } else {  // edited while the file was read
                              whenDiscardable([this, contents = *contents, path, done] { adopt(contents, path, done); });
                            }
                          });
}

void FileController::adopt(const document::DocumentContents& contents, const QString& path, const std::function<void(bool)>& done) {
  workspace_.document().adopt(contents);
  banner_.hide();
  emit opened(contents.path.isEmpty() ? path : contents.path);
  if (done) {
    done(true);
  }
}

void FileController::write(const QString& path, const Next& next) {
  if (writer_.isRunning()) {
    afterWriting_.emplace_back([this, path, next] { write(path, next); });
    return;
  }
  const QString absolute = QFileInfo(path).absoluteFilePath();
  const document::MissionDocument& document = workspace_.document();
  isReplaced_ = false;
  emit working(tr("Writing %1").arg(QFileInfo(absolute).fileName()));
  writer_.start<bool>(
      [snapshot = document.snapshot(), absolute, withPlan = document.needsPlanWritten(absolute)](const Job&) -> Result<bool> {
        const Result<void> done = document::writeDocument(snapshot, absolute, withPlan);
        if (!done) {
          return forward(done);
        }
        return true;
      },
      [this, snapshot = document.snapshot(), absolute, next](const Result<bool>& result) { written(result, snapshot, absolute, next); });
}

void FileController::written(const Result<bool>& result, const document::DocumentContents& snapshot, const QString& path, const Next& next) {
  emit working({});
  const bool isStillShown = !isReplaced_;
  if (!result) {
    QMessageBox::critical(window_, tr("Not saved"), QString::fromStdString(result.error().message()));
  } else if (isStillShown) {
    workspace_.document().markSaved(snapshot, path);
    emit saved(path);
  }
  for (const Next& waiting : std::exchange(afterWriting_, {})) {
    waiting();
  }
  if (result && isStillShown && next) {
    next();
  }
}

void FileController::save(const Next& next) {
  const QString path = workspace_.document().path();
  if (path.isEmpty()) {
    saveAs(next);
  } else {
    write(path, next);
  }
}

void FileController::saveAs(const Next& next) {
  QString name = workspace_.document().title();
  name.replace(QLatin1Char('/'), QLatin1Char('-'));
  QString path =
      QFileDialog::getSaveFileName(window_, tr("Save mission"), QDir(folder()).filePath(name + QStringLiteral(".vpm")), tr("Missions (*.vpm)"));
  if (path.isEmpty()) {
    return;
  }
  if (!path.endsWith(QStringLiteral(".vpm"), Qt::CaseInsensitive)) {
    path += QStringLiteral(".vpm");
  }
  write(path, next);
}

void FileController::addTerrainByDialog() {
  const QStringList paths = QFileDialog::getOpenFileNames(
      window_, tr("Add terrain"), folder(), tr("Elevation rasters (*.tif *.tiff *.hgt *.dt0 *.dt1 *.dt2 *.asc *.img *.vrt *.bil);;All files (*)"));
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
    addFiles(paths);
  }
}

void FileController::addAirspacesByDialog() {
  const QStringList paths =
      QFileDialog::getOpenFileNames(window_, tr("Add airspaces"), folder(), tr("Airspaces: OpenAir (*.txt *.air *.txt.gz *.air.gz);;All files (*)"));
  if (!paths.isEmpty()) {
    addFiles(paths);
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
    return;
  }
  if (!documents.isEmpty()) {
    open(documents.front());
    return;
  }
  const auto targets = std::stable_partition(others.begin(), others.end(), [this](const QString& path) { return !meansTargets(path); });
  const QStringList imports(targets, others.end());
  others.erase(targets, others.end());
  if (!others.isEmpty() && !addFiles(others)) {
    return;
  }
  for (const QString& path : imports) {
    importTargets(path);
  }
}

bool FileController::addFiles(const QStringList& paths) {
  const Result<void> added = workspace_.addFiles(paths);
  if (!added) {
    banner_.show(MessageBanner::Kind::Failure, QString::fromStdString(added.error().message()));
  }
  return added.has_value();
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

/// Whether a file that was dropped holds targets; asks where it may as well hold airfields.
bool FileController::meansTargets(const QString& path) {
  const std::string native = path.toStdString();
  if (formats::targetFileOf(native) == formats::TargetFile::None) {
    return false;
  }
  switch (formats::airfieldFileOf(native)) {
    case formats::AirfieldFile::None:
      return true;
    case formats::AirfieldFile::SeeYou:
    case formats::AirfieldFile::OwnTable:
    case formats::AirfieldFile::GeoJson: {
      QMessageBox ask(QMessageBox::Question, tr("Airfields or targets?"),
                      tr("%1 can be taken for airfields or for targets.").arg(QFileInfo(path).fileName()), QMessageBox::NoButton, window_);
      ask.addButton(tr("&Airfields"), QMessageBox::AcceptRole);
      const QPushButton* targets = ask.addButton(tr("&Targets"), QMessageBox::ActionRole);
      ask.exec();
      return ask.clickedButton() == targets;
    }
    default:
      return false;
  }
}

void FileController::importTargets(const QString& path) {
  const QString name = QFileInfo(path).fileName();
  dialogs::ImportTargetsDialog dialog(name, workspace_.view().units(), window_);
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  const Result<formats::ImportedTargets> imported =
      formats::importTargets(path.toStdString(), dialog.options(), workspace_.document().mission().targets);
  if (!imported) {
    banner_.show(MessageBanner::Kind::Failure, QString::fromStdString(imported.error().message()));
    return;
  }
  addTargets(*imported, name);
}

void FileController::addTargets(const formats::ImportedTargets& imported, const QString& fileName) {
  workspace_.document().edit(tr("Import targets from %1").arg(fileName),
                             [&](mission::Mission& m) { m.targets.insert(m.targets.end(), imported.targets.begin(), imported.targets.end()); });
  QStringList sentences{tr("%n target(s) imported from %1.", nullptr, static_cast<int>(imported.targets.size())).arg(fileName)};
  for (const std::string& note : imported.notes) {
    sentences << QString::fromStdString(note) + QLatin1Char('.');
  }
  QStringList outside;
  if (const auto& terrain = workspace_.situation().terrain) {
    for (const mission::Target& target : imported.targets) {
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

bool FileController::mayClose(Next later) {
  if (workspace_.activity() == jobs::Workspace::Activity::Planning) {
    const auto answer = QMessageBox::question(window_, tr("Planning is running"), tr("A plan is being made. Stop it and close?"),
                                              QMessageBox::Close | QMessageBox::Cancel, QMessageBox::Cancel);
    if (answer != QMessageBox::Close) {
      return false;
    }
    workspace_.cancelPlanning();
  }
  if (writer_.isRunning()) {
    afterWriting_.push_back(std::move(later));
    return false;
  }
  const Answer answer = workspace_.document().isModified() ? askAboutChanges() : Answer::Discard;
  if (answer == Answer::Save) {
    save(later);
  }
  return answer == Answer::Discard;
}

}  // namespace vp::gui
