#include "app/gui/file_controller.h"

#include "app/gui/opened_file.h"
#include "app/gui/suggested_file.h"
#include "ui/style/core_text.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace vp::gui {
using dialogs::MessageBanner;

FileController::FileController(jobs::Workspace& workspace, MessageBanner& banner, QWidget* window)
    : QObject(window),
      workspace_(workspace),
      banner_(banner),
      window_(window),
      intake_(workspace,
              {[this](const QString& path) { return askWhich(path); }, [this](const jobs::TargetsOfFile& file) { return askTargets(file); }}) {
  connect(&workspace_.document(), &document::MissionDocument::replaced, this, [this] { isReplaced_ = true; });
  connect(&workspace_.document(), &document::MissionDocument::stateChanged, this, &FileController::followPath);
  connectIntake();
}

QString FileController::folder() const {
  return suggestedFolder(workspace_.document());
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
  const document::DocumentContents before = workspace_.document().snapshot();
  emit working(tr("Reading %1").arg(QFileInfo(path).fileName()));
  reader_.start<OpenedFile>([path](const Job&) { return openFile(path); },
                            [this, path, done, before](const Result<OpenedFile>& opened) {
                              emit working({});
                              if (!opened) {
                                banner_.show(MessageBanner::Kind::Failure, style::coreText(opened.error()));
                                if (done) {
                                  done(false);
                                }
                                return;
                              }
                              const document::MissionDocument& now = workspace_.document();
                              if (now.sharedMission() == before.mission && now.plan() == before.plan) {
                                adopt(*opened, path, done);
                              } else {  // edited while the file was read
                                whenDiscardable([this, opened = *opened, path, done] { adopt(opened, path, done); });
                              }
                            });
}

void FileController::adopt(const OpenedFile& read, const QString& path, const std::function<void(bool)>& done) {
  document::DocumentContents contents = read.contents;
  const QString mission = contents.path;
  const bool isBusy = read.outcome == document::DocumentLock::Outcome::Busy;
  const WhileOpen answer = isBusy ? askAboutOther(mission, read.lock->owner()) : WhileOpen::Anyway;
  if (answer == WhileOpen::Cancel) {
    return;
  }
  const bool isCopy = answer == WhileOpen::Copy;
  sharedPath_ = isBusy && !isCopy ? mission : QString();
  if (isCopy) {
    contents.path.clear();
  } else if (!lock_ || lock_->missionPath() != mission) {
    lock_ = read.lock;
  }
  stampedPath_ = contents.path;
  stamps_ = read.stamps;
  workspace_.document().adopt(contents);
  banner_.hide();
  emit opened(contents.path.isEmpty() ? path : contents.path);
  if (isCopy) {
    banner_.show(MessageBanner::Kind::Hint, tr("“%1” is open elsewhere: %2. This is a copy of it; save it under another name.")
                                                .arg(QFileInfo(mission).fileName(), read.lock->owner().text()));
  }
  if (done) {
    done(true);
  }
}

void FileController::write(const QString& path, const Next& next, bool force) {
  if (writer_.isRunning()) {
    afterWriting_.emplace_back([this, path, next, force] { write(path, next, force); });
    return;
  }
  const QString absolute = QFileInfo(path).absoluteFilePath();
  const document::MissionDocument& document = workspace_.document();
  isReplaced_ = false;
  emit working(tr("Writing %1").arg(QFileInfo(absolute).fileName()));
  SaveOrder order{document.snapshot(), absolute, document.needsPlanWritten(absolute), force || sharedPath_ == absolute, force, lock_, {}};
  if (stampedPath_ == absolute) {
    order.expected = stamps_;
  }
  writer_.start<WrittenFile>([order](const Job&) { return saveFile(order); },
                             [this, order, next](const Result<WrittenFile>& result) { written(result, order.snapshot, order.path, next); });
}

void FileController::written(const Result<WrittenFile>& result, const document::DocumentContents& snapshot, const QString& path, const Next& next) {
  emit working({});
  const bool isStillShown = !isReplaced_;
  const bool isWritten = result && result->isWritten;
  if (!result) {
    QMessageBox::critical(window_, tr("Not saved"), style::coreText(result.error()));
  } else if (isStillShown && isWritten) {
    lock_ = result->lock;
    stampedPath_ = path;
    stamps_ = result->stamps;
    workspace_.document().markSaved(snapshot, path);
    emit saved(path);
  } else if (isStillShown) {
    askAboutOverwriting(path, *result, next);
  }
  for (const Next& waiting : std::exchange(afterWriting_, {})) {
    waiting();
  }
  if (isWritten && isStillShown && next) {
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
  } else if (answer == Answer::Discard) {
    intake_.cancel();  // nothing is asked any more once the window is gone
  }
  return answer == Answer::Discard;
}

}  // namespace vp::gui
