#pragma once

#include "ui/jobs/workspace.h"

#include <QObject>

#include <memory>

namespace vp::landing {
class SiteRoadmaps;
}
namespace vp::panels {
class EngineOutPanel;
}

namespace vp::gui {

/** Gives the engine-out panel the roadmaps per runway that its table of alternatives is computed from, anew whenever the
 *  world (terrain, runways, aircraft, clearances) is another. */
class AlternativesFeed : public QObject {
public:
  AlternativesFeed(jobs::Workspace& workspace, panels::EngineOutPanel& panel, QObject* parent);

private:
  void refresh();

  jobs::Workspace& workspace_;
  panels::EngineOutPanel& panel_;
  std::shared_ptr<const landing::World> world_;
};

}  // namespace vp::gui
