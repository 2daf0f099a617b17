#include "ui/document/mission_document.h"

#include "core/formats/aircraft_file.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_paths.h"
#include "core/formats/plan_file.h"

#include <QFileInfo>
#include <QUndoCommand>

#include <utility>

namespace vp::document {
namespace {

constexpr auto kDefaultAircraft = "cessna172-operational";
constexpr auto kRecoveryHeader = "volplane-recovery 1";

using SharedMission = std::shared_ptr<const mission::Mission>;

QString planPathOf(const QString& missionPath) {
  const QFileInfo file(missionPath);
  return file.path() + QLatin1Char('/') + file.completeBaseName() + QStringLiteral(".vpp");
}

mission::Mission emptyMission() {
  mission::Mission mission;
  if (Result<aircraft::AircraftProfile> profile = formats::findAircraft(kDefaultAircraft, "")) {
    mission.aircraft = std::move(*profile);
    mission.aircraftReference = kDefaultAircraft;
  }
  return mission;
}

/// Takes the next line (without its end) off a text.
std::string takeLine(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string line(text.substr(0, end));
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

}  // namespace

bool samePlanInputs(const mission::Mission& a, const mission::Mission& b) {
  const auto inputs = [](mission::Mission mission) {
    mission.name.clear();
    mission.aircraftReference.clear();  // the profile itself is compared
    mission.aircraft.id.clear();
    return formats::missionToText(mission);
  };
  return inputs(a) == inputs(b);
}

/// Swaps whole missions; edits with the same key that follow each other become one.
class MissionDocument::EditCommand : public QUndoCommand {
public:
  EditCommand(MissionDocument& document, const QString& name, SharedMission before, SharedMission after, const QString& mergeKey)
      : QUndoCommand(name), document_(document), before_(std::move(before)), after_(std::move(after)), mergeKey_(mergeKey) {}

