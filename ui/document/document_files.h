#pragma once

#include "core/base/result.h"
#include "core/mission/mission.h"
#include "core/mission/plan.h"
#include "ui/document/mission_defaults.h"

#include <QString>

#include <memory>
#include <string>

namespace vp::document {

/** What a document holds, as shared values. File paths inside are absolute. */
struct DocumentContents {
  std::shared_ptr<const mission::Mission> mission;  ///< never null
  std::shared_ptr<const mission::Plan> plan;        ///< may be null
  QString path;                                     ///< of the .vpm; empty: never saved
  QString planProblem;                              ///< why a plan beside the mission was left out; empty if it was not
  bool planIsSaved = true;
};

/** True if two missions ask for the same plan: everything equal but names, aircraft reference and aircraft sources. */
bool samePlanInputs(const mission::Mission& a, const mission::Mission& b);

/** True if nothing differs at all. */
bool sameMission(const mission::Mission& a, const mission::Mission& b);

/** An empty mission with formats::kDefaultAircraft. */
mission::Mission newMission(const MissionDefaults& defaults = {});

/** Reads a .vpm or .vpp as MissionDocument::open() describes. @errors those of the readers  @threads pure */
Result<DocumentContents> readDocument(const QString& path);

/** Writes `path` (.vpm), and NAME.vpp beside it if `withPlan` and there is a plan; both appear whole or
 *  neither does.
 *  An aircraft that no longer equals the file or bundled profile that it refers to is written inline.
 *  @errors as MissionDocument::saveAs() */
Result<void> writeDocument(const DocumentContents& contents, const QString& path, bool withPlan);

/** Where the plan of a mission file is: NAME.vpp. */
QString planPathOf(const QString& missionPath);

/** Contents as bytes and back; truncated or damaged bytes are refused. @errors BadFormat, NewerVersion  @threads pure */
std::string recoveryText(const DocumentContents& contents);
Result<DocumentContents> readRecoveryText(const std::string& bytes);

}  // namespace vp::document
