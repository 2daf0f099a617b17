#include "ui/profile/profile_renderer.h"

#include "core/base/expect.h"
#include "core/safety/limits.h"
#include "ui/profile/wind_lane.h"
#include "ui/style/short_name.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vp::profile {
namespace {

constexpr double kPad = 8.0;           // px, around strip, plot and legend
constexpr double kTickPixelsX = 90.0;  // px, least distance between labels of the distance axis
constexpr double kTickPixelsY = 26.0;  // px, the same of the altitude axis
constexpr double kHeadroom = 0.06;     // of the range of altitudes, free above and below
constexpr double kLeastRange = 60.0;   // m, range of altitudes of a flat profile

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ProfileRenderer)
};

}  // namespace

ProfileRenderer::ProfileRenderer(const document::Situation& situation, ProfileStyle style, QSizeF size, std::optional<PlotWindow> window)
    : situation_(situation),
      plan_((VP_EXPECT(situation.plan != nullptr), *situation_.plan)),
      style_(std::move(style)),
      font_(tabularFont(style_.font)),
      small_(scaledFont(font_, 0.88)),
      size_(size),
      violations_(violations(plan_)),
      unknown_(unknownGround(plan_)),
      hasWind_(courseWind(plan_, plan_.at(0.0)).has_value()) {
  layOut(size, window);
}

