#include "ui/map/overlay_painter.h"

#include "ui/map/hatch.h"
#include "ui/map/margin_pattern.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace vp::map {
namespace {

using style::ChartColors;

constexpr int kScaleColors = 256;
constexpr float kTintOpacity = 0.50F;
constexpr float kNoGlideVeil = 0.22F;
constexpr float kNoGlideInk = 0.55F;
constexpr double kNoGlideSpacing = 11.0;  // px
constexpr float kContourOpacity = 0.85F;
constexpr float kReachVeil = 0.16F;
constexpr float kReachInk = 0.50F;
constexpr double kReachSpacing = 13.0;  // px
constexpr float kReachEdge = 2.6F;      // px
constexpr std::size_t kGlideThinning = 2;

/// A pixel under construction: colour not yet multiplied by its opacity.
struct Ink {
  float red = 0.0F;
  float green = 0.0F;
  float blue = 0.0F;
  float opacity = 0.0F;

  /// `color` laid over what is there.
  void over(QRgb color, float alpha) {
    const float sum = alpha + opacity * (1.0F - alpha);
    if (sum <= 0.0F) {
      return;
    }
    const float share = alpha / sum;
    red += (static_cast<float>(qRed(color)) - red) * share;
    green += (static_cast<float>(qGreen(color)) - green) * share;
    blue += (static_cast<float>(qBlue(color)) - blue) * share;
    opacity = sum;
  }
  [[nodiscard]] QRgb premultiplied() const {
    const auto part = [](float value) {
      const float rounded = value + 0.5F;
      return static_cast<int>(rounded);
    };
    return qRgba(part(red * opacity), part(green * opacity), part(blue * opacity), part(opacity * 255.0F));
  }
};

bool overlap(const geo::Box& a, const geo::Box& b) {
  return a.minX < b.maxX && b.minX < a.maxX && a.minY < b.maxY && b.minY < a.maxY;
}

QPointF inWindow(const PixelWindow& window, geo::Point p) {
  return {p.x / window.metresPerPixel - static_cast<double>(window.left), -p.y / window.metresPerPixel - static_cast<double>(window.top)};
}

}  // namespace

const std::vector<GlideLines::Line>& GlideLines::lines() const {
  std::call_once(made_, [this] {
    for (std::size_t i = 0; i < plan_->plan().tour.size() && !abandoned_; ++i) {
      const document::EngineOut out = plan_->engineOutAt(plan_->distanceOf(i));
      Line line;
      line.margin = out.margin;
      for (std::size_t k = 0; k < out.path.size(); ++k) {
        if (k % kGlideThinning == 0 || k + 1 == out.path.size()) {
          line.points.push_back(out.path[k].pose.point());
          line.box.add(line.points.back());
        }
      }
      lines_.push_back(std::move(line));
    }
  });
  return lines_;
}

bool OverlayContent::isEmpty() const {
  const bool field = safeAltitude != nullptr && (tint || reachableFrom);
  return !field && glides == nullptr && (roadmap == nullptr || roadmap->empty()) && population == nullptr && weather == nullptr;
}

OverlayPainter::OverlayPainter(OverlayContent content) : content_(std::move(content)) {
  for (int i = 0; i < kScaleColors; ++i) {
    scale_.push_back(ChartColors::altitudeScale(static_cast<double>(i) / (kScaleColors - 1)).rgb());
  }
  if (content_.glides == nullptr && content_.roadmap == nullptr && content_.population == nullptr && content_.weather == nullptr &&
      content_.safeAltitude != nullptr) {
    extent_ = content_.safeAltitude->box();
  }
}

void OverlayPainter::abandon() const {
  if (content_.glides != nullptr) {
    content_.glides->abandon();
  }
}

