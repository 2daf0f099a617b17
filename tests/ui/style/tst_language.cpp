// Which language the window speaks, and that numbers are written and typed alike in all of them.
#include "ui/style/language.h"

#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QLibraryInfo>
#include <QLineEdit>
#include <QTest>

using namespace vp::style;

class TestLanguage : public QObject {
  Q_OBJECT

private slots:
  void cleanup() { useLanguage(QStringLiteral("en")); }

  void language_isThatWantedElseThatOfTheSystem_data() {
    QTest::addColumn<QString>("wanted");
    QTest::addColumn<QStringList>("system");
    QTest::addColumn<QString>("spoken");
    const auto row = [](const char* name, const char* wanted, const char* system, const char* spoken) {
      QTest::newRow(name) << QString::fromLatin1(wanted) << QString::fromLatin1(system).split(QLatin1Char(' '), Qt::SkipEmptyParts)
                          << QString::fromLatin1(spoken);
    };
    row("wanted", "cs", "de-DE de", "cs");
    row("English wanted", "en", "de-DE de", "en");
    row("the system's", "", "de-CH de", "de");
    row("first of several that is there", "", "fr-FR fr cs-CZ de", "cs");
    row("none that is there", "", "fr-FR fr", "en");
    row("nothing known of the system", "", "", "en");
    row("unknown wanted", "tlh", "de", "de");
    row("not by the first letters", "", "dede", "en");
  }
  void language_isThatWantedElseThatOfTheSystem() {
    QFETCH(QString, wanted);
    QFETCH(QStringList, system);
    QTEST(languageFor(wanted, system), "spoken");
  }

  void names_areTheirOwn() {
    QCOMPARE(languages(), (QStringList{QStringLiteral("en"), QStringLiteral("de"), QStringLiteral("cs")}));
    QCOMPARE(languageName(QStringLiteral("en")), QStringLiteral("English"));
    QCOMPARE(languageName(QStringLiteral("de")), QStringLiteral("Deutsch"));
    QCOMPARE(languageName(QStringLiteral("cs")), QStringLiteral("Čeština"));
    QCOMPARE(languageName(QStringLiteral("tlh")), QStringLiteral("tlh"));
  }

  void texts_areInTheLanguage() {
    const auto file = [] { return QCoreApplication::translate("vp::gui::MainWindow", "&File"); };
    const auto files = [](int n) { return QCoreApplication::translate("vp::gui::ExportController", "%n files written to %1", nullptr, n); };
    const auto month = [] { return languageLocale().toString(QDate(2026, 10, 3), QStringLiteral("MMMM")); };
    QCOMPARE(file(), QStringLiteral("&File"));
    useLanguage(QStringLiteral("de"));
    QCOMPARE(file(), QStringLiteral("&Datei"));
    QCOMPARE(files(1), QStringLiteral("1 Datei nach %1 geschrieben"));
    QCOMPARE(files(2), QStringLiteral("2 Dateien nach %1 geschrieben"));
    QCOMPARE(month(), QStringLiteral("Oktober"));
    useLanguage(QStringLiteral("cs"));
    QCOMPARE(file(), QStringLiteral("&Soubor"));
    QCOMPARE(files(1), QStringLiteral("1 soubor zapsán do %1"));
    QCOMPARE(files(3), QStringLiteral("3 soubory zapsány do %1"));
    QCOMPARE(files(5), QStringLiteral("5 souborů zapsáno do %1"));
    useLanguage(QStringLiteral("en"));
    QCOMPARE(file(), QStringLiteral("&File"));
    QCOMPARE(files(1), QStringLiteral("1 file written to %1"));
    QCOMPARE(files(2), QStringLiteral("2 files written to %1"));
    QCOMPARE(month(), QStringLiteral("October"));
  }

  void qtsOwnTexts_comeAlong() {
    if (!QFileInfo::exists(QLibraryInfo::path(QLibraryInfo::TranslationsPath) + QStringLiteral("/qtbase_de.qm"))) {
      QSKIP("Qt's translations are not installed");
    }
    const auto cancel = [] { return QCoreApplication::translate("QPlatformTheme", "Cancel"); };
    useLanguage(QStringLiteral("de"));
    QCOMPARE(cancel(), QStringLiteral("Abbrechen"));
    useLanguage(QStringLiteral("en"));
    QCOMPARE(cancel(), QStringLiteral("Cancel"));
  }

  void numbers_haveAPointInEveryLanguage_data() {
    QTest::addColumn<QString>("language");
    for (const QString& language : languages()) {
      QTest::newRow(qPrintable(language)) << language;
    }
  }
  void numbers_haveAPointInEveryLanguage() {
    QFETCH(QString, language);
    QLocale::setDefault(QLocale(QLocale::German));
    useLanguage(language);
    QDoubleSpinBox box;
    box.setRange(0.0, 10'000.0);
    box.setDecimals(1);
    box.setValue(1234.5);
    QCOMPARE(box.text(), QStringLiteral("1234.5"));
    auto* field = box.findChild<QLineEdit*>();
    for (const char* typed : {"7.5", "7,5"}) {  // neither may become 75
      box.setValue(0.0);
      field->selectAll();
      QTest::keyClicks(field, QLatin1String(typed));
      QCOMPARE(box.value(), 7.5);
    }
  }

  void comma_staysOneInOtherFields() {
    useLanguage(QStringLiteral("de"));
    QLineEdit field;
    QTest::keyClicks(&field, QStringLiteral("0,30,45"));
    QCOMPARE(field.text(), QStringLiteral("0,30,45"));
  }
};

QTEST_MAIN(TestLanguage)
#include "tst_language.moc"
