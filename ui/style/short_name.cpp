#include "ui/style/short_name.h"

#include <QTextBoundaryFinder>

#include <vector>

namespace vp::style {

QString shortName(const QString& name) {
  const QString whole = name.simplified();
  // between letters only: an accent or the second half of a character stays with its first
  std::vector<qsizetype> ends;
  QTextBoundaryFinder finder(QTextBoundaryFinder::Grapheme, whole);
  for (qsizetype at = finder.toNextBoundary(); at > 0; at = finder.toNextBoundary()) {
    ends.push_back(at);
  }
  if (ends.size() <= static_cast<std::size_t>(kLongestName)) {
    return whole;
  }
  constexpr std::size_t kTail = kLongestName / 2 - 1;
  constexpr std::size_t kHead = kLongestName - 1 - kTail;
  return whole.left(ends[kHead - 1]).trimmed() + QChar(0x2026) + whole.mid(ends[ends.size() - kTail - 1]).trimmed();
}

}  // namespace vp::style