PlotWindow ProfileRenderer::fullWindow(const document::PlanView& plan) {
  double low = plan.lowestAltitude();
  double high = plan.highestAltitude();
  for (const document::TourSample& sample : plan.samples()) {
    for (const double value : {sample.state.ground, sample.corridor, sample.state.safeAltitude, sample.pitchOnly}) {
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
  }
  const double range = std::max(high - low, kLeastRange);
  return {0.0, std::max(plan.length(), 1.0), low - kHeadroom * range, low + (1.0 + kHeadroom) * range};
}

void ProfileRenderer::layOut(QSizeF size, const std::optional<PlotWindow>& window) {
  const QFontMetricsF metrics(font_);
  const QFontMetricsF small(small_);
  const PlotWindow shown = window.value_or(fullWindow(plan_));
  collectFacts();
  if (style_.onPaper) {
    facts_.clear();  // what is printed beside it holds for all points, not for samples
  }
  const double strip = layOutStrip(metrics, size.width());
  const double legend = legendHeight(size.width() - 2.0 * kPad);
  legendTop_ = size.height() - legend - 0.5 * kPad;
  const double top = strip + small.height() + 4.0;  // the altitude unit stands above its axis
  const double bottom = legendTop_ - small.height() - 0.75 * kPad;

  const double low = style_.units.heightFromSi(shown.low);
  const double high = style_.units.heightFromSi(shown.high);
  altitudeTicks_ = niceTicks(low, high, std::max(2, static_cast<int>((bottom - top) / kTickPixelsY)));
  double widest = small.horizontalAdvance(style_.units.heightUnit() + Words::tr(" MSL"));
  for (const double tick : altitudeTicks_) {
    widest = std::max(widest, small.horizontalAdvance(groupedNumber(tick, tickDecimals(altitudeTicks_))));
  }
  const double left = kPad + widest + 6.0;
  frame_ = QRectF(QPointF(left, top), QPointF(std::max(left + 20.0, size.width() - 2.0 * kPad), std::max(top + 20.0, bottom)));
  scale_ = PlotScale(frame_, shown);  // for the x of the names, which decide on the lanes
  layOutTargets(small);
  int lanes = 0;
  for (const TargetLabel& label : labels_) {
    lanes = std::max(lanes, label.lane + 1);
  }
  const double above = (lanes > 0 ? lanes * small.height() + 6.0 : 0.0) + (showsWind() ? kWindLane : 0.0);
  scale_ = PlotScale(frame_.adjusted(0.0, above, 0.0, 0.0), shown);
  distanceTicks_ = niceTicks(style_.units.distanceFromSi(shown.from), style_.units.distanceFromSi(shown.to),
                             std::max(2, static_cast<int>(frame_.width() / kTickPixelsX)));
}

void ProfileRenderer::layOutTargets(const QFontMetricsF& metrics) {
  const int most = frame_.height() > 220.0 ? 3 : frame_.height() > 130.0 ? 2 : 1;
  for (std::size_t t = 0; t < plan_.plan().targets.size(); ++t) {
    const std::optional<double> distance = plan_.distanceOfTarget(static_cast<int>(t));
    if (distance && *distance >= scale_.window().from && *distance <= scale_.window().to) {
      labels_.push_back(
          {scale_.xOf(*distance), -1, style::shortName(QString::fromStdString(plan_.plan().targets[t].target.name)), static_cast<int>(t), *distance});
    }
  }
  std::sort(labels_.begin(), labels_.end(), [](const TargetLabel& a, const TargetLabel& b) { return a.x < b.x; });
  std::vector<double> free(static_cast<std::size_t>(most), -std::numeric_limits<double>::infinity());
  for (TargetLabel& label : labels_) {
    const double half = 0.5 * metrics.horizontalAdvance(label.name);
    label.x = std::clamp(label.x, frame_.left() + half, std::max(frame_.left() + half, frame_.right() - half));
    for (std::size_t lane = 0; lane < free.size() && label.lane < 0; ++lane) {
      if (label.x - half >= free[lane]) {
        label.lane = static_cast<int>(lane);
        free[lane] = label.x + half + 8.0;
      }
    }
  }
}

void ProfileRenderer::collectFacts() {
  const style::Units& units = style_.units;
  const double clearance = plan_.plan().mission.safety.clearance.si();
  const auto at = [&](double distance) { return Words::tr("at %1").arg(units.distance(distance)); };
  const document::TourState& low = plan_.leastClearance().state;
  const document::TourState& tight = plan_.leastGlideMargin().state;
  const document::TourState& peak = plan_.highestGround().state;
  if (unknown_.empty()) {
    facts_.push_back({Mark::LeastClearance, Words::tr("Least clearance %1 %2").arg(units.heightAboveGround(low.clearance()), at(low.distance)),
                      low.distance, low.clearance() < clearance - safety::kAltitudeTolerance});
  } else {
    const double from = unknown_.front().from;
    facts_.push_back({Mark::LeastClearance, Words::tr("Least clearance unknown: no terrain data %1").arg(at(from)), from, true});
  }
  if (std::isfinite(tight.safeAltitude)) {
    facts_.push_back({Mark::LeastMargin,
                      Words::tr("Least glide margin %1 %2").arg(units.margin(shownMargin(tight.glideMargin())), at(tight.distance)), tight.distance,
                      tight.glideMargin() < -safety::kAltitudeTolerance});
  } else {
    facts_.push_back({Mark::LeastMargin, Words::tr("No safe glide known %1").arg(at(tight.distance)), tight.distance, true});
  }
  if (std::isfinite(peak.ground)) {
    facts_.push_back({Mark::HighestGround, Words::tr("Highest ground %1 %2").arg(units.requiredMsl(peak.ground), at(peak.distance)), peak.distance});
  }
  if (!situation_.planIsCurrent) {
    badges_.push_back({Words::tr("OUT OF DATE"), QRectF()});
  }
  if (!plan_.isVerified()) {
    badges_.push_back({Words::tr("NOT VERIFIED"), QRectF()});
  }
}

double ProfileRenderer::layOutStrip(const QFontMetricsF& metrics, double width) {
  const double height = metrics.height() + 4.0;
  double x = kPad;
  double y = 0.5 * kPad;
  const auto place = [&](double wanted, double gap) {
    const double needed = std::min(wanted, width - 2.0 * kPad);
    if (x > kPad && x + needed > width - kPad) {
      x = kPad;
      y += height + 2.0;
    }
    const QRectF rect(x, y, needed, height);
    x += needed + gap;
    return rect;
  };
  for (Badge& badge : badges_) {
    badge.rect = place(metrics.horizontalAdvance(badge.text) + 34.0, 10.0);
  }
  for (ProfileFact& fact : facts_) {
    fact.rect = place(metrics.horizontalAdvance(fact.text) + 24.0, 18.0);
  }
  if (badges_.empty() && facts_.empty()) {
    return 0.0;
  }
  return y + height;
}

bool ProfileRenderer::showsDecisionPoints() const {
  constexpr double kLeastSpacing = 5.0;  // px: closer ticks would be a band
  const double spacing = plan_.length() / static_cast<double>(plan_.plan().tour.size());
  return spacing / scale_.window().width() * scale_.area().width() >= kLeastSpacing;
}

void ProfileRenderer::paint(QPainter& painter) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double column = 1.0 / painter.device()->devicePixelRatioF();
  painter.fillRect(QRectF(QPointF(0.0, 0.0), size_), style_.colors().panel);
  painter.fillRect(frame_, style_.colors().sky);
  painter.save();
  painter.setClipRect(scale_.area());
  painter.setOpacity(isDimmed() ? 0.55 : 1.0);
  paintTerrain(painter, column);
  paintAirspaces(painter);
  painter.restore();
  paintAxes(painter);
  painter.save();
  painter.setClipRect(scale_.area());
  painter.setOpacity(isDimmed() ? 0.55 : 1.0);
  paintCurves(painter, column);
  painter.restore();
  paintTargets(painter);
  if (showsWind()) {
    paintWind(painter);
  }
  painter.save();
  painter.setClipRect(frame_.adjusted(-4.0, 0.0, 4.0, 0.0));
  paintMarks(painter);
  painter.restore();
  paintFrame(painter);
  paintStrip(painter);
  paintLegend(painter);
  painter.restore();
}

