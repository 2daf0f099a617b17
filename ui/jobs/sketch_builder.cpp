#include "ui/jobs/sketch_builder.h"

#include "core/flight/curve_sampling.h"
#include "core/flight/dubins.h"

#include <QCoreApplication>
#include <QString>
#include <fmt/format.h>

#include <algorithm>

namespace vp::jobs {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(PlanningSketch)
};

constexpr std::chrono::milliseconds kInterval{100};
constexpr std::size_t kMostEdges = 4000;  // more cannot be told apart on a screen
constexpr double kLegStep = 60.0;         // m between points of a drawn leg

}  // namespace

tour::PlanObserver SketchBuilder::observer() {
  return {[this](const landing::Roadmap& roadmap) { roadmapGrew(roadmap); }, [this](const tour::SearchRound& round) { roundDone(round); }};
}

bool SketchBuilder::isTime(Clock::time_point& last) {
  const Clock::time_point now = Clock::now();
  if (now - last < kInterval) {
    return false;
  }
  last = now;
  return true;
}

void SketchBuilder::roadmapGrew(const landing::Roadmap& roadmap) {
  if (!isTime(lastRoadmap_)) {
    return;
  }
  auto edges = std::make_shared<std::vector<document::PlanningSketch::Edge>>();
  roadmap.draw(kMostEdges, [&edges](geo::Point from, geo::Point to, double altitude) { edges->push_back({from, to, static_cast<float>(altitude)}); });
  sketch_.roadmap = std::move(edges);
  sketch_.stage = Words::tr("Roadmap: %n glides", nullptr, static_cast<int>(roadmap.size())).toStdString();
  publish_(std::make_shared<const document::PlanningSketch>(sketch_));
}

void SketchBuilder::roundDone(const tour::SearchRound& round) {
  if (!isTime(lastRound_)) {
    return;
  }
  auto legs = std::make_shared<std::vector<document::PlanningSketch::Leg>>();
  const std::vector<int>& order = *round.tour;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const geo::Pose& from = (*round.visits)[static_cast<std::size_t>(order[i])].pose;
    const geo::Pose& to = (*round.visits)[static_cast<std::size_t>(order[(i + 1) % order.size()])].pose;
    const flight::DubinsPath path = flight::shortestDubins(from, to, tourRadius_);
    document::PlanningSketch::Leg leg;
    leg.safe = round.isSafe[i] != 0;
    const flight::Curve curve{from, {path.piece(0), path.piece(1), path.piece(2)}, {}};
    for (const geo::Pose& pose : flight::sample(curve, kLegStep, 1.0)) {
      leg.path.push_back(pose.point());
    }
    legs->push_back(std::move(leg));
  }
  sketch_.tour = std::move(legs);
  sketch_.round = round.round;
  sketch_.stage = Words::tr("Round %1: %2 of %3 legs are safe")
                      .arg(round.round)
                      .arg(std::count_if(round.isSafe.begin(), round.isSafe.end(), [](char safe) { return safe != 0; }))
                      .arg(round.isSafe.size())
                      .toStdString();
  sketch_.bestCost = round.cost;
  sketch_.lowerBound = round.lowerBound > 0.0 ? std::optional(round.lowerBound) : std::nullopt;
  publish_(std::make_shared<const document::PlanningSketch>(sketch_));
}

}  // namespace vp::jobs
