// Missions that somebody else has open, or has changed since they were opened here.
#include "app/gui/bundled.h"
#include "app/gui/file_controller.h"
#include "app/gui/opened_file.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QSysInfo>

namespace vp::gui {

using document::DocumentLock;

namespace {

std::vector<jobs::FileStamp> stampsOfMission(const QString& path) {
  return jobs::stampsOf({path.toStdString(), document::planPathOf(path).toStdString()});
}

DocumentLock::Outcome takeLock(DocumentLock& lock, const QString& path) {
  return isBundled(path) ? lock.pass(path) : lock.take(path);
}

/// Written by somebody else; one that is gone is simply written again. When an entry changed (by a backup, say) counts for nothing.
bool isChanged(const jobs::FileStamp& before, const jobs::FileStamp& now) {
  return now.size >= 0 && (now.size != before.size || now.changed != before.changed);
}

}  // namespace

Result<OpenedFile> openFile(const QString& path) {
  const QFileInfo file(path);
  const bool isPlan = file.suffix().compare(QStringLiteral("vpp"), Qt::CaseInsensitive) == 0;
  const QString mission = isPlan ? file.dir().absoluteFilePath(file.completeBaseName() + QStringLiteral(".vpm")) : file.absoluteFilePath();
  OpenedFile opened;
  opened.stamps = stampsOfMission(mission);
  Result<document::DocumentContents> contents = document::readDocument(path);
  if (!contents) {
    return forward(contents);
  }
  opened.contents = std::move(*contents);
  opened.lock = std::make_shared<DocumentLock>();
  if (!opened.contents.path.isEmpty()) {
    opened.outcome = takeLock(*opened.lock, opened.contents.path);
  }
  return opened;
}

Result<WrittenFile> saveFile(const SaveOrder& order) {
  WrittenFile written;
  written.lock = order.lock;
  if (!written.lock || written.lock->missionPath() != order.path || written.lock->outcome() == DocumentLock::Outcome::Busy) {
    written.lock = std::make_shared<DocumentLock>();
    if (takeLock(*written.lock, order.path) == DocumentLock::Outcome::Busy && !order.evenIfOpenElsewhere) {
      written.isOpenElsewhere = true;
      return written;
    }
  }
  if (!order.evenIfChanged && !order.expected.empty()) {
    const std::vector<jobs::FileStamp> now = stampsOfMission(order.path);
    if (isChanged(order.expected[0], now[0]) || (order.withPlan && isChanged(order.expected[1], now[1]))) {
      return written;
    }
  }
  if (const Result<void> done = document::writeDocument(order.snapshot, order.path, order.withPlan); !done) {
    return forward(done);
  }
  written.isWritten = true;
  written.stamps = stampsOfMission(order.path);
  return written;
}

/// Called when the operator wants to open a mission that somebody else has open.
FileController::WhileOpen FileController::askAboutOther(const QString& path, const document::LockOwner& owner) {
  QMessageBox box(QMessageBox::Warning, tr("Open elsewhere"), tr("“%1” is open elsewhere: %2.").arg(QFileInfo(path).fileName(), owner.text()),
                  QMessageBox::NoButton, window_);
  const bool isHere = owner.host == QSysInfo::machineHostName();
  box.setInformativeText((isHere ? QString() : tr("Whether that window still runs cannot be told from here.") + QLatin1Char(' ')) +
                         tr("A copy can be changed and saved under another name. If both save the same file, the later one wins."));
  QPushButton* copy = box.addButton(tr("Open a copy"), QMessageBox::AcceptRole);
  QPushButton* anyway = box.addButton(tr("Open anyway"), QMessageBox::DestructiveRole);
  box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(copy);
  box.exec();
  return box.clickedButton() == copy ? WhileOpen::Copy : box.clickedButton() == anyway ? WhileOpen::Anyway : WhileOpen::Cancel;
}

/// Called when nothing was written, because that would have run over what somebody else did.
void FileController::askAboutOverwriting(const QString& path, const WrittenFile& written, const Next& next) {
  const QString name = QFileInfo(path).fileName();
  const QString why = written.isOpenElsewhere ? tr("“%1” is open elsewhere: %2.").arg(name, written.lock->owner().text())
                                              : tr("“%1” has been changed on disk since it was opened here, at %2.")
                                                    .arg(name, QLocale().toString(QFileInfo(path).lastModified(), QLocale::ShortFormat));
  QMessageBox box(QMessageBox::Warning, tr("Not saved"), why, QMessageBox::NoButton, window_);
  box.setInformativeText(tr("Save this work under another name, or overwrite what is there?"));
  QPushButton* other = box.addButton(tr("Save as…"), QMessageBox::AcceptRole);
  QPushButton* overwrite = box.addButton(tr("Overwrite"), QMessageBox::DestructiveRole);
  box.addButton(QMessageBox::Cancel);
  box.setDefaultButton(other);
  box.exec();
  if (box.clickedButton() == other) {
    saveAs(next);
  } else if (box.clickedButton() == overwrite) {
    write(path, next, true);
  }
}

/// The lock goes with the document, however that came by its file: recovered after a crash, begun anew.
void FileController::followPath() {
  const QString path = workspace_.document().path();
  if (path == (lock_ ? lock_->missionPath() : QString())) {
    return;
  }
  lock_.reset();
  if (!path.isEmpty()) {
    lock_ = std::make_shared<DocumentLock>();
    stampedPath_ = path;
    stamps_ = stampsOfMission(path);
    takeLock(*lock_, path);  // if somebody else has it, that is asked about when it is to be saved
  }
}

}  // namespace vp::gui
