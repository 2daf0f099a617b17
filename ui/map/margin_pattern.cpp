#include "ui/map/margin_pattern.h"

#include "core/safety/limits.h"

namespace vp::map {

double shownMargin(double margin) {
  return margin < 0.0 && margin >= -safety::kAltitudeTolerance ? 0.0 : margin;
}

MarginClass marginClass(double margin) {
  if (shownMargin(margin) < 0.0) {
    return MarginClass::Violated;
  }
  if (margin < kTightMargin) {
    return MarginClass::Tight;
  }
  return margin < style::ChartColors::kAmpleMargin ? MarginClass::Modest : MarginClass::Ample;
}

QPen marginPen(double margin, const style::ChartColors& colors, double width) {
  QPen pen(colors.glide(shownMargin(margin)), width, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  switch (marginClass(margin)) {
    case MarginClass::Violated:
      pen.setDashPattern({0.8, 0.8});
      break;
    case MarginClass::Tight:
      pen.setDashPattern({2.0, 1.2});
      break;
    case MarginClass::Modest:
      pen.setDashPattern({6.0, 1.2});
      break;
    case MarginClass::Ample:
      break;
  }
  return pen;
}

}  // namespace vp::map
