// The document layer below all JSON files: places of faults, exact numbers, layout.
#include "core/base/expect.h"
#include "core/formats/json_reader.h"
#include "core/formats/json_value.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <bit>
#include <random>

using namespace vp;
using namespace vp::formats;

class TestJson : public QObject {
  Q_OBJECT
private slots:
  void parse_ofBadText_namesLineAndColumn_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("where");
    QTest::addColumn<QString>("what");
    QTest::newRow("missing comma") << "{\n  \"a\": 1\n  \"b\": 2\n}"
                                   << "line 3, column"
                                   << "not JSON";
    QTest::newRow("cut short") << "{\n  \"a\": [1, 2"
                               << "line 2, column 13"
                               << "ends in the middle";
    QTest::newRow("empty") << ""
                           << "line 1, column 1"
                           << "ends in the middle";
    QTest::newRow("trailing text") << "{} x"
                                   << "line 1, column 4"
                                   << "not JSON";
    QTest::newRow("twice") << "{\"a\": {\"b\": 1, \"b\": 2}}"
                           << "/a/b"
                           << "\"b\" is given twice";
    QTest::newRow("too large") << "{\"a\":\n 1e999}"
                               << "line 2"
                               << "1e999 is too large";
    QTest::newRow("NaN") << "{\"a\": NaN}"
                         << "line 1, column 7"
                         << "not JSON";
    QTest::newRow("comment") << "{\"a\": 1 // one\n}"
                             << "line 1, column 9"
                             << "not JSON";
    QTest::newRow("deep") << QString(100, '[') << "f.json"
                          << "nested deeper than 64";
  }
  void parse_ofBadText_namesLineAndColumn() {
    QFETCH(QString, text);
    QFETCH(QString, where);
    QFETCH(QString, what);
    const Result<JsonValue> value = parseJson(text.toStdString(), "f.json");
    QVERIFY(!value);
    QCOMPARE(value.error().code, Errc::BadFormat);
    VP_CONTAINS(value.error().where, {"f.json", where.toStdString()});
    VP_CONTAINS(value.error().what, {what.toStdString()});
  }

  void parse_ofHugeObject_isRefused() {
    std::string text = "{\"m\": {\"0\": 0";
    for (int i = 1; i < 200000; ++i) {
      text += ", \"" + std::to_string(i) + "\": 0";
    }
    const Result<JsonValue> value = parseJson(text + "}}", "f.json");
    QVERIFY(!value);
    VP_CONTAINS(value.error().message(), {"f.json (/m)", "more than 1000 members"});
  }

  void parse_ofInvalidUtf8_isRefused() { QVERIFY(!parseJson("{\"a\": \"\xff\"}", "f")); }

  void locate_givesPlaceOfValue() {
    const std::string text = "{\n \"a\\\"\": [1, {\"b\": \"x]\"},\n  [true, null]],\n \"c\": -1.5e3 }";
    const auto at = [&](const char* pointer) {
      const TextPlace place = locateJson(text, pointer);
      return std::pair(place.line, place.column);
    };
    QCOMPARE(at(""), std::pair(std::size_t{1}, std::size_t{1}));
    QCOMPARE(at("/a\"/0"), std::pair(std::size_t{2}, std::size_t{10}));
    QCOMPARE(at("/a\"/1/b"), std::pair(std::size_t{2}, std::size_t{19}));
    QCOMPARE(at("/a\"/2/1"), std::pair(std::size_t{3}, std::size_t{10}));
    QCOMPARE(at("/c"), std::pair(std::size_t{4}, std::size_t{7}));
    QCOMPARE(at("/c/none"), std::pair(std::size_t{4}, std::size_t{7}));
    QCOMPARE(at("/none"), std::pair(std::size_t{1}, std::size_t{1}));
  }

  void numbers_ofEveryBitPattern_comeBackExactly() {
    const std::uint64_t seed = 4711;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    int tried = 0;
    while (tried < 100000) {
      const double value = std::bit_cast<double>(random());
      if (!std::isfinite(value)) {
        continue;
      }
      ++tried;
      const Result<JsonValue> back = parseJson(shortestNumber(value), "f");
      QVERIFY2(back && back->isNumber(), shortestNumber(value).c_str());
      QVERIFY2(std::bit_cast<std::uint64_t>(back->number()) == std::bit_cast<std::uint64_t>(value), shortestNumber(value).c_str());
    }
    for (const double value : {0.0, -0.0, 0.1, 1e22, 1e23, 123456789012345680.0, 4.9e-324, 1.7976931348623157e308}) {
      const Result<JsonValue> back = parseJson(shortestNumber(value), "f");
      QVERIFY(back && std::bit_cast<std::uint64_t>(back->number()) == std::bit_cast<std::uint64_t>(value));
    }
    QCOMPARE(shortestNumber(0.1), std::string("0.1"));
    QCOMPARE(shortestNumber(100.0), std::string("100"));
  }

  void angles_comeBackExactly_andRoundOnesLookRound() {
    const std::uint64_t seed = 99;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> radians(0.0, 2.0 * Angle::kPi);
    int inRadians = 0;
    for (int i = 0; i < 20000; ++i) {
      const Angle angle = Angle::radians(radians(random));
      JsonValue json = JsonValue::object();
      writeAngle(json, "x", angle);
      const std::string text = writeJson(json, {});
      inRadians += json.find("x_rad") != nullptr ? 1 : 0;
      const Result<JsonValue> parsed = parseJson(text, "f");
      ReadContext context("f", text);
      ObjectReader reader(*parsed, "", context);
      QVERIFY(reader.angle("x", {0.0, 361.0, "degrees"}) == angle);
      QVERIFY(!context.error());
    }
    QVERIFY(inRadians > 0);  // both ways of writing were met
    QVERIFY(inRadians < 10000);
    for (int degrees = 1; degrees <= 360; ++degrees) {
      JsonValue json = JsonValue::object();
      writeAngle(json, "x", Angle::degrees(degrees));
      QCOMPARE(json.find("x_deg")->number(), static_cast<double>(degrees));
    }
  }

  void layout_breaksLongListsOnly() {
    JsonValue json = JsonValue::object();
    json.set("short", JsonValue::Array{1, 2.5, "x"});
    json.set("lines", JsonValue::Array{JsonValue::Array{1}, JsonValue::Array{2}});
    json.set("none", JsonValue::array());
    QCOMPARE(writeJson(json, {60, {"lines"}}),
             std::string("{\n  \"short\": [1, 2.5, \"x\"],\n  \"lines\": [\n    [1],\n    [2]\n  ],\n  \"none\": []\n}\n"));
  }

  void write_ofInfinity_isABug() { QVERIFY_EXCEPTION_THROWN(shortestNumber(INFINITY), LogicError); }
};

QTEST_APPLESS_MAIN(TestJson)
#include "tst_json.moc"
