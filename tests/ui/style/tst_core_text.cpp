// What the core says is translated in the window. After its sentences were changed: tst_core_text --renew writes ui/style/core_sentences_*.cpp anew;
// then run packaging/translations and translate what it lists.
#include "core/emergency/landing_outcome.h"
#include "core/formats/exports/export_formats.h"
#include "tests/ui/style/core_literals.h"
#include "ui/style/core_sentences.h"
#include "ui/style/core_text.h"
#include "ui/style/language.h"
#include "ui/style/units.h"

#include <QFile>
#include <QGuiApplication>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <vector>

using namespace vp;
using namespace vp::test;

namespace {

/// One of the lists of core_sentences.h.
struct List {
  const char* file;
  const char* function;
  const char* room;
};

constexpr std::array kLists{List{"core_sentences_formats.cpp", "sentencesOfFormats", "formats"},
                            List{"core_sentences_safety.cpp", "sentencesOfSafety", "safety"},
                            List{"core_sentences_others.cpp", "sentencesOfOthers", ""}};

QString fileOf(const List& list) {
  return QStringLiteral(VOLPLANE_SOURCE_DIR "/ui/style/") + QLatin1String(list.file);
}

QByteArray textOf(const List& list) {
  QByteArray text =
      "#include \"ui/style/core_sentences.h\"\n\n#include <QObject>\n\n#include <array>\n\n// Written by tst_core_text --renew from the sources of "
      "core.\n"
      "// clang-format off\nnamespace vp::style {\nnamespace {\n\nconstexpr std::array kSentences{\n";
  for (const QString& sentence : coreSentencesIn(QLatin1String(list.room))) {
    text += "    QT_TRANSLATE_NOOP(\"Core\", \"" + sentence.toUtf8() + "\"),\n";
  }
  return text + "};\n\n}  // namespace\n\nstd::span<const char* const> " + list.function +
         "() {\n  return kSentences;\n}\n\n}  // namespace vp::style\n";
}

int renew() {
  for (const List& list : kLists) {
    QFile file(fileOf(list));
    const QByteArray text = textOf(list);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size()) {
      std::fprintf(stderr, "%s NOT WRITTEN\n", qPrintable(file.fileName()));
      return 1;
    }
    std::printf("%s written\n", qPrintable(file.fileName()));
  }
  return 0;
}

/// A sentence as the core makes it by a pattern: figures where it has figures (or anywhere), names where it has names.
QString sample(const char* pattern, bool isAllFigures = false) {
  static const QRegularExpression placeholder(QStringLiteral(R"(\{([^{}]*)\})"));
  QString text = QString::fromUtf8(pattern);
  text.replace(QStringLiteral("{{"), QStringLiteral("\x01")).replace(QStringLiteral("}}"), QStringLiteral("\x02"));
  int number = 100;
  for (auto match = placeholder.match(text); match.hasMatch(); match = placeholder.match(text)) {
    const QString format = match.captured(1);
    const bool isNumber = isAllFigures || format.contains(QLatin1Char(':'));
    ++number;
    text.replace(match.capturedStart(), match.capturedLength(),
                 isNumber ? (format.contains(QLatin1Char(':')) ? QStringLiteral("%1.5") : QStringLiteral(" %1.5")).arg(number)
                          : QStringLiteral("Q%1").arg(number));
  }
  return text.replace(QLatin1Char('\x01'), QLatin1Char('{')).replace(QLatin1Char('\x02'), QLatin1Char('}'));
}

/// Figures of a text with what follows them, sorted: "101.5 ft".
QStringList lengthsIn(const QString& text) {
  static const QRegularExpression length(QStringLiteral(R"([\d.,\x{2009}]*\d (?:ft|NM|km|m)(?![\w/²³]))"),
                                         QRegularExpression::UseUnicodePropertiesOption);
  QStringList found;
  for (auto it = length.globalMatch(text); it.hasNext();) {
    found << it.next().captured();
  }
  std::sort(found.begin(), found.end());
  return found;
}

void languages() {
  QTest::addColumn<QString>("language");
  QTest::newRow("German") << QStringLiteral("de");
  QTest::newRow("Czech") << QStringLiteral("cs");
}

}  // namespace

class TestCoreText : public QObject {
  Q_OBJECT

private slots:
  void cleanup() { style::useLanguage(QStringLiteral("en")); }

  void lists_haveWhatTheCoreSays() {
    QVERIFY(style::corePatterns().size() > 800);
    for (const List& list : kLists) {
      QFile file(fileOf(list));
      QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
      QVERIFY2(file.readAll() == textOf(list), "run tst_core_text --renew, then packaging/translations");
    }
  }

  void literals_areFoundInSources() {
    const QString source = QStringLiteral(
        "#include \"a b\"\n// \"no comment\"\nf(\"one \"\n  \"two {}\", 'c', '\"', 1'000, R\"(raw text)\");\nVP_EXPECT(x, \"for (programmers) "
        "only\");\n"
        "g(\"\\\"{}\\\" is no name\");");
    QCOMPARE(literalsOf(source), (QStringList{QStringLiteral("one two {}"), QStringLiteral("\\\"{}\\\" is no name")}));
    QVERIFY(isWords(QStringLiteral("no name")));
    QVERIFY(!isWords(QStringLiteral("name {}")));
    QVERIFY(!isWords(QStringLiteral("<Placemark> {} of it")));
  }

