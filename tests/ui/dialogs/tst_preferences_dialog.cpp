// Preferences and mission settings: what is told at once, what stays bit for bit, what each scope leaves alone.
#include "ui/dialogs/mission_settings_dialog.h"
#include "ui/dialogs/preferences_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTabWidget>
#include <QTest>

#include <cmath>
#include <functional>

using namespace vp;
using dialogs::MissionSettingsDialog;
using dialogs::Preferences;
using dialogs::PreferencesDialog;

namespace {

template <typename Widget>
Widget& field(QDialog& dialog, const char* name) {
  auto* found = dialog.findChild<Widget*>(QLatin1String(name));
  if (found == nullptr) {
    qFatal("no field %s", name);
  }
  return *found;
}

void chooseData(QComboBox& box, int data) {
  box.setCurrentIndex(box.findData(data));
}

/// Values that no rounding to whole feet can bring back.
Preferences oddPreferences() {
  Preferences preferences;
  preferences.newMissions.safety.clearance = Length::fromSi(123.4567);
  preferences.newMissions.safety.arrivalMargin = Length::fromSi(33.3);
  preferences.newMissions.safety.reactionTime = Duration::fromSi(4.44);
  preferences.newMissions.safety.reactionLoss = Length::fromSi(17.7);
  preferences.newMissions.safety.dragFactor = 1.0333;
  preferences.newMissions.planner.beta = 2.345;
  preferences.newMissions.planner.step = Length::fromSi(47.25);
  return preferences;
}

aircraft::AircraftProfile skyhawk() {
  aircraft::AircraftProfile profile;
  profile.name = "Skyhawk";
  profile.bestGlideSpeed = Speed::fromSi(33.4);
  profile.windmillingDrag = 0.05;
  profile.stoppedDrag = 0.04;
  profile.steepestDescent = Angle::degrees(8.0);
  profile.powerSettings = {{"65 %", Speed::fromSi(59.2), 27.6, aircraft::PowerSetting::Unit::Litres},
                           {"55 %", Speed::fromSi(54.5), 23.5, aircraft::PowerSetting::Unit::Litres}};
  return profile;
}

}  // namespace

class TestPreferencesDialog : public QObject {
  Q_OBJECT

private slots:
  void opened_changesNothing() {
    PreferencesDialog dialog(oddPreferences(), QStringLiteral("Alps"));
    const QSignalSpy told(&dialog, &PreferencesDialog::changed);
    dialog.show();
    QVERIFY(dialog.preferences() == oddPreferences());
    QCOMPARE(told.count(), 0);
  }

