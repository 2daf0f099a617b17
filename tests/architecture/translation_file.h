#pragma once

#include <QString>
#include <QStringList>
#include <QVector>

namespace vp::test {

/** One text of a translation file (.ts), and what is made of it. */
struct TranslatedText {
  QString context;
  QString source;
  QString comment;
  QStringList forms;  ///< one for each plural of the language; a single one where nothing is counted
  bool isCounted = false;
  bool isFinished = false;

  [[nodiscard]] QString name() const { return context + QStringLiteral(": ") + source; }
};

/** All texts of a file in its order; empty if it cannot be read. */
QVector<TranslatedText> readTranslations(const QString& path);

/** What is wrong with a translation, a sentence each: unfinished or empty, the wrong number of plurals, other placeholders, other spaces
 *  at the ends, other lines, a mnemonic or an ellipsis lost or added, other patterns of file names.
 *  @param plurals  that the language has: 2 in English and German, 3 in Czech */
QStringList faultsOf(const TranslatedText& text, int plurals);

}  // namespace vp::test
