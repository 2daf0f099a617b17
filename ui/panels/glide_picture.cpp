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

void GlidePicture::setGlide(const std::shared_ptr<const document::PlanView>& plan, std::optional<document::EngineOut> glide) {
  if (plan == nullptr || !glide) {
    setGlide(std::nullopt, std::nullopt, 0.0);
    return;
  }
  std::optional<mission::LandingSite> site;
  if (glide->site >= 0) {
    site = plan->plan().sites[static_cast<std::size_t>(glide->site)].site;
  }
  setGlide(std::move(glide), std::move(site), plan->plan().mission.safety.clearance.si());
}

void GlidePicture::setGlide(std::optional<document::EngineOut> glide, std::optional<mission::LandingSite> site, double clearance) {
  glide_ = std::move(glide);
  site_ = std::move(site);
  clearance_ = clearance;
  update();
}

void GlidePicture::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const style::ChartColors& colors = style::ChartColors::of(state_.theme());
  painter.fillRect(rect(), colors.panel);
  if (glide_ && !glide_->path.empty()) {
    const mission::LandingSite* const site = site_ ? &*site_ : nullptr;
    profile::GlideProfileRenderer(*glide_, site, clearance_, {state_.theme(), state_.units(), font()}, QRectF(rect())).paint(painter);
  }
}

}  // namespace vp::panels
