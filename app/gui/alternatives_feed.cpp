#include "app/gui/alternatives_feed.h"

#include "core/landing/rrt_star.h"
#include "core/landing/site_roadmaps.h"
#include "ui/panels/engine_out_panel.h"

namespace vp::gui {

AlternativesFeed::AlternativesFeed(jobs::Workspace& workspace, panels::EngineOutPanel& panel, QObject* parent)
    : QObject(parent), workspace_(workspace), panel_(panel) {
  connect(&workspace_, &jobs::Workspace::situationChanged, this, &AlternativesFeed::refresh);
}

void AlternativesFeed::refresh() {
  if (workspace_.world() == world_) {
    return;
  }
  world_ = workspace_.world();
  if (!world_) {
    panel_.setAlternativesSource(nullptr);
    return;
  }
  landing::RrtStarOptions options;
  options.area = workspace_.glideArea();
  options.samples = landing::defaultSamples(options.area) / 2;  // a roadmap for each runway; a list of alternatives can be a little pessimistic
  options.seed = workspace_.document().mission().planner.seed;
  panel_.setAlternativesSource(std::make_shared<landing::SiteRoadmaps>(world_, options));
}

}  // namespace vp::gui
