#include "ui/map/area_layer.h"

#include "core/base/quantity.h"
#include "core/risk/population.h"

#include <QPainterPath>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vp::map {
namespace {

using style::ChartColors;

constexpr double kPerSquareKm = 1e6;  // m^2
constexpr float kVeil = 0.16F;
constexpr float kHatchOpacity = 0.75F;
constexpr double kOutline = 2.0;  // px
constexpr double kCasing = 4.0;

bool overlap(const geo::Box& a, const geo::Box& b) {
  return a.minX < b.maxX && b.minX < a.maxX && a.minY < b.maxY && b.minY < a.maxY;
}

QPolygonF inWindow(const PixelWindow& window, const std::vector<geo::Point>& ring) {
  QPolygonF polygon;
  polygon.reserve(static_cast<qsizetype>(ring.size()));
  for (const geo::Point& p : ring) {
    polygon << QPointF(p.x / window.metresPerPixel - static_cast<double>(window.left),
                       -p.y / window.metresPerPixel - static_cast<double>(window.top));
  }
  return polygon;
}

double perNauticalMile(const mission::WeatherCell& cell) {
  return std::pow(cell.success, kMetresPerNauticalMile / cell.perDistance);
}

/// Where a pattern that repeats every `period` pixels of the frame's raster begins in a window.
QPointF patternOrigin(const PixelWindow& window, int period) {
  const auto phase = [period](std::int64_t at) { return -static_cast<double>(((at % period) + period) % period); };
  return {phase(window.left), phase(window.top)};
}

}  // namespace

PopulationLayer::PopulationLayer(std::shared_ptr<const risk::Population> population) : population_(std::move(population)) {
  boxes_.resize(population_->size());
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    for (const geo::Point& corner : population_->polygon(i).rings.front()) {
      boxes_[i].add(corner);
    }
  }
}

int PopulationLayer::classOf(double density) {
  const double perSquareKm = density * kPerSquareKm;
  return static_cast<int>(std::count_if(kClasses.begin(), kClasses.end(), [&](double limit) { return perSquareKm >= limit; })) - 1;
}

QColor PopulationLayer::colorOf(int densityClass, style::Theme theme) {
  // YlOrBr of ColorBrewer, C. Brewer 2002, five classes of seven: yellow for towns as on aeronautical charts, in an order of lightness
  static const std::array colors{QColor(0xFE, 0xF3, 0xB8), QColor(0xFE, 0xC4, 0x4F), QColor(0xEC, 0x70, 0x14), QColor(0xA9, 0x3F, 0x03),
                                 QColor(0x5A, 0x1F, 0x05)};
  const auto at = static_cast<std::size_t>(std::clamp(densityClass, 0, static_cast<int>(colors.size()) - 1));
  return theme == style::Theme::Light ? colors[at] : colors[colors.size() - 1 - at];
}

void PopulationLayer::paint(QPainter& painter, const PixelWindow& window, style::Theme theme) const {
  const geo::Box view = window.box();
  // opaque in a picture of its own: where areas meet there is no seam, and the opacity is that of one layer
  QImage image(window.width, window.height, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter onto(&image);
  onto.setPen(Qt::NoPen);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    const risk::Population::Polygon& polygon = population_->polygon(i);
    const int densityClass = classOf(polygon.density);
    if (densityClass < 0 || !overlap(boxes_[i], view)) {
      continue;
    }
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill);
    for (const std::vector<geo::Point>& ring : polygon.rings) {
      path.addPolygon(inWindow(window, ring));
      path.closeSubpath();
    }
    onto.fillPath(path, colorOf(densityClass, theme));
  }
  onto.end();
  painter.save();
  painter.setOpacity(kOpacity);
  painter.drawImage(0, 0, image);
  painter.restore();
}

int weatherHatchPeriod(double success, double devicePixelRatio) {
  const double period = success >= 0.97 ? 18.0 : success >= 0.85 ? 12.0 : 8.0;
  return static_cast<int>(std::lround(period * devicePixelRatio));
}

QBrush weatherHatch(double success, const QColor& color, double devicePixelRatio) {
  const int period = weatherHatchPeriod(success, devicePixelRatio);
  QImage tile(period, period, QImage::Format_ARGB32_Premultiplied);
  tile.fill(Qt::transparent);
  QPainter painter(&tile);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(color, 1.3 * devicePixelRatio));
  for (const int shift : {-period, 0, period}) {
    painter.drawLine(QPointF(shift - 2.0, period + 2.0), QPointF(shift + period + 2.0, -2.0));
  }
  painter.end();
  return QBrush(tile);
}

void paintWeather(QPainter& painter, const PixelWindow& window, double devicePixelRatio, const std::vector<document::ShownWeather>& cells,
                  style::Theme theme) {
  const geo::Box view = window.grown(static_cast<int>(std::ceil(kCasing * devicePixelRatio))).box();
  const ChartColors& colors = ChartColors::of(theme);
  QColor veil = colors.weather;
  veil.setAlphaF(kVeil);
  QColor ink = colors.weather;
  ink.setAlphaF(kHatchOpacity);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const document::ShownWeather& shown : cells) {
    if (!overlap(shown.box, view)) {
      continue;
    }
    QPainterPath path;
    path.addPolygon(inWindow(window, shown.outline));
    path.closeSubpath();
    const double success = perNauticalMile(shown.cell);
    if (success < 1.0) {
      painter.fillPath(path, veil);
      painter.setBrushOrigin(patternOrigin(window, weatherHatchPeriod(success, devicePixelRatio)));
      painter.fillPath(path, weatherHatch(success, ink, devicePixelRatio));
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors.routeCasing, kCasing * devicePixelRatio));
    painter.drawPath(path);
    painter.setPen(QPen(colors.weather, kOutline * devicePixelRatio));
    painter.drawPath(path);
  }
  painter.restore();
}

}  // namespace vp::map
