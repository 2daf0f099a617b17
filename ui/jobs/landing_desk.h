#pragma once

#include "core/base/result.h"
#include "core/emergency/landing_request.h"
#include "ui/document/landing_case.h"
#include "ui/jobs/job_runner.h"
#include "ui/jobs/workspace.h"

#include <QObject>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::jobs {

/** Asks the planners of emergency landings one after the other, in the background, and then for the ranked list of runways, and puts what they answer
 *  into ViewState::landing as it comes. The mission's weather and population go with the question.
 *
 *  Follows the workspace: where terrain, runways, aircraft, wind, weather or population become others while a question stands, it is asked again in
 *  the new world.
 *  @threads GUI thread */
class LandingDesk : public QObject {
  Q_OBJECT

public:
  struct Question {
    geo::Pose pose;                     ///< of the aircraft, over ground, frame of the terrain
    double altitude = 0.0;              ///< m MSL
    double deadline = 1.0;              ///< s for each planner
    std::vector<std::string> planners;  ///< names of emergency::plannerNames()
  };

  explicit LandingDesk(Workspace& workspace, QObject* parent = nullptr);

  /** Forgets what was asked before and asks this. @errors MissingTerrain, NoLandingSite, BadFormat - weather that cannot be used */
  Result<void> ask(Question question);
  /** The planner at work returns its best so far; no other is asked. */
  void stop();
  /** Takes the question and its answers away. */
  void clear();
  [[nodiscard]] bool isRunning() const { return runner_.isRunning() || isWaiting_; }

private:
  void follow();
  void begin();
  void next();
  void rank();
  [[nodiscard]] emergency::LandingRequest request() const;
  [[nodiscard]] bool isOtherWorld() const;
  void publish(bool isRunning);

  Workspace& workspace_;
  JobRunner runner_;
  std::optional<Question> question_;
  std::size_t asked_ = 0;   ///< planners so far
  bool isWaiting_ = false;  ///< for the world
  bool isStopped_ = false;
  std::shared_ptr<const landing::World> world_;           ///< that the answers are of
  std::shared_ptr<const mission::Mission> mission_;       ///< as the world was made of it
  std::shared_ptr<const emergency::LandingJudge> judge_;  ///< of both
  std::shared_ptr<const risk::Weather> weather_;          ///< likewise; null: none
  std::shared_ptr<const risk::Population> population_;    ///< likewise
  std::vector<document::ShownLanding> landings_;
  std::vector<document::ShownRunway> runways_;
};

}  // namespace vp::jobs
