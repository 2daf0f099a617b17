// What the core says in fixed words is translated in the window: lists in ui/style/core_text.cpp fall behind the core otherwise.
#include "core/emergency/landing_outcome.h"
#include "core/formats/exports/export_formats.h"
#include "ui/style/core_text.h"
#include "ui/style/language.h"

#include <QTest>

using namespace vp;

class TestCoreText : public QObject {
  Q_OBJECT

private slots:
  void cleanup() { style::useLanguage(QStringLiteral("en")); }

  void exportFormats_areTranslated_data() {
    QTest::addColumn<QString>("language");
    QTest::newRow("German") << QStringLiteral("de");
    QTest::newRow("Czech") << QStringLiteral("cs");
  }
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

  void otherTexts_stayAsTheyAre() {
    style::useLanguage(QStringLiteral("de"));
    QCOMPARE(style::coreText("the terrain file ends early (Höhe.tif)"), QStringLiteral("the terrain file ends early (Höhe.tif)"));
    QCOMPARE(style::coreText(""), QString());
    style::useLanguage(QStringLiteral("en"));
    QCOMPARE(style::coreText(emergency::kDistance), QStringLiteral("distance"));
  }
};

QTEST_GUILESS_MAIN(TestCoreText)
#include "tst_core_text.moc"
