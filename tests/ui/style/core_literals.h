#pragma once

#include <QString>
#include <QStringList>

namespace vp::test {

/** The string literals of a C++ source as they stand there, escapes and all; neighbours are one. Comments, included files and what VP_ macros and
 *  static_assert say, which is for programmers, are left out. */
QStringList literalsOf(const QString& source);

/** Whether a literal is words: two or more of two letters besides placeholders, and no format of a file. */
bool isWords(const QString& literal);

/** The literals of a room of core, "formats" or "safety", or of all others (empty) that people read in the window, in the order of files and places;
 *  each once, where it comes first. */
QStringList coreSentencesIn(const QString& room);

}  // namespace vp::test
