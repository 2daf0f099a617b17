#pragma once

#include "ui/document/plan_view.h"
#include "ui/profile/plot_scale.h"
#include "ui/profile/plot_text.h"

#include <QRectF>

#include <memory>

class QPainter;

namespace vp::profile {

/** The profile of one engine-out glide: its altitude over the ground below it, the clearance that it keeps, and the runway
 *  that it ends at with what is left there. Draws on any paint device, small ones too.
 *  @threads any thread that may use fonts; const members are pure */
class GlideProfileRenderer {
public:
  /** @param site       that the glide ends at; null: none    @param clearance  that it is to keep above the ground [m]
   *  @param area       logical pixels that the picture may use */
  GlideProfileRenderer(const document::EngineOut& glide, const mission::LandingSite* site, double clearance, ProfileStyle style, const QRectF& area);
  /** Of a glide of a plan. */
  GlideProfileRenderer(const document::PlanView& plan, const document::EngineOut& glide, ProfileStyle style, const QRectF& area);

  [[nodiscard]] const PlotScale& scale() const { return scale_; }
  void paint(QPainter& painter) const;

private:
  void paintGround(QPainter& painter) const;
  void paintAxes(QPainter& painter) const;
  void paintGlide(QPainter& painter) const;
  void paintRunway(QPainter& painter) const;
  void paintLeastClearance(QPainter& painter) const;
  [[nodiscard]] double highestGlideOver(double left, double right) const;  ///< y of the glide's top between two x

  const document::EngineOut& glide_;
  const mission::LandingSite* site_;
  ProfileStyle style_;
  QFont font_;
  QRectF area_;
  QRectF frame_;
  PlotScale scale_;
  double clearance_ = 0.0;
};

}  // namespace vp::profile