void ProfileRenderer::paintCursor(QPainter& painter, double distance, Cursor kind) const {
  const document::TourState state = plan_.at(distance);
  const style::ChartColors& colors = style_.colors();
  const double x = scale_.xOf(distance);
  if (x < frame_.left() - 0.5 || x > frame_.right() + 0.5) {
    return;
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setClipRect(frame_.adjusted(-6.0, 0.0, 6.0, 1.0));
  painter.setPen(QPen(colors.routeCasing, 3.0));
  painter.drawLine(QPointF(x, frame_.top()), QPointF(x, frame_.bottom()));
  painter.setPen(QPen(colors.cursor, 1.2, kind == Cursor::Pinned ? Qt::DashLine : Qt::SolidLine));
  painter.drawLine(QPointF(x, frame_.top()), QPointF(x, frame_.bottom()));
  const QPointF tour(x, scale_.yOf(state.altitude));
  if (std::isfinite(state.safeAltitude)) {
    const QPointF safe(x, scale_.yOf(state.safeAltitude));
    painter.setPen(QPen(colors.routeCasing, 6.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(tour, safe);
    painter.setPen(QPen(colors.glide(shownMargin(state.glideMargin())), 3.5, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(tour, safe);
    painter.setPen(QPen(colors.safeAltitude, 2.0));
    painter.drawLine(safe + QPointF(-5.0, 0.0), safe + QPointF(5.0, 0.0));
  }
  painter.setPen(QPen(colors.cursor, 1.6));
  painter.setBrush(isDimmed() ? colors.routeOutdated : colors.route);
  painter.drawEllipse(tour, 5.0, 5.0);
  if (kind == Cursor::Pinned) {
    painter.setBrush(colors.cursor);
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(QPolygonF() << QPointF(x - 5.0, frame_.top()) << QPointF(x + 5.0, frame_.top()) << QPointF(x, frame_.top() + 7.0));
  }
  painter.restore();
}

QString emptyProfileText(const document::Situation& situation) {
  if (situation.sketch != nullptr) {
    return Words::tr("Planning. The profile appears as soon as the tour is complete.");
  }
  if (situation.terrain == nullptr) {
    return Words::tr("Load terrain and airports, then mark targets on the map: the altitude profile of the tour appears here.");
  }
  if (situation.targets == nullptr || situation.targets->empty()) {
    return Words::tr("Mark targets on the map and plan the tour: its altitude profile appears here.");
  }
  return Words::tr("Plan the tour: its altitude profile appears here.");
}

void paintEmptyProfile(QPainter& painter, const QRectF& area, const document::Situation& situation, const ProfileStyle& style) {
  painter.fillRect(area, style.colors().panel);
  painter.setFont(style.font);
  painter.setPen(style.colors().mutedText);
  painter.drawText(area.adjusted(16.0, 16.0, -16.0, -16.0), static_cast<int>(Qt::AlignCenter) | static_cast<int>(Qt::TextWordWrap),
                   emptyProfileText(situation));
}

QImage renderProfile(const document::Situation& situation, QSize size, double dpr, style::Theme theme, const style::Units& units,
                     std::optional<double> cursor) {
  QImage image(QSize(static_cast<int>(std::lround(size.width() * dpr)), static_cast<int>(std::lround(size.height() * dpr))),
               QImage::Format_ARGB32_Premultiplied);
  image.setDevicePixelRatio(dpr);
  image.fill(style::ChartColors::of(theme).panel);
  QPainter painter(&image);
  const ProfileStyle style{theme, units, QGuiApplication::font()};
  if (situation.plan == nullptr) {
    paintEmptyProfile(painter, QRectF(QPointF(0.0, 0.0), size), situation, style);
  } else {
    const ProfileRenderer renderer(situation, style, size);
    renderer.paint(painter);
    if (cursor) {
      renderer.paintCursor(painter, *cursor, Cursor::Pinned);
    }
  }
  return image;
}

}  // namespace vp::profile
