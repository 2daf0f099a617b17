#include "ui/style/text_size.h"

#include <QFontMetricsF>

#include <algorithm>

namespace vp::style {

QSizeF textSize(const QStringList& lines, const QFont& font) {
  const QFontMetricsF metrics(font);
  double width = 0.0;
  for (const QString& line : lines) {
    width = std::max(width, metrics.horizontalAdvance(line));
  }
  return {width, metrics.height() * static_cast<double>(lines.size())};
}

}  // namespace vp::style
