#pragma once

#include "ui/document/plan_view.h"
#include "ui/document/view_state.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace vp::panels {

/** The little profile of one glide as a widget. */
class GlidePicture : public QWidget {
  Q_OBJECT

public:
  explicit GlidePicture(document::ViewState& state, QWidget* parent = nullptr);

  /** The glide of a plan to show; nothing: empty. */
  void setGlide(const std::shared_ptr<const document::PlanView>& plan, std::optional<document::EngineOut> glide);
  /** A glide to a site, or to none.  @param clearance  that it is to keep above the ground [m] */
  void setGlide(std::optional<document::EngineOut> glide, std::optional<mission::LandingSite> site, double clearance);

  [[nodiscard]] QSize sizeHint() const override { return {380, 170}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 120}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  document::ViewState& state_;
  std::optional<document::EngineOut> glide_;
  std::optional<mission::LandingSite> site_;
  double clearance_ = 0.0;
};

}  // namespace vp::panels
