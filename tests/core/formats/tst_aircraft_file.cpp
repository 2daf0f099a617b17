#include "core/aircraft/glide_model.h"
#include "core/formats/aircraft_file.h"
#include "tests/core/formats/format_samples.h"

#include <QTest>

#include <cmath>
#include <tuple>

using namespace vp;
using namespace vp::formats;
using samples::Folder;

namespace {

std::string elaspText() {
  return samples::readBytes(std::string(VOLPLANE_SOURCE_DIR) + "/resources/aircraft/cessna172-elasp.json");
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = elaspText();
  const std::size_t at = text.find(from);
  return at == std::string::npos ? "TEXT NOT FOUND" : text.replace(at, from.size(), to);
}

}  // namespace

class TestAircraftFile : public QObject {
  Q_OBJECT
  Folder folder_;

private slots:
  void written_readsBackTheSame() {
    for (const std::string& name : bundledAircraft()) {
      const auto profile = findAircraft(name, "");
      QVERIFY(profile);
      const std::string path = folder_.path(name + ".json");
      QVERIFY(writeAircraft(*profile, path));
      const auto again = readAircraft(path);
      QVERIFY2(again, again ? "" : again.error().message().c_str());
      QCOMPARE(aircraftToText(*again), aircraftToText(*profile));
      QCOMPARE(again->id, profile->id);
      QVERIFY(again->glideBanks == profile->glideBanks);
    }
  }

  void written_withEveryField_readsBackTheSame() {
    aircraft::AircraftProfile profile = samples::sampleAircraft();
    const auto back = parseAircraft(aircraftToText(profile), "test.json");
    QVERIFY2(back, back ? "" : back.error().message().c_str());
    QVERIFY(*back == profile);
    profile.powerSettings.front().unit = profile.powerSettings.back().unit = aircraft::PowerSetting::Unit::WattHours;
    QVERIFY(parseAircraft(aircraftToText(profile), "test.json")->powerSettings == profile.powerSettings);
  }

  void elasp_isTable1OfThePaper() {
    const auto profile = findAircraft("cessna172-elasp", "");
    QVERIFY2(profile, profile ? "" : profile.error().message().c_str());
    QCOMPARE(profile->mass_kg, 1000.0);
    QCOMPARE(profile->wingArea_m2, 16.2);
    QCOMPARE(profile->zeroLiftDrag, 0.0341);
    QCOMPARE(profile->inducedDrag, 0.053);
    QCOMPARE(profile->bestGlideSpeed.si(), 33.4);
    QCOMPARE(profile->maxBank().degrees(), 60.0);
    QCOMPARE(profile->tourBank.degrees(), 60.0);
    QCOMPARE(profile->maxClimb.degrees(), 30.0);
    QCOMPARE(profile->maxDescent.degrees(), 20.0);
    const aircraft::GlideModel model(*profile);
    QVERIFY(std::abs(model.minRadius() - 65.7) < 0.05);                                         // Table 1
    QVERIFY(std::abs(Angle::radians(std::atan(model.straightLoss())).degrees() - 4.9) < 0.01);  // section 8
    QCOMPARE(aircraft::profileWarnings(*profile).size(), std::size_t{1});                       // stalls at 60 degrees
  }

  void operational_needsNoWarning() {
    const auto profile = findAircraft("cessna172-operational", "");
    QVERIFY2(profile, profile ? "" : profile.error().message().c_str());
    QVERIFY(aircraft::profileWarnings(*profile).empty());
    QVERIFY(profile->maxBank().degrees() <= 45.001);
    QVERIFY(profile->ceiling && std::abs(profile->ceiling->feet() - 13500.0) < 1e-6);
    QVERIFY(profile->sources.size() >= 6);
  }

  void handbook_glidesAsTheHandbookSays() {
    // Cessna 172N handbook: 9 : 1 at 65 kt, flaps up, propeller windmilling; stall 50 kt, in a turn times the root of the load factor
    const auto profile = findAircraft("cessna172-handbook", "");
    QVERIFY2(profile, profile ? "" : profile.error().message().c_str());
    QVERIFY(aircraft::profileWarnings(*profile).empty());
    const aircraft::GlideModel model(*profile);
    QVERIFY(std::abs(1.0 / model.straightLoss() - 9.0) < 0.05 * 9.0);
    QVERIFY(std::abs(profile->bestGlideSpeed.si() / kMpsPerKnot - 65.0) < 0.1);
    for (const double faster : {0.9, 1.1}) {  // it is the best speed
      aircraft::AircraftProfile other = *profile;
      other.bestGlideSpeed = Speed::fromSi(faster * profile->bestGlideSpeed.si());
      QVERIFY(aircraft::GlideModel(other).straightLoss() > model.straightLoss());
    }
    aircraft::AircraftProfile steep = *profile;
    steep.glideBanks = {Angle::degrees(52.0)};  // 50 kt * sqrt(1 / cos 52) = 63.7 kt
    QVERIFY(aircraft::profileWarnings(steep).empty());
    steep.glideBanks = {Angle::degrees(55.0)};  // 66.0 kt
    QCOMPARE(aircraft::profileWarnings(steep).size(), std::size_t{1});
  }

