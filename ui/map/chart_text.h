#pragma once

#include "ui/style/chart_colors.h"
#include "ui/style/text_size.h"

#include <QFont>
#include <QPainter>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace vp::map {

/** The type scale of the map, device-independent pixels. */
enum class TextSize { Small = 11, Normal = 12, Large = 14 };

/** Font of the application at a size of the map; figures all as wide as each other. */
QFont chartFont(TextSize size, bool bold = false);

/** A line or more of text with a halo, so that it can be read over any ground. `at`: upper left corner of its box. */
void drawHaloText(QPainter& painter, QPointF at, const QStringList& lines, const QFont& font, const QColor& color, const QColor& halo);
/** Size of the box that drawHaloText fills. */
using style::textSize;

/** Text broken into lines of at most `width` px: at blanks where that can be done, else within a word. */
QStringList brokenLines(const QString& text, const QFont& font, double width);

/** The background of the scale bar, the legend and the like. */
void drawPanel(QPainter& painter, const QRectF& box, const style::ChartColors& colors);

/** Size of a plate with a text broken into lines, at most `maxWidth` px. */
QSizeF plateSize(const QString& text, const QFont& font, double maxWidth);
/** Text on a rounded plate of plateSize(). */
void drawPlate(QPainter& painter, const QRectF& box, const QString& text, const QFont& font, const QColor& color, const QColor& plate,
               const QColor& border);
/** The same in one line, centred on a point: warnings, readouts. Returns the plate. */
QRectF drawPlate(QPainter& painter, QPointF centre, const QString& text, const QFont& font, const QColor& color, const QColor& plate,
                 const QColor& border);
/** The box of a readout with its upper left corner at a point, moved so that it stays inside `within`. */
QRectF readoutBox(QPointF at, const QStringList& lines, const QRectF& within);
/** Lines on a plate of readoutBox(), which it returns. */
QRectF drawReadout(QPainter& painter, QPointF at, const QStringList& lines, const style::ChartColors& colors, const QRectF& within);

/** Greedy label placement: the first free of several places around a point, or none. */
class LabelPlacer {
public:
  explicit LabelPlacer(QRectF within) : within_(within) {}

  /** Keeps a place free of labels: a symbol, the frame. */
  void reserve(const QRectF& taken) { taken_.push_back(taken); }
  /** Keeps a place free as long as there is another: lines that labels should rather not cross. */
  void avoid(const QRectF& box) { avoided_.push_back(box); }
  [[nodiscard]] bool isFree(const QRectF& box) const;
  /** Finds room for a box next to a symbol of `radius` px and takes it. @return its upper left corner, or nothing */
  std::optional<QPointF> place(QPointF anchor, double radius, QSizeF size);
  /** Takes exactly this place if it is free. */
  bool placeAt(const QRectF& box);
  /** The same, but not on what labels should rather not cross. */
  bool placeClear(const QRectF& box);

private:
  [[nodiscard]] bool isClear(const QRectF& box) const;

  QRectF within_;
  std::vector<QRectF> taken_;
  std::vector<QRectF> avoided_;
};

}  // namespace vp::map
