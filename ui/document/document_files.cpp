#include "ui/document/document_files.h"

#include "core/formats/aircraft_file.h"
#include "core/formats/atomic_file.h"
#include "core/formats/json_value.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_json.h"
#include "core/formats/mission_paths.h"
#include "core/formats/plan_file.h"
#include "core/mission/glide_conditions.h"
#include "ui/style/core_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <fmt/format.h>

#include <charconv>
#include <string_view>

namespace vp::document {
namespace {

constexpr const char* kRecoveryHeader = "volplane-recovery 1 ";

struct Words {
  Q_DECLARE_TR_FUNCTIONS(DocumentFiles)
};

std::string folderOf(const QString& path) {
  return QFileInfo(path).absolutePath().toStdString();
}

Result<mission::Plan> readPlanFile(const QString& path) {
  Result<mission::Plan> plan = formats::readPlan(path.toStdString());
  if (plan) {
    formats::makePathsAbsolute(*plan, folderOf(path));
  }
  return plan;
}

Result<mission::Mission> readMissionFile(const QString& path) {
  Result<mission::Mission> mission = formats::readDraft(path.toStdString());
  if (mission) {
    formats::makePathsAbsolute(*mission, folderOf(path));
  }
  return mission;
}

Result<DocumentContents> readFromPlan(const QString& path) {
  Result<mission::Plan> plan = readPlanFile(path);
  if (!plan) {
    return forward(plan);
  }
  DocumentContents contents;
  contents.mission = std::make_shared<const mission::Mission>(plan->mission);
  const QFileInfo info(path);
  const QString beside = info.dir().absoluteFilePath(info.completeBaseName() + QStringLiteral(".vpm"));
  const Result<mission::Mission> saved = QFileInfo::exists(beside) ? readMissionFile(beside) : fail(Errc::BadFile, Words::tr("none").toStdString());
  if (saved && samePlanInputs(*saved, plan->mission)) {
    contents.path = beside;
    contents.mission = std::make_shared<const mission::Mission>(*saved);
  }
  contents.plan = std::make_shared<const mission::Plan>(std::move(*plan));
  return contents;
}

/// The mission as it is written: paths relative, the aircraft by reference only if that gives the same profile.
mission::Mission forFile(const mission::Mission& mission, const std::string& folder) {
  mission::Mission written = mission;
  formats::makePathsRelative(written, folder);
  if (!written.aircraftReference.empty()) {
    const Result<aircraft::AircraftProfile> found = formats::findAircraft(mission.aircraftReference, folder);
    if (!found || !(*found == mission.aircraft)) {
      written.aircraftReference.clear();
    }
  }
  return written;
}

/// Whatever is written about it, the same aircraft.
bool samePhysics(aircraft::AircraftProfile a, aircraft::AircraftProfile b) {
  for (aircraft::AircraftProfile* profile : {&a, &b}) {
    profile->id.clear();
    profile->name.clear();
    profile->sources.clear();
  }
  return a == b;
}

/// Whatever is noted about runways, the same ones count.
bool sameFilter(mission::SiteFilter a, mission::SiteFilter b) {
  a.notes.clear();
  b.notes.clear();
  return a == b;
}

}  // namespace

bool samePlanInputs(const mission::Mission& a, const mission::Mission& b) {
  return a.targets == b.targets && a.terrain == b.terrain && a.airfields == b.airfields && a.sites == b.sites &&
         sameFilter(a.siteFilter, b.siteFilter) && a.home == b.home && a.ceiling == b.ceiling && a.safety == b.safety && a.planner == b.planner &&
         a.airspace == b.airspace && mission::sameConditions(a, b) && samePhysics(a.aircraft, b.aircraft);
}

bool sameMission(const mission::Mission& a, const mission::Mission& b) {
  return a.name == b.name && a.aircraftReference == b.aircraftReference && a.aircraft == b.aircraft && a.siteFilter == b.siteFilter &&
         a.weather == b.weather && a.populationFiles == b.populationFiles && samePlanInputs(a, b);
}

mission::Mission newMission(const MissionDefaults& defaults) {
  mission::Mission mission;
  mission.safety = defaults.safety;
  mission.planner = defaults.planner;
  if (Result<aircraft::AircraftProfile> profile = formats::findAircraft(formats::kDefaultAircraft, {})) {
    mission.aircraft = std::move(*profile);
    mission.aircraftReference = formats::kDefaultAircraft;
  }
  return mission;
}

QString planPathOf(const QString& missionPath) {
  const QFileInfo info(missionPath);
  return info.dir().absoluteFilePath(info.completeBaseName() + QStringLiteral(".vpp"));
}

Result<DocumentContents> readDocument(const QString& path) {
  if (path.endsWith(QStringLiteral(".vpp"), Qt::CaseInsensitive)) {
    return readFromPlan(path);
  }
  Result<mission::Mission> mission = readMissionFile(path);
  if (!mission) {
    return forward(mission);
  }
  DocumentContents contents;
  contents.path = QFileInfo(path).absoluteFilePath();
  const QString planPath = planPathOf(path);
  if (QFileInfo::exists(planPath)) {
    Result<mission::Plan> plan = readPlanFile(planPath);
    if (!plan) {
      contents.planProblem = Words::tr("The plan beside the mission was not opened: %1").arg(style::coreText(plan.error()));
    } else if (plan->mission.terrain != mission->terrain) {
      contents.planProblem = Words::tr("The plan beside the mission was made over other terrain and was not opened.");
    } else {
      contents.plan = std::make_shared<const mission::Plan>(std::move(*plan));
    }
  }
  contents.mission = std::make_shared<const mission::Mission>(std::move(*mission));
  return contents;
}

Result<void> writeDocument(const DocumentContents& contents, const QString& path, bool withPlan) {
  const std::string folder = folderOf(path);
  const mission::Mission written = forFile(*contents.mission, folder);
  const std::string text = formats::missionToText(written);
  // a file that could not be read again must not replace one that can
  if (const Result<mission::Mission> again = formats::parseDraft(text, path.toStdString()); !again) {
    return forward(again);
  }
  std::vector<formats::FileToWrite> files;
  std::string planText;
  if (withPlan && contents.plan) {
    mission::Plan plan = *contents.plan;
    formats::makePathsRelative(plan, folder);
    planText = formats::planToJson(plan);
    files.push_back({planPathOf(path).toStdString(), planText});
  }
  files.push_back({path.toStdString(), text});
  return formats::writeFilesAtomically(files);
}

std::string recoveryText(const DocumentContents& contents) {
  formats::JsonValue json = formats::JsonValue::object();
  json.set("path", contents.path.toStdString());
  json.set("planIsSaved", contents.planIsSaved);
  json.set("mission", formats::missionToJson(*contents.mission, formats::MissionPlace::Plan));
  const std::string head = formats::writeJson(json, {});
  const std::string plan = contents.plan ? formats::planToJson(*contents.plan) : std::string();
  return fmt::format("{}{} {}\n{}{}", kRecoveryHeader, head.size(), plan.size(), head, plan);
}

Result<DocumentContents> readRecoveryText(const std::string& bytes) {
  constexpr const char* kName = "recovered work";
  constexpr std::string_view kHeader = kRecoveryHeader;
  const auto damaged = [&] {
    return fail(Errc::BadFormat, Words::tr("the saved copy of unsaved work is damaged; it cannot be restored").toStdString(), kName);
  };
  if (!bytes.starts_with(kHeader)) {
    return bytes.starts_with("volplane-recovery ")
               ? fail(Errc::NewerVersion, Words::tr("the copy was written by a newer Volplane; open it there").toStdString(), kName)
               : damaged();
  }
  std::size_t headSize = 0;
  std::size_t planSize = 0;
  const char* end = bytes.data() + bytes.size();
  const auto [afterHead, headCode] = std::from_chars(bytes.data() + kHeader.size(), end, headSize);
  if (headCode != std::errc() || afterHead == end || *afterHead != ' ') {
    return damaged();
  }
  const auto [afterPlan, planCode] = std::from_chars(afterHead + 1, end, planSize);
  const auto start = static_cast<std::size_t>(afterPlan - bytes.data()) + 1;
  if (planCode != std::errc() || afterPlan == end || *afterPlan != '\n' || headSize > bytes.size() || planSize > bytes.size() ||
      start + headSize + planSize != bytes.size()) {
    return damaged();
  }
  const std::string head = bytes.substr(start, headSize);
  const Result<formats::JsonValue> json = formats::parseJson(head, kName);
  if (!json) {
    return forward(json);
  }
  formats::ReadContext context(kName, head);
  formats::ObjectReader reader(*json, "", context);
  DocumentContents contents;
  contents.path = QString::fromStdString(reader.path("path", std::string()));
  contents.planIsSaved = reader.flag("planIsSaved", true);
  if (const formats::JsonValue* mission = reader.require("mission")) {
    contents.mission =
        std::make_shared<const mission::Mission>(formats::readMissionObject(*mission, "/mission", context, formats::MissionPlace::Plan, {}));
  }
  reader.finish();
  if (context.error()) {
    return tl::unexpected<Error>(*context.error());
  }
  if (planSize > 0) {
    Result<mission::Plan> plan = formats::parsePlan(bytes.substr(start + headSize), kName);
    if (!plan) {
      return forward(plan);
    }
    contents.plan = std::make_shared<const mission::Plan>(std::move(*plan));
  }
  return contents;
}

}  // namespace vp::document
