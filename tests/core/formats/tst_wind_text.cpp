// Wind as pilots and weather services write it, and the way back.
#include "core/aircraft/wind_check.h"
#include "core/formats/wind_text.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace vp;
using namespace vp::formats;

namespace {

using Layers = std::vector<air::WindLayer>;

Layers everywhere(double from, double spread, double least, double most, double unit = kMpsPerKnot) {
  return {{geo::HeightMsl(), {from, spread, least * unit, most * unit}}};
}

air::WindLayer atFeet(double feet, double from, double knots) {
  return {geo::HeightMsl::fromMetres(feet * kMetresPerFoot), {from, 0.0, knots * kMpsPerKnot, knots * kMpsPerKnot}};
}

bool isNear(const Layers& a, const Layers& b) {
  const auto near = [](double x, double y) { return std::abs(x - y) <= 1e-12 * std::max(1.0, std::abs(y)); };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const air::WindLayer& one, const air::WindLayer& other) {
    return near(one.altitude.metres(), other.altitude.metres()) && near(one.wind.from_deg, other.wind.from_deg) &&
           near(one.wind.spread_deg, other.wind.spread_deg) && near(one.wind.leastSpeed, other.wind.leastSpeed) &&
           near(one.wind.mostSpeed, other.wind.mostSpeed);
  });
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += line + "\n";
  }
  return text;
}

/// On one line.
std::string rowName(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '|');
  return text;
}

const std::string kAloft =
    "DATA BASED ON 010000Z\nVALID 010600Z FOR USE 0500-0900Z. TEMPS NEG ABV 24000\n\n"
    "FT  3000    6000    9000   12000   18000   24000  30000  34000  39000\n";

}  // namespace

Q_DECLARE_METATYPE(Layers)

