#include "ui/panels/position_text.h"

#include <QRegularExpression>
#include <QStringList>

#include <cmath>
#include <vector>

namespace vp::panels {
namespace {

struct Part {
  double degrees = 0.0;
  QChar letter;  ///< N, S, E, W or none
};

/// One, two or three numbers: degrees, minutes, seconds; only the last may have a fraction, only the first a sign.
std::optional<double> degreesOf(const QStringList& numbers) {
  if (numbers.isEmpty() || numbers.size() > 3) {
    return std::nullopt;
  }
  double value = 0.0;
  double unit = 1.0;
  for (qsizetype i = 0; i < numbers.size(); ++i, unit /= 60.0) {
    bool ok = false;
    const double number = std::abs(numbers[i].toDouble(&ok));
    const bool whole = !numbers[i].contains(QLatin1Char('.'));
    if (!ok || (i > 0 && (number >= 60.0 || numbers[i].startsWith(QLatin1Char('-')))) || (i + 1 < numbers.size() && !whole)) {
      return std::nullopt;
    }
    value += number * unit;
  }
  return numbers[0].startsWith(QLatin1Char('-')) ? -value : value;
}

/// Splits at the letters, or at the comma, or in the middle.
std::vector<std::pair<QStringList, QChar>> split(const QStringList& tokens) {
  std::vector<std::pair<QStringList, QChar>> parts;
  const auto isLetter = [](const QString& token) { return token.size() == 1 && QStringLiteral("NSEW").contains(token[0]); };
  const bool letterFirst = !tokens.isEmpty() && isLetter(tokens[0]);
  QStringList numbers;
  QChar letter;
  for (const QString& token : tokens) {
    const bool ends = token == QStringLiteral(",") || isLetter(token);
    if (!ends) {
      numbers << token;
      continue;
    }
    if (isLetter(token) && !letterFirst) {
      letter = token[0];
    }
    if (!numbers.isEmpty()) {
      parts.emplace_back(numbers, letter);
      numbers.clear();
      letter = QChar();
    }
    if (isLetter(token) && letterFirst) {
      letter = token[0];
    }
  }
  if (!numbers.isEmpty()) {
    parts.emplace_back(numbers, letter);
  }
  if (parts.size() == 1 && parts[0].second.isNull() && parts[0].first.size() % 2 == 0) {
    const QStringList all = parts[0].first;
    parts = {{all.mid(0, all.size() / 2), QChar()}, {all.mid(all.size() / 2), QChar()}};
  }
  return parts;
}

}  // namespace

std::optional<geo::LatLon> parsePosition(const QString& text) {
  static const QRegularExpression tokenPattern(QStringLiteral("-?\\d+(?:\\.\\d+)?|[NSEW,;]"));
  static const QRegularExpression allowed(QStringLiteral("^[-\\d.,;NSEW\\s°'\"′″º:]*$"));
  QString upper = text.toUpper().trimmed();
  upper.replace(QChar(0x2212), QLatin1Char('-'));
  if (!allowed.match(upper).hasMatch()) {
    return std::nullopt;
  }
  QStringList tokens;
  for (auto match = tokenPattern.globalMatch(upper); match.hasNext();) {
    const QString token = match.next().captured();
    tokens << (token == QStringLiteral(";") ? QStringLiteral(",") : token);
  }
  std::vector<Part> parts;
  for (const auto& [numbers, letter] : split(tokens)) {
    const std::optional<double> degrees = degreesOf(numbers);
    if (!degrees || (!letter.isNull() && *degrees < 0.0)) {
      return std::nullopt;
    }
    const bool negative = letter == QLatin1Char('S') || letter == QLatin1Char('W');
    parts.push_back({negative ? -*degrees : *degrees, letter});
  }
  if (parts.size() != 2 || parts[0].letter.isNull() != parts[1].letter.isNull()) {
    return std::nullopt;
  }
  const auto isEastWest = [](const Part& part) { return part.letter == QLatin1Char('E') || part.letter == QLatin1Char('W'); };
  if (!parts[0].letter.isNull() && isEastWest(parts[0]) == isEastWest(parts[1])) {
    return std::nullopt;
  }
  if (isEastWest(parts[0])) {
    std::swap(parts[0], parts[1]);
  }
  if (std::abs(parts[0].degrees) > 90.0 || std::abs(parts[1].degrees) > 180.0) {
    return std::nullopt;
  }
  return geo::LatLon{parts[0].degrees, parts[1].degrees};
}

}  // namespace vp::panels