  void handbook_stallsInTurnsAsTheHandbookSays_data() {
    QTest::addColumn<double>("bank");
    QTest::addColumn<double>("knots");
    // Cessna 172N handbook, section 5, stall speeds: flaps up, KCAS at 2300 lb
    QTest::newRow("level") << 0.0 << 50.0;
    QTest::newRow("30 degrees") << 30.0 << 54.0;
    QTest::newRow("45 degrees") << 45.0 << 59.0;
    QTest::newRow("60 degrees") << 60.0 << 71.0;
  }
  void handbook_stallsInTurnsAsTheHandbookSays() {
    QFETCH(double, bank);
    QFETCH(double, knots);
    const auto profile = findAircraft("cessna172-handbook", "");
    const double loadFactor = 1.0 / cos(Angle::degrees(bank));
    QVERIFY(std::abs(profile->stallSpeed->si() / kMpsPerKnot * std::sqrt(loadFactor) / knots - 1.0) < 0.05);
    aircraft::AircraftProfile turning = *profile;  // the same limit as the warning of a bank angle has
    turning.glideBanks = {Angle::degrees(bank + 1e-9)};
    turning.tourBank = turning.glideBanks.front();
    turning.bestGlideSpeed = Speed::fromSi(0.95 * knots * kMpsPerKnot);
    QCOMPARE(aircraft::profileWarnings(turning).size(), std::size_t{1});
    turning.bestGlideSpeed = Speed::fromSi(1.05 * knots * kMpsPerKnot);
    QVERIFY(aircraft::profileWarnings(turning).empty());
  }

  void handbook_hasTheHandbooksFigures() {
    const auto profile = findAircraft("cessna172-handbook", "");
    QVERIFY(std::abs(profile->landingDistance->si() / kMetresPerFoot - 1250.0) < 0.1);  // section 1
    QVERIFY(std::abs(profile->climbRate->si() * 60.0 / kMetresPerFoot - 770.0) < 0.1);
    QVERIFY(std::abs(profile->serviceCeiling->feet() - 14200.0) < 0.1);
    QVERIFY(std::abs(*profile->usableEnergy / 3.785411784 - 40.0) < 0.01);
    QVERIFY(std::abs(profile->maxSpeed->si() / kMpsPerKnot - 158.0) < 0.01);  // KCAS, section 2
    QCOMPARE(profile->powerSettings.size(), std::size_t{3});
    for (const auto& [index, knots, milesPerGallon] : {std::tuple(0, 122.0, 14.5), std::tuple(1, 115.0, 15.8), std::tuple(2, 106.0, 17.1)}) {
      const aircraft::PowerSetting& power = profile->powerSettings[static_cast<std::size_t>(index)];
      QVERIFY(std::abs(power.trueAirspeed.si() / kMpsPerKnot - knots) < 0.01);
      QVERIFY(std::abs(power.perHour / 3.785411784 - knots / milesPerGallon) < 0.02);
    }
    aircraft::GlideConditions conditions;
    conditions.propeller = aircraft::Propeller::Windmilling;
    QVERIFY(std::abs(1.0 / aircraft::GlideModel(*profile, conditions).straightLoss() - 9.0) < 0.06);
    conditions.propeller = aircraft::Propeller::Stopped;
    QVERIFY(std::abs(1.0 / aircraft::GlideModel(*profile, conditions).straightLoss() / 9.0 - 1.083) < 0.005);
    const aircraft::SpeedRange speeds = aircraft::glideSpeeds(*profile, std::nullopt);
    QVERIFY(std::abs(speeds.most / kMpsPerKnot - 65.0) < 0.1 && std::abs(speeds.least / kMpsPerKnot - 52.5) < 0.1);
  }

  void profiles_sayWhatTheyLack() {
    for (const std::string& name : bundledAircraft()) {
      const auto profile = findAircraft(name, "");
      QVERIFY(profile->steepestDescent.has_value() == (name == "cessna182-gradient"));  // no public figure was found for any other
      QVERIFY2(name == "cessna172-handbook" || (!profile->windmillingDrag && !profile->stoppedDrag && profile->powerSettings.empty()), name.c_str());
    }
  }

