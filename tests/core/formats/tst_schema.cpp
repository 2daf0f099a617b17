// The published schemas against what the program writes and refuses. valijson serves here only.
#include "core/formats/aircraft_file.h"
#include "core/formats/mission_file.h"
#include "core/formats/plan_file.h"
#include "tests/core/formats/format_samples.h"
#include "tests/support/schema_check.h"

#include <QTest>

using namespace vp;
using namespace vp::formats;
using Json = nlohmann::json;
using samples::Folder;

namespace {

std::string source(const std::string& path) {
  return std::string(VOLPLANE_SOURCE_DIR) + "/" + path;
}

Json missionJson(const Folder& folder) {
  const std::string path = folder.path("m.vpm");
  mission::Mission mission = samples::sampleMission();
  mission.planner.seed = 9223372036854775807ull;  // valijson itself knows no larger integers
  return writeMission(mission, path) ? Json::parse(samples::readBytes(path)) : Json();
}

Json planJson() {
  mission::Plan plan = samples::samplePlan();
  plan.mission.planner.seed = 1;
  return Json::parse(planToJson(plan));
}

/// Every "properties" member of a schema must say what it is.
std::string undescribed(const Json& schema, const std::string& path) {
  if (schema.is_object()) {
    if (schema.contains("properties")) {
      for (const auto& [name, property] : schema["properties"].items()) {
        if (!property.contains("description") && !property.contains("$ref")) {
          return path + "/" + name;
        }
      }
    }
    for (const auto& [name, value] : schema.items()) {
      if (const std::string found = undescribed(value, path + "/" + name); !found.empty()) {
        return found;
      }
    }
  }
  return {};
}

}  // namespace

class TestSchema : public QObject {
  Q_OBJECT
  Folder folder_;

private slots:
  void writtenFiles_fit() {
    QVERIFY2(test::schemaMisfit("mission", missionJson(folder_)).empty(), test::schemaMisfit("mission", missionJson(folder_)).c_str());
    QVERIFY2(test::schemaMisfit("plan", planJson()).empty(), test::schemaMisfit("plan", planJson()).c_str());
    mission::Plan bare = samples::samplePlan();
    bare.mission.planner.seed = 1;
    bare.tour.clear();
    bare.spirals.clear();
    bare.certificate.reset();
    QVERIFY2(test::schemaMisfit("plan", Json::parse(planToJson(bare))).empty(), test::schemaMisfit("plan", Json::parse(planToJson(bare))).c_str());
    for (const std::string& name : bundledAircraft()) {
      QVERIFY2(test::schemaMisfit("aircraft", Json::parse(samples::readBytes(source("resources/aircraft/" + name + ".json")))).empty(),
               test::schemaMisfit("aircraft", Json::parse(samples::readBytes(source("resources/aircraft/" + name + ".json")))).c_str());
    }
    QVERIFY2(
        test::schemaMisfit("mission", Json::parse(R"({"format":"volplane-mission","version":1,"terrain":["t.tif"],"aircraft":"cessna172-elasp"})"))
            .empty(),
        test::schemaMisfit("mission", Json::parse(R"({"format":"volplane-mission","version":1,"terrain":["t.tif"],"aircraft":"cessna172-elasp"})"))
            .c_str());
  }

