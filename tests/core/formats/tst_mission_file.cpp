#include "core/formats/aircraft_file.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_paths.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

const char* const kSmall = R"({"format":"volplane-mission","version":1,"terrain":["t.tif"],"aircraft":"cessna172-elasp"})";

/// The small mission with a text put in the place of another.
std::string with(const std::string& from, const std::string& to) {
  std::string text = kSmall;
  text.replace(text.find(from), from.size(), to);
  return text;
}
std::string adding(const std::string& members) {
  return with("\"terrain\"", members + ",\"terrain\"");
}

}  // namespace

class TestMissionFile : public QObject {
  Q_OBJECT
  Folder folder_;

private slots:
  void read_ofSmallestMission_givesDefaults() {
    const auto mission = readMission(folder_.write("a.vpm", kSmall));
    QVERIFY2(mission, mission ? "" : mission.error().message().c_str());
    QCOMPARE(mission->terrain, std::vector<std::string>{"t.tif"});
    QCOMPARE(mission->aircraftReference, std::string("cessna172-elasp"));
    QCOMPARE(mission->aircraft.id, std::string("cessna172-elasp"));
    QVERIFY(mission->planner == mission::PlannerSettings());
    QVERIFY(mission->safety == mission::SafetySettings());
    QVERIFY(mission->siteFilter == mission::SiteFilter());
    QVERIFY(mission->targets.empty() && mission->airfields.empty() && mission->sites.empty() && !mission->ceiling);
  }

  void relativePaths_areThoseThatShareAFolder() {
    mission::Mission mission;
    mission.terrain = {"/home/pilot/maps/a.tif", "/home/pilot/missions/north/b.tif", "/usr/share/volplane/maps/c.tif", "/d.tif"};
    const std::vector<std::string> before = mission.terrain;
    makePathsRelative(mission, "/home/pilot/missions/north");
    QCOMPARE(mission.terrain, (std::vector<std::string>{"../../maps/a.tif", "b.tif", "/usr/share/volplane/maps/c.tif", "/d.tif"}));
    makePathsAbsolute(mission, "/home/pilot/missions/north");
    QCOMPARE(mission.terrain, before);
    makePathsRelative(mission, "/");
    QCOMPARE(mission.terrain.front(), std::string("/home/pilot/maps/a.tif"));
  }

  void read_withByteOrderMark_works() { QVERIFY(readMission(folder_.write("bom.vpm", std::string("\xEF\xBB\xBF") + kSmall))); }

  void writeThenRead_givesTheSameMission() {
    mission::Mission mission = samples::sampleMission();
    for (const bool byReference : {false, true}) {
      if (byReference) {
        mission.aircraftReference = "cessna172-operational";
        mission.aircraft = *findAircraft("cessna172-operational", ".");
        mission.approach.slope.reset();  // that profile says nothing of these
        mission.propeller = {};
        mission.powerSetting.clear();
      }
      const std::string path = folder_.path("round.vpm");
      const auto written = writeMission(mission, path);
      QVERIFY2(written, written ? "" : written.error().message().c_str());
      const auto back = readMission(path);
      QVERIFY2(back, back ? "" : back.error().message().c_str());
      QVERIFY(samples::sameMission(mission, *back));
      const std::string bytes = samples::readBytes(path);
      QVERIFY(writeMission(*back, path));
      QCOMPARE(samples::readBytes(path), bytes);
    }
  }

  /// Names are shown and printed, so a control character is a blank; names of files are what the file system has.
  void controlCharacters_areBlanksInNamesAndKeptInNamesOfFiles() {
    mission::Mission mission = samples::sampleMission();
    mission.name = "Davos\n\x1b[31m";
    mission.targets[0].name = "T\t1";
    mission.populationFiles = {"a\nb.geojson"};
    const auto back = parseMission(missionToText(mission), "m.vpm");
    QVERIFY2(back, back ? "" : back.error().message().c_str());
    QCOMPARE(back->name, std::string("Davos  [31m"));
    QCOMPARE(back->targets[0].name, std::string("T 1"));
    QCOMPARE(back->populationFiles, mission.populationFiles);
    QCOMPARE(back->terrain, mission.terrain);
  }

