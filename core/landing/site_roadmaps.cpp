#include "core/landing/site_roadmaps.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace vp::landing {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
/// Two ends of a strip point in opposite directions; real files round courses to degrees, and displaced thresholds bend little.
constexpr double kOpposite = 10.0 / 180.0 * Angle::kPi;
/// Centre lines farther apart than this are different runways [m]; parallel runways of one airport lie closer at times, so
/// among several candidates the nearest line is taken.
constexpr double kSameLine = 300.0;
constexpr std::chrono::milliseconds kPoll(10);

std::string airportOf(const mission::LandingSite& site) {
  return site.airportIdent.empty() ? site.id.substr(0, site.id.find('/')) : site.airportIdent;
}

/// Distance of a point from the line through a pose along its heading.
double besides(const geo::Pose& line, geo::Point p) {
  return std::abs(-(p.x - line.x) * std::sin(line.heading) + (p.y - line.y) * std::cos(line.heading));
}

}  // namespace

SiteRoadmaps::SiteRoadmaps(std::shared_ptr<const World> world, RrtStarOptions options) : world_(std::move(world)), options_(std::move(options)) {
  VP_EXPECT(world_ != nullptr);
  options_.seconds.reset();  // an answer must not depend on the machine
  pairEnds();
  built_.resize(runways_.size());
}

void SiteRoadmaps::pairEnds() {
  const std::vector<mission::SiteInFrame>& sites = world_->sites;
  runwayOfSite_.assign(sites.size(), -1);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (runwayOfSite_[i] >= 0) {
      continue;
    }
    std::optional<std::size_t> other;
    double nearest = kSameLine;
    for (std::size_t j = i + 1; j < sites.size(); ++j) {
      const bool opposite = std::abs(wrapPi(sites[j].pose.heading - sites[i].pose.heading + Angle::kPi)) <= kOpposite;
      if (runwayOfSite_[j] < 0 && opposite && airportOf(sites[j].site) == airportOf(sites[i].site)) {
        if (const double away = besides(sites[i].pose, sites[j].pose.point()); away <= nearest) {
          nearest = away;
          other = j;
        }
      }
    }
    runwayOfSite_[i] = static_cast<int>(runways_.size());
    runways_.push_back({static_cast<int>(i)});
    if (other) {
      runwayOfSite_[*other] = runwayOfSite_[i];
      runways_.back().push_back(static_cast<int>(*other));
    }
  }
}

double SiteRoadmaps::boundTo(std::size_t runway, const geo::Pose& from) const {
  double least = kInfinite;
  for (const int site : runways_[runway]) {
    const mission::SiteInFrame& end = world_->sites[static_cast<std::size_t>(site)];
    const double loss = world_->glide.leastLossOver(end.pose.x - from.x, end.pose.y - from.y);
    least = std::min(least, end.site.elevation.metres() + world_->arrivalMargin + loss);
  }
  return least + world_->reactionLoss;
}

Result<const SiteRoadmaps::Built*> SiteRoadmaps::built(std::size_t runway, const Job& job) {
  if (built_[runway] == nullptr) {
    auto made = std::make_unique<Built>();
    made->world = *world_;  // the terrain is shared between copies
    made->world.sites.clear();
    for (const int site : runways_[runway]) {
      made->world.sites.push_back(world_->sites[static_cast<std::size_t>(site)]);
    }
    Result<TreeRoadmap> roadmap = buildRrtStarRoadmap(made->world, options_, job);
    if (roadmap) {
      made->roadmap = std::move(*roadmap);
      made->hasGlides = true;
    } else if (roadmap.error().code != Errc::NoLandingSite) {
      return forward(roadmap);
    }
    built_[runway] = std::move(made);
  }
  return built_[runway].get();
}

std::optional<SiteAnswer> SiteRoadmaps::answerOf(std::size_t runway, const Built& built, const geo::Pose& from, double altitude) {
  const std::optional<SafeAltitude> best = built.hasGlides ? built.roadmap.query(built.world, from, scratch_) : std::nullopt;
  if (!best) {
    return std::nullopt;
  }
  SiteAnswer answer;
  answer.site = runways_[runway][static_cast<std::size_t>(best->site)];
  answer.altitude = best->altitude;
  answer.margin = altitude - best->altitude;
  double direct = kInfinite;
  for (const int root : built.roadmap.roots()) {
    if (const auto leg = built.roadmap.legTo(built.world, afterReaction(built.world, from), root, direct, scratch_.options)) {
      direct = leg->altitude;
    }
  }
  answer.directAltitude = beforeReaction(built.world, from, direct);
  answer.pieces = built.roadmap.witnessPieces(*best);
  geo::Pose pose = from;
  for (const flight::Piece& piece : answer.pieces) {
    answer.length += piece.length;
    answer.seconds += flight::glideSeconds(world_->glide, pose, piece);
    pose = flight::endOf(pose, piece);
  }
  return answer;
}

Result<std::vector<SiteAnswer>> SiteRoadmaps::alternatives(const geo::Pose& from, double altitude, int most, const Job& job) {
  const auto cancelled = [] { return fail(Errc::Cancelled, "stopped while looking for other runways"); };
  std::unique_lock lock(mutex_, std::defer_lock);
  while (!lock.try_lock()) {  // std::timed_mutex would wait by itself, unseen by the thread sanitizer
    if (job.stopRequested()) {
      return cancelled();
    }
    std::this_thread::sleep_for(kPoll);
  }
  std::vector<std::pair<double, std::size_t>> byBound;
  for (std::size_t runway = 0; runway < runways_.size(); ++runway) {
    byBound.emplace_back(boundTo(runway, from), runway);
  }
  std::sort(byBound.begin(), byBound.end());
  const auto wanted = static_cast<std::size_t>(std::max(0, most));
  const auto lower = [](const SiteAnswer& a, const SiteAnswer& b) {
    return a.altitude != b.altitude ? a.altitude < b.altitude : a.length < b.length;
  };
  std::vector<SiteAnswer> answers;
  for (const auto& [bound, runway] : byBound) {
    if (wanted == 0 || (answers.size() == wanted && bound >= answers.back().altitude)) {
      break;
    }
    if (job.stopRequested()) {
      return cancelled();
    }
    job.progress(static_cast<double>(answers.size()) / static_cast<double>(wanted), fmt::format("other runways: {}", answers.size()));
    const Result<const Built*> ready = built(runway, Job(job.stopToken()));
    if (!ready) {
      return forward(ready);
    }
    if (std::optional<SiteAnswer> answer = answerOf(runway, **ready, from, altitude)) {
      answers.insert(std::upper_bound(answers.begin(), answers.end(), *answer, lower), std::move(*answer));
    }
    answers.resize(std::min(answers.size(), wanted));
  }
  return answers;
}

std::size_t SiteRoadmaps::builtCount() const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::count_if(built_.begin(), built_.end(), [](const auto& built) { return built != nullptr; }));
}

}  // namespace vp::landing
