// Mission and plan as one document: undo, plan out of date, files, recovery.
#include "tests/support/quick_plan.h"
#include "ui/document/mission_document.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp;
using document::MissionDocument;

namespace {

const QString kMaps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");

QByteArray readAll(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool writeAll(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

void moveTarget(MissionDocument& document, double latitude, const QString& key = {}) {
  document.edit(
      QStringLiteral("Move target 1"), [latitude](mission::Mission& m) { m.targets.front().position.latitude_deg = latitude; }, key);
}

}  // namespace

class TestMissionDocument : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    made_ = test::quickPlan(test::quickMission((kMaps + "mountain-n5.vpm").toStdString()));
    QVERIFY(made_.plan->certificate.has_value());
  }

  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    QVERIFY(folder_->isValid());
    QVERIFY(QFile::copy(kMaps + "mountain-n5.vpm", at("n5.vpm")));
    QVERIFY(QFile::copy(kMaps + "mountain.tif", at("mountain.tif")));
  }

  void newDocument_hasTheDefaultAircraftAndNothingToSave() {
    MissionDocument document;
    QVERIFY(!document.isModified());
    QVERIFY(document.mission().aircraft.mass_kg > 0.0);
    QCOMPARE(document.mission().aircraftReference, std::string("cessna172-handbook"));
    QVERIFY(aircraft::profileWarnings(document.mission().aircraft).empty());
    QCOMPARE(document.title(), QStringLiteral("Untitled mission"));
    QVERIFY(document.path().isEmpty());
    QVERIFY(!document.planIsCurrent());
  }

  void defaults_areWhatNewMissionsStartWith_openOnesKeepTheirs() {
    document::MissionDefaults defaults;
    defaults.safety.clearance = Length::fromSi(250.0);
    defaults.planner.headings = 5;
    MissionDocument document;
    document.setDefaults(defaults);
    QCOMPARE(document.mission().safety.clearance.si(), 250.0);  // nobody had touched it
    QVERIFY(!document.isModified());
    QVERIFY(document.open(at("n5.vpm")));
    const mission::Mission opened = document.mission();
    defaults.planner.headings = 6;
    document.setDefaults(defaults);
    QVERIFY(document::sameMission(document.mission(), opened));
    document.startNew();
    QCOMPARE(document.mission().planner.headings, 6);
    document.edit(QStringLiteral("Name"), [](mission::Mission& m) { m.name = "mine"; });
    document.setDefaults({});
    QCOMPARE(document.mission().planner.headings, 6);
  }

  void saved_whileItWasEdited_staysModified() {
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    moveTarget(document, 46.99);
    const MissionDocument::Snapshot snapshot = document.snapshot();
    QVERIFY(document::writeDocument(snapshot, at("n5.vpm"), document.needsPlanWritten(at("n5.vpm"))).has_value());
    moveTarget(document, 46.98);  // while a worker writes
    document.markSaved(snapshot, at("n5.vpm"));
    QVERIFY(document.isModified());
    QVERIFY(document.saveAs(at("n5.vpm")).has_value());
    QVERIFY(!document.isModified());
    MissionDocument again;
    QVERIFY(again.open(at("n5.vpm")));
    QCOMPARE(again.mission().targets.front().position.latitude_deg, 46.98);
  }

  void plan_madeWhileItWasSaved_staysUnsaved() {
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    const MissionDocument::Snapshot snapshot = document.snapshot();
    document.setPlan(made_.plan);
    document.markSaved(snapshot, at("n5.vpm"));
    QVERIFY(document.isModified());
    QVERIFY(document.needsPlanWritten(at("n5.vpm")));
  }

  void edit_isUndoneAndRedoneByName() {
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    const auto before = document.sharedMission();
    QSignalSpy changed(&document, &MissionDocument::missionChanged);
    moveTarget(document, 46.99);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Move target 1"));
    QCOMPARE(document.mission().targets.front().position.latitude_deg, 46.99);
    QVERIFY(document.isModified());
    document.undoStack().undo();
    QVERIFY(document.sharedMission() == before);
    QVERIFY(!document.isModified());
    document.undoStack().redo();
    QCOMPARE(document.mission().targets.front().position.latitude_deg, 46.99);
    QCOMPARE(changed.count(), 3);
  }

  void edits_underOneKey_areOneStep() {
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    const double start = document.mission().targets.front().position.latitude_deg;
    for (int i = 1; i <= 20; ++i) {
      moveTarget(document, start + 1e-4 * i, QStringLiteral("drag 1"));
    }
    moveTarget(document, start + 0.01, QStringLiteral("drag 2"));
    moveTarget(document, start + 0.02);
    moveTarget(document, start + 0.03);
    QCOMPARE(document.undoStack().count(), 4);
    document.undoStack().undo();
    document.undoStack().undo();
    document.undoStack().undo();
    QCOMPARE(document.mission().targets.front().position.latitude_deg, start + 2e-3);
    document.undoStack().undo();
    QCOMPARE(document.mission().targets.front().position.latitude_deg, start);
  }

  void edit_thatEndsWhereItBegan_leavesNoStep() {
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    const double start = document.mission().targets.front().position.latitude_deg;
    document.edit(QStringLiteral("Nothing"), [](mission::Mission&) {});
    QCOMPARE(document.undoStack().count(), 0);
    moveTarget(document, start + 0.01, QStringLiteral("drag"));
    moveTarget(document, start, QStringLiteral("drag"));
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(!document.isModified());
  }

  void edit_afterSaving_isAStepOfItsOwn() {
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    moveTarget(document, 46.990, QStringLiteral("drag"));
    QVERIFY(document.saveAs(document.path()));
    moveTarget(document, 46.991, QStringLiteral("drag"));
    QVERIFY(document.isModified());
    document.undoStack().undo();
    QVERIFY(!document.isModified());
    QCOMPARE(document.mission().targets.front().position.latitude_deg, 46.990);
  }

  void plan_isOutOfDateAfterAnEditAndCurrentAfterUndo() {
    MissionDocument document;
    openPlanned(document);
    QVERIFY(document.planIsCurrent());
    QVERIFY(document.isModified());
    QSignalSpy planChanged(&document, &MissionDocument::planChanged);
    moveTarget(document, 46.99);
    QVERIFY(!document.planIsCurrent());
    QVERIFY(document.plan() != nullptr);
    QCOMPARE(planChanged.count(), 1);
    moveTarget(document, 46.991);
    QCOMPARE(planChanged.count(), 1);
    document.undoStack().undo();
    document.undoStack().undo();
    QVERIFY(document.planIsCurrent());
    QCOMPARE(planChanged.count(), 2);
  }

  void eachInput_makesThePlanOutOfDate_data() {
    QTest::addColumn<int>("input");
    const char* names[] = {"terrain", "airfields", "sites", "filter", "aircraft", "targets", "ceiling", "clearance", "seed", "wind"};
    for (int i = 0; i < 10; ++i) {
      QTest::newRow(names[i]) << i;
    }
  }

  void eachInput_makesThePlanOutOfDate() {
    QFETCH(int, input);
    MissionDocument document;
    openPlanned(document);
    document.edit(QStringLiteral("Change"), [input](mission::Mission& m) {
      switch (input) {
        case 0:
          m.terrain.emplace_back("/more.tif");
          break;
        case 1:
          m.airfields.push_back({"/more.cup", ""});
          break;
        case 2:
          m.sites.pop_back();
          break;
        case 3:
          m.siteFilter.minLength = Length::fromSi(900.0);
          break;
        case 4:
          m.aircraft.zeroLiftDrag *= 1.01;
          break;
        case 5:
          m.targets.front().height_m += 1.0;
          break;
        case 6:
          m.ceiling = geo::HeightMsl::fromMetres(3000.0);
          break;
        case 7:
          m.safety.clearance = Length::fromSi(101.0);
          break;
        case 8:
          ++m.planner.seed;
          break;
        default:
          m.wind = {{geo::HeightMsl(), {270.0, 0.0, 5.0, 5.0}}};
      }
    });
    QVERIFY(!document.planIsCurrent());
  }

  void words_leaveThePlanCurrent() {
    MissionDocument document;
    openPlanned(document);
    document.edit(QStringLiteral("Rename"), [](mission::Mission& m) {
      m.name = "another";
      m.aircraft.name = "My Cessna";
      m.aircraftReference.clear();
    });
    QVERIFY(document.planIsCurrent());
    QCOMPARE(document.title(), QStringLiteral("another"));
  }

  void savedAndReopened_isTheSame() {
    MissionDocument document;
    openPlanned(document);
    moveTarget(document, 46.9901);
    document.undoStack().undo();
    QVERIFY(document.saveAs(at("saved.vpm")));
    QVERIFY(!document.isModified());
    QCOMPARE(document.path(), at("saved.vpm"));
    QVERIFY(readAll(at("saved.vpm")).contains("\"mountain.tif\""));
    QVERIFY(!readAll(at("saved.vpp")).contains(folder_->path().toUtf8()));
    MissionDocument again;
    QVERIFY(again.open(at("saved.vpm")));
    QVERIFY(document::sameMission(again.mission(), document.mission()));
    QVERIFY(again.plan() != nullptr);
    QVERIFY(again.planIsCurrent());
    QVERIFY(again.plan()->tour == document.plan()->tour);
    QVERIFY(again.plan()->terrain == document.plan()->terrain);
    QVERIFY(again.plan()->certificate.has_value());
    QVERIFY(!again.isModified());
    QVERIFY(again.planProblem().isEmpty());
  }

  void folder_movedWithAllItsFiles_opens() {
    MissionDocument document;
    openPlanned(document);
    QVERIFY(document.saveAs(at("saved.vpm")));
    QVERIFY(QDir(folder_->path()).mkpath("elsewhere/deep"));
    for (const char* name : {"saved.vpm", "saved.vpp", "mountain.tif"}) {
      QVERIFY(QFile::rename(at(name), at("elsewhere/deep/") + name));
    }
    MissionDocument again;
    QVERIFY(again.open(at("elsewhere/deep/saved.vpm")));
    QCOMPARE(QString::fromStdString(again.mission().terrain.front()), at("elsewhere/deep/mountain.tif"));
    QVERIFY(again.planIsCurrent());
  }

  void folder_reachedByALink_keepsItsPaths() {
    QVERIFY(QDir(folder_->path()).mkpath("a/b/c/real"));
    QVERIFY(QFile::link(at("a/b/c/real"), at("link")));
    MissionDocument document;
    openPlanned(document);
    QVERIFY(document.saveAs(at("link/saved.vpm")));
    MissionDocument again;
    QVERIFY(again.open(at("link/saved.vpm")));
    QCOMPARE(QString::fromStdString(again.mission().terrain.front()), at("mountain.tif"));
    QVERIFY(again.planIsCurrent());
  }

  void unreadable_leavesTheDocumentAsItWas_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("code");
    QByteArray newer = readAll(kMaps + "mountain-n5.vpm");
    QTest::newRow("newer version") << newer.replace("\"version\": 1", "\"version\": 2") << static_cast<int>(Errc::NewerVersion);
    QTest::newRow("cut short") << readAll(kMaps + "mountain-n5.vpm").left(200) << static_cast<int>(Errc::BadFormat);
    QTest::newRow("not json") << QByteArray("hello") << static_cast<int>(Errc::BadFormat);
  }

  void unreadable_leavesTheDocumentAsItWas() {
    QFETCH(QByteArray, text);
    QFETCH(int, code);
    QVERIFY(writeAll(at("bad.vpm"), text));
    MissionDocument document;
    openPlanned(document);
    moveTarget(document, 46.99);
    const auto mission = document.sharedMission();
    const auto plan = document.plan();
    QSignalSpy changed(&document, &MissionDocument::missionChanged);
    const Result<void> opened = document.open(at("bad.vpm"));
    QVERIFY(!opened);
    QCOMPARE(static_cast<int>(opened.error().code), code);
    QVERIFY(QString::fromStdString(opened.error().message()).contains("bad.vpm"));
    QVERIFY(document.sharedMission() == mission && document.plan() == plan);
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(changed.count(), 0);
  }

  void missionWithoutTerrain_isSavedAndReopened() {
    MissionDocument document;
    document.edit(QStringLiteral("Add target"), [](mission::Mission& m) { m.targets.push_back({"T1", {46.5, 9.5}, 120.0}); });
    QVERIFY(document.saveAs(at("draft.vpm")));
    MissionDocument again;
    const Result<void> opened = again.open(at("draft.vpm"));
    QVERIFY2(opened, opened ? "" : opened.error().message().c_str());
    QVERIFY(document::sameMission(again.mission(), document.mission()));
  }

  void missionWithMissingTerrainFile_opens() {
    QVERIFY(QFile::remove(at("mountain.tif")));
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    QCOMPARE(document.mission().targets.size(), std::size_t(5));
  }

  void editedAircraft_underABundledName_isSavedInFull() {
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    QVERIFY(!document.mission().aircraftReference.empty());
    QVERIFY(document.saveAs(at("same.vpm")));
    QVERIFY(!readAll(at("same.vpm")).contains("mass_kg"));
    document.edit(QStringLiteral("Heavier"), [](mission::Mission& m) { m.aircraft.mass_kg = 1111.0; });
    QVERIFY(document.saveAs(at("heavy.vpm")));
    MissionDocument again;
    QVERIFY(again.open(at("heavy.vpm")));
    QCOMPARE(again.mission().aircraft.mass_kg, 1111.0);
  }

  void aircraftFile_isFoundFromWhereverTheMissionIsSaved() {
    QVERIFY(QFile::copy(QStringLiteral(VOLPLANE_SOURCE_DIR "/resources/aircraft/cessna172-elasp.json"), at("mine.json")));
    QByteArray text = readAll(at("n5.vpm"));
    const qsizetype from = text.indexOf("\"aircraft\": \"") + 13;
    text.replace(from, text.indexOf('"', from) - from, "./mine.json");
    QVERIFY(writeAll(at("own.vpm"), text));
    MissionDocument document;
    QVERIFY(document.open(at("own.vpm")));
    QCOMPARE(QString::fromStdString(document.mission().aircraftReference), at("mine.json"));
    QVERIFY(QDir(folder_->path()).mkpath("sub"));
    QVERIFY(document.saveAs(at("sub/own.vpm")));
    QVERIFY(readAll(at("sub/own.vpm")).contains("\"../mine.json\""));
    MissionDocument again;
    QVERIFY(again.open(at("sub/own.vpm")));
    QCOMPARE(again.mission().aircraftReference, document.mission().aircraftReference);
  }

  void planFile_opensWithItsMissionAndNeverTakesAnothersPlace() {
    MissionDocument document;
    openPlanned(document);
    QVERIFY(document.saveAs(at("saved.vpm")));
    MissionDocument beside;
    QVERIFY(beside.open(at("saved.vpp")));
    QCOMPARE(beside.path(), at("saved.vpm"));
    QVERIFY(beside.planIsCurrent());
    QVERIFY(QFile::copy(at("saved.vpp"), at("n5.vpp")));  // beside n5.vpm, which asks for another plan
    MissionDocument other;
    QVERIFY(other.open(at("n5.vpp")));
    QVERIFY(other.path().isEmpty());
    QVERIFY(other.planIsCurrent());
    QVERIFY(QFile::remove(at("saved.vpm")));
    MissionDocument alone;
    QVERIFY(alone.open(at("saved.vpp")));
    QVERIFY(alone.path().isEmpty());
    QVERIFY(document::samePlanInputs(alone.mission(), document.mission()));
  }

  void outOfDatePlan_isStillThereAfterReopening() {
    MissionDocument document;
    openPlanned(document);
    moveTarget(document, 46.99);
    QVERIFY(document.saveAs(at("saved.vpm")));
    MissionDocument again;
    QVERIFY(again.open(at("saved.vpm")));
    QVERIFY(again.plan() != nullptr);
    QVERIFY(!again.planIsCurrent());
  }

  void damagedPlanBeside_isToldAndLeftAlone() {
    QVERIFY(writeAll(at("n5.vpp"), "{ not a plan"));
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    QVERIFY(document.plan() == nullptr);
    QVERIFY2(document.planProblem().contains("n5.vpp"), qPrintable(document.planProblem()));
    moveTarget(document, 46.99);
    QVERIFY(document.saveAs(at("n5.vpm")));
    QCOMPARE(readAll(at("n5.vpp")), QByteArray("{ not a plan"));
  }

  void unreadableValues_areNotWrittenOverAGoodFile() {
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    const QByteArray before = readAll(at("n5.vpm"));
    document.edit(QStringLiteral("Rename"), [](mission::Mission& m) { m.targets[1].name = m.targets[0].name; });
    const Result<void> saved = document.saveAs(at("n5.vpm"));
    QVERIFY(!saved);
    QVERIFY(saved.error().code == Errc::OutOfRange);
    QCOMPARE(readAll(at("n5.vpm")), before);
    QVERIFY(document.isModified());
  }

  void unwritableFolder_leavesTheDocumentModified() {
    MissionDocument document;
    QVERIFY(document.open(at("n5.vpm")));
    moveTarget(document, 46.99);
    const Result<void> saved = document.saveAs(at("no/such/folder/n5.vpm"));
    QVERIFY(!saved && saved.error().code == Errc::OutputFailed);
    QVERIFY(document.isModified());
    QCOMPARE(document.path(), at("n5.vpm"));
  }

  void recovery_bringsBackMissionPlanAndPath() {
    MissionDocument document;
    openPlanned(document);
    QVERIFY(document.saveAs(at("saved.vpm")));
    moveTarget(document, 46.99);
    const std::string data = MissionDocument::recoveryData(document.snapshot());
    MissionDocument again;
    const Result<void> restored = again.restore(data);
    QVERIFY2(restored, restored ? "" : restored.error().message().c_str());
    QVERIFY(document::sameMission(again.mission(), document.mission()));
    QVERIFY(again.plan()->tour == document.plan()->tour);
    QVERIFY(!again.planIsCurrent());
    QCOMPARE(again.path(), at("saved.vpm"));
    QVERIFY(again.isModified());
    QVERIFY(again.saveAs(again.path()));
    QVERIFY(!again.isModified());
  }

  void recovery_ofAnUnfinishedMission_works() {
    MissionDocument document;
    document.edit(QStringLiteral("Add"), [](mission::Mission& m) {
      m.targets.push_back({"T1", {46.5, 9.5}, 120.0});
      m.aircraft.mass_kg = 987.0;
      m.wind = {{geo::HeightMsl(), {270.0, 0.0, 60.0, 60.0}}};  // too strong to be planned for, not to be kept
    });
    MissionDocument again;
    const Result<void> restored = again.restore(MissionDocument::recoveryData(document.snapshot()));
    QVERIFY2(restored, restored ? "" : restored.error().message().c_str());
    QVERIFY(document::sameMission(again.mission(), document.mission()));
    QVERIFY(again.path().isEmpty() && again.isModified());
  }

  void damagedRecovery_isRefusedWhole() {
    MissionDocument document;
    openPlanned(document);
    const std::string data = MissionDocument::recoveryData(document.snapshot());
    MissionDocument again;
    QVERIFY(again.open(at("n5.vpm")));
    const auto before = again.sharedMission();
    for (const std::size_t size : {std::size_t{0}, std::size_t{5}, std::size_t{25}, std::size_t{400}, data.size() / 2, data.size() - 1}) {
      const Result<void> restored = again.restore(data.substr(0, size));
      QVERIFY(!restored);
      QVERIFY(again.sharedMission() == before);
    }
    QVERIFY(again.restore("volplane-recovery 2 ...").error().code == Errc::NewerVersion);
    QVERIFY(!again.restore("volplane-recovery 1 99999999999999999999 1\n{}"));
  }

  void document_destroyedWithUnsavedWork_tellsNobody() {
    auto document = std::make_unique<MissionDocument>();
    moveNothing(*document);
    int told = 0;
    connect(document.get(), &MissionDocument::stateChanged, this, [&told] { ++told; });
    document.reset();
    QCOMPARE(told, 0);
  }

private:
  [[nodiscard]] QString at(const QString& name) const { return folder_->filePath(name); }

  static void moveNothing(MissionDocument& document) {
    document.edit(QStringLiteral("Name"), [](mission::Mission& m) { m.name = "unsaved"; });
  }

  /// n5 with quick settings, its terrain in the test's folder, and a current plan.
  void openPlanned(MissionDocument& document) {
    QVERIFY(document.open(at("n5.vpm")));
    const std::string terrain = document.mission().terrain.front();
    document.edit(QStringLiteral("Quick"), [this, &terrain](mission::Mission& m) {
      m = made_.plan->mission;
      m.terrain = {terrain};
    });
    document.undoStack().clear();
    auto plan = std::make_shared<mission::Plan>(*made_.plan);
    plan->mission.terrain = {terrain};
    plan->terrain.front().path = terrain;
    document.setPlan(std::move(plan));
  }

  test::QuickPlan made_;
  std::unique_ptr<QTemporaryDir> folder_;
};

QTEST_GUILESS_MAIN(TestMissionDocument)
#include "tst_mission_document.moc"