  void read_ofMissionOlderThanTheLattice_keepsWhatItAskedFor() {
    const auto roadmapOf = [&](const char* members) {
      const auto mission = readMission(folder_.write("old.vpm", adding(R"("planner":{)" + std::string(members) + "}")));
      return mission ? std::optional(mission->planner.roadmap) : std::nullopt;
    };
    QVERIFY(roadmapOf(R"("seed":1)") == mission::RoadmapKind::Lattice);
    QVERIFY(roadmapOf(R"("roadmapSamples":7500)") == mission::RoadmapKind::RrtStar);
    QVERIFY(roadmapOf(R"("roadmapTime_s":30)") == mission::RoadmapKind::RrtStar);
    QVERIFY(roadmapOf(R"("roadmapSamples":7500,"roadmap":"lattice")") == mission::RoadmapKind::Lattice);
    QVERIFY(roadmapOf(R"("roadmap":"rrtstar")") == mission::RoadmapKind::RrtStar);
  }

  void wind_isWrittenOnlyWhereItBlows() {
    mission::Mission mission = samples::sampleMission();
    QVERIFY(missionToText(mission).find("\"wind\"") != std::string::npos);
    mission.wind.clear();
    QVERIFY(missionToText(mission).find("\"wind\"") == std::string::npos);
    QVERIFY(parseMission(adding("\"wind\":[]"), "m.vpm")->wind.empty());
  }

  void weatherAndPopulation_areWrittenOnlyWhereThereAreAny() {
    mission::Mission mission = samples::sampleMission();
    VP_CONTAINS(missionToText(mission), (std::vector<std::string>{"\"weather\"", "\"population\"", "perDistance_m"}));
    mission.weather.clear();
    mission.populationFiles.clear();
    const std::string text = missionToText(mission);
    QVERIFY(text.find("\"weather\"") == std::string::npos && text.find("\"population\"") == std::string::npos);
    const auto older = parseMission(kSmall, "m.vpm");
    QVERIFY(older && older->weather.empty() && older->populationFiles.empty());
  }

  void settings_asInThePapers_areNotWritten() {
    mission::Mission mission = samples::sampleMission();
    const std::vector<std::string> members{"reactionTime_s", "reactionLoss_m", "dragFactor", "atmosphere", "approach", "propeller", "powerSetting\""};
    VP_CONTAINS(missionToText(mission), members);
    mission.safety = {mission.safety.clearance, mission.safety.arrivalMargin};
    mission.atmosphere.reset();
    mission.approach = {};
    mission.propeller = {};
    mission.powerSetting.clear();
    const std::string text = missionToText(mission);
    for (const std::string& member : members) {
      QVERIFY2(text.find('"' + member) == std::string::npos, member.c_str());
    }
  }

  void approaches_ofEveryKind_readBackTheSame() {
    using Kind = mission::ApproachKind;
    std::vector<mission::ApproachSettings> all(5);
    all[0].kind = Kind::Straight;
    all[1].kind = Kind::Overhead;
    all[2].hold = true;
    all[3] = {Kind::Overhead, Length::fromSi(1000.0), {}, 1.0 / 30.0, Length::fromSi(60.0), Length::fromSi(0.0), false};
    all[4] = {Kind::Threshold, Length::fromSi(1.0 / 3.0), Angle::degrees(20.0), {}, Length::fromSi(0.0), {}, false};
    for (const mission::ApproachSettings& approach : all) {
      mission::Mission mission = samples::sampleMission();
      mission.approach = approach;
      const auto back = parseMission(missionToText(mission), "m.vpm");
      QVERIFY2(back, back ? "" : back.error().message().c_str());
      QVERIFY(back->approach == approach);
    }
  }

