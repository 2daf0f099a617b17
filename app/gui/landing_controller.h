#pragma once

#include "ui/jobs/landing_desk.h"

#include <QObject>

#include <optional>

namespace vp::panels {
class LandingPanel;
}

namespace vp::gui {

/** "The engine stops here: where to?" from the map or the tour, by the landing panel, to the planners and back. */
class LandingController : public QObject {
  Q_OBJECT

public:
  LandingController(jobs::Workspace& workspace, panels::LandingPanel& panel, QObject* parent);

  /** Asks about a place. @param distance  m along the tour, where the place is a point of it */
  void askAt(geo::Point place, std::optional<double> distance);
  /** Asks about the point of the tour that is looked at, if there is one. */
  void askAtCursor();

signals:
  void asked();  ///< the panel should be seen

private:
  jobs::Workspace& workspace_;
  panels::LandingPanel& panel_;
  jobs::LandingDesk desk_;
};

}  // namespace vp::gui
