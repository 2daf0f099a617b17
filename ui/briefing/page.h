#pragma once

#include "ui/briefing/briefing_options.h"

#include <QColor>
#include <QFont>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QPainter;

namespace vp::briefing {

/** Lengths on paper: one unit is 1/720 inch, a tenth of a point, so fonts have whole sizes. */
inline constexpr double kPoint = 10.0;
inline constexpr double kInch = 720.0;

/** The fonts of a briefing. All of them DejaVu Sans, which the packages of the program bring along; sizes in points. */
enum class Type { Body, Strong, Small, SmallStrong, Cell, CellStrong, Head, Title };
inline constexpr double kLeastPointSize = 8.0;
QFont fontOf(Type type);

/** Lines of text in a box that they fit into. */
struct TextItem {
  QRectF box;
  QStringList lines;
  Type type = Type::Body;
  Qt::Alignment alignment = Qt::AlignLeft;
  QColor color = Qt::black;
};

/** A filled and framed rectangle or, where it has no width or no height, a line. */
struct ShapeItem {
  QRectF box;
  QColor fill;  ///< invalid: none
  double line = 0.0;
};

/** A picture; the callback draws into its box, which is what it is given. */
struct PictureItem {
  QRectF box;
  std::function<void(QPainter&, const QRectF&)> draw;
};

/** A page ready to be painted: every text measured, every box known. */
struct Page {
  std::vector<ShapeItem> shapes;
  std::vector<TextItem> texts;
  std::vector<PictureItem> pictures;
};

/** Whole sheet and the part inside the margins, which everything stays within. */
struct Sheet {
  QRectF paper;
  QRectF frame;
  static Sheet of(Paper paper);
};

/** Paints shapes, pictures and text, in this order. */
void paintPage(QPainter& painter, const Page& page);

/** Breaks text at words, or inside them where a word is wider than the line. Newlines break always. */
QStringList brokenInto(const QString& text, Type type, double width);
double lineHeight(Type type);
double textWidth(const QString& text, Type type);

}  // namespace vp::briefing