  void schemaAndReader_refuseTheSame_data() {
    QTest::addColumn<QString>("pointer");
    QTest::addColumn<QString>("value");  // "" removes the member
    const auto row = [](const char* pointer, const char* value) {
      QTest::newRow((std::string(pointer) + " = " + value).c_str()) << pointer << value;
    };
    row("/format", "\"volplane-plan\"");
    row("/version", "2");
    row("/version", "");
    row("/terrain", "");
    row("/terrain", "[]");
    row("/terrain/0", "\"\"");
    row("/terrain", "\"a.tif\"");
    row("/aircraft", "");
    row("/aircraft", "172");
    row("/aircraft/mass_kg", "0");
    row("/aircraft/mass_kg", "\"heavy\"");
    row("/aircraft/wingArea_m2", "");
    row("/aircraft/glideBanks_deg", "[]");
    row("/aircraft/glideBanks_deg", "[85]");
    row("/aircraft/tourBank_deg", "");
    row("/aircraft/span_m", "11");
    row("/ceilling_m", "4000");
    row("/weather/0/success", "0");
    row("/weather/0/success", "1.5");
    row("/weather/0/success", "");
    row("/weather/0/perDistance_m", "0");
    row("/weather/0/outline", "");
    row("/weather/0/outline", "[[9.9, 46.6], [9.9, 46.7]]");
    row("/weather/0/outline/0", "[9.9]");
    row("/weather/0/outline/0", "[9.9, 91]");
    row("/weather/0/floor_m", "-2000");
    row("/weather/0/top_m", "\"high\"");
    row("/weather/0/probability", "0.9");
    row("/population/0", "\"\"");
    row("/ceiling_m", "\"4000\"");
    row("/ceiling_m", "40000");
    row("/targets/0/name", "\"\"");
    row("/targets/0/latitude_deg", "91");
    row("/targets/0/latitude_deg", "");
    row("/targets/0/reference", "\"AGL\"");
    row("/targets", "{}");
    row("/landingSites/0/elevation_m", "");
    row("/landingSites/0/landingCourse_deg", "-1");
    row("/landingSites/0/landingCourse_deg", "");
    row("/landingSites/0/surface", "\"lava\"");
    row("/landingSites/0/length_m", "0");
    row("/siteFilter/water", "1");
    row("/siteFilter/exclude/0", "7");
    row("/safety/clearance_m", "-1");
    row("/planner/headings", "0");
    row("/planner/headings", "65");
    row("/planner/headings", "7.5");
    row("/planner/step_m", "0.5");
    row("/planner/step_m", "1000.5");
    row("/planner/beta", "1.9");
    row("/planner/seed", "-1");
    row("/planner/method", "\"fast\"");
    row("/planner/roadmap", "\"rrt\"");
    row("/planner/refine", "true");
    row("/planner/roadmapTime_s", "0");
    row("/wind", "{}");
    row("/wind/0/altitude_m", "");
    row("/wind/0/altitude_m", "20001");
    row("/wind/0/from_deg", "");
    row("/wind/0/from_deg", "361");
    row("/wind/0/from_deg", "\"W\"");
    row("/wind/0/spread_deg", "181");
    row("/wind/0/speed_mps", "");
    row("/wind/0/speed_mps", "-1");
    row("/wind/0/speed_mps", "102.89");
    row("/wind/0/leastSpeed_mps", "1");
    row("/wind/0/mostSpeed_mps", "3");
    row("/wind/1/leastSpeed_mps", "");
    row("/wind/1/mostSpeed_mps", "");
    row("/wind/1/speed_mps", "5");
    row("/wind/1/gust_mps", "5");
    row("/safety/reactionTime_s", "61");
    row("/safety/reactionLoss_m", "-1");
    row("/safety/dragFactor", "0.99");
    row("/safety/dragFactor", "3.1");
    row("/safety/skill", "1");
    row("/atmosphere", "\"ISA\"");
    row("/atmosphere/temperatureOffset_K", "51");
    row("/atmosphere/qnh_hPa", "849");
    row("/atmosphere/qnh_hPa", "29.92");
    row("/atmosphere/qfe_hPa", "1000");
    row("/approach/kind", "\"Straight\"");
    row("/approach/finalLength_m", "0");
    row("/approach/finalLength_m", "20001");
    row("/approach/slope_deg", "20.1");
    row("/approach/slope_deg", "0");
    row("/approach/slope_rad", "0.1");  // beside slope_deg
    row("/approach/surfaceSlope", "0");
    row("/approach/surfaceSlope", "1.01");
    row("/approach/surfaceStart_m", "-1");
    row("/approach/keyHeight_m", "3001");
    row("/approach/hold", "1");
    row("/propeller", "\"feathered\"");
    row("/powerSetting", "65");
    row("/aircraft/leastMass_kg", "0");
    row("/aircraft/mostMass_kg", "\"full\"");
    row("/aircraft/windmillingDrag", "-0.05");
    row("/aircraft/stoppedDrag", "0");
    row("/aircraft/maxSpeed_mps", "351");
    row("/aircraft/steepestDescent_deg", "46");
    row("/aircraft/steepestDescent_rad", "0.2");  // beside steepestDescent_deg
    row("/aircraft/rollRate_dps", "0.5");
    row("/aircraft/landingDistance_m", "0");
    row("/aircraft/climbRate_mps", "0");
    row("/aircraft/serviceCeiling_m", "20001");
    row("/aircraft/powerSettings/0/name", "\"\"");
    row("/aircraft/powerSettings/0/unit", "\"gal\"");
    row("/aircraft/powerSettings/0/perHour", "-1");
    row("/aircraft/powerSettings/0/trueAirspeed_mps", "");
    row("/aircraft/powerSettings/0/rpm", "2300");
    row("/aircraft/usableEnergy", "-1");
    row("/airfields/0/airports", "\"\"");
    row("/airfields/0/airports", "");
  }
  void schemaAndReader_refuseTheSame() {
    QFETCH(QString, pointer);
    QFETCH(QString, value);
    Json mission = missionJson(folder_);
    const Json::json_pointer where(pointer.toStdString());
    if (value.isEmpty()) {
      mission.at(where.parent_pointer()).erase(where.back());
    } else {
      mission[where] = Json::parse(value.toStdString());
    }
    QVERIFY(!test::schemaMisfit("mission", mission).empty());
    const auto read = readMission(folder_.write("bad.vpm", mission.dump()));
    QVERIFY(!read);
    QVERIFY(read.error().code == Errc::BadFormat || read.error().code == Errc::OutOfRange || read.error().code == Errc::NewerVersion);
  }