  void everyField_toldAtOnce_data() {
    using Change = std::function<void(PreferencesDialog&)>;
    using Check = std::function<bool(const Preferences&)>;
    QTest::addColumn<Change>("change");
    QTest::addColumn<Check>("check");
    const auto row = [](const char* name, const Change& change, const Check& check) { QTest::newRow(name) << change << check; };
    row(
        "units", [](PreferencesDialog& d) { chooseData(field<QComboBox>(d, "units"), static_cast<int>(style::UnitSystem::Metric)); },
        [](const Preferences& p) { return p.units == style::UnitSystem::Metric; });
    row(
        "dark", [](PreferencesDialog& d) { chooseData(field<QComboBox>(d, "theme"), static_cast<int>(style::Theme::Dark)); },
        [](const Preferences& p) { return p.theme == style::Theme::Dark; });
    row(
        "language", [](PreferencesDialog& d) { field<QComboBox>(d, "language").setCurrentText(QStringLiteral("Deutsch")); },
        [](const Preferences& p) { return p.language == QStringLiteral("de"); });
    row(
        "clearance", [](PreferencesDialog& d) { field<QDoubleSpinBox>(d, "clearance").setValue(500.0); },
        [](const Preferences& p) { return std::abs(p.newMissions.safety.clearance.si() - 500.0 * kMetresPerFoot) < 1e-9; });
    row(
        "arrival", [](PreferencesDialog& d) { field<QDoubleSpinBox>(d, "arrivalMargin").setValue(300.0); },
        [](const Preferences& p) { return std::abs(p.newMissions.safety.arrivalMargin.si() - 300.0 * kMetresPerFoot) < 1e-9; });
    row(
        "reaction", [](PreferencesDialog& d) { field<QDoubleSpinBox>(d, "reactionTime").setValue(6.5); },
        [](const Preferences& p) { return p.newMissions.safety.reactionTime.si() == 6.5; });
    row(
        "reaction loss", [](PreferencesDialog& d) { field<QDoubleSpinBox>(d, "reactionLoss").setValue(100.0); },
        [](const Preferences& p) { return std::abs(p.newMissions.safety.reactionLoss.si() - 30.48) < 1e-9; });
    row(
        "drag", [](PreferencesDialog& d) { field<QDoubleSpinBox>(d, "dragFactor").setValue(1.2); },
        [](const Preferences& p) { return std::abs(p.newMissions.safety.dragFactor - 1.2) < 1e-12; });
    row(
        "low targets", [](PreferencesDialog& d) { chooseData(field<QComboBox>(d, "lowTargets"), static_cast<int>(mission::LowTargets::Descend)); },
        [](const Preferences& p) { return p.newMissions.planner.lowTargets == mission::LowTargets::Descend; });
    row(
        "headings", [](PreferencesDialog& d) { field<QSpinBox>(d, "headings").setValue(12); },
        [](const Preferences& p) { return p.newMissions.planner.headings == 12; });
    row(
        "step", [](PreferencesDialog& d) { field<QDoubleSpinBox>(d, "step").setValue(80.0); },
        [](const Preferences& p) { return p.newMissions.planner.step.si() == 80.0; });
    row(
        "beta", [](PreferencesDialog& d) { field<QDoubleSpinBox>(d, "beta").setValue(5.0); },
        [](const Preferences& p) { return p.newMissions.planner.beta == 5.0; });
    row(
        "method", [](PreferencesDialog& d) { chooseData(field<QComboBox>(d, "method"), static_cast<int>(mission::Method::Base)); },
        [](const Preferences& p) { return p.newMissions.planner.method == mission::Method::Base; });
    row(
        "samples", [](PreferencesDialog& d) { field<QCheckBox>(d, "hasSamples").click(); },
        [](const Preferences& p) { return p.newMissions.planner.roadmapSamples.has_value(); });
    row(
        "seed", [](PreferencesDialog& d) { field<QSpinBox>(d, "seed").setValue(7); },
        [](const Preferences& p) { return p.newMissions.planner.seed == 7U; });
    row(
        "exaggeration", [](PreferencesDialog& d) { field<QDoubleSpinBox>(d, "exaggeration").setValue(2.0); },
        [](const Preferences& p) { return p.scene.verticalExaggeration == 2.0; });
    row(
        "curtain", [](PreferencesDialog& d) { field<QCheckBox>(d, "curtain").click(); }, [](const Preferences& p) { return !p.scene.curtain; });
    row(
        "all glides", [](PreferencesDialog& d) { field<QCheckBox>(d, "allGlides").click(); }, [](const Preferences& p) { return p.scene.allGlides; });
    row(
        "runways", [](PreferencesDialog& d) { field<QCheckBox>(d, "runways").click(); }, [](const Preferences& p) { return !p.scene.runways; });
    row(
        "excluded", [](PreferencesDialog& d) { field<QCheckBox>(d, "excludedRunways").click(); },
        [](const Preferences& p) { return !p.scene.excludedRunways; });
    row(
        "names", [](PreferencesDialog& d) { field<QCheckBox>(d, "labels").click(); }, [](const Preferences& p) { return !p.scene.labels; });
  }
  void everyField_toldAtOnce() {
    QFETCH(std::function<void(PreferencesDialog&)>, change);
    QFETCH(std::function<bool(const Preferences&)>, check);
    PreferencesDialog dialog(Preferences{}, QStringLiteral("Alps"));
    QSignalSpy told(&dialog, &PreferencesDialog::changed);
    change(dialog);
    QCOMPARE(told.count(), 1);
    QVERIFY(check(told.front().front().value<Preferences>()));
    QVERIFY(dialog.preferences() == told.front().front().value<Preferences>());
  }