  void eachPattern_isFoundAgainInItsSentence_data() { languages(); }
  void eachPattern_isFoundAgainInItsSentence() {
    QFETCH(QString, language);
    style::useLanguage(language);
    static const QRegularExpression kept(QStringLiteral(R"(Q\d+|\d+\.5)"));
    QStringList faults;
    const auto filled = [](const QString& text) {
      QStringList parts;
      for (auto it = kept.globalMatch(text); it.hasNext();) {
        parts << it.next().captured();
      }
      std::sort(parts.begin(), parts.end());
      parts.removeDuplicates();
      return parts;
    };
    for (const char* pattern : style::corePatterns()) {
      const QString english = sample(pattern);
      const QString translated = style::coreText(english.toStdString());
      if (translated == english) {
        faults << QStringLiteral("not translated: %1").arg(english);
      } else if (filled(translated) != filled(english)) {
        faults << QStringLiteral("filled in otherwise: %1 -> %2").arg(english, translated);
      }
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
  }

  /// "between 300 and 400 m" has two lengths in any language.
  void lengths_areInTheUnitsOfTheWindow_data() { languages(); }
  void lengths_areInTheUnitsOfTheWindow() {
    QFETCH(QString, language);
    const style::Units feet(style::UnitSystem::Aviation);
    std::vector<QStringList> wanted;
    for (const char* pattern : style::corePatterns()) {
      wanted.push_back(lengthsIn(feet.inSentence(sample(pattern, true).toStdString())));
    }
    style::useLanguage(language);
    QStringList faults;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (const QString shown = feet.inSentence(sample(style::corePatterns()[i], true).toStdString()); lengthsIn(shown) != wanted[i]) {
        faults
            << QStringLiteral("lengths %1 instead of %2: %3").arg(lengthsIn(shown).join(QLatin1Char('|')), wanted[i].join(QLatin1Char('|')), shown);
      }
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
  }

  void exportFormats_areTranslated_data() { languages(); }
  void exportFormats_areTranslated() {
    QFETCH(QString, language);
    style::useLanguage(language);
    QVERIFY(formats::exportFormats().size() >= 15);
    for (const formats::ExportFormat& format : formats::exportFormats()) {
      QVERIFY2(style::coreText(format.what) != QString::fromStdString(format.what), format.what.c_str());
      QVERIFY2(format.loses.empty() || style::coreText(format.loses) != QString::fromStdString(format.loses), format.loses.c_str());
    }
  }

  void termsOfLandings_areTranslated() {
    style::useLanguage(QStringLiteral("de"));
    for (const char* term : {emergency::kDistance, emergency::kHowFar, emergency::kWeatherSuccess}) {
      QVERIFY2(style::coreText(term) != QString::fromUtf8(term), term);
    }
  }

  void errors_keepPlaceAndName() {
    style::useLanguage(QStringLiteral("de"));
    const Error error{Errc::BadFormat, "\"name\" is missing; add it", "Höhe.vpm, line 3, column 4 (/targets/0)"};
    const QString text = style::coreText(error);
    QVERIFY2(text.startsWith(QStringLiteral("Höhe.vpm, Zeile 3, Spalte 4 (/targets/0): ")), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("name")) && !text.contains(QStringLiteral("missing")), qPrintable(text));
  }

  void lists_areTranslatedPieceByPiece() {
    style::useLanguage(QStringLiteral("de"));
    const QString text = style::coreText(
        "landing site LSPG/21 is approximate: heading derived from the runway number and the magnetic variation of 3 degrees east; runway ends "
        "derived "
        "from the airport's position, length and heading; elevation of the airport, not of the threshold");
    QCOMPARE(text.count(QStringLiteral("; ")), 2);
    QVERIFY2(text.contains(QStringLiteral("(3 Grad Ost); Pistenenden")), qPrintable(text));
    for (const char* english : {"derived", "airport", "threshold", "heading", "east"}) {
      QVERIFY2(!text.contains(QLatin1String(english)), qPrintable(text));
    }
  }

  void sentenceInASentence_isTranslated() {
    style::useLanguage(QStringLiteral("de"));
    const QString text = style::coreText("/flights/a.json: there is no such file; check the name and the folder it is relative to");
    QVERIFY2(text.startsWith(QStringLiteral("/flights/a.json: ")) && !text.contains(QStringLiteral("check")), qPrintable(text));
  }

  void hostileText_endsSoon() {
    style::useLanguage(QStringLiteral("de"));
    std::string text;
    for (int i = 0; i < 500; ++i) {
      text += "a: b; c. no name ";
    }
    QVERIFY(!style::coreText(text).isEmpty());
  }

  void otherTexts_stayAsTheyAre() {
    style::useLanguage(QStringLiteral("de"));
    QCOMPARE(style::coreText("Zzz(Höhe.tif)"), QStringLiteral("Zzz(Höhe.tif)"));
    QCOMPARE(style::coreText(""), QString());
    style::useLanguage(QStringLiteral("en"));
    QCOMPARE(style::coreText(emergency::kDistance), QStringLiteral("distance"));
    QCOMPARE(style::coreText("target 3: no point of the tour visits it"), QStringLiteral("target 3: no point of the tour visits it"));
  }
};

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--renew") == 0) {
    return renew();
  }
  QGuiApplication application(argc, argv);
  TestCoreText test;
  return QTest::qExec(&test, argc, argv);
}

#include "tst_core_text.moc"
