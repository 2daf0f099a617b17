#include "ui/panels/glide_picture.h"

#include "ui/profile/glide_profile_renderer.h"

#include <QPainter>

namespace vp::panels {

GlidePicture::GlidePicture(document::ViewState& state, QWidget* parent) : QWidget(parent), state_(state) {
  setAccessibleName(tr("Profile of the glide"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  connect(&state_, &document::ViewState::unitsChanged, this, qOverload<>(&QWidget::update));
  connect(&state_, &document::ViewState::themeChanged, this, qOverload<>(&QWidget::update));
}

void GlidePicture::setGlide(std::shared_ptr<const document::PlanView> plan, std::optional<document::EngineOut> glide) {
  plan_ = std::move(plan);
  glide_ = std::move(glide);
  update();
}

void GlidePicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const style::ChartColors& colors = style::ChartColors::of(state_.theme());
  painter.fillRect(rect(), colors.panel);
  if (plan_ != nullptr && glide_ && !glide_->path.empty()) {
    profile::GlideProfileRenderer(*plan_, *glide_, {state_.theme(), state_.units(), font()}, QRectF(rect())).paint(painter);
  }
}

}  // namespace vp::panels