  /// 60 degrees in 4 s (14 CFR 23.157 (c) (1)), 90 degrees in a third of the span in metres (CS 22.147).
  void rollRates_areThoseOfTheRulesThatCertifiedThem() {
    QCOMPARE(findAircraft("cessna172-handbook", "")->rollRate_dps, std::optional<double>(15.0));
    QCOMPARE(findAircraft("cessna182-gradient", "")->rollRate_dps, std::optional<double>(15.0));
    const double reversal = 16.33 / 3.0;  // s
    QVERIFY(std::abs(*findAircraft("motorglider-hk36", "")->rollRate_dps - 90.0 / reversal) < 0.05);
    for (const char* name : {"cessna172-elasp", "cessna172-operational", "uav-aerosonde"}) {
      QVERIFY2(!findAircraft(name, "")->rollRate_dps, name);
    }
  }

  void otherProfiles_glideAsTheirSourcesSay() {
    const auto angleOf = [](const char* name) {
      const auto profile = findAircraft(name, "");
      return profile ? Angle::radians(std::atan(aircraft::GlideModel(*profile).straightLoss())).degrees() : 0.0;
    };
    QVERIFY(std::abs(angleOf("cessna182-gradient") / 4.4 - 1.0) < 0.03);  // [3] section 6.2
    // [3] (5): 4.4 degrees, as printed, is half-way between best glide and steepest descent
    const double steepest = findAircraft("cessna182-gradient", "")->steepestDescent->degrees();
    QVERIFY(std::abs(0.5 * (angleOf("cessna182-gradient") + steepest) - 4.4) < 0.05);
    QVERIFY(std::abs(1.0 / std::tan(Angle::degrees(angleOf("motorglider-hk36")).radians()) / 27.0 - 1.0) < 0.01);
    QVERIFY(std::abs(1.0 / std::tan(Angle::degrees(angleOf("uav-aerosonde")).radians()) / 14.8 - 1.0) < 0.01);
  }

  void bundled_areFoundAndListed() {
    QCOMPARE(bundledAircraft(), (std::vector<std::string>{"cessna172-elasp", "cessna172-handbook", "cessna172-operational", "cessna182-gradient",
                                                          "motorglider-hk36", "uav-aerosonde"}));
    QVERIFY(resourceFolders().size() >= 2);
  }

  void resources_ofTheEnvironmentComeFirst() {
    std::filesystem::create_directories(folder_.path("aircraft"));
    folder_.write("aircraft/cessna172-elasp.json", with("Cessna 172 (ELASP paper)", "Mine"));
    qputenv("VOLPLANE_RESOURCES", QByteArray::fromStdString(folder_.path()));
    const auto profile = findAircraft("cessna172-elasp", "");
    qunsetenv("VOLPLANE_RESOURCES");
    QVERIFY(profile);
    QCOMPARE(profile->name, std::string("Mine"));
  }

