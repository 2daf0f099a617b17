#include "ui/briefing/page.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRegularExpression>
#include <QTextLayout>

#include <cmath>
#include <map>

namespace vp::briefing {
namespace {

constexpr double kMillimetre = kInch / 25.4;
constexpr double kSide = 13.0 * kMillimetre;  // left and right, room for a clip
constexpr double kEnd = 11.0 * kMillimetre;   // top and bottom

struct Face {
  double points = kLeastPointSize;
  bool isStrong = false;
  bool isCondensed = false;
};

Face faceOf(Type type) {
  switch (type) {
    case Type::Body:
      return {9.0};
    case Type::Strong:
      return {9.0, true};
    case Type::Small:
      return {kLeastPointSize};
    case Type::SmallStrong:
      return {kLeastPointSize, true};
    case Type::Cell:
      return {8.5, false, true};
    case Type::CellStrong:
      return {8.5, true, true};
    case Type::Head:
      return {11.5, true};
    case Type::Title:
      return {17.0, true};
  }
  return {};
}

/// As long as the text: no line ends between a number and its unit, or a unit and its datum.
QString unbroken(QString words) {
  static const QRegularExpression gap(
      QStringLiteral("(?<=\\d) (?=(?:ft|m|NM|km|kt|kg|min|h|km/h|m/s|ft/min)\\b)|(?<=\\bft|\\bm) (?=(?:MSL|AGL)\\b)"));
  constexpr QChar kThinSpace(0x2009);  // between groups of digits
  constexpr QChar kThinNbsp(0x202F);
  return words.replace(gap, QString(QChar(QChar::Nbsp))).replace(kThinSpace, kThinNbsp);
}

QFont makeFont(Type type) {
  const Face face = faceOf(type);
  QFont font(face.isCondensed ? QStringLiteral("DejaVu Sans Condensed") : QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(std::lround(face.points * kPoint)));
  font.setBold(face.isStrong);
  font.setHintingPreference(QFont::PreferNoHinting);
  return font;
}

}  // namespace

QFont fontOf(Type type) {
  thread_local std::map<Type, QFont> fonts;  // matching a family takes longer than setting a page
  const auto known = fonts.find(type);
  return known != fonts.end() ? known->second : fonts.emplace(type, makeFont(type)).first->second;
}

double lineHeight(Type type) {
  return 1.18 * fontOf(type).pixelSize();
}

double textWidth(const QString& text, Type type) {
  return QFontMetricsF(fontOf(type)).horizontalAdvance(text);
}

QStringList brokenInto(const QString& text, Type type, double width) {
  QStringList lines;
  for (const QString& paragraph : text.split(QLatin1Char('\n'))) {
    if (textWidth(paragraph, type) <= width) {
      lines << paragraph;
      continue;
    }
    QTextLayout layout(unbroken(paragraph), fontOf(type));
    QTextOption option;
    option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    layout.setTextOption(option);
    layout.beginLayout();
    for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
      line.setLineWidth(width);
      lines << paragraph.mid(line.textStart(), line.textLength()).trimmed();
    }
    layout.endLayout();
  }
  return lines;
}

Sheet Sheet::of(Paper paper) {
  const QSizeF size = paper == Paper::A4 ? QSizeF(210.0 * kMillimetre, 297.0 * kMillimetre) : QSizeF(8.5 * kInch, 11.0 * kInch);
  const QRectF whole(QPointF(0.0, 0.0), size);
  return {whole, whole.adjusted(kSide, kEnd, -kSide, -kEnd)};
}

void paintPage(QPainter& painter, const Page& page) {
  for (const ShapeItem& shape : page.shapes) {
    painter.setPen(shape.line > 0.0 ? QPen(Qt::black, shape.line, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin) : QPen(Qt::NoPen));
    painter.setBrush(shape.fill.isValid() ? QBrush(shape.fill) : QBrush(Qt::NoBrush));
    if (shape.box.width() <= 0.0 || shape.box.height() <= 0.0) {
      painter.drawLine(shape.box.topLeft(), shape.box.bottomRight());
    } else {
      painter.drawRect(shape.box);
    }
  }
  for (const PictureItem& picture : page.pictures) {
    painter.save();
    painter.setClipRect(picture.box);
    picture.draw(painter, picture.box);
    painter.restore();
  }
  for (const TextItem& item : page.texts) {
    painter.setFont(fontOf(item.type));
    painter.setPen(item.color);
    QRectF line(item.box.topLeft(), QSizeF(item.box.width(), lineHeight(item.type)));
    for (const QString& words : item.lines) {
      painter.drawText(line, static_cast<int>(item.alignment | Qt::AlignVCenter) | Qt::TextDontClip | Qt::TextSingleLine, words);
      line.translate(0.0, lineHeight(item.type));
    }
  }
}

}  // namespace vp::briefing
