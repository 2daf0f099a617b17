#include "core/base/expect.h"
#include "core/formats/plan_file.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <bit>
#include <random>
#include <regex>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

class TestPlanFile : public QObject {
  Q_OBJECT
  Folder folder_;

  Result<mission::Plan> reread(const std::string& text) { return readPlan(folder_.write("p.vpp", text)); }

  static std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    return at == std::string::npos ? "TEXT NOT FOUND: " + from : text.replace(at, from.size(), to);
  }

private slots:
  void writeThenRead_givesTheSamePlanAndBytes() {
    const mission::Plan plan = samples::samplePlan();
    const std::string path = folder_.path("round.vpp");
    QVERIFY(writePlan(plan, path));
    const auto back = readPlan(path);
    QVERIFY2(back, back ? "" : back.error().message().c_str());
    QVERIFY(samples::samePlan(plan, *back));
    QCOMPARE(planToJson(*back), samples::readBytes(path));
    QVERIFY(std::signbit(back->sites[1].pose.y));  // -0.0 keeps its sign
  }

  void writeThenRead_ofPlanWithoutOptionalParts_works() {
    mission::Plan plan = samples::samplePlan();
    plan.certificate.reset();
    plan.spirals.clear();
    plan.holds.clear();
    plan.departure.reset();
    plan.arrival.reset();
    plan.mission.home.reset();
    plan.tour.clear();
    plan.mission.aircraftReference.clear();
    plan.mission.aircraft.stallSpeed.reset();
    plan.mission.ceiling.reset();
    const auto back = reread(planToJson(plan));
    QVERIFY2(back, back ? "" : back.error().message().c_str());
    QVERIFY(samples::samePlan(plan, *back));
  }

  void read_ofPlanOlderThanRefinement_works() {
    std::string text = planToJson(samples::samplePlan());
    for (const char* member : {"roadmap", "refine", "sampledCost_m", "movesTried", "movesAccepted", "freeLowerBound_m"}) {
      const std::string without = std::regex_replace(text, std::regex(std::string(",\\s*\"") + member + "\": [^,}\\s]+"), "");
      QVERIFY2(without != text, member);
      text = without;
    }
    const auto plan = reread(text);
    QVERIFY2(plan, plan ? "" : plan.error().message().c_str());
    QVERIFY(plan->tour == samples::samplePlan().tour);
    QVERIFY(plan->mission.planner.roadmap == mission::RoadmapKind::RrtStar);  // it names samples
    QCOMPARE(plan->metrics.sampledCost, 0.0);
  }

  void numbers_ofTheTour_comeBackBitForBit() {
    const std::uint64_t seed = 20240611;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> metres(-1e5, 1e5);
    std::uniform_real_distribution<double> exponent(-12.0, 6.0);
    mission::Plan plan = samples::samplePlan();
    plan.tour.clear();
    const auto any = [&] { return std::pow(10.0, exponent(random)); };
    for (int i = 0; i < 12000; ++i) {
      mission::DecisionPoint point;
      point.pose = {metres(random), metres(random), metres(random) / 1e4};
      point.altitude = metres(random);
      point.safeAltitude = metres(random);
      point.onward = i % 2 == 0 ? flight::Piece{flight::Turn::Straight, 0.0, any()} : flight::Piece{flight::Turn::Right, any(), any()};
      point.witness = {i % 3 - 1, {{flight::Turn::Left, any(), any()}}};
      point.target = i % 6 - 1 < 4 ? i % 6 - 1 : -1;
      plan.tour.push_back(point);
    }
    const auto back = reread(planToJson(plan));
    QVERIFY2(back, back ? "" : back.error().message().c_str());
    QVERIFY(back->tour == plan.tour);
  }

  void layout_hasOneDecisionPointPerLine() {
    const mission::Plan plan = samples::samplePlan();
    const std::string text = planToJson(plan);
    std::size_t lines = 0;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      if (line.find("\"safeAltitude_m\"") != std::string::npos) {
        ++lines;
        const bool hasGlide = line.find("\"site\": -1") == std::string::npos;
        VP_CONTAINS(line, {"{\"pose\": [", "\"onward\": [\"", "\"witness\": {\"site\": ",
                           hasGlide ? "\"pieces\": [[\"L\", 197, 321.5], [\"S\", 1234.5], [\"R\", 113.8, 20]]}" : "\"pieces\": []}"});
      }
    }
    QCOMPARE(lines, plan.tour.size() + plan.departure->points.size() + plan.arrival->points.size());
  }

  void tamperedPlan_isReadAsItIs() {
    const std::string text = planToJson(samples::samplePlan());
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{"\"altitude_m\": 2500", "\"altitude_m\": 100"},
                                                                                   {"[\"L\", 197, 321.5], ", ""},
                                                                                   {"[\"R\", 113.8, 20]", "[\"R\", 1, 20]"},
                                                                                   {"\"sha256\": \"00ff\"", "\"sha256\": \"\""},
                                                                                   {"\"site\": 0", "\"site\": -1"},
                                                                                   {", \"target\": 1}", "}"}}) {
      const auto plan = reread(replaced(text, from, to));
      QVERIFY2(plan, plan ? "" : plan.error().message().c_str());
    }
  }

  void read_ofBadPlan_namesPlace_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<int>("code");
    QTest::addColumn<QStringList>("parts");
    const auto row = [](const char* name, const char* from, const char* to, Errc code, const QStringList& parts) {
      QTest::newRow(name) << QString(from) << QString(to) << static_cast<int>(code) << parts;
    };
    row("newer", "\"version\": 1", "\"version\": 2", Errc::NewerVersion, {"/version", "update Volplane"});
    row("a mission", "volplane-plan", "volplane-mission", Errc::BadFormat, {"/format", "not a volplane-plan file"});
    row("cut", "\"tour\": [", "\"tour\": [[", Errc::BadFormat, {"line", "column"});
    row("wind as strong as the glide", "\"mostSpeed_mps\": 1", "\"mostSpeed_mps\": 4", Errc::OutOfRange,
        {"/mission/wind/1/mostSpeed_mps", "at 5000 ft is not below the gliding speed of 58.1 kt, that of the lightest aircraft"});
    row("site index", "\"witness\": {\"site\": 1", "\"witness\": {\"site\": 2", Errc::OutOfRange,
        {"/tour/1/witness/site", "no element 2 in sites, which has 2"});
    row("site below", "\"witness\": {\"site\": 1", "\"witness\": {\"site\": -2", Errc::OutOfRange, {"/tour/1/witness/site", "-1 to"});
    row("target index", "\"target\": 3}", "\"target\": 4}", Errc::OutOfRange, {"/target", "no element 4 in targets, which has 4"});
    row("spiral target", "{\"target\": 2, \"top_m\"", "{\"target\": 9, \"top_m\"", Errc::OutOfRange, {"/spirals/0/target", "no element 9"});
    row("piece word", "[\"S\", 50]", "[\"Q\", 50]", Errc::BadFormat, {"/tour/0/onward", "[\"S\", length]"});
    row("piece short", "[\"S\", 50]", "[\"L\", 50]", Errc::BadFormat, {"/tour/0/onward"});
    row("piece negative", "[\"S\", 50]", "[\"S\", -50]", Errc::OutOfRange, {"/tour/0/onward/1", "0 to"});
    row("radius zero", "[\"L\", 197, 321.5]", "[\"L\", 0, 321.5]", Errc::OutOfRange, {"/tour/0/witness/pieces/0/1", "more than 0"});
    row("pose", "{\"pose\": [-1000, -1114, 0]", "{\"pose\": [-1000, -1114]", Errc::BadFormat, {"/tour/0/pose", "metres east"});
    row("pose text", "{\"pose\": [-1000, ", "{\"pose\": [\"-1000\", ", Errc::BadFormat, {"/tour/0/pose/0", "must be a number"});
    row("infinite", "\"altitude_m\": 2500", "\"altitude_m\": 1e999", Errc::BadFormat, {"line", "1e999 is too large"});
    row("huge", "\"altitude_m\": 2500", "\"altitude_m\": 1e99", Errc::OutOfRange, {"/tour/0/altitude_m"});
    row("home joins beyond the tour", "\"join\": 5,", "\"join\": 5000,", Errc::OutOfRange, {"/departure/join"});
    row("turn", "\"turn\": \"right\"", "\"turn\": \"Right\"", Errc::BadFormat, {"/spirals/0/turn", "\"right\""});
    row("no tour", "\"tour\": [", "\"tours\": [", Errc::BadFormat, {"\"tour\" is missing; is \"tours\" meant?"});
    row("unknown", "\"createdBy\"", "\"createdby\"", Errc::BadFormat, {"/createdby", "is \"createdBy\" meant?"});
    row("mission", "\"headings\": 12", "\"headings\": 0", Errc::OutOfRange, {"/mission/planner/headings"});
    row("aircraft", "\"aircraft\": {", "\"aircraft\": \"x\", \"y\": {", Errc::BadFormat, {"/mission/aircraft", "must be a profile"});
    row("count", "\"pointsChecked\": 5000000000", "\"pointsChecked\": -5", Errc::OutOfRange, {"/certificate/pointsChecked", "at least 0"});
    row("origin", "\"frameOrigin\": {\"latitude_deg\": 46.6", "\"frameOrigin\": {\"latitude_deg\": 146.6", Errc::OutOfRange,
        {"/frameOrigin/latitude_deg", "-90 to 90 degrees"});
  }
  void read_ofBadPlan_namesPlace() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(int, code);
    QFETCH(QStringList, parts);
    const auto plan = reread(replaced(planToJson(samples::samplePlan()), from.toStdString(), to.toStdString()));
    QVERIFY(!plan);
    const std::string message = plan.error().message();
    QVERIFY2(static_cast<int>(plan.error().code) == code, message.c_str());
    VP_CONTAINS(message, {"p.vpp"});
    for (const QString& part : parts) {
      VP_CONTAINS(message, {part.toStdString()});
    }
  }

  void read_ofTruncatedPlan_saysSo() {
    const std::string text = planToJson(samples::samplePlan());
    const auto plan = reread(text.substr(0, text.size() / 2));
    QVERIFY(!plan);
    VP_CONTAINS(plan.error().message(), {"p.vpp, line ", "ends in the middle"});
  }

  void write_ofNumberThatIsNone_isABug() {
    mission::Plan plan = samples::samplePlan();
    plan.tour[3].safeAltitude = std::nan("");
    QVERIFY_EXCEPTION_THROWN(planToJson(plan), LogicError);
  }
};

QTEST_APPLESS_MAIN(TestPlanFile)
#include "tst_plan_file.moc"
