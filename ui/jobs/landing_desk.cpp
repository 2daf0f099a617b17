#include "ui/jobs/landing_desk.h"

#include "core/emergency/landing_judge.h"
#include "core/emergency/planners.h"
#include "core/emergency/runway_ranking.h"
#include "core/emergency/verified_answer.h"
#include "core/risk/people_under.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace vp::jobs {
namespace {

constexpr double kLeastRanking = 1.0;  // s for all runways together

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
    return fail(Errc::MissingTerrain, LandingDesk::tr("there is no terrain to glide over; add a terrain file first").toStdString());
  }
  if (!hasUsableRunway(situation)) {
    return fail(Errc::NoLandingSite, LandingDesk::tr("no runway may be used here; add airfields or let more runways count first").toStdString());
  }
  if (!situation.weatherProblem.empty()) {
    return fail(Errc::BadFormat, situation.weatherProblem.substr(0, situation.weatherProblem.size() - 1));
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
  runways_.clear();
  world_.reset();
  mission_.reset();
  judge_.reset();
  weather_.reset();
  population_.reset();
  workspace_.view().setLanding(nullptr);
}

/// The world has changed, or is there at last.
void LandingDesk::follow() {
  if (!question_) {
    return;
  }
  const document::Situation& situation = workspace_.situation();
  if (situation.terrain == nullptr || !hasUsableRunway(situation) || !situation.weatherProblem.empty()) {
    clear();
  } else if (isWaiting_ || isOtherWorld()) {
    begin();
  }
}

bool LandingDesk::isOtherWorld() const {
  const document::Situation& situation = workspace_.situation();
  return workspace_.world() != world_ || situation.weatherRisk != weather_ || situation.population != population_;
}

void LandingDesk::begin() {
  runner_.cancel();
  landings_.clear();
  runways_.clear();
  asked_ = 0;
  isStopped_ = false;
  world_ = workspace_.world();
  mission_ = std::make_shared<const mission::Mission>(workspace_.document().mission());
  judge_.reset();
  weather_ = workspace_.situation().weatherRisk;
  population_ = workspace_.situation().population;
  isWaiting_ = world_ == nullptr;  // it is being made; follow() goes on
  publish(true);
  if (!isWaiting_) {
    judge_ = emergency::withJudge(request()).judge;
    next();
  }
}

emergency::LandingRequest LandingDesk::request() const {
  emergency::LandingRequest request;
  request.pose = question_->pose;
  request.altitude = question_->altitude;
  request.world = world_;
  request.mission = mission_;
  request.judge = judge_;
  request.frameOrigin = workspace_.situation().terrain->frame.origin();
  request.roadmap = workspace_.roadmap();
  request.weather = weather_;
  if (population_ != nullptr && question_->altitude > 0.0) {  // nobody is at risk from higher than the aircraft is, [3] (42)
    request.risk = std::make_shared<const risk::PeopleUnder>(population_, world_->glide.airspeed(), question_->altitude);
  }
  request.deadline = question_->deadline;
  request.seed = workspace_.document().mission().planner.seed;
  return request;
}

void LandingDesk::next() {
  if (isStopped_) {
    publish(false);
    return;
  }
  if (asked_ >= question_->planners.size()) {
    rank();
    return;
  }
  const std::string name = question_->planners[asked_++];
  runner_.start<document::ShownLanding>(
      [request = request(), name](const Job& job) mutable -> Result<document::ShownLanding> {
        const std::unique_ptr<emergency::LandingPlanner> planner = emergency::makePlanner(name);
        if (planner == nullptr) {
          return fail(Errc::Internal, LandingDesk::tr("there is no planner called %1").arg(QString::fromStdString(name)).toStdString());
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

/// The runways by total risk, with the best way found so far for its own.
void LandingDesk::rank() {
  emergency::LandingAnswer known;
  if (const int best = document::bestLanding(landings_); best >= 0) {
    known = landings_[static_cast<std::size_t>(best)].answer;
  }
  using Runways = std::vector<document::ShownRunway>;
  runner_.start<Runways>(
      [request = request(), known = std::move(known)](const Job& job) mutable -> Result<Runways> {
        request.job = job;
        request.deadline = std::max(request.deadline, kLeastRanking);
        request.threads = static_cast<int>(std::max(2U, std::thread::hardware_concurrency()) - 1U);
        emergency::RankingOptions options;
        options.known = &known;
        Runways runways;
        if (emergency::requestFault(request)) {
          return runways;  // the planners have said why
        }
        for (emergency::RankedRunway& runway : emergency::rankRunways(request, options)) {
          runways.push_back(document::shownRunway(std::move(runway), *request.world));
        }
        return runways;
      },
      [this](Result<Runways> result) {
        if (result) {
          runways_ = std::move(*result);
        }
        publish(false);
      });
}

void LandingDesk::publish(bool isRunning) {
  if (!question_ || workspace_.situation().terrain == nullptr) {
    return;
  }
  const std::shared_ptr<const document::LandingCase> before = workspace_.view().landing();
  document::LandingCase shown;
  shown.pose = question_->pose;
  shown.altitude = question_->altitude;
  shown.ground = workspace_.situation().terrain->grid->upperAt(shown.pose.point());
  shown.clearance = workspace_.document().mission().safety.clearance.si();
  shown.landings = landings_;
  shown.selected = document::bestLanding(landings_);
  shown.runways = runways_;
  shown.hasWeather = weather_ != nullptr;
  shown.hasPeople = population_ != nullptr;
  if (!runways_.empty() && before != nullptr && before->landings.size() == landings_.size() && before->selected >= 0) {
    shown.selected = before->selected;  // only the list has come: what is looked at stays
  }
  shown.isRunning = isRunning;
  workspace_.view().setLanding(std::make_shared<const document::LandingCase>(std::move(shown)));
}

}  // namespace vp::jobs