QImage OverlayPainter::paint(const PixelWindow& window, double devicePixelRatio) const {
  QImage image(window.width, window.height, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  if (content_.safeAltitude != nullptr && (content_.tint || content_.reachableFrom) && overlap(content_.safeAltitude->box(), window.box())) {
    paintField(image, window, devicePixelRatio);
  }
  if (content_.population != nullptr) {
    QPainter painter(&image);
    painter.setCompositionMode(QPainter::CompositionMode_DestinationOver);  // under the field, which counts more
    content_.population->paint(painter, window, content_.theme);
  }
  if (content_.weather != nullptr) {
    QPainter painter(&image);
    paintWeather(painter, window, devicePixelRatio, *content_.weather, content_.theme);
  }
  if (content_.roadmap != nullptr || content_.glides != nullptr) {
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    paintRoadmap(painter, window, devicePixelRatio);
    paintGlides(painter, window, devicePixelRatio);
  }
  return image;
}

void OverlayPainter::paintField(QImage& image, const PixelWindow& window, double devicePixelRatio) const {
  const SafeAltitudeLayer& layer = *content_.safeAltitude;
  const Samples samples = sample(layer.raster(), window.grown(1), Kernel::Bilinear);
  const ChartColors& colors = ChartColors::of(content_.theme);
  const geo::Box box = layer.box();
  const auto pixel = static_cast<float>(devicePixelRatio);
  const auto interval = static_cast<float>(layer.interval(content_.units));
  const QRgb line = colors.safeAltitude.darker(content_.theme == style::Theme::Light ? 150 : 90).rgb();
  const QRgb edge = colors.glideAmple.rgb();
  const QRgb none = colors.text.rgb();
  const double low = layer.lowest();
  const double perMetre = (kScaleColors - 1) / std::max(layer.highest() - low, 1.0);
  for (int row = 0; row < window.height; ++row) {
    const double y = window.yOf(row);
    if (y < box.minY || y > box.maxY) {
      continue;
    }
    auto* to = reinterpret_cast<QRgb*>(image.scanLine(row));
    for (int column = 0; column < window.width; ++column) {
      const double x = window.xOf(column);
      if (x < box.minX || x > box.maxX) {
        continue;
      }
      Ink ink;
      const std::size_t here = samples.index(column + 1, row + 1);
      const std::int64_t gx = window.left + column;
      const std::int64_t gy = window.top + row;
      if (!samples.isKnown(here)) {
        if (content_.tint) {
          const double spacing = kNoGlideSpacing * devicePixelRatio;
          ink.over(none, kNoGlideVeil);
          ink.over(none,
                   kNoGlideInk * std::max(hatchInk(gx, gy, spacing, devicePixelRatio, true), hatchInk(gx, gy, spacing, devicePixelRatio, false)));
          to[column] = ink.premultiplied();
        }
        continue;
      }
      const float value = samples.value[here];
      const float east = 0.5F * (samples.value[here + 1] - samples.value[here - 1]);
      const float north = 0.5F * (samples.value[samples.index(column + 1, row)] - samples.value[samples.index(column + 1, row + 2)]);
      const float steep = std::max(std::sqrt(east * east + north * north), 1e-3F * interval);  // m per device pixel
      if (content_.tint) {
        const auto at = static_cast<std::size_t>(std::clamp((static_cast<double>(value) - low) * perMetre, 0.0, kScaleColors - 1.0));
        ink.over(scale_[at], kTintOpacity);
        ink.over(line, kContourOpacity * lineInk((value - std::round(value / interval) * interval) / steep, 1.3F * pixel));
      }
      if (content_.reachableFrom) {
        const auto room = static_cast<float>(*content_.reachableFrom) - value;
        if (room >= 0.0F) {
          ink.over(edge, kReachVeil);
          ink.over(edge, kReachInk * hatchInk(gx, gy, kReachSpacing * devicePixelRatio, 1.2 * devicePixelRatio, false));
        }
        ink.over(edge, lineInk(room / steep, kReachEdge * pixel));
      }
      to[column] = ink.premultiplied();
    }
  }
}

void OverlayPainter::paintRoadmap(QPainter& painter, const PixelWindow& window, double devicePixelRatio) const {
  if (content_.roadmap == nullptr) {
    return;
  }
  QColor color = ChartColors::of(content_.theme).safeAltitude;
  color.setAlphaF(0.55F);
  painter.setPen(QPen(color, 0.9 * devicePixelRatio));
  const geo::Box view = window.grown(2).box();
  QVector<QLineF> lines;
  for (const document::PlanningSketch::Edge& edge : *content_.roadmap) {
    geo::Box box;
    box.add(edge.from);
    box.add(edge.to);
    if (overlap(view, box.grown(1e-3))) {
      lines.push_back({inWindow(window, edge.from), inWindow(window, edge.to)});
    }
  }
  painter.drawLines(lines);
}

void OverlayPainter::paintGlides(QPainter& painter, const PixelWindow& window, double devicePixelRatio) const {
  if (content_.glides == nullptr) {
    return;
  }
  const ChartColors& colors = ChartColors::of(content_.theme);
  const geo::Box view = window.grown(4).box();
  for (const GlideLines::Line& line : content_.glides->lines()) {
    if (!overlap(view, line.box.grown(1e-3))) {
      continue;
    }
    QPolygonF points;
    for (const geo::Point& point : line.points) {
      points.push_back(inWindow(window, point));
    }
    QPen pen = marginPen(line.margin, colors, 1.2 * devicePixelRatio);
    QColor color = pen.color();
    color.setAlphaF(0.75F);
    pen.setColor(color);
    painter.setPen(pen);
    painter.drawPolyline(points);
  }
}

}  // namespace vp::map
