// What is remembered between starts.
#include "ui/document/settings.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace vp;
using document::Settings;

namespace {

document::MissionDefaults oddDefaults() {
  document::MissionDefaults defaults;
  defaults.safety.clearance = Length::fromSi(123.456789012345);
  defaults.safety.arrivalMargin = Length::fromSi(0.1);
  defaults.planner.headings = 5;
  defaults.planner.step = Length::fromSi(33.3);
  defaults.planner.beta = 2.7;
  defaults.planner.method = mission::Method::Base;
  defaults.planner.lowTargets = mission::LowTargets::Descend;
  defaults.planner.roadmap = mission::RoadmapKind::RrtStar;
  defaults.planner.roadmapSamples = 1234;
  defaults.planner.seed = 0xFFFFFFFFFFFFFFFFULL;
  return defaults;
}

}  // namespace

class TestSettings : public QObject {
  Q_OBJECT

private slots:
  void init() { QFile::remove(ini()); }

  void firstStart_hasDefaults() {
    const Settings settings(ini());
    QVERIFY(settings.unitSystem() == style::UnitSystem::Aviation);
    QVERIFY(!settings.theme().has_value());
    QVERIFY(settings.language().isEmpty());
    QVERIFY(settings.windowGeometry().isEmpty() && settings.windowState().isEmpty());
    QVERIFY(settings.recentFiles().isEmpty());
    QVERIFY(settings.lastFolder(QStringLiteral("terrain")).isEmpty());
    QVERIFY(settings.missionDefaults() == document::MissionDefaults{});
    QVERIFY(settings.sceneOptions().isEmpty());
  }

  void everything_isThereAtTheNextStart() {
    {
      Settings settings(ini());
      settings.setUnitSystem(style::UnitSystem::Metric);
      settings.setTheme(style::Theme::Dark);
      settings.setLanguage(QStringLiteral("cs"));
      settings.setWindowGeometry(QByteArray("geo\0metry", 9));
      settings.setWindowState("state");
      settings.setMissionDefaults(oddDefaults());
      settings.setSceneOptions({{QStringLiteral("curtain"), false}, {QStringLiteral("verticalExaggeration"), 2.5}});
      settings.setLastFolder(QStringLiteral("terrain"), folder_.path());
      settings.addRecentFile(made("ä b,c;d.vpm"));
    }
    Settings settings(ini());
    QVERIFY(settings.unitSystem() == style::UnitSystem::Metric);
    QVERIFY(settings.theme() == style::Theme::Dark);
    QCOMPARE(settings.language(), QStringLiteral("cs"));
    QCOMPARE(settings.windowGeometry(), QByteArray("geo\0metry", 9));
    QCOMPARE(settings.windowState(), QByteArray("state"));
    QCOMPARE(settings.lastFolder(QStringLiteral("terrain")), folder_.path());
    QVERIFY(settings.lastFolder(QStringLiteral("missions")).isEmpty());
    QCOMPARE(settings.recentFiles(), QStringList{folder_.filePath("ä b,c;d.vpm")});
    QVERIFY(settings.missionDefaults() == oddDefaults());
    QCOMPARE(settings.sceneOptions().value(QStringLiteral("curtain")).toString(), QStringLiteral("false"));
    QCOMPARE(settings.sceneOptions().value(QStringLiteral("verticalExaggeration")).toDouble(), 2.5);
    settings.setMissionDefaults({});
    QVERIFY(settings.missionDefaults() == document::MissionDefaults{});
    settings.setTheme(std::nullopt);
    settings.setLanguage({});
    QVERIFY(settings.language().isEmpty());
    settings.setUnitSystem(style::UnitSystem::Aviation);
    QVERIFY(!settings.theme().has_value());
  }

  void brokenEntries_readAsDefaults() {
    QFile file(ini());
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(
        "[General]\nunits=furlongs\ntheme=pink\nlanguage=tlh\nrecentFiles=\nfolders/terrain=/no/such/folder\n[folders]\nterrain=/no/such/folder\n"
        "[newMissions]\nclearance_m=-5\narrivalMargin_m=high\nheadings=900\nstep_m=0\nbeta=1\nmethod=magic\nlowTargets=dig\n"
        "roadmapSamples=-1\nseed=-1\n");
    file.close();
    const Settings settings(ini());
    QVERIFY(settings.unitSystem() == style::UnitSystem::Aviation);
    QVERIFY(!settings.theme().has_value());
    QVERIFY(settings.language().isEmpty());
    QVERIFY(settings.missionDefaults() == document::MissionDefaults{});
    QVERIFY(settings.recentFiles().isEmpty());
    QVERIFY(settings.lastFolder(QStringLiteral("terrain")).isEmpty());
  }

  void recentFiles_areLatestFirstOnceAndFew() {
    Settings settings(ini());
    for (int i = 0; i < Settings::kMostRecent + 3; ++i) {
      settings.addRecentFile(made(QStringLiteral("m%1.vpm").arg(i)));
    }
    QCOMPARE(settings.recentFiles().size(), Settings::kMostRecent);
    QCOMPARE(settings.recentFiles().front(), folder_.filePath("m12.vpm"));
    settings.addRecentFile(folder_.path() + "/./m7.vpm");  // the same file by another way
    QCOMPARE(settings.recentFiles().front(), folder_.filePath("m7.vpm"));
    QCOMPARE(settings.recentFiles().size(), Settings::kMostRecent);
    QCOMPARE(settings.recentFiles().count(folder_.filePath("m7.vpm")), 1);
    settings.clearRecentFiles();
    QVERIFY(settings.recentFiles().isEmpty());
  }

  void recentFile_thatIsGone_isNotOffered() {
    Settings settings(ini());
    settings.addRecentFile(made("a.vpm"));
    settings.addRecentFile(made("b.vpm"));
    QVERIFY(QFile::remove(folder_.filePath("b.vpm")));
    QCOMPARE(settings.recentFiles(), QStringList{folder_.filePath("a.vpm")});
  }

private:
  [[nodiscard]] QString ini() const { return folder_.filePath("volplane.ini"); }
  [[nodiscard]] QString made(const QString& name) const {
    QFile file(folder_.filePath(name));
    return file.open(QIODevice::WriteOnly) ? file.fileName() : QString();
  }

  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestSettings)
#include "tst_settings.moc"
