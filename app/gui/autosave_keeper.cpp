#include "app/gui/autosave_keeper.h"

namespace vp::gui {
namespace {
constexpr int kDelay = 2000;  // ms after a change
}

using dialogs::MessageBanner;
using document::Autosave;

AutosaveKeeper::AutosaveKeeper(jobs::Workspace& workspace, const QString& folder, QObject* parent)
    : QObject(parent), workspace_(workspace), folder_(folder.isEmpty() ? Autosave::defaultFolder() : folder), autosave_(folder_) {
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
  writer_.start<bool>(
      [this, snapshot = workspace_.document().snapshot(), ticket = autosave_.ticket()](const Job& job) -> Result<bool> {
        const std::string data = document::MissionDocument::recoveryData(snapshot);
        return !job.stopRequested() && autosave_.write(data, ticket);
      },
      [this](const Result<bool>&) {
        if (!workspace_.document().isModified()) {
          autosave_.remove();
        }
      });
}

void AutosaveKeeper::offerRecovery(MessageBanner& banner, const std::function<void(const QString&)>& otherwise) {
  const std::optional<Autosave::Found> found = Autosave::takeOrphan(folder_);
  if (!found) {
    otherwise({});
    return;
  }
  using Contents = document::DocumentContents;
  reader_.start<Contents>([data = found->data](const Job&) { return document::readRecoveryText(data); },
                          [this, found, &banner, otherwise](const Result<Contents>& contents) {
                            if (contents) {
                              recovered(*found, *contents, banner);
                              return;
                            }
                            otherwise(tr("Work of a session that ended unexpectedly was found but cannot be read: %1 It stays in %2.")
                                          .arg(QString::fromStdString(contents.error().message()), found->file));
                          });
}

void AutosaveKeeper::recovered(const Autosave::Found& found, const document::DocumentContents& contents, MessageBanner& banner) {
  workspace_.document().adoptRecovered(contents);
  writer_.start<bool>([this, data = found.data, ticket = autosave_.ticket()](const Job&) -> Result<bool> { return autosave_.write(data, ticket); },
                      [found](const Result<bool>& written) {
                        if (written && *written) {
                          Autosave::discard(found);  // the old file goes when the new one is there
                        }
                      });
  banner.show(MessageBanner::Kind::Hint,
              tr("The last session ended unexpectedly. Its work on “%1” is here again; save it to keep it.").arg(workspace_.document().title()),
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
