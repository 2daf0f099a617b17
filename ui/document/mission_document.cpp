#include "ui/document/mission_document.h"

#include <QFileInfo>
#include <QUndoCommand>

namespace vp::document {
namespace {

constexpr int kMergeable = 1;  ///< QUndoCommand::id of commands with a merge key

}  // namespace

/** The mission before and after one edit. */
class MissionDocument::EditCommand : public QUndoCommand {
public:
  EditCommand(MissionDocument& document, const QString& name, QString mergeKey, std::shared_ptr<const mission::Mission> after)
      : QUndoCommand(name), document_(document), mergeKey_(std::move(mergeKey)), before_(document.mission_), after_(std::move(after)) {}

  void redo() override { document_.replaceMission(after_); }
  void undo() override { document_.replaceMission(before_); }
  [[nodiscard]] int id() const override { return mergeKey_.isEmpty() ? -1 : kMergeable; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const EditCommand*>(other);  // only commands of this class have this id
    if (next->mergeKey_ != mergeKey_) {
      return false;
    }
    after_ = next->after_;
    setText(next->text());
    setObsolete(sameMission(*before_, *after_));
    return true;
  }

private:
  MissionDocument& document_;
  QString mergeKey_;
  std::shared_ptr<const mission::Mission> before_;
  std::shared_ptr<const mission::Mission> after_;
};

MissionDocument::MissionDocument(QObject* parent) : QObject(parent), mission_(std::make_shared<const mission::Mission>(newMission())) {
  connect(&undo_, &QUndoStack::cleanChanged, this, &MissionDocument::stateChanged);
}

MissionDocument::~MissionDocument() {
  undo_.disconnect();  // the stack tells of its end when neither this nor who listens to it can answer any more
}

void MissionDocument::comparePlan() {
  planIsCurrent_ = plan_ != nullptr && samePlanInputs(*mission_, plan_->mission);
}

QString MissionDocument::title() const {
  if (!mission_->name.empty()) {
    return QString::fromStdString(mission_->name);
  }
  return path_.isEmpty() ? tr("Untitled mission") : QFileInfo(path_).completeBaseName();
}

bool MissionDocument::isModified() const {
  return !undo_.isClean() || !planIsSaved_;
}

void MissionDocument::edit(const QString& name, const std::function<void(mission::Mission&)>& change, const QString& mergeKey) {
  auto changed = std::make_shared<mission::Mission>(*mission_);
  change(*changed);
  if (!sameMission(*mission_, *changed)) {
    undo_.push(new EditCommand(*this, name, mergeKey, std::move(changed)));
  }
}

void MissionDocument::replaceMission(std::shared_ptr<const mission::Mission> mission) {
  mission_ = std::move(mission);
  const bool wasCurrent = planIsCurrent_;
  comparePlan();
  emit missionChanged();
  if (planIsCurrent_ != wasCurrent) {
    emit planChanged();
  }
  emit stateChanged();
}

void MissionDocument::setPlan(std::shared_ptr<const mission::Plan> plan) {
  if (plan == plan_) {
    return;
  }
  plan_ = std::move(plan);
  planIsSaved_ = false;
  comparePlan();
  emit planChanged();
  emit stateChanged();
}

void MissionDocument::setDefaults(const MissionDefaults& defaults) {
  const bool isFresh = path_.isEmpty() && plan_ == nullptr && undo_.count() == 0 && !isModified() && sameMission(*mission_, newMission(defaults_));
  defaults_ = defaults;
  if (isFresh && !sameMission(*mission_, newMission(defaults_))) {
    startNew();
  }
}

void MissionDocument::startNew() {
  adopt({std::make_shared<const mission::Mission>(newMission(defaults_)), nullptr, {}, {}, true});
}

Result<void> MissionDocument::open(const QString& path) {
  Result<DocumentContents> contents = readDocument(path);
  if (!contents) {
    return forward(contents);
  }
  adopt(std::move(*contents));
  return {};
}

void MissionDocument::adopt(DocumentContents contents) {
  mission_ = std::move(contents.mission);
  plan_ = std::move(contents.plan);
  path_ = contents.path;
  planProblem_ = contents.planProblem;
  planIsSaved_ = contents.planIsSaved;
  comparePlan();
  emit replaced();
  undo_.clear();
  emit missionChanged();
  emit planChanged();
  emit stateChanged();
}

Result<void> MissionDocument::saveAs(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  const Snapshot written = snapshot();
  if (Result<void> done = writeDocument(written, absolute, needsPlanWritten(absolute)); !done) {
    return done;
  }
  markSaved(written, absolute);
  return {};
}

void MissionDocument::markSaved(const DocumentContents& snapshot, const QString& path) {
  path_ = path;
  planIsSaved_ = snapshot.plan == plan_;
  if (snapshot.mission == mission_) {
    undo_.setClean();
  } else {
    undo_.resetClean();  // what was written is none of the steps that can be gone back to for sure
  }
  emit stateChanged();
}

Result<void> MissionDocument::restore(const std::string& recoveryData) {
  Result<DocumentContents> contents = readRecoveryText(recoveryData);
  if (!contents) {
    return forward(contents);
  }
  adoptRecovered(std::move(*contents));
  return {};
}

void MissionDocument::adoptRecovered(DocumentContents contents) {
  adopt(std::move(contents));
  undo_.resetClean();
  emit stateChanged();
}

}  // namespace vp::document