class TestWindText : public QObject {
  Q_OBJECT

private slots:
  void oneWind_isReadInEveryNotation_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<Layers>("expected");
    const auto row = [](const char* text, const Layers& expected) { QTest::newRow(text) << QString::fromUtf8(text) << expected; };
    for (const char* text :
         {"270/15kt", "270/15", "27015KT", "27015kt", "  270/15 KT ", "270/15kts", "27015", "270.0/15.0kn", "270\u00B0/15kt", "270 / 15 kt"}) {
      row(text, everywhere(270.0, 0.0, 15.0, 15.0));
    }
    row("007/15kt", everywhere(7.0, 0.0, 15.0, 15.0));
    row("000/15kt", everywhere(0.0, 0.0, 15.0, 15.0));
    row("36015KT", everywhere(360.0, 0.0, 15.0, 15.0));
    row("270/8mps", everywhere(270.0, 0.0, 8.0, 8.0, 1.0));
    row("270/8 m/s", everywhere(270.0, 0.0, 8.0, 8.0, 1.0));
    row("27008MPS", everywhere(270.0, 0.0, 8.0, 8.0, 1.0));
    row("270/36km/h", everywhere(270.0, 0.0, 10.0, 10.0, 1.0));
    row("27036KMH", everywhere(270.0, 0.0, 10.0, 10.0, 1.0));
    row("270120KT", everywhere(270.0, 0.0, 120.0, 120.0));
    row("27015G25KT", everywhere(270.0, 0.0, 15.0, 25.0));
    row("270/15g25kt", everywhere(270.0, 0.0, 15.0, 25.0));
    row("270/10-20kt", everywhere(270.0, 0.0, 10.0, 20.0));
    for (const char* text :
         {"270+-20/15+-5kt", "270\u00B120/15\u00B15kt", "270+/-20/15+/-5", "270 \u00B1 20 / 15 \u00B1 5 kt", "270\u00B120\u00B0/10-20kt"}) {
      row(text, everywhere(270.0, 20.0, 10.0, 20.0));
    }
    row("VRB05KT", everywhere(0.0, 180.0, 0.0, 5.0));
    row("vrb05g15kt", everywhere(0.0, 180.0, 0.0, 15.0));
    row("VRB/5kt", everywhere(0.0, 180.0, 0.0, 5.0));
    row("VRB/3-5kt", everywhere(0.0, 180.0, 3.0, 5.0));
    row("calm", {});
    row("00000KT", {});
    row("00000MPS", {});
    row("27015KT 240V300", everywhere(270.0, 30.0, 15.0, 15.0));
    row("25015KT 240V310", everywhere(275.0, 35.0, 15.0, 15.0));  // the range need not lie evenly about the mean
    row("35010KT 320V040", everywhere(0.0, 40.0, 10.0, 10.0));
    row("36010KT 360V050", everywhere(25.0, 25.0, 10.0, 10.0));
    row("VRB05KT 240V300", everywhere(0.0, 180.0, 0.0, 5.0));
    row("270/200kt", everywhere(270.0, 0.0, 200.0, 200.0));
  }
  void oneWind_isReadInEveryNotation() {
    QFETCH(QString, text);
    QFETCH(Layers, expected);
    const auto read = parseWind(text.toStdString());
    QVERIFY2(read, read ? "" : read.error().message().c_str());
    QVERIFY2(isNear(read->layers, expected), windText(read->layers).c_str());
    QVERIFY2(read->notes.empty(), joined(read->notes).c_str());
  }

  void layers_areReadFromTheLowestUp() {
    const Layers two{atFeet(0.0, 270.0, 15.0), atFeet(5000.0, 290.0, 25.0)};
    for (const char* text : {"0ft 270/15kt; 5000ft 290/25kt", "0ft 27015KT\n5000ft 29025KT\n", "0 270/15; 5000 29025",
                             "0 ft: 270/15 ;; 5000 feet msl 290/25kt;", "0m 270/15kt; 1524 m 290/25kt"}) {
      const auto read = parseWind(text);
      QVERIFY2(read, read ? "" : read.error().message().c_str());
      QVERIFY2(isNear(read->layers, two), (std::string(text) + ": " + windText(read->layers)).c_str());
    }
    QVERIFY(isNear(parseWind("3000 27015 ; 6000 29025")->layers, {atFeet(3000.0, 270.0, 15.0), atFeet(6000.0, 290.0, 25.0)}));
    QVERIFY(isNear(parseWind("5000ft 290/25kt")->layers, {atFeet(5000.0, 290.0, 25.0)}));
    QVERIFY(isNear(parseWind("0ft calm; 5000ft VRB03KT")->layers,
                   {atFeet(0.0, 0.0, 0.0), {geo::HeightMsl::fromMetres(1524.0), {0.0, 180.0, 0.0, 3.0 * kMpsPerKnot}}}));
    const auto level = parseWind("-100ft 270/5kt; FL095 290/25kt");
    QVERIFY(level && isNear(level->layers, {atFeet(-100.0, 270.0, 5.0), atFeet(9500.0, 290.0, 25.0)}));
    VP_CONTAINS(joined(level->notes), {"flight levels are taken as heights"});
  }

  void weatherReport_givesItsWindAndSaysWhatItIgnores() {
    const auto metar = parseWind("METAR LSZH 121250Z AUTO 27015G25KT 240V300 9999 FEW020 12/08 Q1013 TEMPO 29025G40KT=");
    QVERIFY2(metar, metar ? "" : metar.error().message().c_str());
    QVERIFY(isNear(metar->layers, everywhere(270.0, 30.0, 15.0, 25.0)));
    VP_CONTAINS(joined(metar->notes), {"measured near the ground", "ignored: 9999 FEW020 12/08 Q1013 TEMPO 29025G40KT\n",
                                       "other winds of the report are not taken: 29025G40KT"});
    const auto speci = parseWind("SPECI COR UUEE 121250Z 27008MPS CAVOK 05/M01 Q1020 NOSIG");
    QVERIFY(speci && isNear(speci->layers, everywhere(270.0, 0.0, 8.0, 8.0, 1.0)));
    const auto american = parseWind("KJFK 121251Z 31018KT 10SM RMK AO2\nPK WND 30031/1205=");
    QVERIFY(american && isNear(american->layers, everywhere(310.0, 0.0, 18.0, 18.0)));
    VP_CONTAINS(joined(american->notes), {"peak wind 30031/1205"});
    QVERIFY(parseWind("METAR EDDF 121250Z 00000KT 0200 FG=")->layers.empty());
    QVERIFY(isNear(parseWind("METAR EDDF 121250Z VRB02KT=")->layers, everywhere(0.0, 180.0, 0.0, 2.0)));
  }

  void windsAloft_areReadByTheirAltitudes() {
    const auto read = parseWind("FT 3000 6000 9000 12000\nBRL 2715 2725+00 9900-05 7545-10");
    QVERIFY2(read, read ? "" : read.error().message().c_str());
    const Layers expected{atFeet(3000.0, 270.0, 15.0),
                          atFeet(6000.0, 270.0, 25.0),
                          {geo::HeightMsl::fromMetres(2743.2), {0.0, 180.0, 0.0, 5.0 * kMpsPerKnot}},
                          atFeet(12000.0, 250.0, 145.0)};
    QVERIFY2(isNear(read->layers, expected), windText(read->layers).c_str());
    VP_CONTAINS(joined(read->notes), {"temperatures are ignored", "station BRL: below 3000 ft its lowest wind is taken"});
    QVERIFY(isNear(parseWind("ft 3000 6000 brl 2715 2725+00")->layers, {expected[0], expected[1]}));
    QVERIFY(isNear(parseWind("FT 3000 6000; BRL 2715 2725+00")->layers, {expected[0], expected[1]}));
    const auto columns = parseWind(kAloft + "ABI      1931+21 2031+16 2228+11 2525-03 2334-16 243232 244041 254252\n");
    QVERIFY2(columns, columns ? "" : columns.error().message().c_str());
    QVERIFY2(isNear(columns->layers,
                    {atFeet(6000.0, 190.0, 31.0), atFeet(9000.0, 200.0, 31.0), atFeet(12000.0, 220.0, 28.0), atFeet(18000.0, 250.0, 25.0),
                     atFeet(24000.0, 230.0, 34.0), atFeet(30000.0, 240.0, 32.0), atFeet(34000.0, 240.0, 40.0), atFeet(39000.0, 250.0, 42.0)}),
             windText(columns->layers).c_str());
    VP_CONTAINS(joined(columns->notes), {"before the altitudes is ignored", "below 6000 ft", "flight levels"});
  }

  void badText_isRefusedWithASentence_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("parts");
    const auto row = [](const char* text, const QStringList& parts) { QTest::newRow(rowName(text).c_str()) << QString::fromUtf8(text) << parts; };
    row("", {"is empty", "calm"});
    row(" ;\n ", {"is empty"});
    row("strong", {"\"strong\" at character 1", "270/15kt"});
    row("361/15kt", {"character 1", "above 360"});
    row("36115KT", {"character 1", "above 360"});
    row("27/15kt", {"character 1", "three digits"});
    row("2700/15kt", {"character 1", "four digits"});
    row("270/-5kt", {"character 5", "below zero"});
    row("270/201kt", {"character 5", "0 to 200 kt"});
    row("270/110mps", {"character 5", "0 to 200 kt"});
    row("270/15mph", {"character 7", "\"MPH\"", "kt, mps or km/h"});
    row("270/15k", {"character 7", "\"K\""});
    row("270/", {"character 5", "a speed is expected"});
    row("270", {"character 4", "slash"});
    row("270-15", {"character 4", "slash"});
    row("270+-181/15kt", {"character 6", "0 to 180"});
    row("270+-/15kt", {"character 6", "degrees to each side"});
    row("270/15+-20kt", {"character 7", "below zero"});
    row("270/20-15kt", {"lower speed goes first"});
    row("27025G15KT", {"character 7", "stronger"});
    row("270/15G15kt", {"stronger"});
    row("27015G5KT", {"two or three digits"});
    row("2701500KT", {"three digits"});
    row("270150", {"unit of the speed"});
    row("00015KT", {"character 1", "360"});
    row("270P99KT", {"character 4", "upper limit"});
    row("/////KT", {"character 1", "direction is missing"});
    row("27015KT 300V240x", {"range of directions"});
    row("10015KT 240V300", {"character 9", "does not lie in this range"});
    row("27015KT 240V361", {"above 360"});
    row("270/15kt 290/25kt", {"character 10", "should end here"});
    row("270/15kt; 290/25kt", {"character 1", "each needs its altitude"});
    row("0ft 270/15kt; 290/25kt", {"character 15", "each needs its altitude"});
    row("27015 29025", {"character 1", "whole hundreds of feet"});
    row("3050 27015", {"character 1", "whole hundreds of feet"});
    row("5000ft 290/25kt; 0ft 270/15kt", {"character 18", "at 0 ft comes after the one at 5000 ft"});
    row("0ft 270/15kt; 0m 270/15kt", {"character 15", "given twice"});
    row("70000ft 270/15kt", {"70000 ft is not between"});
    row("5000ft", {"character 7", "270/15kt"});
    row("FL1 270/15kt", {"FL095"});
    row("calmish", {"character 5", "should end"});
    row("2715", {"four digits", "line of altitudes"});
    row("METAR LSZH 121250Z", {"wind of the report is expected"});
    row("METAR LSZH 121250Z NIL=", {"character 20", "27015G25KT"});
    row("METAR LSZH 121250Z /////KT 9999", {"character 20", "direction is missing"});
    row("METAR LSZH 121250Z 27015 9999", {"character 25", "unit of the speed"});
    row("METAR LSZH 121250Z 27015KTX 9999", {"\"KTX\""});
    row("METAR LSZH 121250Z 27015KT 9999 METAR EDDF 121250Z 27010KT", {"one report is expected"});
    row("FT 3000 6000", {"a station and its winds"});
    row("FT 3000 6000\nBRL", {"winds of the station"});
    row("FT 3000 6000 9000\nBRL 2715 2725+00", {"2 winds for 3 altitudes"});
    row("FT 3000\nBRL 2715 2725+00", {"2 winds for 1 altitudes"});
    row("FT 3000\nBRL 3715", {"character 13", "tens of degrees"});
    row("FT 3000\nBRL 0015", {"tens of degrees"});
    row("FT 3000\nBRL 8715", {"tens of degrees"});
    row("FT 3000\nBRL 7799", {"199 kt or more"});
    row("FT 3000\nBRL 271x", {"2725+00"});
    row("FT 3000\nBRL 2715\nABI 2716", {"one station"});
    row("FT 6000 3000\nBRL 2715 2725", {"character 9", "at 3000 ft comes after the one at 6000 ft"});
    row("FT 300000\nBRL 2715", {"character 4", "whole hundreds"});
    row("FT 3050\nBRL 2715", {"whole hundreds"});
    row("FT 90000\nBRL 2715", {"90000 ft is not between"});
  }
  void badText_isRefusedWithASentence() {
    QFETCH(QString, text);
    QFETCH(QStringList, parts);
    const auto read = parseWind(text.toStdString());
    QVERIFY2(!read, read ? windText(read->layers).c_str() : "");
    QVERIFY(read.error().code == Errc::BadFormat || read.error().code == Errc::OutOfRange);
    QVERIFY(read.error().what.find('\n') == std::string::npos);
    for (const QString& part : parts) {
      VP_CONTAINS(read.error().message(), {part.toStdString()});
    }
  }

  void longText_isQuotedAroundTheFault() {
    std::string text;
    for (int i = 0; i < 50; ++i) {
      text += std::to_string(i * 1000) + "ft 270/15kt; ";
    }
    const auto read = parseWind(text + "51000ft 270/x");
    QVERIFY(!read && read.error().what.size() < 250);
    VP_CONTAINS(read.error().what, {"...", "51000ft 270/x"});
  }

  void windText_saysItShortly() {
    QCOMPARE(windText({}), std::string("calm"));
    QCOMPARE(windText(everywhere(270.0, 0.0, 15.0, 15.0)), std::string("270/15kt"));
    QCOMPARE(windText(everywhere(7.5, 20.0, 10.0, 20.0)), std::string("007.5\u00B120/10-20kt"));
    QCOMPARE(windText(everywhere(0.0, 180.0, 0.0, 5.0)), std::string("VRB/0-5kt"));
    QCOMPARE(windText({atFeet(0.0, 0.0, 0.0)}), std::string("0ft calm"));
    QCOMPARE(windText({atFeet(0.0, 270.0, 15.0), atFeet(5000.0, 290.0, 25.5)}), std::string("0ft 270/15kt; 5000ft 290/25.5kt"));
    const WindUnits metric{WindUnits::Speed::MetresPerSecond, WindUnits::Height::Metres};
    QCOMPARE(windText({{geo::HeightMsl::fromMetres(1500.0), {270.0, 0.0, 8.0, 8.0}}}, metric), std::string("1500m 270/8mps"));
    QCOMPARE(windText(everywhere(270.0, 0.0, 1.0 / 3.0, 1.0 / 3.0, 1.0)), std::string("270/0.3333333333333333mps"));
  }

  void windText_readBack_isTheSameValue() {
    const std::uint64_t seed = 11;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto number = [&](double most) {  // whole, with decimals, any at all, or an end of the range
      const double value = unit(random) * most;
      switch (random() % 5) {
        case 0:
          return std::floor(value);
        case 1:
          return std::floor(value * 10.0) / 10.0;
        case 2:
          return most;
        case 3:
          return 0.0;
        default:
          return value;
      }
    };
    for (int i = 0; i < 20000; ++i) {
      Layers layers;
      double altitude = random() % 2 == 0 ? 0.0 : aircraft::kLowestWind + number(2000.0);
      for (std::size_t count = random() % 4; count > 0; --count) {
        const double factor = random() % 2 == 0 ? kMpsPerKnot : 1.0;
        const double least = number(50.0) * factor;
        const double most = random() % 2 == 0 ? least : least + number(50.0) * factor;
        layers.push_back({geo::HeightMsl::fromMetres(altitude), {number(360.0), random() % 2 == 0 ? 0.0 : number(180.0), least, most}});
        altitude += 0.1 + number(4000.0) * (random() % 2 == 0 ? kMetresPerFoot : 1.0);
      }
      const WindUnits units{static_cast<WindUnits::Speed>(random() % 3), static_cast<WindUnits::Height>(random() % 2)};
      const std::string text = windText(layers, units);
      const auto read = parseWind(text);
      QVERIFY2(read, (text + ": " + (read ? "" : read.error().message())).c_str());
      QVERIFY2(read->layers == layers, text.c_str());
    }
  }

  void windWords_areForReading() {
    QCOMPARE(joined(windWords({})), std::string("still air\n"));
    QCOMPARE(joined(windWords(everywhere(270.0, 0.0, 15.0, 15.0))), std::string("15 kt from 270 degrees at every height\n"));
    QCOMPARE(joined(windWords(everywhere(10.0, 20.0, 10.0, 20.0))), std::string("10 to 20 kt from 350 to 030 degrees at every height\n"));
    QCOMPARE(joined(windWords(everywhere(0.0, 180.0, 0.0, 5.0))), std::string("0 to 5 kt from any direction at every height\n"));
    QCOMPARE(joined(windWords({atFeet(0.0, 0.0, 0.0), atFeet(5000.0, 0.0, 25.25)})), std::string("0 ft: calm\n5000 ft: 25.3 kt from 360 degrees\n"));
    const WindUnits metric{WindUnits::Speed::MetresPerSecond, WindUnits::Height::Metres};
    QCOMPARE(joined(windWords({atFeet(0.0, 0.0, 0.0), {geo::HeightMsl::fromMetres(1500.0), {90.0, 0.0, 7.0, 7.0}}}, metric)),
             std::string("0 m: calm\n1500 m: 7 m/s from 090 degrees\n"));
  }

  /// Whatever is done to a good text: an error that can be shown, or a wind whose own text means the same.
  void damagedTexts_areReadOrRefused_data() {
    QTest::addColumn<QString>("text");
    for (const char* text : {"270\u00B120/15\u00B15kt", "27015G25KT 240V300", "0ft 270/15kt; 5000ft 290/10-20mps; FL100 VRB05KT",
                             "METAR LSZH 121250Z AUTO 27015G25KT 240V300 9999 TEMPO 29025G40KT=", "FT 3000 6000 9000\nBRL 2715 2725+00 9900-05"}) {
      QTest::newRow(rowName(text).c_str()) << QString::fromUtf8(text);
    }
  }
  void damagedTexts_areReadOrRefused() {
    QFETCH(QString, text);
    const std::string good = text.toStdString();
    const std::string pieces = "0123456789/+-.;:GVPKTMSFLRBC \n\xC2\xB1\xFF" + std::string(1, '\0');
    std::mt19937_64 random(12);
    int refused = 0;
    for (int i = 0; i < 4000; ++i) {
      std::string damaged = good;
      for (std::size_t changes = 1 + random() % 3; changes > 0; --changes) {
        const std::size_t at = random() % (damaged.size() + 1);
        switch (random() % 3) {
          case 0:
            damaged.erase(at, 1 + random() % 4);
            break;
          case 1:
            damaged.insert(at, 1, pieces[random() % pieces.size()]);
            break;
          default:
            damaged.replace(at, 1, 1, pieces[random() % pieces.size()]);
            break;
        }
      }
      const auto read = parseWind(damaged);
      if (!read) {
        ++refused;
        QVERIFY2(!read.error().what.empty() && read.error().what.size() < 400, read.error().what.c_str());
        QVERIFY(read.error().what.find('\n') == std::string::npos);
        continue;
      }
      const auto fault = aircraft::windFault(read->layers);
      QVERIFY2(!fault, (damaged + ": " + (fault ? fault->sentence : "")).c_str());
      const auto again = parseWind(windText(read->layers));
      QVERIFY2(again && again->layers == read->layers, damaged.c_str());
    }
    QVERIFY(refused > 1000 && refused < 4000);
  }
};

QTEST_APPLESS_MAIN(TestWindText)
#include "tst_wind_text.moc"