  void settingsThatTheAircraftLacks_areRefusedForPlanningAndOpenedToBeEdited() {
    const auto isRefusedAlone = [&](const char* members, const std::vector<std::string>& parts) {
      const auto planned = parseMission(adding(members), "m.vpm");
      QVERIFY(!planned);
      VP_CONTAINS(planned.error().message(), parts);
      QVERIFY(parseDraft(adding(members), "m.vpm"));
    };
    isRefusedAlone(R"("propeller":"windmilling")", {"/propeller", "Cessna 172 (ELASP paper) does not say", "propeller windmilling"});
    isRefusedAlone(R"("propeller":"stopped")", {"/propeller", "propeller stopped"});
    isRefusedAlone(R"("powerSetting":"65 %")", {"/powerSetting", "no power setting \"65 %\"", "its profile has none"});
    isRefusedAlone(R"("approach":{"kind":"straight","slope_deg":6})", {"/approach", "slope of 6 degrees needs a profile"});
    mission::Mission mission = samples::sampleMission();
    mission.approach.slope = Angle::degrees(9.5);
    VP_CONTAINS(parseMission(missionToText(mission), "m.vpm").error().message(), {"9.5 degrees is steeper than", "9.16732 degrees"});
    mission.approach.slope.reset();
    mission.safety.dragFactor = 2.0;
    QVERIFY(parseMission(missionToText(mission), "m.vpm"));
    mission.aircraft.glideBanks.back() = Angle::degrees(75.0);
    VP_CONTAINS(parseMission(missionToText(mission), "m.vpm").error().message(),
                {"/safety/dragFactor", "drag factor of 2 drag exceeds the weight", "in turns of 75 degrees of bank"});
    mission.powerSetting = "65 %";
    VP_CONTAINS(parseMission(missionToText(mission), "m.vpm").error().message(), {"it has \"75 %\""});
  }

  void tooStrongWind_isRefusedForPlanningAndOpenedToBeEdited() {
    const std::string text = adding(R"("wind":[{"altitude_m":0,"from_deg":270,"speed_mps":60}])");
    QVERIFY(!parseMission(text, "m.vpm"));
    const auto draft = parseDraft(text, "m.vpm");
    QVERIFY2(draft, draft ? "" : draft.error().message().c_str());
    QCOMPARE(draft->wind.size(), std::size_t{1});
    QVERIFY(!parseDraft(adding(R"("wind":[{"altitude_m":0,"from_deg":270,"speed_mps":-1}])"), "m.vpm"));
  }

  void read_resolvesAircraftFileBesideMission() {
    std::filesystem::create_directories(folder_.path("sub"));
    std::filesystem::copy_file(resourceFolders().back() + "/aircraft/cessna172-elasp.json", folder_.path("sub/mine.json"));
    const auto mission = readMission(folder_.write("b.vpm", with("cessna172-elasp", "sub/mine.json")));
    QVERIFY2(mission, mission ? "" : mission.error().message().c_str());
    QCOMPARE(mission->aircraft.id, std::string("mine"));
    QCOMPARE(mission->aircraftReference, std::string("sub/mine.json"));
  }

