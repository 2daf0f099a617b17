// The working desk on a bundled mission: loading, planning, stopping, edits, and what goes missing.
#include "core/formats/mission_paths.h"
#include "ui/jobs/file_kind.h"
#include "ui/jobs/workspace.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cmath>
#include <functional>
#include <memory>

using namespace vp;
using jobs::PlanningOutcome;
using jobs::Workspace;
using Kind = PlanningOutcome::Kind;

namespace {

const QString kMaps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");
constexpr int kPatience = 120'000;  // ms; a guard against hanging, far beyond what a sanitizer on a busy machine takes

void makeQuick(mission::Mission& mission) {
  mission.planner.headings = 4;
  mission.planner.step = Length::fromSi(100.0);
  mission.planner.roadmap = mission::RoadmapKind::RrtStar;
  mission.planner.roadmapSamples = 800;
}

bool writeAll(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

}  // namespace

class TestWorkspace : public QObject {
  Q_OBJECT

private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    for (const char* name : {"mountain-n5.vpm", "mountain-n10.vpm", "mountain-n50.vpm", "mountain.tif", "alpine-n10.vpm", "alpine.tif",
                             "alpine-airports.csv", "alpine-runways.csv"}) {
      QVERIFY(QFile::copy(kMaps + name, at(name)));
    }
    desk_ = std::make_unique<Workspace>();
    ended_.reset();
    connect(desk_.get(), &Workspace::planningEnded, this, [this](const PlanningOutcome& outcome) { ended_ = outcome; });
    failures_.clear();
    connect(desk_.get(), &Workspace::loadingFailed, this, [this](const Error& error) { failures_ << QString::fromStdString(error.message()); });
  }

  void cleanup() { desk_.reset(); }

  void mission_isLoadedInTheBackground() {
    QSignalSpy activity(desk_.get(), &Workspace::activityChanged);
    QVERIFY(desk_->document().open(at("mountain-n5.vpm")));
    QVERIFY(desk_->activity() == Workspace::Activity::Loading);
    QVERIFY(desk_->situation().terrain == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    const document::Situation& now = desk_->situation();
    QVERIFY(now.terrain != nullptr && now.terrain->highest > now.terrain->lowest + 1000.0);
    QCOMPARE(now.sites->size(), std::size_t(5));
    QCOMPARE(now.targets->size(), std::size_t(5));
    for (const document::ShownTarget& target : *now.targets) {
      QVERIFY(target.altitude.has_value() && target.problem.empty());
      QVERIFY(std::abs(*target.altitude - now.terrain->grid->upperAt(target.point) - target.target.height_m) < 1e-6);
    }
    QVERIFY(now.plan == nullptr && now.planIsCurrent);
    QCOMPARE(activity.count(), 2);
    QVERIFY(failures_.isEmpty());
  }

  void windAndAircraft_decideWhichRunwaysCount() {
    QVERIFY(desk_->document().open(at("alpine-n10.vpm")));
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    const auto used = [this] {
      return std::count_if(desk_->situation().sites->begin(), desk_->situation().sites->end(),
                           [](const document::ShownSite& site) { return site.usable; });
    };
    const auto all = used();
    desk_->document().edit(QStringLiteral("Long landing"), [](mission::Mission& m) { m.aircraft.landingDistance = Length::fromSi(9000.0); });
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle && used() < all, kPatience);
    QVERIFY2(desk_->notes().join(' ').contains("too short to be landed on that day"), qPrintable(desk_->notes().join(' ')));
    desk_->document().undoStack().undo();
    QTRY_COMPARE_WITH_TIMEOUT(used(), all, kPatience);
    desk_->document().edit(QStringLiteral("Wind"), [](mission::Mission& m) {
      m.aircraft.maxTailwind = Speed::fromSi(1.0);
      m.wind = {{geo::HeightMsl(), {0.0, 180.0, 5.0, 5.0}}};  // from any direction
    });
    QTRY_COMPARE_WITH_TIMEOUT(used(), 0, kPatience);
  }

  void settingThatTheAircraftLacks_isRefusedWithItsSentence() {
    openQuick();
    desk_->document().edit(QStringLiteral("Power"), [](mission::Mission& m) { m.powerSetting = "80 %"; });
    const Result<void> started = desk_->startPlanning();
    QVERIFY(!started);
    QVERIFY2(started.error().what.find("has no power setting \"80 %\"") != std::string::npos, started.error().what.c_str());
  }

