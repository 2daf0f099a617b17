#pragma once

#include <QByteArray>
#include <QRegularExpression>
#include <QString>
#include <QStringList>

#include <optional>
#include <span>
#include <vector>

namespace vp::style {

/** Finds which of many patterns of fmt a sentence was made by, and what was filled in: "target {}: {:.0f} m are missing" and "target 3: 40 m are
 *  missing" give "3" and "40". The core joins sentences of pieces, so a pattern that begins with a punctuation mark or a space may have anything
 * before it, and one that ends with a space anything behind it. */
class SentencePatterns {
public:
  /** @param patterns  in UTF-8, kept by the caller; {{ and }} are braces, a placeholder with a format of numbers stands for a number only */
  explicit SentencePatterns(std::span<const char* const> patterns);

  struct Match {
    QByteArray pattern;  ///< as it was given
    QStringList filled;  ///< one for each of its placeholders
    QString before;      ///< what stands before a pattern that is a piece of a sentence; empty otherwise
    QString behind;
  };

  /** @param mayHoldJoints  whether what is filled in may hold a semicolon and a space, by which sentences are joined
   *  @return the pattern with the most text of its own, the first of equal ones; nothing if none fits */
  [[nodiscard]] std::optional<Match> match(const QString& sentence, bool mayHoldJoints = true) const;

private:
  struct Pattern {
    QByteArray text;
    QString longestPiece;  ///< of its own text: a quick look whether it can fit
    QRegularExpression expression;
    qsizetype length = 0;  ///< of its own text
    bool isOpenBefore = false;
    bool isOpenBehind = false;
  };

  std::vector<Pattern> patterns_;  ///< longest first
};

/** @return a translated pattern with %1, %2 ... filled in, each as often as it stands there; what is filled in is never looked at */
QString filledIn(const QString& translated, const QStringList& filled);

}  // namespace vp::style
