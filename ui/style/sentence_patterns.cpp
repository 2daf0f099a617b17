#include "ui/style/sentence_patterns.h"

#include <algorithm>

namespace vp::style {
namespace {

bool isOpening(QChar c) {
  return QStringLiteral(" ,;:.").contains(c);
}

/// A piece of a pattern: its own text, and the placeholder behind it.
struct Piece {
  QString text;
  enum Kind { End, Text, Number } behind = End;
};

Piece::Kind kindOf(QStringView placeholder) {
  const qsizetype colon = placeholder.indexOf(QLatin1Char(':'));
  return colon >= 0 && QStringLiteral("fgde").contains(placeholder.back()) ? Piece::Number : Piece::Text;
}

std::vector<Piece> piecesOf(const QString& pattern) {
  std::vector<Piece> pieces(1);
  for (qsizetype i = 0; i < pattern.size(); ++i) {
    const QChar c = pattern[i];
    const bool isBrace = c == QLatin1Char('{') || c == QLatin1Char('}');
    const bool isDoubled = isBrace && i + 1 < pattern.size() && pattern[i + 1] == c;
    const qsizetype end = c == QLatin1Char('{') && !isDoubled ? pattern.indexOf(QLatin1Char('}'), i) : -1;
    if (end > 0) {
      pieces.back().behind = kindOf(QStringView(pattern).mid(i + 1, end - i - 1));
      pieces.emplace_back();
      i = end;
    } else {
      pieces.back().text += c;
      i += isDoubled ? 1 : 0;
    }
  }
  return pieces;
}

}  // namespace

SentencePatterns::SentencePatterns(std::span<const char* const> patterns) {
  const QString anything = QStringLiteral("(.*?)");
  const QString number = QStringLiteral("([-+]?(?:\\d[\\d.]*(?:e[-+]?\\d+)?|inf|nan))");
  patterns_.reserve(patterns.size());
  for (const char* text : patterns) {
    Pattern pattern;
    pattern.text = text;
    const QString whole = QString::fromUtf8(text);
    pattern.isOpenBefore = !whole.isEmpty() && isOpening(whole.front());
    pattern.isOpenBehind = !whole.isEmpty() && whole.back() == QLatin1Char(' ');
    QString expression = pattern.isOpenBefore ? anything : QString();
    for (const Piece& piece : piecesOf(whole)) {
      expression += QRegularExpression::escape(piece.text);
      expression += piece.behind == Piece::End ? QString() : piece.behind == Piece::Number ? number : anything;
      pattern.length += piece.text.size();
      pattern.longestPiece = piece.text.size() > pattern.longestPiece.size() ? piece.text : pattern.longestPiece;
    }
    expression += pattern.isOpenBehind ? anything : QString();
    pattern.expression = QRegularExpression(QRegularExpression::anchoredPattern(expression), QRegularExpression::DotMatchesEverythingOption);
    patterns_.push_back(std::move(pattern));
  }
  std::stable_sort(patterns_.begin(), patterns_.end(), [](const Pattern& a, const Pattern& b) { return a.length > b.length; });
}

std::optional<SentencePatterns::Match> SentencePatterns::match(const QString& sentence, bool mayHoldJoints) const {
  for (const Pattern& pattern : patterns_) {
    if (!sentence.contains(pattern.longestPiece)) {
      continue;
    }
    const QRegularExpressionMatch match = pattern.expression.match(sentence);
    if (!match.hasMatch()) {
      continue;
    }
    Match found{pattern.text, match.capturedTexts().mid(1), {}, {}};
    if (!mayHoldJoints && !found.filled.filter(QStringLiteral("; ")).isEmpty()) {
      continue;
    }
    if (pattern.isOpenBefore) {
      found.before = found.filled.takeFirst();
    }
    if (pattern.isOpenBehind) {
      found.behind = found.filled.takeLast();
    }
    return found;
  }
  return std::nullopt;
}

QString filledIn(const QString& translated, const QStringList& filled) {
  QString text;
  for (qsizetype i = 0; i < translated.size(); ++i) {
    const int number = translated[i] == QLatin1Char('%') && i + 1 < translated.size() ? translated[i + 1].digitValue() : -1;
    if (number < 1) {
      text += translated[i];
      continue;
    }
    ++i;
    const int second = number < 10 && i + 1 < translated.size() ? translated[i + 1].digitValue() : -1;
    const bool isTwoDigits = second >= 0 && 10 * number + second <= filled.size();
    i += isTwoDigits ? 1 : 0;
    const int which = isTwoDigits ? 10 * number + second : number;
    text += which <= filled.size() ? filled[which - 1] : QString();
  }
  return text;
}

}  // namespace vp::style
