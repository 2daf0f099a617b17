#include "ui/map/screen_lines.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vp::map {
namespace {

constexpr double kLeastStep = 0.8;  // px between points worth drawing
constexpr double kFlatness = 0.12;  // px that a line may leave a point out by

/// The part of a segment inside a rectangle as parameters 0..1 (Liang and Barsky 1984).
std::optional<std::pair<double, double>> clipped(QPointF a, QPointF b, const QRectF& rect) {
  double from = 0.0;
  double to = 1.0;
  const auto cut = [&](double step, double room) {
    if (step == 0.0) {
      return room >= 0.0;
    }
    const double t = room / step;
    (step < 0.0 ? from : to) = step < 0.0 ? std::max(from, t) : std::min(to, t);
    return from <= to;
  };
  const bool isInside = cut(a.x() - b.x(), a.x() - rect.left()) && cut(b.x() - a.x(), rect.right() - a.x()) &&
                        cut(a.y() - b.y(), a.y() - rect.top()) && cut(b.y() - a.y(), rect.bottom() - a.y());
  return isInside ? std::optional(std::pair(from, to)) : std::nullopt;
}

double lengthOf(QPointF a) {
  return std::hypot(a.x(), a.y());
}

/// Leaves out points of nearly straight stretches: stroking costs by the point (Reumann and Witkam 1974).
QPolygonF straightened(const QPolygonF& points) {
  if (points.size() < 3) {
    return points;
  }
  QPolygonF kept{points.front()};
  QPointF way = points[1] - points[0];
  for (qsizetype i = 1; i + 1 < points.size(); ++i) {
    const QPointF step = points[i + 1] - kept.back();
    const double length = lengthOf(way);
    const bool isAhead = QPointF::dotProduct(points[i + 1] - points[i], way) > 0.0;
    if (!isAhead || std::abs(way.x() * step.y() - way.y() * step.x()) > kFlatness * length) {
      kept.push_back(points[i]);
      way = points[i + 1] - points[i];
    }
  }
  kept.push_back(points.back());
  return kept;
}

}  // namespace

std::vector<ScreenLine> screenLines(const std::vector<geo::Point>& line, const MapCamera& camera, double border) {
  std::vector<ScreenLine> lines;
  if (line.size() < 2) {
    return lines;
  }
  const QRectF view = camera.screen().adjusted(-border, -border, border, border);
  double along = 0.0;
  bool isOpen = false;
  QPointF a = camera.toScreen(line.front());
  for (std::size_t i = 1; i < line.size(); ++i) {
    const QPointF b = camera.toScreen(line[i]);
    const double length = lengthOf(b - a);
    if (length < kLeastStep && i + 1 < line.size()) {
      continue;
    }
    const auto part = clipped(a, b, view);
    if (part) {
      if (!isOpen || part->first > 0.0) {
        lines.push_back({{a + (b - a) * part->first}, along + length * part->first});
      }
      lines.back().points.push_back(a + (b - a) * part->second);
      isOpen = part->second >= 1.0;
    } else {
      isOpen = false;
    }
    along += length;
    a = b;
  }
  for (ScreenLine& part : lines) {
    part.points = straightened(part.points);
  }
  return lines;
}

std::vector<LineMark> marksAlong(const ScreenLine& line, double spacing) {
  std::vector<LineMark> marks;
  double along = line.start;
  for (qsizetype i = 1; i < line.points.size(); ++i) {
    const QPointF a = line.points[i - 1];
    const QPointF step = line.points[i] - a;
    const double length = lengthOf(step);
    // marks stand at (k + 1/2) spacing of the whole line, so they stay when the view moves
    double next = (std::floor(along / spacing - 0.5) + 1.5) * spacing;
    for (; length > 0.0 && next <= along + length; next += spacing) {
      marks.push_back({a + step * ((next - along) / length), std::atan2(step.y(), step.x())});
    }
    along += length;
  }
  return marks;
}

}  // namespace vp::map