  void undo() override { document_.replaceMission(before_); }
  void redo() override { document_.replaceMission(after_); }
  [[nodiscard]] int id() const override { return mergeKey_.isEmpty() ? -1 : static_cast<int>(qHash(mergeKey_) & 0x7fffffffU); }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const EditCommand*>(other);
    if (next == nullptr || next->mergeKey_ != mergeKey_) {
      return false;
    }
    after_ = next->after_;
    setText(next->text());
    return true;
  }

private:
  MissionDocument& document_;
  SharedMission before_;
  SharedMission after_;
  QString mergeKey_;
};

MissionDocument::MissionDocument(QObject* parent) : QObject(parent), mission_(std::make_shared<const mission::Mission>(emptyMission())) {
  connect(&undo_, &QUndoStack::cleanChanged, this, &MissionDocument::stateChanged);
}

QString MissionDocument::title() const {
  if (!mission_->name.empty()) {
    return QString::fromStdString(mission_->name);
  }
  return path_.isEmpty() ? tr("Untitled mission") : QFileInfo(path_).completeBaseName();
}

bool MissionDocument::isModified() const {
  return !undo_.isClean() || !planIsSaved_ || isRestored_;
}

void MissionDocument::edit(const QString& name, const std::function<void(mission::Mission&)>& change, const QString& mergeKey) {
  auto changed = std::make_shared<mission::Mission>(*mission_);
  change(*changed);
  undo_.push(new EditCommand(*this, name, mission_, std::move(changed), mergeKey));
}

void MissionDocument::replaceMission(SharedMission mission) {
  mission_ = std::move(mission);
  const bool before = planIsCurrent_;
  comparePlan();
  emit missionChanged();
  if (before != planIsCurrent_) {
    emit planChanged();
  }
  emit stateChanged();
}

void MissionDocument::comparePlan() {
  planIsCurrent_ = plan_ != nullptr && samePlanInputs(*mission_, plan_->mission);
}

void MissionDocument::setPlan(std::shared_ptr<const mission::Plan> plan) {
  plan_ = std::move(plan);
  planIsSaved_ = false;
  comparePlan();
  emit planChanged();
  emit stateChanged();
}

void MissionDocument::adopt(mission::Mission mission, std::shared_ptr<const mission::Plan> plan, const QString& path, bool modified) {
  mission_ = std::make_shared<const mission::Mission>(std::move(mission));
  plan_ = std::move(plan);
  path_ = path;
  planIsSaved_ = true;
  isRestored_ = modified;
  undo_.clear();
  undo_.setClean();
  comparePlan();
  emit missionChanged();
  emit planChanged();
  emit stateChanged();
}

void MissionDocument::startNew() {
  adopt(emptyMission(), nullptr, {}, false);
}

Result<void> MissionDocument::open(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  const std::string folder = QFileInfo(absolute).absolutePath().toStdString();
  const auto readPlanAt = [&folder](const QString& file) -> Result<std::shared_ptr<const mission::Plan>> {
    Result<mission::Plan> plan = formats::readPlan(file.toStdString());
    if (!plan) {
      return forward(plan);
    }
    formats::makePathsAbsolute(*plan, folder);
    return std::make_shared<const mission::Plan>(std::move(*plan));
  };
  if (absolute.endsWith(QStringLiteral(".vpp"), Qt::CaseInsensitive)) {
    Result<std::shared_ptr<const mission::Plan>> plan = readPlanAt(absolute);
    if (!plan) {
      return forward(plan);
    }
    const QFileInfo file(absolute);
    adopt((*plan)->mission, *plan, file.path() + QLatin1Char('/') + file.completeBaseName() + QStringLiteral(".vpm"), false);
    return {};
  }
  Result<mission::Mission> mission = formats::readMission(absolute.toStdString());
  if (!mission) {
    return forward(mission);
  }
  formats::makePathsAbsolute(*mission, folder);
  std::shared_ptr<const mission::Plan> plan;
  if (QFileInfo::exists(planPathOf(absolute))) {
    if (const auto beside = readPlanAt(planPathOf(absolute)); beside && samePlanInputs((*beside)->mission, *mission)) {
      plan = *beside;
    }
  }
  adopt(std::move(*mission), std::move(plan), absolute, false);
  return {};
}

Result<void> MissionDocument::saveAs(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  const std::string folder = QFileInfo(absolute).absolutePath().toStdString();
  mission::Mission mission = *mission_;
  formats::makePathsRelative(mission, folder);
  if (Result<void> written = formats::writeMission(mission, absolute.toStdString()); !written) {
    return written;
  }
  if (plan_ != nullptr) {
    mission::Plan plan = *plan_;
    formats::makePathsRelative(plan, folder);
    if (Result<void> written = formats::writePlan(plan, planPathOf(absolute).toStdString()); !written) {
      return written;
    }
  }
  path_ = absolute;
  planIsSaved_ = true;
  isRestored_ = false;
  undo_.setClean();
  emit stateChanged();
  return {};
}

std::string MissionDocument::recoveryData(const Snapshot& snapshot) {
  const std::string mission = formats::missionToText(*snapshot.mission);
  const std::string plan = snapshot.plan ? formats::planToJson(*snapshot.plan) : std::string();
  return std::string(kRecoveryHeader) + '\n' + snapshot.path.toStdString() + '\n' + std::to_string(mission.size()) + '\n' + mission + plan;
}

Result<void> MissionDocument::restore(const std::string& recoveryData) {
  std::string_view rest(recoveryData);
  if (takeLine(rest) != kRecoveryHeader) {
    return fail(Errc::BadFormat, "this is no recovered work of this version of Volplane");
  }
  const std::string path = takeLine(rest);
  const std::string size = takeLine(rest);
  const std::size_t missionSize = QString::fromStdString(size).toULongLong();
  if (missionSize == 0 || missionSize > rest.size()) {
    return fail(Errc::BadFormat, "the recovered work is cut short");
  }
  Result<mission::Mission> mission = formats::parseMission(std::string(rest.substr(0, missionSize)), "recovered mission");
  if (!mission) {
    return forward(mission);
  }
  std::shared_ptr<const mission::Plan> plan;
  if (rest.size() > missionSize) {
    if (Result<mission::Plan> read = formats::parsePlan(std::string(rest.substr(missionSize)), "recovered plan")) {
      plan = std::make_shared<const mission::Plan>(std::move(*read));
    }
  }
  adopt(std::move(*mission), std::move(plan), QString::fromStdString(path), true);
  return {};
}

}  // namespace vp::document