  void mission_isPlannedAndVerified() {
    openQuick();
    QSignalSpy progress(desk_.get(), &Workspace::progressed);
    bool sawRoadmap = false;
    bool sawLegs = false;
    connect(desk_.get(), &Workspace::situationChanged, this, [&] {
      if (const auto sketch = desk_->situation().sketch) {
        sawRoadmap = sawRoadmap || (sketch->roadmap && !sketch->roadmap->empty());
        sawLegs = sawLegs || (sketch->tour && sketch->tour->size() == 5);
        QVERIFY(!sketch->stage.empty());
      }
    });
    plan();
    QVERIFY(ended_->kind == Kind::Verified);
    QVERIFY(ended_->report.isSafe() && ended_->seconds > 0.0 && !ended_->error);
    QVERIFY(sawRoadmap && sawLegs);
    QVERIFY(!progress.isEmpty());
    QVERIFY(desk_->situation().sketch == nullptr);
    QVERIFY(desk_->activity() == Workspace::Activity::Idle);
    QVERIFY(desk_->document().planIsCurrent());
    QVERIFY(desk_->document().plan()->certificate.has_value());
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().plan != nullptr, kPatience);
    QVERIFY(desk_->situation().planIsCurrent && desk_->situation().plan->isVerified());
    QVERIFY(&desk_->situation().plan->plan() == desk_->document().plan().get());
  }

  void edit_makesThePlanOutOfDate_undoMakesItCurrent() {
    openQuick();
    plan();
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().plan != nullptr, kPatience);
    const auto view = desk_->situation().plan;
    desk_->document().edit(QStringLiteral("Move"), [](mission::Mission& m) { m.targets[0].position.latitude_deg += 1e-3; });
    QVERIFY(!desk_->situation().planIsCurrent);
    QVERIFY(desk_->situation().plan == view);  // shown, not lost, and not made again
    desk_->document().undoStack().undo();
    QVERIFY(desk_->situation().planIsCurrent);
    QVERIFY(desk_->situation().plan == view);
  }

  void newPlan_neverShowsTheOldTourAsCurrent() {
    openQuick();
    plan();
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().plan != nullptr, kPatience);
    const auto old = desk_->situation().plan;
    desk_->document().edit(QStringLiteral("Move"), [](mission::Mission& m) { m.targets[0].position.latitude_deg += 1e-3; });
    bool mixed = false;
    connect(desk_.get(), &Workspace::situationChanged, this,
            [&] { mixed = mixed || (desk_->situation().plan == old && desk_->situation().planIsCurrent); });
    plan();
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().plan != old && desk_->situation().planIsCurrent, kPatience);
    QVERIFY(!mixed);
  }

  void planning_isStoppedAndStartedAgain() {
    openQuick("mountain-n50.vpm");
    desk_->document().edit(QStringLiteral("Fine"), [](mission::Mission& m) {
      m.planner.roadmap = mission::RoadmapKind::RrtStar;
      m.planner.roadmapSamples = 200'000;
    });
    QVERIFY(desk_->startPlanning());
    QVERIFY(desk_->activity() == Workspace::Activity::Planning);
    QVERIFY(!desk_->startPlanning());
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().sketch != nullptr, kPatience);
    desk_->cancelPlanning();
    QTRY_VERIFY_WITH_TIMEOUT(ended_.has_value(), kPatience);
    QVERIFY(ended_->kind == Kind::Cancelled);
    QVERIFY(desk_->activity() == Workspace::Activity::Idle);
    QVERIFY(desk_->document().plan() == nullptr);
    QVERIFY(desk_->situation().sketch == nullptr);
    desk_->document().edit(QStringLiteral("Few"), [](mission::Mission& m) {
      m.targets.resize(4);
      m.planner.roadmap = mission::RoadmapKind::RrtStar;
      m.planner.roadmapSamples = 500;
    });
    plan();
    QVERIFY(ended_->kind == Kind::Verified);
  }

  void editedTargets_plannedAgain_reuseTheTourAndAreVerified() {
    openQuick("mountain-n10.vpm");
    plan();
    QVERIFY(ended_->kind == Kind::Verified && !ended_->isTourReused);
    const auto edits = std::to_array<std::function<void(mission::Mission&)>>({
        [](mission::Mission& m) { m.targets[2].position.latitude_deg += 1e-3; },
        [](mission::Mission& m) { m.targets.erase(m.targets.begin() + 4); },
        [](mission::Mission& m) {
          mission::Target added = m.targets[1];
          added.name = "added";
          added.position.latitude_deg += 3e-3;
          m.targets.push_back(added);
        },
    });
    for (const auto& edit : edits) {
      desk_->document().edit(QStringLiteral("Edit"), edit);
      QSignalSpy progress(desk_.get(), &Workspace::progressed);
      plan();
      QVERIFY(ended_->kind == Kind::Verified && ended_->isTourReused);
      QVERIFY(!progress.isEmpty());
      QVERIFY(desk_->document().planIsCurrent() && desk_->document().plan()->certificate.has_value());
      QCOMPARE(desk_->document().plan()->targets.size(), desk_->document().mission().targets.size());
    }
    plan();
    QVERIFY(ended_->kind == Kind::Verified && !ended_->isTourReused);
    QVERIFY(desk_->document().plan()->metrics.lowerBound > 0.0);
  }

  void closedRunway_plannedAgain_isNotUsed() {
    openQuick();
    plan();
    const auto before = desk_->document().plan();
    const std::string closed = before->sites[static_cast<std::size_t>(before->tour.front().witness.site)].site.id;
    desk_->document().edit(QStringLiteral("Close"), [&](mission::Mission& m) { m.siteFilter.exclude = {closed}; });
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    plan();
    QVERIFY(ended_->kind == Kind::Verified && !ended_->isTourReused);
    for (const mission::DecisionPoint& point : desk_->document().plan()->tour) {
      QVERIFY(desk_->document().plan()->sites[static_cast<std::size_t>(point.witness.site)].site.id != closed);
    }
  }

  void stoppedReplanning_keepsThePlanAndWhatItKnew() {
    openQuick("mountain-n10.vpm");
    plan();
    const auto before = desk_->document().plan();
    desk_->document().edit(QStringLiteral("Move"), [](mission::Mission& m) { m.targets[2].position.latitude_deg += 1e-3; });
    ended_.reset();
    QVERIFY(desk_->startPlanning());
    desk_->cancelPlanning();
    QTRY_VERIFY_WITH_TIMEOUT(ended_.has_value(), kPatience);
    QVERIFY(ended_->kind == Kind::Cancelled);
    QVERIFY(desk_->document().plan() == before);
    plan();
    QVERIFY(ended_->kind == Kind::Verified);
    QVERIFY(desk_->document().planIsCurrent());
    desk_->document().startNew();
    openQuick("mountain-n10.vpm");
    plan();
    QVERIFY(ended_->kind == Kind::Verified && !ended_->isTourReused);
  }

  void edit_whilePlanning_leavesAPlanThatIsOutOfDate() {
    openQuick();
    QVERIFY(desk_->startPlanning());
    desk_->document().edit(QStringLiteral("Raise"), [](mission::Mission& m) { m.targets[1].height_m += 50.0; });
    QTRY_VERIFY_WITH_TIMEOUT(ended_.has_value(), kPatience);
    QVERIFY(ended_->kind == Kind::Verified);
    QVERIFY(!desk_->document().planIsCurrent());
    desk_->document().undoStack().undo();
    QVERIFY(desk_->document().planIsCurrent());
  }

  void documentReplaced_whilePlanning_keepsThePlanOut() {
    openQuick();
    QVERIFY(desk_->startPlanning());
    desk_->document().startNew();
    QVERIFY(ended_.has_value() && ended_->kind == Kind::Cancelled);
    QVERIFY(desk_->activity() == Workspace::Activity::Idle);
    QVERIFY(desk_->situation().terrain == nullptr && desk_->situation().targets->empty());
    QVERIFY(desk_->document().open(at("mountain-n5.vpm")));
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    QVERIFY(desk_->document().plan() == nullptr);
  }

  void planning_isRefusedWithWhatIsMissing() {
    QVERIFY(refusal().contains("terrain"));
    QVERIFY(desk_->document().open(at("mountain-n5.vpm")));
    QVERIFY(refusal().contains("moment"));
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    desk_->document().edit(QStringLiteral("None"), [](mission::Mission& m) { m.targets.clear(); });
    QVERIFY(refusal().contains("targets"));
    desk_->document().undoStack().undo();
    desk_->document().edit(QStringLiteral("Out"), [](mission::Mission& m) { m.targets[2].position.latitude_deg += 2.0; });
    QVERIFY2(refusal().contains(QString::fromStdString(desk_->document().mission().targets[2].name)), qPrintable(refusal()));
    QVERIFY(!desk_->situation().targets->at(2).problem.empty());
    desk_->document().undoStack().undo();
    desk_->document().edit(QStringLiteral("Twice"), [](mission::Mission& m) { m.targets[3].position = m.targets[2].position; });
    QVERIFY2(refusal().contains("same place"), qPrintable(refusal()));
    desk_->document().undoStack().undo();
    desk_->document().edit(QStringLiteral("Storm"), [](mission::Mission& m) { m.wind = {{geo::HeightMsl(), {270.0, 0.0, 60.0, 60.0}}}; });
    QVERIFY2(refusal().contains("not below the gliding speed"), qPrintable(refusal()));
    desk_->document().undoStack().undo();
    desk_->document().edit(QStringLiteral("No sites"), [](mission::Mission& m) { m.sites.clear(); });
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    QVERIFY2(refusal().contains("runway"), qPrintable(refusal()));
  }

  void lowCeiling_saysByHowMuchAndWhere() {
    openQuick();
    desk_->document().edit(QStringLiteral("Ceiling"), [](mission::Mission& m) { m.ceiling = geo::HeightMsl::fromMetres(300.0); });
    plan();
    QVERIFY(ended_->kind == Kind::Failed);
    QVERIFY(ended_->error && ended_->error->code == Errc::NoSolution);
    QVERIFY(ended_->target >= 0 && ended_->target < 5);
    QVERIFY(ended_->missingHeight && *ended_->missingHeight > 0.0);
    const std::string& name = desk_->document().mission().targets[static_cast<std::size_t>(ended_->target)].name;
    QVERIFY(ended_->error->what.find(name) != std::string::npos);
    QVERIFY(desk_->document().plan() == nullptr);
    const double missing = *ended_->missingHeight;
    desk_->document().edit(QStringLiteral("Raise"), [missing](mission::Mission& m) {
      m.ceiling = geo::HeightMsl::fromMetres(m.ceiling->metres() + missing + 600.0);  // more for the way between the targets
    });
    plan();
    QVERIFY2(ended_->kind == Kind::Verified, ended_->error ? ended_->error->what.c_str() : "");
  }

  void missingTerrainFile_isNamedAndTheDocumentOpens() {
    QVERIFY(QFile::remove(at("mountain.tif")));
    QVERIFY(desk_->document().open(at("mountain-n5.vpm")));
    QTRY_VERIFY_WITH_TIMEOUT(!failures_.isEmpty(), kPatience);
    QVERIFY2(failures_.first().contains("mountain.tif"), qPrintable(failures_.first()));
    QVERIFY(desk_->activity() == Workspace::Activity::Idle);
    QCOMPARE(desk_->document().mission().targets.size(), std::size_t(5));
    QCOMPARE(desk_->situation().targets->size(), std::size_t(5));
    QVERIFY(desk_->situation().terrain == nullptr);
    QVERIFY2(refusal().contains("mountain.tif"), qPrintable(refusal()));
  }

  void terrainOfAnotherMission_doesNotStay() {
    openQuick();
    QVERIFY(QFile::remove(at("alpine.tif")));
    QVERIFY(desk_->document().open(at("alpine-n10.vpm")));
    QVERIFY(desk_->situation().terrain != nullptr);  // until it is known that there is no other
    QTRY_VERIFY_WITH_TIMEOUT(!failures_.isEmpty(), kPatience);
    QVERIFY(desk_->situation().terrain == nullptr && desk_->situation().sites == nullptr);
  }

  void terrainRewrittenOnDisk_isReadAgainBeforePlanning() {
    openQuick();
    const auto before = desk_->situation().terrain;
    QVERIFY(QFile::remove(at("mountain.tif")));
    QVERIFY(QFile::copy(kMaps + "flat.tif", at("mountain.tif")));
    QVERIFY2(refusal().contains("changed"), qPrintable(refusal()));
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().terrain != before, kPatience);
    QVERIFY(desk_->situation().terrain->highest < before->highest);
  }

  void filter_leavesSitesOutButShowsThem() {
    openQuick();
    desk_->document().edit(QStringLiteral("Exclude"), [](mission::Mission& m) { m.siteFilter.exclude = {m.sites[0].id}; });
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    const std::string excluded = desk_->document().mission().sites[0].id;
    QCOMPARE(desk_->situation().sites->size(), std::size_t(5));
    for (const document::ShownSite& site : *desk_->situation().sites) {
      QCOMPARE(site.usable, site.site.site.id != excluded);
    }
    plan();
    QCOMPARE(desk_->document().plan()->sites.size(), std::size_t(4));
  }

  void filterThatNamesNothing_isShownButNotPlannedWith() {
    openQuick();
    desk_->document().edit(QStringLiteral("Exclude"), [](mission::Mission& m) { m.siteFilter.exclude = {"NOWHERE"}; });
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    QCOMPARE(desk_->situation().sites->size(), std::size_t(5));
    QVERIFY2(refusal().contains("NOWHERE"), qPrintable(refusal()));
  }

  void unreadableAirfields_areNotPlannedAround() {
    openQuick();
    QVERIFY(writeAll(at("bad.cup"), "this is no cup file"));
    desk_->document().edit(QStringLiteral("Add"), [this](mission::Mission& m) { m.airfields.push_back({at("bad.cup").toStdString(), ""}); });
    QTRY_VERIFY_WITH_TIMEOUT(!failures_.isEmpty(), kPatience);
    QVERIFY2(failures_.first().contains("bad.cup"), qPrintable(failures_.first()));
    QVERIFY2(refusal().contains("bad.cup"), qPrintable(refusal()));
    desk_->document().undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    QCOMPARE(desk_->situation().sites->size(), std::size_t(5));
    plan();
    QVERIFY(ended_->kind == Kind::Verified);
  }

  void addedFiles_areOneStepAndLoaded() {
    QVERIFY(add({at("alpine.tif"), at("alpine-airports.csv")}));
    QCOMPARE(desk_->document().undoStack().count(), 1);
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().sites != nullptr && desk_->situation().sites->size() > 5, kPatience);
    QVERIFY(!add({at("alpine-n10.vpm")}));
    desk_->document().undoStack().undo();
    QVERIFY(desk_->situation().terrain == nullptr && desk_->situation().sites == nullptr);
  }

  void hiddenAirspaces_areFoundThoughNotShown() {
    const QByteArray shape = "AL SFC\nAH UNL\nV X=46:30:00 N 027:00:00 W\nDC 2\n";
    QVERIFY(writeAll(at("zones.txt"),
                     "AC R\nAN RANGE\n" + shape + "AC C\nAN AREA\n" + shape + "AC G\nAN FAR\nAL SFC\nAH UNL\nV X=10:00:00 S 120:00:00 E\nDC 1\n"));
    QVERIFY(add({at("alpine.tif"), at("zones.txt")}));
    desk_->document().edit(QStringLiteral("Hide"), [](mission::Mission& m) {
      m.airspace.rules = {{"C", "", mission::AirspaceUse::Warn}};
      m.airspace.otherwise = mission::AirspaceUse::Hide;
    });
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    QVERIFY(desk_->situation().airspaces != nullptr && desk_->situation().foundAirspaces != nullptr);
    QCOMPARE(desk_->situation().airspaces->size(), std::size_t(1));
    QCOMPARE(desk_->situation().airspaces->front().airspace.kind, std::string("C"));
    QCOMPARE(desk_->situation().foundAirspaces->hidden.size(), std::size_t(1));
    QCOMPARE(desk_->situation().foundAirspaces->hidden.front().name, std::string("RANGE"));
    QCOMPARE(desk_->situation().foundAirspaces->kinds, (std::vector<std::string>{"C", "G", "R"}));
    desk_->document().edit(QStringLiteral("None"), [](mission::Mission& m) { m.airspace.files.clear(); });
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
    QVERIFY(desk_->situation().airspaces == nullptr && desk_->situation().foundAirspaces == nullptr);
  }

  void outOfDatePlan_isShownOverMoreTerrain() {
    openQuick();
    plan();
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().plan != nullptr, kPatience);
    const auto before = desk_->situation().plan;
    const geo::LatLon place = desk_->situation().terrain->frame.toLatLon(before->at(500.0).pose.point());
    // a raster beside the mountain moves the middle of the terrain, and with it the local frame
    QVERIFY(writeAll(at("east.asc"), "ncols 20\nnrows 20\nxllcorner -24.967\nyllcorner 46.978\ncellsize 0.002\n" +
                                         (QByteArray("5 ").repeated(20) + '\n').repeated(20)));
    QVERIFY(writeAll(
        at("east.prj"),
        R"(GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]])"));
    const Result<void> added = add({at("east.asc")});
    QVERIFY2(added, added ? "" : added.error().message().c_str());
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().plan != nullptr && desk_->situation().plan != before, kPatience);
    QVERIFY(!(desk_->situation().terrain->frame == before->terrain().frame));
    QVERIFY(!desk_->situation().planIsCurrent);
    const geo::LatLon now = desk_->situation().terrain->frame.toLatLon(desk_->situation().plan->at(500.0).pose.point());
    QVERIFY(geo::geodesicDistance(place, now).si() < 1.0);
    desk_->document().undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().planIsCurrent && desk_->situation().plan != nullptr, kPatience);
  }

  void safeAltitude_isKnownOnceGlidesAre() {
    openQuick();
    const geo::Point place = desk_->situation().targets->front().point;
    QTRY_VERIFY_WITH_TIMEOUT(desk_->roadmap() != nullptr, kPatience);
    const auto altitude = desk_->safeAltitudeAt(place);
    QVERIFY(altitude.has_value());
    QVERIFY(*altitude >= desk_->situation().terrain->grid->upperAt(place) + desk_->document().mission().safety.clearance.si());
    QVERIFY(!desk_->safeAltitudeAt({1e7, 0.0}));
    const auto world = desk_->world();
    desk_->document().edit(QStringLiteral("Clearance"), [](mission::Mission& m) { m.safety.clearance = Length::fromSi(200.0); });
    QVERIFY(!desk_->safeAltitudeAt(place));  // the old answer holds no longer
    QTRY_VERIFY_WITH_TIMEOUT(desk_->safeAltitudeAt(place).has_value(), kPatience);
    QVERIFY(*desk_->safeAltitudeAt(place) > *altitude);
    QVERIFY(desk_->world() != world);
    desk_->document().edit(QStringLiteral("Wind"), [](mission::Mission& m) { m.wind = {{geo::HeightMsl(), {270.0, 180.0, 0.0, 5.0}}}; });
    QVERIFY(!desk_->safeAltitudeAt(place));  // nor does one for still air in wind
  }

  void overlay_isCoarseThenFineAndAgreesWithThePointer() {
    openQuick();
    desk_->setSafeAltitudesWanted(true);
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().safeAltitudes != nullptr, kPatience);
    const auto coarse = desk_->situation().safeAltitudes;
    QVERIFY(std::max(coarse->columns, coarse->rows) <= 41);
    const int column = coarse->columns / 2;
    const int row = coarse->rows / 2;
    const auto there = desk_->safeAltitudeAt({coarse->originX + (column + 0.5) * coarse->cell, coarse->originY + (row + 0.5) * coarse->cell});
    QVERIFY(there && std::abs(*there - static_cast<double>(coarse->worst(column, row))) < 30.0);  // other hints, other glides
    QTRY_VERIFY_WITH_TIMEOUT(desk_->situation().safeAltitudes != coarse, kPatience);
    QVERIFY(std::max(desk_->situation().safeAltitudes->columns, desk_->situation().safeAltitudes->rows) > 70);
    desk_->setSafeAltitudesWanted(false);
    QVERIFY(desk_->situation().safeAltitudes == nullptr);
  }

  void stopAll_endsEverythingAtOnce() {
    openQuick("mountain-n50.vpm");
    desk_->setSafeAltitudesWanted(true);
    QVERIFY(desk_->startPlanning());
    desk_->stopAll();
    QVERIFY(desk_->activity() == Workspace::Activity::Idle);
    QCoreApplication::processEvents();
    QVERIFY(!ended_.has_value());
  }

private:
  [[nodiscard]] QString at(const QString& name) const { return folder_->filePath(name); }

  Result<void> add(const QStringList& files) {
    return jobs::sortFiles(files).and_then([this](const jobs::NewFiles& sorted) { return desk_->add(sorted); });
  }

  void openQuick(const QString& name = QStringLiteral("mountain-n5.vpm")) {
    QVERIFY(desk_->document().open(at(name)));
    desk_->document().edit(QStringLiteral("Quick"), makeQuick);
    QTRY_VERIFY_WITH_TIMEOUT(desk_->activity() == Workspace::Activity::Idle, kPatience);
  }

  void plan() {
    ended_.reset();
    const Result<void> started = desk_->startPlanning();
    QVERIFY2(started, started ? "" : started.error().message().c_str());
    QTRY_VERIFY_WITH_TIMEOUT(ended_.has_value(), kPatience);
  }

  QString refusal() {
    const Result<void> started = desk_->startPlanning();
    return started ? QStringLiteral("started") : QString::fromStdString(started.error().message());
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<Workspace> desk_;
  std::optional<PlanningOutcome> ended_;
  QStringList failures_;
};

QTEST_GUILESS_MAIN(TestWorkspace)
#include "tst_workspace.moc"