  void read_ofBadProfile_namesField_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<int>("code");
    QTest::addColumn<QStringList>("parts");
    const auto row = [](const char* name, const char* from, const char* to, Errc code, const QStringList& parts) {
      QTest::newRow(name) << QString(from) << QString(to) << static_cast<int>(code) << parts;
    };
    row("mass", "\"mass_kg\": 1000", "\"mass_kg\": 0", Errc::OutOfRange, {"line 5", "/mass_kg", "more than 0 and at most 600000 kg", "not 0"});
    row("mass text", "\"mass_kg\": 1000", "\"mass_kg\": \"1 t\"", Errc::BadFormat, {"/mass_kg", "must be a number", "\"1 t\""});
    row("missing", "  \"wingArea_m2\": 16.2,\n", "", Errc::BadFormat, {"\"wingArea_m2\" is missing"});
    row("unknown", "wingArea_m2", "wingarea_m2", Errc::BadFormat, {"\"wingArea_m2\" is missing; is \"wingarea_m2\" meant?"});
    row("polar", "0.0341", "-0.03", Errc::OutOfRange, {"/zeroLiftDrag"});
    row("density", "1.225", "12.25", Errc::OutOfRange, {"/airDensity_kgm3", "0.1 to 1.6 kg/m3"});
    row("speed", "33.4,", "334,", Errc::OutOfRange, {"/bestGlideSpeed_mps", "1 to 200 m/s"});
    row("bank", "[30, 45, 53, 60]", "[30, 95]", Errc::OutOfRange, {"/glideBanks_deg/1", "at most 80 degrees", "not 95"});
    row("no bank", "[30, 45, 53, 60]", "[]", Errc::OutOfRange, {"/glideBanks_deg", "at least one bank angle"});
    row("bank order", "[30, 45, 53, 60]", "[45, 30]", Errc::OutOfRange, {"/glideBanks_deg", "ascend"});
    row("tour bank", "\"tourBank_deg\": 60", "\"tourBank_deg\": 0", Errc::OutOfRange, {"/tourBank_deg", "more than 0"});
    row("climb", "\"maxClimb_deg\": 30", "\"maxClimb_deg\": 50", Errc::OutOfRange, {"/maxClimb_deg"});
    row("descent", "\"maxDescent_deg\": 20", "\"maxDescent_deg\": -20", Errc::OutOfRange, {"/maxDescent_deg"});
    row("stall", "25.4,", "33.4,", Errc::OutOfRange, {"/stallSpeed_mps", "below bestGlideSpeed_mps"});
    row("load", "3.8,", "0.5,", Errc::OutOfRange, {"/maxLoadFactor"});
    row("no glide", "0.0341", "0.95", Errc::OutOfRange, {"/bestGlideSpeed_mps", "no glide exists"});
    row("no glide in turn", "[30, 45, 53, 60]", "[30, 79]", Errc::OutOfRange,
        {"/glideBanks_deg", "at 79.0 degrees of bank", "leave this bank angle out"});
    const auto adding = [&row](const char* name, const char* members, const QStringList& parts) {
      row(name, "\"sources\"", (std::string(members) + ", \"sources\"").c_str(), Errc::OutOfRange, parts);
    };
    adding("least mass", "\"leastMass_kg\": 1001", {"/leastMass_kg", "1001 kg is above the mass of the polar, 1000 kg"});
    adding("most mass", "\"mostMass_kg\": 999", {"/mostMass_kg", "999 kg is below the mass of the polar, 1000 kg"});
    adding("windmilling", "\"windmillingDrag\": -0.05", {"/windmillingDrag", "more than 0"});
    adding("windmilling, no glide", "\"windmillingDrag\": 0.9", {"/windmillingDrag", "propeller windmilling drag exceeds weight"});
    adding("stopped, no glide", "\"stoppedDrag\": 0.9", {"/stoppedDrag", "propeller stopped drag exceeds weight"});
    adding("max speed", "\"maxSpeed_mps\": 33.4", {"/maxSpeed_mps", "33.4 m/s, is not above the speed of best glide, 33.4 m/s"});
    adding("steepest descent", "\"steepestDescent_deg\": 4.8", {"/steepestDescent_deg", "4.80 degrees is shallower than the glide, 4.90 degrees"});
    adding("rate of roll", "\"rollRate_dps\": 0", {"/rollRate_dps", "must be 1 to 360 degrees per second, not 0"});
    adding("landing distance", "\"landingDistance_m\": 0", {"/landingDistance_m", "more than 0 and at most 10000 m"});
    adding("climb", "\"climbRate_mps\": 0", {"/climbRate_mps", "more than 0"});
    adding(
        "power twice",
        R"("powerSettings": [{"name":"a","trueAirspeed_mps":40,"perHour":1,"unit":"l"},{"name":"a","trueAirspeed_mps":50,"perHour":1,"unit":"l"}])",
        {"/powerSettings/1/name", "\"a\" is given twice"});
    adding(
        "power units",
        R"("powerSettings": [{"name":"a","trueAirspeed_mps":40,"perHour":1,"unit":"l"},{"name":"b","trueAirspeed_mps":50,"perHour":1,"unit":"kg"}])",
        {"/powerSettings/1/unit", "the same unit"});
    adding("power stalls", R"("powerSettings": [{"name":"slow","trueAirspeed_mps":25.4,"perHour":1,"unit":"l"}])",
           {"/powerSettings/0/trueAirspeed_mps", "the airspeed of \"slow\", 25.4 m/s, is not above the stall speed of 25.4 m/s"});
    adding("power too fast", R"("maxSpeed_mps": 60, "powerSettings": [{"name":"fast","trueAirspeed_mps":61,"perHour":1,"unit":"l"}])",
           {"/powerSettings/0/trueAirspeed_mps", "61 m/s, is above the speed never to be exceeded, 60 m/s"});
    adding("fuel alone", "\"usableEnergy\": 100", {"/usableEnergy", "power settings"});
    row("newer", "\"version\": 1", "\"version\": 3", Errc::NewerVersion, {"/version", "update Volplane"});
    row("format", "volplane-aircraft", "volplane", Errc::BadFormat, {"/format", "not a volplane-aircraft file"});
    row("both units", "\"tourBank_deg\": 60", "\"tourBank_deg\": 60, \"tourBank_rad\": 1", Errc::BadFormat, {"/tourBank_rad", "keep one of them"});
  }
  void read_ofBadProfile_namesField() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(int, code);
    QFETCH(QStringList, parts);
    const auto profile = readAircraft(folder_.write("bad.json", with(from.toStdString(), to.toStdString())));
    QVERIFY(!profile);
    const std::string message = profile.error().message();
    QVERIFY2(static_cast<int>(profile.error().code) == code, message.c_str());
    VP_CONTAINS(message, {"bad.json"});
    for (const QString& part : parts) {
      VP_CONTAINS(message, {part.toStdString()});
    }
  }
};

QTEST_APPLESS_MAIN(TestAircraftFile)
#include "tst_aircraft_file.moc"