  void otherUnits_leaveUntouchedValuesBitForBit() {
    PreferencesDialog dialog(oddPreferences(), QStringLiteral("Alps"));
    chooseData(field<QComboBox>(dialog, "units"), static_cast<int>(style::UnitSystem::Metric));
    QVERIFY2(field<QDoubleSpinBox>(dialog, "clearance").text().contains(QStringLiteral("123 m")), "shown in the new units");
    chooseData(field<QComboBox>(dialog, "units"), static_cast<int>(style::UnitSystem::Aviation));
    field<QSpinBox>(dialog, "headings").setValue(5);
    Preferences expected = oddPreferences();
    expected.newMissions.planner.headings = 5;
    QVERIFY(dialog.preferences() == expected);
  }

  void restore_touchesOnlyThePageThatIsShown() {
    Preferences start = oddPreferences();
    start.units = style::UnitSystem::Metric;
    start.newMissions.planner.headings = 3;
    start.newMissions.planner.lowTargets = mission::LowTargets::Descend;
    start.scene.curtain = false;
    PreferencesDialog dialog(start, QStringLiteral("Alps"));
    auto& tabs = field<QTabWidget>(dialog, "preferencePages");
    auto& restore = field<QPushButton>(dialog, "restorePage");
    tabs.setCurrentIndex(1);
    restore.click();
    Preferences expected = start;
    expected.newMissions.safety = {};
    expected.newMissions.safety.reactionTime = Duration::fromSi(4.0);  // FAA-H-8083-3
    expected.newMissions.planner.lowTargets = mission::LowTargets::PassAbove;
    QVERIFY(dialog.preferences() == expected);
    tabs.setCurrentIndex(2);
    restore.click();
    expected.newMissions.planner = {};
    QVERIFY(dialog.preferences() == expected);
    tabs.setCurrentIndex(3);
    restore.click();
    expected.scene = {};
    QVERIFY(dialog.preferences() == expected);
    tabs.setCurrentIndex(0);
    restore.click();
    QVERIFY(dialog.preferences() == Preferences{});
  }

  void newMissionPages_sayThatTheOpenMissionKeepsItsOwn() {
    PreferencesDialog dialog(Preferences{}, QStringLiteral("Alps"));
    int sentences = 0;
    for (const QLabel* label : dialog.findChildren<QLabel*>()) {
      sentences += label->text().contains(QStringLiteral("“Alps”, keeps its own")) ? 1 : 0;
    }
    QCOMPARE(sentences, 2);
    const QSignalSpy led(&dialog, &PreferencesDialog::missionSettingsRequested);
    field<QPushButton>(dialog, "openMissionSettings").click();
    QCOMPARE(led.count(), 1);
    QVERIFY2(dialog.findChild<QWidget*>(QStringLiteral("ceiling")) == nullptr, "a ceiling belongs to one mission");
  }

  void everyField_isNamedAndExplained() {
    PreferencesDialog dialog(Preferences{}, QStringLiteral("Alps"));
    for (const char* name : {"units",      "theme",        "language", "clearance", "arrivalMargin", "reactionTime",    "reactionLoss",
                             "dragFactor", "lowTargets",   "headings", "step",      "beta",          "method",          "hasSamples",
                             "seed",       "exaggeration", "curtain",  "allGlides", "runways",       "excludedRunways", "labels"}) {
      const auto* widget = dialog.findChild<QWidget*>(QLatin1String(name));
      QVERIFY2(widget != nullptr, name);
      QVERIFY2(!widget->accessibleName().isEmpty() && !widget->accessibleName().contains(QLatin1Char('&')), name);
      QVERIFY2(widget->accessibleDescription().size() > 20, name);
      QVERIFY2(widget->focusPolicy() & Qt::TabFocus, name);
    }
  }