  void read_ofBadMission_namesPlaceAndRemedy_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("code");
    QTest::addColumn<QStringList>("parts");
    const auto row = [](const char* name, const std::string& text, Errc code, const QStringList& parts) {
      QTest::newRow(name) << QString::fromStdString(text) << static_cast<int>(code) << parts;
    };
    const std::string target = R"("targets":[{"name":"A","latitude_deg":46,"longitude_deg":9},)";
    row("malformed", "{\n\"format\": \"volplane-mission\",\n oops", Errc::BadFormat, {"line 3, column 2", "not JSON"});
    row("empty file", "", Errc::BadFormat, {"line 1", "ends in the middle"});
    row("not an object", "[1]", Errc::BadFormat, {"must be an object", "a list"});
    row("other format", with("volplane-mission", "volplane-plan"), Errc::BadFormat, {"/format", "not a volplane-mission file", "volplane-plan"});
    row("no format", with("\"format\":\"volplane-mission\",", ""), Errc::BadFormat, {"\"format\" is missing"});
    row("newer", with("\"version\":1", "\"version\":2"), Errc::NewerVersion, {"/version", "newer Volplane", "version 2", "update Volplane"});
    row("version 0", with("\"version\":1", "\"version\":0"), Errc::OutOfRange, {"/version", "at least 1"});
    row("version text", with("\"version\":1", "\"version\":\"1\""), Errc::BadFormat, {"/version", "whole number", "not \"1\""});
    row("no terrain", with("\"terrain\":[\"t.tif\"],", ""), Errc::BadFormat, {"\"terrain\" is missing"});
    row("terrain empty", with("[\"t.tif\"]", "[]"), Errc::OutOfRange, {"/terrain", "at least one terrain file"});
    row("terrain empty name", with("t.tif", ""), Errc::OutOfRange, {"/terrain/0", "must not be empty"});
    row("terrain text", with("[\"t.tif\"]", "\"t.tif\""), Errc::BadFormat, {"/terrain", "must be a list", "not \"t.tif\""});
    row("terrain number", with("\"t.tif\"", "7"), Errc::BadFormat, {"/terrain/0", "must be text", "not 7"});
    row("misspelt field", adding("\"ceilling_m\":3"), Errc::BadFormat,
        {"/ceilling_m", "unknown field \"ceilling_m\"", "is \"ceiling_m\" meant?", "column 55"});
    row("misspelt required", with("\"terrain\"", "\"terain\""), Errc::BadFormat, {"\"terrain\" is missing; is \"terain\" meant?"});
    row("foreign field", adding("\"qqqqqqqqqqqq\":3"), Errc::BadFormat, {"/qqqqqqqqqqqq", "unknown field", "remove it"});
    row("nested unknown", adding(R"("planner":{"headngs":3})"), Errc::BadFormat, {"/planner/headngs", "is \"headings\" meant?"});
    row("ceiling text", adding("\"ceiling_m\":\"high\""), Errc::BadFormat, {"/ceiling_m", "must be a number", "-500 to 20000 m", "not \"high\""});
    row("ceiling high", adding("\"ceiling_m\":90000"), Errc::OutOfRange, {"/ceiling_m", "-500 to 20000 m", "not 90000"});
    row("headings 0", adding(R"("planner":{"headings":0})"), Errc::OutOfRange, {"/planner/headings", "1 to 64", "not 0"});
    row("headings 65", adding(R"("planner":{"headings":65})"), Errc::OutOfRange, {"/planner/headings", "1 to 64"});
    row("headings 2.5", adding(R"("planner":{"headings":2.5})"), Errc::OutOfRange, {"/planner/headings", "whole number", "not 2.5"});
    row("step small", adding(R"("planner":{"step_m":0.5})"), Errc::OutOfRange, {"/planner/step_m", "1 to 1000 m", "not 0.5"});
    row("step large", adding(R"("planner":{"step_m":1001})"), Errc::OutOfRange, {"/planner/step_m"});
    row("beta", adding(R"("planner":{"beta":1.99})"), Errc::OutOfRange, {"/planner/beta", "2 to 1000", "not 1.99"});
    row("seed negative", adding(R"("planner":{"seed":-1})"), Errc::OutOfRange, {"/planner/seed", "whole number, 0 to"});
    row("roadmap", adding(R"("planner":{"roadmap":"RRT*"})"), Errc::BadFormat, {"/planner/roadmap", "\"lattice\" or \"rrtstar\""});
    row("refine", adding(R"("planner":{"refine":"some"})"), Errc::BadFormat, {"/planner/refine", "\"none\" or \"full\""});
    row("method", adding(R"("planner":{"method":"LAZY"})"), Errc::BadFormat, {"/planner/method", "\"lazy\" or \"base\"", "not \"LAZY\""});
    row("low targets", adding(R"("planner":{"lowTargets":1})"), Errc::BadFormat, {"/planner/lowTargets", "passAbove", "descend"});
    row("solver", adding(R"("planner":{"tourSolver":"x"})"), Errc::BadFormat, {"/planner/tourSolver", "builtin", "lkh"});
    row("samples", adding(R"("planner":{"roadmapSamples":0})"), Errc::OutOfRange, {"/planner/roadmapSamples"});
    row("time", adding(R"("planner":{"roadmapTime_s":0})"), Errc::OutOfRange, {"/planner/roadmapTime_s", "more than 0 and at most 86400 s"});
    row("clearance", adding(R"("safety":{"clearance_m":-1})"), Errc::OutOfRange, {"/safety/clearance_m", "0 to 5000 m"});
    row("safety list", adding(R"("safety":[])"), Errc::BadFormat, {"/safety", "must be an object"});
    row("flag", adding(R"("siteFilter":{"water":1})"), Errc::BadFormat, {"/siteFilter/water", "true or false", "not 1"});
    row("exclude", adding(R"("siteFilter":{"exclude":[""]})"), Errc::OutOfRange, {"/siteFilter/exclude/0", "must not be empty"});
    row("twice", adding(target + R"({"name":"A","latitude_deg":1,"longitude_deg":9}])"), Errc::OutOfRange,
        {"/targets/1/name", "\"A\" is given twice"});
    row("target name", adding(target + R"({"name":"","latitude_deg":1,"longitude_deg":9}])"), Errc::OutOfRange,
        {"/targets/1/name", "must not be empty"});
    row("latitude", adding(target + R"({"name":"B","latitude_deg":91,"longitude_deg":9}])"), Errc::OutOfRange,
        {"/targets/1/latitude_deg", "-90 to 90 degrees", "not 91"});
    row("no longitude", adding(target + R"({"name":"B","latitude_deg":1}])"), Errc::BadFormat, {"/targets/1)", "\"longitude_deg\" is missing"});
    row("reference", adding(target + R"({"name":"B","latitude_deg":1,"longitude_deg":9,"reference":"AGL"}])"), Errc::BadFormat,
        {"/targets/1/reference", "\"agl\" or \"msl\""});
    row("null", adding(R"("name":null)"), Errc::BadFormat, {"/name", "must be text", "not null"});
    row("site id twice", adding(R"("landingSites":[{"id":"A","latitude_deg":1,"longitude_deg":9,"elevation_m":1,"landingCourse_deg":9},
                                  {"id":"A","latitude_deg":1,"longitude_deg":9,"elevation_m":1,"landingCourse_deg":9}])"),
        Errc::OutOfRange, {"line 2", "/landingSites/1/id", "given twice"});
    row("site course", adding(R"("landingSites":[{"id":"A","latitude_deg":1,"longitude_deg":9,"elevation_m":1,"landingCourse_deg":361}])"),
        Errc::OutOfRange, {"/landingSites/0/landingCourse_deg", "0 to 360 degrees"});
    row("source", adding(R"("airfields":[{"airport":"x"}])"), Errc::BadFormat, {"/airfields/0", "\"airports\" is missing", "is \"airport\" meant?"});
    row("reaction time", adding(R"("safety":{"reactionTime_s":61})"), Errc::OutOfRange, {"/safety/reactionTime_s", "0 to 60 s", "not 61"});
    row("reaction loss", adding(R"("safety":{"reactionLoss_m":501})"), Errc::OutOfRange, {"/safety/reactionLoss_m", "0 to 500 m", "not 501"});
    row("drag factor", adding(R"("safety":{"dragFactor":0.9})"), Errc::OutOfRange, {"/safety/dragFactor", "1 to 3", "not 0.9"});
    row("QNH", adding(R"("atmosphere":{"qnh_hPa":29.92})"), Errc::OutOfRange, {"/atmosphere/qnh_hPa", "850 to 1090 hPa", "not 29.92"});
    row("temperature", adding(R"("atmosphere":{"temperatureOffset_K":-61})"), Errc::OutOfRange,
        {"/atmosphere/temperatureOffset_K", "-60 to 50 K", "not -61"});
    row("approach", adding(R"("approach":{"kind":"final"})"), Errc::BadFormat, {"/approach/kind", "threshold", "straight", "overhead"});
    row("final", adding(R"("approach":{"finalLength_m":0})"), Errc::OutOfRange, {"/approach/finalLength_m", "more than 0 and at most 20000 m"});
    row("slope", adding(R"("approach":{"slope_deg":21})"), Errc::OutOfRange, {"/approach/slope_deg", "at most 20 degrees", "not 21"});
    row("surface", adding(R"("approach":{"surfaceSlope":20})"), Errc::OutOfRange, {"/approach/surfaceSlope", "at most 1", "not 20"});
    row("surface start", adding(R"("approach":{"surfaceStart_m":1001})"), Errc::OutOfRange, {"/approach/surfaceStart_m", "0 to 1000 m"});
    row("key", adding(R"("approach":{"keyHeight_m":3001})"), Errc::OutOfRange, {"/approach/keyHeight_m", "0 to 3000 m", "not 3001"});
    row("hold misspelt", adding(R"("approach":{"holds":true})"), Errc::BadFormat, {"/approach/holds", "is \"hold\" meant?"});
    row("propeller", adding(R"("propeller":"off")"), Errc::BadFormat, {"/propeller", "windmilling"});
    const auto wind = [](const std::string& layers) { return adding("\"wind\":[" + layers + "]"); };
    const std::string low = R"({"altitude_m":0,"from_deg":270,"speed_mps":5})";
    row("wind direction", wind(R"({"altitude_m":0,"from_deg":361,"speed_mps":5})"), Errc::OutOfRange, {"/wind/0/from_deg", "0 to 360", "not 361"});
    row("wind spread", wind(R"({"altitude_m":0,"from_deg":0,"spread_deg":181,"speed_mps":5})"), Errc::OutOfRange, {"/wind/0/spread_deg", "not 181"});
    row("wind without speed", wind(R"({"altitude_m":0,"from_deg":0})"), Errc::BadFormat, {"/wind/0", "\"speed_mps\" is missing"});
    row("wind of two speeds", wind(R"({"altitude_m":0,"from_deg":0,"speed_mps":5,"mostSpeed_mps":6})"), Errc::BadFormat,
        {"/wind/0/mostSpeed_mps", "either speed_mps or"});
    row("wind range turned", wind(R"({"altitude_m":0,"from_deg":0,"leastSpeed_mps":6,"mostSpeed_mps":5})"), Errc::OutOfRange,
        {"/wind/0/mostSpeed_mps", "9.7 kt", "below its least, 11.7 kt"});
    row("wind layer twice", wind(low + "," + low), Errc::OutOfRange, {"/wind/1/altitude_m", "at 0 ft is given twice"});
    row("wind layers turned", wind(R"({"altitude_m":1524,"from_deg":270,"speed_mps":5},)" + low), Errc::OutOfRange,
        {"/wind/1/altitude_m", "at 0 ft comes after the one at 5000 ft"});
    row("wind as strong as the glide", wind(low + R"(,{"altitude_m":1524,"from_deg":270,"speed_mps":36.0111111})"), Errc::OutOfRange,
        {"/wind/1/speed_mps", "the wind of 70 kt at 5000 ft is not below the gliding speed of 64.9 kt"});
    row("wind unknown member", wind(R"({"altitude_m":0,"from_deg":0,"speed_mps":5,"gust_mps":9})"), Errc::BadFormat, {"/wind/0/gust_mps"});
    const auto cell = [](const std::string& members) {
      return adding(R"("weather":[{"outline":[[9.9,46.6],[9.9,46.7],[10,46.7]],)" + members + "}]");
    };
    row("weather without probability", cell(R"("floor_m":0)"), Errc::BadFormat, {"/weather/0", "\"success\" is missing"});
    row("weather of no chance", cell(R"("success":0)"), Errc::OutOfRange, {"/weather/0/success", "not 0"});
    row("weather upside down", cell(R"("success":0.9,"floor_m":3000,"top_m":2000)"), Errc::OutOfRange,
        {"/weather/0/top_m", "the top must be above the floor"});
    row("weather of two corners", adding(R"("weather":[{"outline":[[9.9,46.6],[9.9,46.7]],"success":0.9}])"), Errc::OutOfRange,
        {"/weather/0/outline", "three corners or more"});
    row("weather north of the pole", adding(R"("weather":[{"outline":[[9.9,46.6],[9.9,96.7],[10,46.7]],"success":0.9}])"), Errc::OutOfRange,
        {"/weather/0/outline/1/1", "96.7"});
    row("aircraft unknown", with("cessna172-elasp", "cessna172-elsap"), Errc::BadFile,
        {"/aircraft", "no bundled aircraft \"cessna172-elsap\"", "is \"cessna172-elasp\" meant?", "cessna172-operational"});
    row("aircraft file missing", with("cessna172-elasp", "./x.json"), Errc::BadFile, {"/aircraft", "x.json", "no such file"});
    row("aircraft number", with("\"cessna172-elasp\"", "172"), Errc::BadFormat, {"/aircraft", "name of an aircraft or a profile", "not 172"});
    row("aircraft inline", with("\"cessna172-elasp\"", "{\"name\":\"x\",\"mass_kg\":-1}"), Errc::OutOfRange,
        {"/aircraft/mass_kg", "more than 0", "not -1"});
  }
  void read_ofBadMission_namesPlaceAndRemedy() {
    QFETCH(QString, text);
    QFETCH(int, code);
    QFETCH(QStringList, parts);
    const auto mission = readMission(folder_.write("bad.vpm", text.toStdString()));
    QVERIFY(!mission);
    const std::string message = mission.error().message();
    QVERIFY2(static_cast<int>(mission.error().code) == code, message.c_str());
    for (const QString& part : parts) {
      VP_CONTAINS(message, {part.toStdString()});
    }
    if (!message.starts_with(folder_.path("x.json"))) {
      VP_CONTAINS(message, {"bad.vpm"});
    }
  }

  void read_ofUnreadable_saysWhy() {
    VP_CONTAINS(readMission(folder_.path("none.vpm")).error().message(), {"none.vpm", "no such file"});
    VP_CONTAINS(readMission(folder_.path()).error().message(), {"this is a folder"});
    VP_CONTAINS(readMission(folder_.write("utf16.vpm", std::string("\xFF\xFE{\0}\0", 6))).error().message(),
                {"utf16.vpm", "UTF-16", "save it as UTF-8"});
    VP_CONTAINS(readMission(folder_.write("bin.vpm", std::string("{\0}", 3))).error().message(), {"bin.vpm", "not a text file"});
  }

  void limits_areAccepted() {
    for (const char* members :
         {R"("planner":{"headings":1,"step_m":1,"beta":2})", R"("planner":{"headings":64,"step_m":1000,"seed":18446744073709551615})",
          R"("safety":{"clearance_m":0})", R"("ceiling_m":20000)", R"("safety":{"reactionTime_s":60,"reactionLoss_m":500,"dragFactor":1})",
          R"("atmosphere":{"temperatureOffset_K":-60,"qnh_hPa":1090})", R"("atmosphere":{})",
          R"("approach":{"kind":"overhead","finalLength_m":20000,"surfaceSlope":1,"surfaceStart_m":1000,"keyHeight_m":3000})"}) {
      const auto mission = readMission(folder_.write("limit.vpm", adding(members)));
      QVERIFY2(mission, mission ? "" : mission.error().message().c_str());
    }
  }

  void write_toMissingFolder_saysSo() {
    const auto written = writeMission(samples::sampleMission(), folder_.path("none/x.vpm"));
    QVERIFY(!written);
    QCOMPARE(written.error().code, Errc::OutputFailed);
    VP_CONTAINS(written.error().message(), {"none/x.vpm", "no such folder"});
  }

  void resolvePath_startsAtTheMission() {
    QCOMPARE(resolvePath("/a/b/m.vpm", "t.tif"), std::string("/a/b/t.tif"));
    QCOMPARE(resolvePath("/a/b/m.vpm", "../t.tif"), std::string("/a/t.tif"));
    QCOMPARE(resolvePath("/a/b/m.vpm", "/t.tif"), std::string("/t.tif"));
    QCOMPARE(resolvePath("m.vpm", "t.tif"), std::string("t.tif"));
    QCOMPARE(resolvePath(folder_.path(), "t.tif"), folder_.path("t.tif"));
  }
};

QTEST_APPLESS_MAIN(TestMissionFile)
#include "tst_mission_file.moc"
