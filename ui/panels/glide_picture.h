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

  /** The glide to show; nothing: empty. */
  void setGlide(std::shared_ptr<const document::PlanView> plan, std::optional<document::EngineOut> glide);

  [[nodiscard]] QSize sizeHint() const override { return {380, 170}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 120}; }

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  document::ViewState& state_;
  std::shared_ptr<const document::PlanView> plan_;
  std::optional<document::EngineOut> glide_;
};

}  // namespace vp::panels