  void missionSettings_untouched_giveTheMissionBack() {
    mission::Mission mission;
    mission.name = "Alps";
    mission.safety = oddPreferences().newMissions.safety;
    mission.planner = oddPreferences().newMissions.planner;
    mission.planner.seed = 0xFFFFFFFFFFFFFFFFULL;
    mission.ceiling = geo::HeightMsl::fromMetres(3333.3);
    mission.aircraft = skyhawk();
    mission.atmosphere = air::Atmosphere{-7.3, 1013.25};
    mission.approach = {
        mission::ApproachKind::Straight, Length::fromSi(1234.5), Angle::degrees(4.44), 1.0 / 30.0, Length::fromSi(33.3), Length::fromSi(222.2), true};
    mission.propeller = aircraft::Propeller::Stopped;
    mission.powerSetting = "65 %";
    MissionSettingsDialog dialog(mission, {}, style::Units());
    dialog.show();
    const mission::Mission result = dialog.result();
    QVERIFY(result.safety == mission.safety);
    QVERIFY(result.planner == mission.planner);
    QVERIFY(result.ceiling == mission.ceiling);
    QVERIFY(result.atmosphere == mission.atmosphere && result.approach == mission.approach);
    QVERIFY(result.propeller == mission.propeller && result.powerSetting == mission.powerSetting);
    MissionSettingsDialog plain(mission::Mission(), {}, style::Units());
    const mission::Mission same = plain.result();
    QVERIFY(!same.atmosphere && same.approach == mission::ApproachSettings() && same.powerSetting.empty());
    field<QCheckBox>(dialog, "hasCeiling").setChecked(false);
    field<QDoubleSpinBox>(dialog, "clearance").setValue(1000.0);
    QVERIFY(!dialog.result().ceiling);
    QVERIFY(std::abs(dialog.result().safety.clearance.si() - 304.8) < 1e-9);
  }

  void airEngineAndApproach_chosen_areInTheResult() {
    mission::Mission mission;
    mission.aircraft = skyhawk();
    MissionSettingsDialog dialog(mission, {}, style::Units());
    field<QCheckBox>(dialog, "hasAir").click();
    field<QDoubleSpinBox>(dialog, "temperatureOffset").setValue(-15.0);
    field<QDoubleSpinBox>(dialog, "qnh").setValue(1005.0);
    chooseData(field<QComboBox>(dialog, "propeller"), static_cast<int>(aircraft::Propeller::Stopped));
    field<QComboBox>(dialog, "power").setCurrentIndex(2);
    chooseData(field<QComboBox>(dialog, "approachKind"), static_cast<int>(mission::ApproachKind::Straight));
    field<QDoubleSpinBox>(dialog, "finalLength").setValue(1.0);
    field<QCheckBox>(dialog, "hasSlope").click();
    field<QDoubleSpinBox>(dialog, "slope").setValue(6.0);
    field<QCheckBox>(dialog, "hasSurface").click();
    field<QDoubleSpinBox>(dialog, "surfaceStart").setValue(100.0);
    field<QCheckBox>(dialog, "hold").click();
    const mission::Mission made = dialog.result();
    QVERIFY(made.atmosphere == std::optional(air::Atmosphere{-15.0, 1005.0}));
    QVERIFY(made.propeller == aircraft::Propeller::Stopped);
    QCOMPARE(made.powerSetting, std::string("55 %"));
    QVERIFY(made.approach.kind == mission::ApproachKind::Straight && std::abs(made.approach.finalLength.si() - 1852.0) < 1e-9);
    QVERIFY(made.approach.slope && std::abs(made.approach.slope->degrees() - 6.0) < 1e-9 && made.approach.hold);
    QVERIFY(made.approach.surfaceSlope == std::optional(0.05) && std::abs(made.approach.surfaceStart.si() - 30.48) < 1e-9);
    chooseData(field<QComboBox>(dialog, "approachKind"), static_cast<int>(mission::ApproachKind::Overhead));
    QVERIFY(!field<QWidget>(dialog, "slope").isEnabled() && !field<QWidget>(dialog, "finalLength").isEnabled());
    field<QCheckBox>(dialog, "hasKey").click();
    field<QDoubleSpinBox>(dialog, "keyHeight").setValue(1500.0);
    QVERIFY(std::abs(dialog.result().approach.keyHeight->si() - 457.2) < 1e-9);
    field<QCheckBox>(dialog, "hasAir").click();
    QVERIFY(!dialog.result().atmosphere);
  }

