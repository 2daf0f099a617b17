#include "tests/ui/style/core_literals.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <array>

namespace vp::test {
namespace {

/// What is read on the command line alone or stands in files: solvers and their files, exports, reports of the second opinion.
constexpr std::array kNotInTheWindow{"core/tour/gtsp", "core/tour/lkh", "core/formats/exports/", "core/audit/"};
constexpr auto kButFormats = "core/formats/exports/export_formats.cpp";

const QStringList kRooms{QStringLiteral("formats"), QStringLiteral("safety")};

/// Words for programs.
const QSet<QString>& notForPeople() {
  static const QSet<QString> kTexts{
      // counts of planners, which `land --json` writes
      QStringLiteral("runways in range"),
      QStringLiteral("direct glides"),
      QStringLiteral("glides tried against the ground"),
      QStringLiteral("paths judged by the checker"),
      QStringLiteral("leaves of free space"),
      QStringLiteral("samples reached"),
      QStringLiteral("legs tried against the ground"),
      QStringLiteral("ways made flyable"),
      QStringLiteral("Dubins ways"),
      QStringLiteral("states expanded"),
      QStringLiteral("states known"),
      QStringLiteral("states connected to the goal"),
      QStringLiteral("poses of the roadmap"),
      QStringLiteral("vertices of roadmaps"),
      QStringLiteral("edges evaluated"),
      QStringLiteral("ways flown"),
      // what stands in files
      QStringLiteral("HTTP error code : "),
      QStringLiteral("Range: bytes={}-{}"),
      QStringLiteral("Copernicus GLO-30 surface model, heights above EGM2008 in metres, posts copied and not resampled"),
      QStringLiteral("(c) DLR e.V. 2010-2014 and (c) Airbus Defence and Space GmbH 2014-2018 provided under COPERNICUS by the European Union and "
                     "ESA; all rights reserved"),
      QStringLiteral("no such tile on the server, so sea: zero everywhere"),
      QStringLiteral("not published: nothing is known here"),
      QStringLiteral("runway direction"),
      QStringLiteral("-----Related Tasks"),
      QStringLiteral("the area has no extent"),
      QStringLiteral("ESRI Shapefile"),
      QStringLiteral("international foot"),
      QStringLiteral("ft (international)"),
      QStringLiteral("us survey foot"),
      QStringLiteral("Lowest safe altitude on any course, m MSL"),
      QStringLiteral("Lowest safe altitude on the best course, m MSL"),
      QStringLiteral("Lowest safe altitude on true course {:05.1f} and {:.2f} degrees to each side, m MSL"),
      QStringLiteral("straight for the last {:g} m"),
      QStringLiteral("a full circle down from above the touchdown point"),
      QStringLiteral("at the touchdown point, by any curve"),
      QStringLiteral("metres above mean sea level, the datum of the terrain"),
      QStringLiteral("upper bound: from every place in the cell, on every course of the band, at this altitude or above, engine off and in {}, a "
                     "glide reaches a landing site with the clearance; no data where there is none or the ground is unknown"),
      QStringLiteral("lowest safe altitude"),
      QStringLiteral("Lowest safe altitude"),
      QStringLiteral(": lowest safe altitude"),
      QStringLiteral("Local frame of the mission"),
  };
  return kTexts;
}

/// @return the place behind a literal that begins at `at` with its quote
qsizetype endOfQuoted(const QString& source, qsizetype at) {
  const QChar quote = source[at];
  for (++at; at < source.size() && source[at] != quote; ++at) {
    at += source[at] == QLatin1Char('\\') ? 1 : 0;
  }
  return at + 1;
}

/// @return the place behind the brackets that open at `at`
qsizetype endOfBrackets(const QString& source, qsizetype at) {
  int depth = 0;
  while (at < source.size()) {
    const QChar c = source[at];
    if (c == QLatin1Char('"') || c == QLatin1Char('\'')) {
      at = endOfQuoted(source, at);
      continue;
    }
    depth += c == QLatin1Char('(') ? 1 : c == QLatin1Char(')') ? -1 : 0;
    ++at;
    if (depth == 0) {
      break;
    }
  }
  return at;
}

qsizetype endOfLine(const QString& source, qsizetype at) {
  const qsizetype end = source.indexOf(QLatin1Char('\n'), at);
  return end < 0 ? source.size() : end;
}

/// @return the place behind what says nothing to people (comments, directives, characters, raw strings, checks); `at` if there is none
qsizetype endOfSilent(const QString& source, qsizetype at) {
  static const QRegularExpression checks(QStringLiteral(R"(VP_[A-Z_]+\(|static_assert\()"));
  const QStringView rest = QStringView(source).mid(at);
  const QChar before = at > 0 ? source[at - 1] : QLatin1Char('\n');
  if (rest.startsWith(QStringLiteral("//")) || rest.front() == QLatin1Char('#')) {
    return endOfLine(source, at);
  }
  if (rest.startsWith(QStringLiteral("/*"))) {
    return source.indexOf(QStringLiteral("*/"), at) + 2;
  }
  if (rest.front() == QLatin1Char('\'')) {
    return before.isDigit() ? at + 1 : endOfQuoted(source, at);  // 10'000
  }
  if (rest.startsWith(QStringLiteral("R\""))) {
    const QString mark = source.mid(at + 2, source.indexOf(QLatin1Char('('), at) - at - 2);
    return source.indexOf(QLatin1Char(')') + mark + QLatin1Char('"'), at) + mark.size() + 2;
  }
  const QRegularExpressionMatch check = checks.match(source, at, QRegularExpression::NormalMatch, QRegularExpression::AnchorAtOffsetMatchOption);
  return check.hasMatch() ? endOfBrackets(source, check.capturedEnd() - 1) : at;
}

}  // namespace

QStringList literalsOf(const QString& source) {
  QStringList literals;
  bool isOpen = false;  // only spaces since the last literal
  for (qsizetype at = 0; at < source.size();) {
    if (source[at].isSpace()) {
      ++at;
    } else if (source[at] == QLatin1Char('"')) {
      const qsizetype end = endOfQuoted(source, at);
      const QString text = source.mid(at + 1, end - at - 2);
      isOpen ? void(literals.back() += text) : literals.append(text);
      isOpen = true;
      at = end;
    } else {
      const qsizetype end = endOfSilent(source, at);
      isOpen = false;
      at = std::max(end, at + 1);
    }
  }
  return literals;
}

bool isWords(const QString& literal) {
  static const QRegularExpression placeholder(QStringLiteral(R"(\{[^{}]*\})"));
  static const QRegularExpression word(QStringLiteral("[A-Za-z]{2,}"));
  for (const char* sign : {"\\n", "+proj", "<"}) {
    if (literal.contains(QLatin1String(sign))) {
      return false;
    }
  }
  QString plain = literal;
  plain.remove(placeholder);
  int words = 0;
  for (auto it = word.globalMatch(plain); it.hasNext(); it.next()) {
    ++words;
  }
  return words >= 2 && plain.trimmed().contains(QLatin1Char(' '));
}

QStringList coreSentencesIn(const QString& room) {
  QStringList files;
  for (QDirIterator it(QStringLiteral(VOLPLANE_SOURCE_DIR "/core"), {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                       QDirIterator::Subdirectories);
       it.hasNext();) {
    const QString file = it.next().mid(static_cast<qsizetype>(sizeof(VOLPLANE_SOURCE_DIR)));
    const auto isPart = [&](const char* start) { return file.startsWith(QLatin1String(start)); };
    if (file == QLatin1String(kButFormats) || std::none_of(kNotInTheWindow.begin(), kNotInTheWindow.end(), isPart)) {
      files << file;
    }
  }
  files.sort();
  QStringList sentences;
  QSet<QString> known = notForPeople();
  for (const QString& name : files) {
    const QString itsRoom = name.section(QLatin1Char('/'), 1, 1);
    QFile file(QStringLiteral(VOLPLANE_SOURCE_DIR "/") + name);
    if (!file.open(QIODevice::ReadOnly)) {
      return {};
    }
    for (const QString& literal : literalsOf(QString::fromUtf8(file.readAll()))) {
      if (isWords(literal) && !known.contains(literal)) {
        known << literal;
        if ((kRooms.contains(itsRoom) ? itsRoom : QString()) == room) {
          sentences << literal;
        }
      }
    }
  }
  return sentences;
}

}  // namespace vp::test
