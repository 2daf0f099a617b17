#include "ui/jobs/landing_desk.h"

#include "core/emergency/planners.h"
#include "core/emergency/verified_answer.h"

#include <utility>

namespace vp::jobs {
namespace {

bool hasUsableRunway(const document::Situation& situation) {
  if (situation.sites == nullptr) {
    return false;
  }
  for (const document::ShownSite& site : *situation.sites) {
    if (site.usable) {
      return true;
    }
  }
  return false;
}

}  // namespace

LandingDesk::LandingDesk(Workspace& workspace, QObject* parent) : QObject(parent), workspace_(workspace) {
  connect(&workspace_, &Workspace::situationChanged, this, &LandingDesk::follow);
}

Result<void> LandingDesk::ask(Question question) {
  const document::Situation& situation = workspace_.situation();
  if (situation.terrain == nullptr) {
    return fail(Errc::MissingTerrain, "there is no terrain to glide over; add a terrain file first");
  }
  if (!hasUsableRunway(situation)) {
    return fail(Errc::NoLandingSite, "no runway may be used here; add airfields or let more runways count first");
  }
  question_ = std::move(question);
  begin();
  return {};
}

void LandingDesk::stop() {
  isStopped_ = true;
  isWaiting_ = false;
  runner_.requestStop();
  if (!runner_.isRunning()) {
    publish(false);
  }
}

void LandingDesk::clear() {
  question_.reset();
  isWaiting_ = false;
  runner_.cancel();
  landings_.clear();
  world_.reset();
  workspace_.view().setLanding(nullptr);
}

/// The world has changed, or is there at last.
void LandingDesk::follow() {
  if (!question_) {
    return;
  }
  if (workspace_.situation().terrain == nullptr || !hasUsableRunway(workspace_.situation())) {
    clear();
  } else if (isWaiting_ || workspace_.world() != world_) {
    begin();
  }
}

void LandingDesk::begin() {
  runner_.cancel();
  landings_.clear();
  asked_ = 0;
  isStopped_ = false;
  world_ = workspace_.world();
  isWaiting_ = world_ == nullptr;  // it is being made; follow() goes on
  publish(true);
  if (!isWaiting_) {
    next();
  }
}

void LandingDesk::next() {
  if (isStopped_ || asked_ >= question_->planners.size()) {
    publish(false);
    return;
  }
  emergency::LandingRequest request;
  request.pose = question_->pose;
  request.altitude = question_->altitude;
  request.world = world_;
  request.mission = std::make_shared<const mission::Mission>(workspace_.document().mission());
  request.frameOrigin = workspace_.situation().terrain->frame.origin();
  request.roadmap = workspace_.roadmap();
  request.deadline = question_->deadline;
  request.seed = workspace_.document().mission().planner.seed;
  const std::string name = question_->planners[asked_++];
  runner_.start<document::ShownLanding>(
      [request, name](const Job& job) mutable -> Result<document::ShownLanding> {
        const std::unique_ptr<emergency::LandingPlanner> planner = emergency::makePlanner(name);
        if (planner == nullptr) {
          return fail(Errc::Internal, "there is no planner called " + name);
        }
        request.job = job;
        return document::shownLanding(emergency::verifiedAnswer(request, planner->plan(request)), *request.world);
      },
      [this](Result<document::ShownLanding> result) {
        if (result) {
          landings_.push_back(std::move(*result));
        }
        publish(true);
        next();
      });
}

void LandingDesk::publish(bool isRunning) {
  if (!question_ || workspace_.situation().terrain == nullptr) {
    return;
  }
  document::LandingCase shown;
  shown.pose = question_->pose;
  shown.altitude = question_->altitude;
  shown.ground = workspace_.situation().terrain->grid->upperAt(shown.pose.point());
  shown.clearance = workspace_.document().mission().safety.clearance.si();
  shown.landings = landings_;
  shown.selected = document::bestLanding(landings_);
  shown.isRunning = isRunning;
  workspace_.view().setLanding(std::make_shared<const document::LandingCase>(std::move(shown)));
}

}  // namespace vp::jobs