  void whatTheAircraftSaysNothingOf_cannotBeChosen() {
    mission::Mission mission;
    mission.aircraft = skyhawk();
    mission.aircraft.stoppedDrag.reset();
    mission.aircraft.steepestDescent.reset();
    mission.aircraft.powerSettings.clear();
    mission.powerSetting = "65 %";
    MissionSettingsDialog dialog(mission, {}, style::Units());
    auto& propeller = field<QComboBox>(dialog, "propeller");
    const auto isEnabled = [&](aircraft::Propeller which) {
      return (propeller.model()->flags(propeller.model()->index(propeller.findData(static_cast<int>(which)), 0)) & Qt::ItemIsEnabled) != 0;
    };
    QVERIFY(isEnabled(aircraft::Propeller::Windmilling) && !isEnabled(aircraft::Propeller::Stopped));
    chooseData(field<QComboBox>(dialog, "approachKind"), static_cast<int>(mission::ApproachKind::Straight));
    QVERIFY(!field<QWidget>(dialog, "hasSlope").isEnabled());
    QVERIFY(field<QComboBox>(dialog, "power").currentText().contains(QStringLiteral("which the aircraft lacks")));
    QCOMPARE(dialog.result().powerSetting, std::string("65 %"));
  }

  void missionSettings_fitASmallScreen() {
    mission::Mission mission;
    mission.aircraft = skyhawk();
    MissionSettingsDialog dialog(mission, {QStringLiteral("LSZS/21")}, style::Units());
    dialog.show();
    QVERIFY2(dialog.sizeHint().height() <= 700 && dialog.sizeHint().width() <= 1000, qPrintable(QString::number(dialog.sizeHint().height())));
    auto* tabs = dialog.findChild<QTabWidget*>();
    QVERIFY(tabs != nullptr && tabs->count() >= 3);
    for (int i = 0; i < tabs->count(); ++i) {
      tabs->setCurrentIndex(i);
      if (const QString folder = qEnvironmentVariable("VOLPLANE_TEST_PICTURES"); !folder.isEmpty()) {
        dialog.grab().save(QStringLiteral("%1/mission-settings-%2.png").arg(folder).arg(i));
      }
    }
  }

  void everyFieldOfTheMissionSettings_isNamedAndExplained() {
    MissionSettingsDialog dialog(mission::Mission(), {}, style::Units());
    for (const char* name : {"hasAir", "propeller", "power", "approachKind", "finalLength", "hasSlope", "hasKey", "hasSurface", "hold"}) {
      const auto* widget = dialog.findChild<QWidget*>(QLatin1String(name));
      QVERIFY2(widget != nullptr, name);
      QVERIFY2(!widget->accessibleName().isEmpty() && !widget->accessibleName().contains(QLatin1Char('&')), name);
      QVERIFY2(widget->accessibleDescription().size() > 20, name);
    }
    for (const char* name : {"temperatureOffset", "qnh", "slope", "keyHeight", "surfaceSlope", "surfaceStart"}) {
      QVERIFY2(!field<QWidget>(dialog, name).accessibleName().isEmpty(), name);
    }
    dialog.resize(640, 620);
    dialog.show();
    QVERIFY2(dialog.width() <= 1024 && dialog.minimumSizeHint().height() <= 700, "fits a screen of 1024 by 768");
  }

  void homeRunway_chosenInTheMissionSettings_isInTheResult() {
    mission::Mission mission;
    {
      MissionSettingsDialog dialog(mission, {QStringLiteral("LSZA/01"), QStringLiteral("LSZS/21")}, style::Units());
      auto* takeoff = dialog.findChild<QComboBox*>(QStringLiteral("homeTakeoff"));
      auto* landing = dialog.findChild<QComboBox*>(QStringLiteral("homeLanding"));
      QVERIFY(!dialog.result().home && !landing->isEnabled());
      takeoff->setCurrentText(QStringLiteral("LSZS/21"));
      QCOMPARE(dialog.result().home, std::optional(mission::HomeBase{"LSZS/21", "LSZS/21"}));
      landing->setCurrentText(QStringLiteral("LSZA/01"));
      QCOMPARE(dialog.result().home, std::optional(mission::HomeBase{"LSZS/21", "LSZA/01"}));
    }
    mission.home = mission::HomeBase{"GONE/09", "LSZA/01"};
    MissionSettingsDialog dialog(mission, {QStringLiteral("LSZA/01")}, style::Units());
    QCOMPARE(dialog.result().home, mission.home);  // a runway that is not usable now is not forgotten
    dialog.findChild<QComboBox*>(QStringLiteral("homeTakeoff"))->setCurrentIndex(0);
    QVERIFY(!dialog.result().home);
  }
};

QTEST_MAIN(TestPreferencesDialog)
#include "tst_preferences_dialog.moc"
