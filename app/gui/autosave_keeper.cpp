#include "app/gui/autosave_keeper.h"

#include "ui/style/core_text.h"

#include <QFileInfo>

#include <utility>

namespace vp::gui {
namespace {
constexpr int kDelay = 2000;   // ms after a change
constexpr int kRetry = 30000;  // ms after it could not be written
}  // namespace

using dialogs::MessageBanner;
using document::Autosave;

AutosaveKeeper::AutosaveKeeper(jobs::Workspace& workspace, MessageBanner& banner, const QString& folder, QObject* parent)
    : QObject(parent), workspace_(workspace), banner_(banner), folder_(folder.isEmpty() ? Autosave::defaultFolder() : folder), autosave_(folder_) {
  delay_.setSingleShot(true);
  delay_.setInterval(kDelay);
  connect(&delay_, &QTimer::timeout, this, &AutosaveKeeper::write);
  connect(&workspace_.document(), &document::MissionDocument::stateChanged, this, [this] {
    if (!workspace_.document().isModified()) {
      delay_.stop();
      writer_.cancel();
      autosave_.remove();
    } else if (!delay_.isActive()) {
      delay_.start();
    }
  });
}

void AutosaveKeeper::write() {
  if (writer_.isRunning()) {
    delay_.start();
    return;
  }
  delay_.setInterval(kDelay);
  writer_.start<bool>(
      [this, snapshot = workspace_.document().snapshot(), ticket = autosave_.ticket()](const Job& job) -> Result<bool> {
        const std::string data = document::MissionDocument::recoveryData(snapshot);
        if (job.stopRequested()) {
          return false;
        }
        const Result<void> done = autosave_.write(data, ticket);
        if (!done && done.error().code != Errc::Cancelled) {
          return forward(done);
        }
        return done.has_value();
      },
      [this](const Result<bool>& result) { written(result); });
}

void AutosaveKeeper::written(const Result<bool>& result) {
  if (!workspace_.document().isModified()) {
    autosave_.remove();
  }
  if (result) {
    isFailing_ = false;
    return;
  }
  delay_.setInterval(kRetry);
  delay_.start();
  if (!std::exchange(isFailing_, true)) {
    banner_.show(MessageBanner::Kind::Warning,
                 tr("Unsaved work cannot be kept for the case of a crash; save the mission yourself. %1").arg(style::coreText(result.error())));
  }
}

void AutosaveKeeper::offerRecovery(const std::function<void(const QString&)>& otherwise) {
  const std::optional<Autosave::Found> found = Autosave::takeOrphan(folder_);
  if (!found) {
    otherwise({});
    return;
  }
  using Contents = document::DocumentContents;
  reader_.start<Contents>([data = found->data](const Job&) { return document::readRecoveryText(data); },
                          [this, found, otherwise](const Result<Contents>& contents) {
                            if (contents) {
                              recovered(*found, *contents);
                              return;
                            }
                            otherwise(tr("Work of a session that ended unexpectedly was found but cannot be read: %1 It stays in %2.")
                                          .arg(style::coreText(contents.error()), found->file));
                          });
}

void AutosaveKeeper::recovered(const Autosave::Found& found, const document::DocumentContents& contents) {
  workspace_.document().adoptRecovered(contents);
  const QFileInfo file(contents.path);
  const bool isOlder = !contents.path.isEmpty() && file.exists() && file.lastModified() > QFileInfo(found.file).lastModified();
  autosave_.takeOver(found);  // where that fails, the folder cannot be written: it stays, and is offered again
  banner_.show(
      MessageBanner::Kind::Hint,
      tr("The last session ended unexpectedly. Its work on “%1” is here again; save it to keep it.").arg(workspace_.document().title()) +
          (isOlder ? QLatin1Char(' ') + tr("%1 has been written after this copy was kept: compare before you save over it.").arg(file.fileName())
                   : QString()),
      {{tr("Discard it"), [this, found] {
          workspace_.document().startNew();
          Autosave::discard(found);
        }}});
}

void AutosaveKeeper::discard() {
  delay_.stop();
  writer_.cancel();
  autosave_.remove();
}

}  // namespace vp::gui