  void planSchema_refusesBadPlans() {
    const Json plan = planJson();
    QVERIFY(test::schemaMisfit("plan", plan).empty());
    const auto refused = [&](const char* pointer, const Json& value) {
      Json bad = plan;
      bad[Json::json_pointer(pointer)] = value;
      return !test::schemaMisfit("plan", bad).empty() && !readPlan(folder_.write("bad.vpp", bad.dump()));
    };
    QVERIFY(refused("/tour/0/onward", Json::array({"S", -1})));
    QVERIFY(refused("/tour/0/onward", Json::array({"L", 5})));
    QVERIFY(refused("/tour/0/onward", Json::array({"Q", 5})));
    QVERIFY(refused("/tour/0/pose", Json::array({1, 2})));
    QVERIFY(refused("/tour/0/witness/site", -2));
    QVERIFY(refused("/tour/0/speed", 1));
    QVERIFY(refused("/version", 2));
    QVERIFY(refused("/sites/0/pose", "north"));
    QVERIFY(refused("/spirals/0/turn", "Left"));
    QVERIFY(refused("/holds/0/turn", 1));
    QVERIFY(refused("/holds/0/site", -2));
    QVERIFY(refused("/holds/0/radius_m", 0));
    QVERIFY(refused("/holds/0/lowest_m", "low"));
    QVERIFY(refused("/holds/0/top_m", 5));
    QVERIFY(refused("/mission/approach/kind", "circle"));
    QVERIFY(refused("/departure/join", "T1"));
    QVERIFY(refused("/arrival/points/0/pose", "north"));
    QVERIFY(refused("/mission/home/takeoff", 21));
    QVERIFY(refused("/mission/planner/headings", 0));
    QVERIFY(refused("/mission/wind/0/from_deg", 400));
    QVERIFY(refused("/mission/format", "volplane-mission"));
    QVERIFY(refused("/certificate/margins/0/value", "much"));
  }

  void schemas_describeEveryFieldAndAgree() {
    const Json mission = Json::parse(samples::readBytes(source("resources/schema/mission.schema.json")));
    const Json plan = Json::parse(samples::readBytes(source("resources/schema/plan.schema.json")));
    const Json aircraft = Json::parse(samples::readBytes(source("resources/schema/aircraft.schema.json")));
    QVERIFY2(undescribed(mission, "").empty(), undescribed(mission, "").c_str());
    QVERIFY2(undescribed(plan, "").empty(), undescribed(plan, "").c_str());
    QVERIFY2(undescribed(aircraft, "").empty(), undescribed(aircraft, "").c_str());
    for (const auto& [name, definition] : mission["definitions"].items()) {
      QVERIFY2(plan["definitions"][name] == definition, name.c_str());
    }
    QVERIFY(mission["definitions"]["aircraft"]["properties"] == aircraft["properties"]);
  }
};

QTEST_APPLESS_MAIN(TestSchema)
#include "tst_schema.moc"
