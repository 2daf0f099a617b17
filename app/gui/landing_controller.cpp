#include "app/gui/landing_controller.h"

#include "ui/panels/landing_panel.h"
#include "ui/style/core_text.h"

namespace vp::gui {

LandingController::LandingController(jobs::Workspace& workspace, panels::LandingPanel& panel, QObject* parent)
    : QObject(parent), workspace_(workspace), panel_(panel), desk_(workspace) {
  connect(&panel_, &panels::LandingPanel::asked, this,
          [this](geo::Pose pose, double altitude, double deadline, const std::vector<std::string>& planners) {
            const Result<void> begun = desk_.ask({pose, altitude, deadline, planners});
            if (!begun) {
              QString sentence = style::coreText(begun.error()) + QLatin1Char('.');
              sentence.replace(0, 1, sentence.front().toUpper());
              panel_.showProblem(sentence);
            }
          });
  connect(&panel_, &panels::LandingPanel::stopRequested, this, [this] { desk_.stop(); });
  connect(&panel_, &panels::LandingPanel::clearRequested, this, [this] { desk_.clear(); });
}

void LandingController::askAt(geo::Point place, std::optional<double> distance) {
  panel_.askAt(place, distance);
  emit asked();
}

void LandingController::askAtCursor() {
  const std::optional<double> position = workspace_.view().position();
  if (const auto& plan = workspace_.situation().plan; plan != nullptr && position) {
    askAt(plan->at(*position).pose.point(), position);
  }
}

}  // namespace vp::gui
