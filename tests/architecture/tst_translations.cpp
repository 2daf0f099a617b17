// Every text of the interface is translated, and the translations keep what the program fills in or reads: placeholders, mnemonics, line ends.
#include "tests/architecture/translation_file.h"

#include <QDirIterator>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTemporaryDir>
#include <QTest>

using namespace vp::test;

namespace {

QString fileOf(const QString& language) {
  return QStringLiteral(VOLPLANE_SOURCE_DIR "/resources/translations/volplane_%1.ts").arg(language);
}

QSet<QString> namesOf(const QVector<TranslatedText>& texts) {
  QSet<QString> names;
  for (const TranslatedText& text : texts) {
    names << text.name() + QStringLiteral(" / ") + text.comment;
  }
  return names;
}

void addLanguages() {
  QTest::addColumn<QString>("language");
  QTest::addColumn<int>("plurals");
  QTest::newRow("English: what is counted") << QStringLiteral("en") << 2;
  QTest::newRow("German") << QStringLiteral("de") << 2;
  QTest::newRow("Czech") << QStringLiteral("cs") << 3;
}

}  // namespace

class TestTranslations : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    QProcess script;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("LUPDATE"), QStringLiteral(VOLPLANE_LUPDATE));
    script.setProcessEnvironment(environment);
    script.setProcessChannelMode(QProcess::MergedChannels);
    script.start(QStringLiteral("bash"), {QStringLiteral(VOLPLANE_SOURCE_DIR "/packaging/translations"), QStringLiteral("--check"), folder_.path()});
    QVERIFY(script.waitForFinished(120'000));
    output_ = script.readAll();
    QVERIFY2(script.exitCode() == 0, output_.constData());
  }

  void sources_areAllInTheFiles_data() { addLanguages(); }
  void sources_areAllInTheFiles() {
    QFETCH(QString, language);
    const QSet<QString> inSources = namesOf(readTranslations(folder_.filePath(QStringLiteral("volplane_%1.ts").arg(language))));
    const QSet<QString> inFile = namesOf(readTranslations(fileOf(language)));
    QVERIFY(inSources.size() >= (language == QStringLiteral("en") ? 10 : 1400));
    QVERIFY2(inSources == inFile, qPrintable(QStringLiteral("run packaging/translations; missing: %1; no longer there: %2")
                                                 .arg(QStringList((inSources - inFile).values()).join(QStringLiteral(" | ")),
                                                      QStringList((inFile - inSources).values()).join(QStringLiteral(" | ")))));
    QVERIFY2(!output_.contains("Q_OBJECT"), output_.constData());  // such a class looks its texts up under another name
  }

  void translations_areComplete_data() { addLanguages(); }
  void translations_areComplete() {
    QFETCH(QString, language);
    QFETCH(int, plurals);
    QStringList faults;
    for (const TranslatedText& text : readTranslations(fileOf(language))) {
      faults << faultsOf(text, plurals);
    }
    QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QLatin1Char('\n'))));
  }

  /// A helper that hands a variable on to translate() hides its callers' texts from lupdate; Q_DECLARE_TR_FUNCTIONS does not.
  void texts_areNotHiddenFromTheCollector() {
    const QRegularExpression helper(QStringLiteral(R"(\(const char\* ?(\w+)\)\s*\{\s*return QCoreApplication::translate\("[\w:]+", \1\))"));
    QVERIFY(
        helper.match(QStringLiteral("QString text(const char* source) {\n  return QCoreApplication::translate(\"Profile\", source);\n}")).hasMatch());
    int files = 0;
    for (const char* folder : {"/ui", "/app"}) {
      QDirIterator it(QStringLiteral(VOLPLANE_SOURCE_DIR) + QLatin1String(folder), {QStringLiteral("*.cpp"), QStringLiteral("*.h")}, QDir::Files,
                      QDirIterator::Subdirectories);
      while (it.hasNext()) {
        QFile file(it.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(!helper.match(QString::fromUtf8(file.readAll())).hasMatch(), qPrintable(file.fileName()));
        ++files;
      }
    }
    QVERIFY(files > 300);
  }

  void faults_areFound_data() {
    QTest::addColumn<QString>("source");
    QTest::addColumn<QString>("translation");
    QTest::addColumn<QString>("fault");
    const auto row = [](const char* name, const char* source, const char* translation, const char* fault) {
      QTest::newRow(name) << QString::fromUtf8(source) << QString::fromUtf8(translation) << QString::fromUtf8(fault);
    };
    row("none", "&Save %1 as %2…", "%2 als %1 &sichern…", "");
    row("empty", "Save", "", "no translation");
    row("placeholder lost", "%1 of %2", "%1 von", "placeholders");
    row("placeholder twice", "%1 of %2", "%1 von %1", "placeholders");
    row("mnemonic lost", "&File", "Datei", "mnemonics");
    row("mnemonic added", "File", "&Datei", "mnemonics");
    row("ellipsis lost", "Open…", "Öffnen", "ellipsis");
    row("space lost", " km", "km", "outer spaces");
    row("line lost", "Height\n%1", "Höhe %1", "line ends");
    row("tag lost", "<b>Volplane</b>", "Volplane", "tags");
    row("pattern changed", "Missions (*.vpm)", "Missionen (*.vpp)", "file patterns");
    row("name in braces translated", "{mission} is replaced", "{Mission} wird ersetzt", "placeholders");
  }
  void faults_areFound() {
    QFETCH(QString, source);
    QFETCH(QString, translation);
    QFETCH(QString, fault);
    const QStringList faults = faultsOf({QStringLiteral("Test"), source, {}, {translation}, false, true}, 2);
    QCOMPARE(faults.size(), fault.isEmpty() ? 0 : 1);
    QVERIFY2(fault.isEmpty() || faults.front().contains(fault), qPrintable(faults.join(QLatin1Char('\n'))));
  }

  void patternOfTheCore_hasNumbersForItsPlaceholders() {
    const auto faults = [](const char* form) {
      return faultsOf({QStringLiteral("Core"), QStringLiteral("{} of {:.0f} in {{braces}}"), {}, {QString::fromUtf8(form)}, false, true}, 2).size();
    };
    QCOMPARE(faults("von %2 sind es %1 in {Klammern}"), 0);
    QCOMPARE(faults("%1 von %2, also %1"), 0);
    QCOMPARE(faults("%1 von allen"), 1);
    QCOMPARE(faults("{} von %2"), 1);
  }

  void countedText_needsAllPlurals() {
    const auto faults = [](const QStringList& forms, bool isFinished) {
      return faultsOf({QStringLiteral("Test"), QStringLiteral("%n files"), {}, forms, true, isFinished}, 3);
    };
    const QString form = QStringLiteral("%n");
    QVERIFY(faults({form, form, form}, true).isEmpty());
    QCOMPARE(faults({form, form}, true).size(), 1);
    QCOMPARE(faults({form, form, QString()}, true).size(), 1);
    QCOMPARE(faults({form, form, form}, false).size(), 1);
  }

private:
  QTemporaryDir folder_;
  QByteArray output_;
};

QTEST_GUILESS_MAIN(TestTranslations)
#include "tst_translations.moc"
