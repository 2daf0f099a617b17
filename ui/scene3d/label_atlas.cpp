#include "ui/scene3d/label_atlas.h"

#include "ui/style/chart_colors.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QTransform>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vp::scene3d {
namespace {

constexpr int kAtlasWidth = 1024;  // px at 96 dpi
constexpr double kGap = 2.0;

/// Something to paint into the atlas and the piece that learns where it went.
struct Job {
  QSizeF size;
  std::function<void(QPainter&)> paint;  ///< into a rectangle of that size at the origin
  AtlasPiece* piece = nullptr;
};

QFont fontOf(SceneLabel::Kind kind, bool isDetail) {
  QFont font;
  font.setPixelSize(kind == SceneLabel::Kind::RunwayEnd || kind == SceneLabel::Kind::Airspace || isDetail ? 11 : 13);
  font.setBold(!isDetail && kind != SceneLabel::Kind::RunwayEnd);
  return font;
}

/// Outlines of text. Those of small letters are rounded to 1/64 px in a way that depends on what was written before, so they are taken
/// from letters many times as large.
QPainterPath outlineOf(QPointF baseline, const QFont& font, const QString& text) {
  constexpr int kLarger = 64;
  QFont large = font;
  large.setPixelSize(kLarger * font.pixelSize());
  QPainterPath path;
  path.addText({}, large, text);
  return QTransform::fromTranslate(baseline.x(), baseline.y()).scale(1.0 / kLarger, 1.0 / kLarger).map(path);
}

void paintText(QPainter& painter, QPointF baseline, const QFont& font, const QString& text, const QColor& color, const QColor& halo) {
  const QPainterPath path = outlineOf(baseline, font, text);
  painter.strokePath(path, QPen(halo, 3.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(path, color);
}

/// A text of one or two lines with a halo; the cursor's on a panel, since it moves over everything.
Job textJob(const SceneLabel& label, bool isBrief, const style::ChartColors& colors, AtlasPiece* piece) {
  const QFont first = fontOf(label.kind, false);
  const QFont second = fontOf(label.kind, true);
  const QFontMetricsF firstMetrics(first);
  const QFontMetricsF secondMetrics(second);
  const bool hasDetail = !isBrief && !label.detail.isEmpty();
  const bool hasPanel = label.kind == SceneLabel::Kind::Cursor;
  const double border = hasPanel ? 5.0 : 2.5;
  const double wide = std::max(firstMetrics.horizontalAdvance(label.text), hasDetail ? secondMetrics.horizontalAdvance(label.detail) : 0.0);
  const double high = firstMetrics.height() + (hasDetail ? secondMetrics.height() : 0.0);
  const QSizeF size(std::ceil(wide + 2.0 * border), std::ceil(high + 2.0 * border));
  const auto paint = [=](QPainter& painter) {
    if (hasPanel) {
      QColor panel = colors.panel;
      panel.setAlpha(225);
      painter.setPen(QPen(colors.panelBorder, 1.0));
      painter.setBrush(panel);
      painter.drawRoundedRect(QRectF(QPointF(0.5, 0.5), size - QSizeF(1.0, 1.0)), 4.0, 4.0);
    }
    const QColor halo = hasPanel ? QColor(Qt::transparent) : colors.textHalo;
    const auto left = [&](double width) { return 0.5 * (size.width() - width); };
    paintText(painter, {left(firstMetrics.horizontalAdvance(label.text)), border + firstMetrics.ascent()}, first, label.text, label.color, halo);
    if (hasDetail) {
      paintText(painter, {left(secondMetrics.horizontalAdvance(label.detail)), border + firstMetrics.height() + secondMetrics.ascent()}, second,
                label.detail, colors.text, halo);
    }
  };
  return {size, paint, piece};
}

Job targetHeadJob(const QColor& color, const style::ChartColors& colors, bool isSelected, AtlasPiece* piece) {
  constexpr double kSide = 18.0;
  return {QSizeF(kSide, kSide),
          [=](QPainter& painter) {
            const QPointF middle(0.5 * kSide, 0.5 * kSide);
            painter.setPen(QPen(isSelected ? colors.selection : colors.textHalo, isSelected ? 3.0 : 2.0));
            painter.setBrush(color);
            painter.drawEllipse(middle, 6.5, 6.5);
            painter.setPen(Qt::NoPen);
            painter.setBrush(colors.textHalo);
            painter.drawEllipse(middle, 2.4, 2.4);
          },
          piece};
}

/// An aircraft from above, nose up.
Job aircraftJob(const style::ChartColors& colors, AtlasPiece* piece) {
  constexpr double kSide = 40.0;
  return {QSizeF(kSide, kSide),
          [=](QPainter& painter) {
            QPainterPath path;
            path.addRoundedRect(QRectF(18.2, 5.0, 3.6, 28.0), 1.8, 1.8);
            path.addRoundedRect(QRectF(4.0, 13.0, 32.0, 5.0), 2.0, 2.0);
            path.addRoundedRect(QRectF(14.0, 28.5, 12.0, 3.6), 1.6, 1.6);
            path.setFillRule(Qt::WindingFill);
            const QPainterPath outline = path.simplified();
            painter.strokePath(outline, QPen(colors.textHalo, 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
            painter.fillPath(outline, colors.cursor);
          },
          piece};
}

/// Places the jobs in rows. @return height used
double pack(const std::vector<Job>& jobs, std::vector<QPointF>& places) {
  double x = kGap;
  double y = kGap;
  double row = 0.0;
  for (const Job& job : jobs) {
    if (x + job.size.width() + kGap > kAtlasWidth) {
      x = kGap;
      y += row + kGap;
      row = 0.0;
    }
    places.emplace_back(x, y);
    x += job.size.width() + kGap;
    row = std::max(row, job.size.height());
  }
  return y + row + kGap;
}

void addItems(const SceneData& scene, const style::ChartColors& colors, LabelAtlas& atlas, std::vector<Job>& jobs) {
  for (const ScenePole& pole : scene.poles) {
    AtlasItem& item = atlas.items.emplace_back();
    item.shape = AtlasItem::Shape::TargetHead;
    item.anchor = pole.head;
    item.priority = 90.0;
    item.isFaintBehindGround = true;
    jobs.push_back(targetHeadJob(pole.color, colors, pole.isSelected, &item.full));
  }
  for (const SceneLabel& label : scene.labels) {
    AtlasItem& item = atlas.items.emplace_back();
    item.anchor = label.anchor;
    item.priority = label.priority;
    item.showWithin = label.showWithin;
    item.isFaintBehindGround = label.kind == SceneLabel::Kind::Target || label.kind == SceneLabel::Kind::Cursor;
    item.lift = label.kind == SceneLabel::Kind::Target ? 10.0 : label.kind == SceneLabel::Kind::Cursor ? 24.0 : 7.0;
    jobs.push_back(textJob(label, false, colors, &item.full));
    if (!label.detail.isEmpty()) {
      jobs.push_back(textJob(label, true, colors, &item.brief));
    }
  }
  if (scene.aircraft) {
    AtlasItem& item = atlas.items.emplace_back();
    item.shape = AtlasItem::Shape::Aircraft;
    item.anchor = scene.aircraft->position;
    item.heading = scene.aircraft->heading;
    item.priority = 110.0;
    item.isFaintBehindGround = true;
    jobs.push_back(aircraftJob(colors, &item.full));
  }
}

}  // namespace

LabelAtlas buildLabelAtlas(const SceneData& scene, double pixelRatio) {
  const style::ChartColors& colors = style::ChartColors::of(scene.style.theme);
  LabelAtlas atlas;
  atlas.items.reserve(scene.poles.size() + scene.labels.size() + 1);  // jobs point into it
  std::vector<Job> jobs;
  addItems(scene, colors, atlas, jobs);
  if (jobs.empty()) {
    return atlas;
  }
  std::vector<QPointF> places;
  const double used = pack(jobs, places);
  int high = 16;
  while (high < used) {
    high *= 2;
  }
  atlas.image = QImage(QSize(qRound(kAtlasWidth * pixelRatio), qRound(high * pixelRatio)), QImage::Format_RGBA8888_Premultiplied);
  atlas.image.fill(Qt::transparent);
  QPainter painter(&atlas.image);
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    painter.resetTransform();
    painter.scale(pixelRatio, pixelRatio);
    painter.translate(places[i]);
    jobs[i].paint(painter);
    *jobs[i].piece = {QRectF(places[i].x() / kAtlasWidth, places[i].y() / high, jobs[i].size.width() / kAtlasWidth, jobs[i].size.height() / high),
                      jobs[i].size};
  }
  return atlas;
}

}  // namespace vp::scene3d
