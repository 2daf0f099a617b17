#include "ui/style/core_text.h"

#include "ui/style/core_sentences.h"
#include "ui/style/sentence_patterns.h"

#include <QCoreApplication>
#include <QHash>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace vp::style {
namespace {

constexpr int kDeepest = 6;            // a sentence in a sentence in a sentence, and its figures
constexpr int kMostJoints = 16;        // of a text that is not known as a whole
constexpr qsizetype kMostKept = 2000;  // sentences remembered, some 400 bytes each

// Texts of one word, which the list of sentences leaves out because few words of a source are for people; some with a format that the core does not
// state.
constexpr std::array kWords{
    QT_TRANSLATE_NOOP("Core", "weather"),
    QT_TRANSLATE_NOOP("Core", "manoeuvres"),
    QT_TRANSLATE_NOOP("Core", "distance"),
    QT_TRANSLATE_NOOP("Core", "time"),
    QT_TRANSLATE_NOOP("Core", "airfields"),
    QT_TRANSLATE_NOOP("Core", "contours"),
    QT_TRANSLATE_NOOP("Core", "planned"),
    QT_TRANSLATE_NOOP("Core", "stopped"),
    QT_TRANSLATE_NOOP("Core", "left"),
    QT_TRANSLATE_NOOP("Core", "right"),
    QT_TRANSLATE_NOOP("Core", "front"),
    QT_TRANSLATE_NOOP("Core", "behind {}"),
    QT_TRANSLATE_NOOP("Core", "from"),
    QT_TRANSLATE_NOOP("Core", "to"),
    QT_TRANSLATE_NOOP("Core", "windmilling"),
    QT_TRANSLATE_NOOP("Core", "windmill"),
    QT_TRANSLATE_NOOP("Core", "warmer"),
    QT_TRANSLATE_NOOP("Core", "colder"),
    QT_TRANSLATE_NOOP("Core", "departure"),
    QT_TRANSLATE_NOOP("Core", "arrival"),
    QT_TRANSLATE_NOOP("Core", "east"),
    QT_TRANSLATE_NOOP("Core", "west"),
    QT_TRANSLATE_NOOP("Core", "tailwind"),
    QT_TRANSLATE_NOOP("Core", "crosswind"),
    QT_TRANSLATE_NOOP("Core", "degrees"),
    QT_TRANSLATE_NOOP("Core", "latitude"),
    QT_TRANSLATE_NOOP("Core", "longitude"),
    QT_TRANSLATE_NOOP("Core", "closed"),
    QT_TRANSLATE_NOOP("Core", "water"),
    QT_TRANSLATE_NOOP("Core", "Water."),
    QT_TRANSLATE_NOOP("Core", "Lighted."),
    QT_TRANSLATE_NOOP("Core", "a list"),
    QT_TRANSLATE_NOOP("Core", "row {}"),
    QT_TRANSLATE_NOOP("Core", "line {}"),
    QT_TRANSLATE_NOOP("Core", "{}, line {:d}"),
    QT_TRANSLATE_NOOP("Core", ", {} sea"),
    QT_TRANSLATE_NOOP("Core", "{:.0f} m wide."),
    QT_TRANSLATE_NOOP("Core", "{:g} to {:g}"),
    QT_TRANSLATE_NOOP("Core", "{:g} to {:g} {}"),
    QT_TRANSLATE_NOOP("Core", "{:d} bytes"),
    QT_TRANSLATE_NOOP("Core", "{:g} K {} than"),
    QT_TRANSLATE_NOOP("Core", "{} point {:d}"),
    QT_TRANSLATE_NOOP("Core", "aircraft {}: {}"),
    QT_TRANSLATE_NOOP("Core", " Exception: {}."),
};

/// @return the translation; nothing if there is none
QString lookUp(const QByteArray& pattern) {
  const QString translated = QCoreApplication::translate("Core", pattern.constData());
  return translated == QString::fromUtf8(pattern) ? QString() : translated;
}

bool hasLetters(const QString& text) {
  return std::any_of(text.begin(), text.end(), [](QChar c) { return c.isLetter(); });
}

/// What a text was made by, as a whole.
struct Known {
  QString translated;
  SentencePatterns::Match match;
};

std::optional<Known> known(const QString& text, bool mayHoldJoints) {
  if (const QString whole = lookUp(text.toUtf8()); !whole.isEmpty()) {
    return Known{whole, {}};
  }
  static const SentencePatterns kPatterns(corePatterns());
  const auto match = kPatterns.match(text, mayHoldJoints);
  const QString translated = match ? lookUp(match->pattern) : QString();
  return translated.isEmpty() ? std::nullopt : std::optional(Known{translated, *match});
}

/// Calls `take` with both sides of each place where two sentences may be joined, until it says that it took them.
template <typename Take>
bool splitAt(const QString& text, const char* joint, int& tried, Take take) {
  const QString between = QLatin1String(joint);
  for (qsizetype at = text.indexOf(between); at > 0 && tried < kMostJoints; at = text.indexOf(between, at + 1), ++tried) {
    if (take(text.left(at), between, text.mid(at + between.size()))) {
      return true;
    }
  }
  return false;
}

QString inWords(const QString& text, int depth);

/// A list of sentences, all of them known; empty: the text is none.
QString listInWords(const QString& text, int depth) {
  QString words;
  int tried = 0;
  splitAt(text, "; ", tried, [&](const QString& before, const QString& between, const QString& behind) {
    if (!known(before, false)) {
      return false;
    }
    const QString rest = known(behind, false) ? inWords(behind, depth) : listInWords(behind, depth);
    words = rest.isEmpty() ? QString() : inWords(before, depth) + between + rest;
    return !words.isEmpty();
  });
  return words;
}

/// A sentence that was joined of two, at the first place where one of them is known.
QString inTwoParts(const QString& text, int depth) {
  QString words = text;
  int tried = 0;
  for (const char* joint : {"; ", ": ", ". "}) {
    if (splitAt(text, joint, tried, [&](const QString& before, const QString& between, const QString& behind) {
          if (!known(before, true) && !known(behind, true)) {
            return false;
          }
          words = inWords(before, depth) + between + inWords(behind, depth);
          return true;
        })) {
      break;
    }
  }
  return words;
}

QString inWords(const QString& text, int depth) {
  if (depth == 0 || !hasLetters(text)) {
    return text;
  }
  std::optional<Known> found = known(text, false);
  if (!found) {
    if (const QString list = listInWords(text, depth - 1); !list.isEmpty()) {
      return list;
    }
    found = known(text, true);
  }
  if (!found) {
    return inTwoParts(text, depth - 1);
  }
  QStringList filled;
  for (const QString& part : found->match.filled) {
    filled << inWords(part, depth - 1);
  }
  return inWords(found->match.before, depth - 1) + filledIn(found->translated, filled) + inWords(found->match.behind, depth - 1);
}

}  // namespace

const std::vector<const char*>& corePatterns() {
  static const std::vector<const char*> kAll = [] {
    std::vector<const char*> all(kWords.begin(), kWords.end());
    for (const std::span<const char* const> sentences : {sentencesOfFormats(), sentencesOfSafety(), sentencesOfOthers()}) {
      all.insert(all.end(), sentences.begin(), sentences.end());
    }
    return all;
  }();
  return kAll;
}

QString coreText(const std::string& text) {
  const QString language = lookUp(kWords.front());  // the same sentence reads otherwise after the language was changed
  if (language.isEmpty()) {
    return QString::fromStdString(text);
  }
  thread_local QHash<QString, QString> kept;
  const QString sentence = QString::fromStdString(text);
  const QString key = language + sentence;
  if (const auto known = kept.constFind(key); known != kept.constEnd()) {
    return *known;
  }
  if (kept.size() >= kMostKept) {
    kept.clear();
  }
  return *kept.insert(key, inWords(sentence, kDeepest));
}

QString coreText(const Error& error) {
  const QString what = coreText(error.what);
  return error.where.empty() ? what : coreText(error.where) + QStringLiteral(": ") + what;
}

}  // namespace vp::style
