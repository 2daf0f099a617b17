#include "app/gui/file_controller.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

namespace vp::gui {
namespace {

bool isDocument(const QString& path) {
  return path.endsWith(QStringLiteral(".vpm"), Qt::CaseInsensitive) || path.endsWith(QStringLiteral(".vpp"), Qt::CaseInsensitive);
}

}  // namespace

using dialogs::MessageBanner;

FileController::FileController(jobs::Workspace& workspace, MessageBanner& banner, QWidget* window)
    : QObject(window), workspace_(workspace), banner_(banner), window_(window) {}

QString FileController::folder() const {
  const QString path = workspace_.document().path();
  return path.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : QFileInfo(path).absolutePath();
}

bool FileController::mayDiscard() {
  if (!workspace_.document().isModified()) {
    return true;
  }
  QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), tr("“%1” has changes that are not saved.").arg(workspace_.document().title()),
                  QMessageBox::NoButton, window_);
  box.setInformativeText(tr("Save them first?"));
  QPushButton* saveButton = box.addButton(QMessageBox::Save);
  QPushButton* discard = box.addButton(QMessageBox::Discard);
  box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(saveButton);
  box.exec();
  if (box.clickedButton() == saveButton) {
    return save();
  }
  return box.clickedButton() == discard;
}

void FileController::startNew() {
  if (mayDiscard()) {
    workspace_.cancelPlanning();
    workspace_.document().startNew();
    banner_.hide();
  }
}

void FileController::openByDialog() {
  const QString path =
      QFileDialog::getOpenFileName(window_, tr("Open mission or plan"), folder(), tr("Missions and plans (*.vpm *.vpp);;All files (*)"));
  if (!path.isEmpty()) {
    open(path);
  }
}

bool FileController::open(const QString& path) {
  if (!mayDiscard()) {
    return false;
  }
  workspace_.cancelPlanning();
  const Result<void> result = workspace_.document().open(path);
  if (!result) {
    banner_.show(MessageBanner::Kind::Failure, QString::fromStdString(result.error().message()));
    return false;
  }
  banner_.hide();
  emit opened(workspace_.document().path().isEmpty() ? path : workspace_.document().path());
  return true;
}

bool FileController::write(const QString& path) {
  const Result<void> result = workspace_.document().saveAs(path);
  if (!result) {
    QMessageBox::critical(window_, tr("Not saved"), QString::fromStdString(result.error().message()));
    return false;
  }
  emit opened(path);
  return true;
}

bool FileController::save() {
  const QString path = workspace_.document().path();
  return path.isEmpty() ? saveAs() : write(path);
}

bool FileController::saveAs() {
  QString name = workspace_.document().title();
  name.replace(QLatin1Char('/'), QLatin1Char('-'));
  QString path =
      QFileDialog::getSaveFileName(window_, tr("Save mission"), QDir(folder()).filePath(name + QStringLiteral(".vpm")), tr("Missions (*.vpm)"));
  if (path.isEmpty()) {
    return false;
  }
  if (!path.endsWith(QStringLiteral(".vpm"), Qt::CaseInsensitive)) {
    path += QStringLiteral(".vpm");
  }
  return write(path);
}

void FileController::addTerrainByDialog() {
  const QStringList paths = QFileDialog::getOpenFileNames(
      window_, tr("Add terrain"), folder(), tr("Elevation rasters (*.tif *.tiff *.hgt *.dt0 *.dt1 *.dt2 *.asc *.img *.vrt *.bil);;All files (*)"));
  if (!paths.isEmpty()) {
    take(paths);
  }
}

void FileController::addAirfieldsByDialog() {
  const QStringList paths = QFileDialog::getOpenFileNames(window_, tr("Add airfields"), folder(),
                                                          tr("OurAirports csv (both files) or SeeYou cup (*.csv *.csv.gz *.cup);;All files (*)"));
  if (!paths.isEmpty()) {
    take(paths);
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
  const Result<void> added = workspace_.addFiles(others);
  if (!added) {
    banner_.show(MessageBanner::Kind::Failure, QString::fromStdString(added.error().message()));
  }
}

bool FileController::mayClose() {
  if (workspace_.activity() == jobs::Workspace::Activity::Planning) {
    const auto answer = QMessageBox::question(window_, tr("Planning is running"), tr("A plan is being made. Stop it and close?"),
                                              QMessageBox::Close | QMessageBox::Cancel, QMessageBox::Cancel);
    if (answer != QMessageBox::Close) {
      return false;
    }
    workspace_.cancelPlanning();
  }
  return mayDiscard();
}

}  // namespace vp::gui
