// The window's words for the wind are those of the command line, until they are translated.
#include "core/formats/wind_text.h"
#include "tests/support/comma_locale.h"
#include "ui/document/wind_words.h"
#include "ui/style/language.h"

#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <cstdio>
#include <random>

using namespace vp;

namespace {

constexpr unsigned kSeed = 20260601;
constexpr int kCases = 10'000;
constexpr double kKnot = 1852.0 / 3600.0;  // m/s

std::vector<air::WindLayer> someWind(std::mt19937& random) {
  const auto number = [&random](double least, double most) { return std::uniform_real_distribution(least, most)(random); };
  const auto oneOf = [&random](int count) { return std::uniform_int_distribution(0, count - 1)(random); };
  std::vector<air::WindLayer> layers;
  for (int i = 0, count = oneOf(4); i < count; ++i) {
    air::WindSector wind;
    if (oneOf(5) > 0) {
      wind.from_deg = oneOf(2) == 0 ? oneOf(361) : number(0.0, 360.0);
      wind.spread_deg = oneOf(3) == 0 ? 0.0 : oneOf(4) == 0 ? 180.0 : number(0.0, 90.0);
      wind.leastSpeed = number(0.0, 20.0);
      wind.mostSpeed = oneOf(3) == 0 ? wind.leastSpeed : wind.leastSpeed + number(0.0, 10.0);
    }
    layers.push_back({geo::HeightMsl::fromMetres(1000.0 * i + number(0.0, 900.0)), wind});
  }
  return layers;
}

}  // namespace

class TestWindWords : public QObject {
  Q_OBJECT

private slots:
  void cleanup() { style::useLanguage(QStringLiteral("en")); }

  void english_isThatOfTheCore_data() {
    QTest::addColumn<int>("units");
    QTest::newRow("aviation") << static_cast<int>(style::UnitSystem::Aviation);
    QTest::newRow("metric") << static_cast<int>(style::UnitSystem::Metric);
  }
  void english_isThatOfTheCore() {
    QFETCH(int, units);
    const style::Units shown(static_cast<style::UnitSystem>(units));
    std::mt19937 random(kSeed);
    std::printf("seed %u\n", kSeed);
    for (int i = 0; i < kCases; ++i) {
      const std::vector<air::WindLayer> winds = someWind(random);
      QCOMPARE(document::airPhrase(winds, shown), QString::fromStdString(formats::airPhrase(winds, document::windUnits(shown))));
      QStringList lines;
      for (const std::string& line : formats::windWords(winds, document::windUnits(shown))) {
        lines << QString::fromStdString(line);
      }
      QCOMPARE(document::windLines(winds, shown), lines);
    }
  }

  // The text lost its unit where the locale has a decimal comma: "270/4.37277777777777764mps" instead of "270/8.5kt".
  void text_isTheSameUnderACommaLocale() {
    const QTemporaryDir folder;
    const QString problem = test::makeCommaLocale(folder.path());
    QVERIFY2(problem.isEmpty(), qPrintable(problem));
    const std::vector<air::WindLayer> winds = formats::parseWind("270/8.5kt")->layers;
    const std::string before = std::setlocale(LC_ALL, nullptr);
    qputenv("LOCPATH", folder.path().toLocal8Bit());
    QVERIFY(std::setlocale(LC_ALL, "de_DE.UTF-8") != nullptr);
    QCOMPARE(std::localeconv()->decimal_point, ",");  // else this test would compare nothing
    const std::string text = formats::windText(winds);
    std::setlocale(LC_ALL, before.c_str());
    QCOMPARE(text, std::string("270/8.5kt"));
  }

  void translation_hasTheSameFigures() {
    const std::vector<air::WindLayer> winds{{geo::HeightMsl(), {270.0, 20.0, 10.0 * kKnot, 20.0 * kKnot}}};
    const style::Units units(style::UnitSystem::Aviation);
    QCOMPARE(document::airPhrase(winds, units), QStringLiteral("every wind of 10 to 20 kt from 250 to 290 degrees true"));
    style::useLanguage(QStringLiteral("de"));
    QCOMPARE(document::airPhrase(winds, units), QStringLiteral("jedem Wind von 10 bis 20 kt aus 250 bis 290 Grad rechtweisend"));
    QCOMPARE(document::airPhrase({}, units), QStringLiteral("Windstille"));
    style::useLanguage(QStringLiteral("cs"));
    QCOMPARE(document::airPhrase(winds, units), QStringLiteral("každého větru 10 až 20 kt ze směru 250 až 290 stupňů zeměpisně"));
  }
};

QTEST_GUILESS_MAIN(TestWindWords)
#include "tst_wind_words.moc"
