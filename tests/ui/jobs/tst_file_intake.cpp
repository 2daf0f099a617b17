// Files on their way into the mission: sorted and read beside the window, in order, fitted to the mission as it is when they arrive.
#include "ui/jobs/file_intake.h"
#include "ui/jobs/workspace.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <memory>

using namespace vp;
using jobs::FileIntake;
using jobs::TargetsOfFile;
using Holds = FileIntake::Holds;
using Purpose = FileIntake::Purpose;

namespace {

const QString kMaps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");
constexpr int kPatience = 120'000;  // ms; a guard against hanging

QByteArray tableOf(int rows) {
  QByteArray text = "name,latitude,longitude\n";
  for (int i = 0; i < rows; ++i) {
    text += "W" + QByteArray::number(i) + ",46." + QByteArray::number(10000 + i) + ",9.5\n";
  }
  return text;
}

}  // namespace

class TestFileIntake : public QObject {
  Q_OBJECT

private slots:
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    desk_ = std::make_unique<jobs::Workspace>();
    which_ = [](const QString&) { return Holds::Neither; };
    choose_ = [](const TargetsOfFile& file) { return std::optional(*file.found); };
    asked_.clear();
    shown_.clear();
    refusals_.clear();
    added_.clear();
    intake_ = std::make_unique<FileIntake>(*desk_, FileIntake::Operator{[this](const QString& path) {
                                                                          asked_ << QFileInfo(path).fileName();
                                                                          return which_(path);
                                                                        },
                                                                        [this](const TargetsOfFile& file) {
                                                                          shown_ << QFileInfo(file.path).fileName();
                                                                          return choose_(file);
                                                                        }});
    connect(intake_.get(), &FileIntake::refused, this, [this](const Error& error) { refusals_ << QString::fromStdString(error.message()); });
    connect(intake_.get(), &FileIntake::targetsAdded, this,
            [this](const QString&, const formats::ImportedTargets& added) { added_.push_back(added); });
  }

  void cleanup() {
    intake_.reset();
    desk_.reset();
  }

  void filesOfEachKind_goWhereTheyBelong() {
    copy("mountain.tif", "m.tif");
    copy("alpine-airports.csv", "a_airports.csv");
    copy("alpine-runways.csv", "a_runways.csv");
    write("zone.txt", "AC R\nAN RANGE\nAL SFC\nAH UNL\nV X=46:30:00 N 009:30:00 E\nDC 1\n");
    write("places.csv", "name,latitude,longitude\nHut,46.5,9.5\n");
    write("fields.csv", "name,latitude,longitude,course_deg,length_m\nStrip,46.6,9.6,120,400\n");
    which_ = [](const QString&) { return Holds::Airfields; };
    intake_->take({at("places.csv"), at("m.tif"), at("fields.csv"), at("a_runways.csv"), at("a_airports.csv"), at("zone.txt")}, Purpose::Any);
    QVERIFY(intake_->isBusy());
    QCOMPARE(mission().terrain.size(), std::size_t(0));  // never within take()
    finish();
    QCOMPARE(refusals_, QStringList());
    QCOMPARE(mission().terrain, std::vector<std::string>{at("m.tif").toStdString()});
    QCOMPARE(mission().airfields.size(), std::size_t(2));
    QCOMPARE(mission().airspace.files, std::vector<std::string>{at("zone.txt").toStdString()});
    QCOMPARE(asked_, QStringList{"fields.csv"});
    QCOMPARE(shown_, QStringList{"places.csv"});
    QCOMPARE(names(), QStringList{"Hut"});
    QCOMPARE(steps(), (QStringList{"Add 4 file(s)", "Import targets from places.csv"}));
  }

  void doubtfulFile_becomesWhatTheOperatorSays_data() {
    QTest::addColumn<int>("answer");
    QTest::addColumn<int>("airfields");
    QTest::addColumn<int>("targets");
    QTest::newRow("airfields") << static_cast<int>(Holds::Airfields) << 1 << 0;
    QTest::newRow("targets") << static_cast<int>(Holds::Targets) << 0 << 1;
    QTest::newRow("neither") << static_cast<int>(Holds::Neither) << 0 << 0;
  }

  void doubtfulFile_becomesWhatTheOperatorSays() {
    QFETCH(int, answer);
    QFETCH(int, airfields);
    QFETCH(int, targets);
    write("strip.cup", "name,code,country,lat,lon,elev,style,rwdir,rwlen,freq,desc\nStrip,,CH,4632.046N,00953.046E,500m,2,120,400m,,\n");
    which_ = [answer](const QString&) { return static_cast<Holds>(answer); };
    intake_->take({at("strip.cup")}, Purpose::Any);
    finish();
    QCOMPARE(asked_, QStringList{"strip.cup"});
    QCOMPARE(static_cast<int>(mission().airfields.size()), airfields);
    QCOMPARE(static_cast<int>(mission().targets.size()), targets);
    QCOMPARE(refusals_, QStringList());
  }

  void filesForTheMap_areNeverTargets() {
    write("strip.cup", "name,code,country,lat,lon,elev,style,rwdir,rwlen,freq,desc\nStrip,,CH,4632.046N,00953.046E,500m,2,120,400m,,\n");
    write("way.gpx", R"(<gpx version="1.1"><wpt lat="46.5" lon="9.5"><name>W</name></wpt></gpx>)");
    intake_->take({at("strip.cup")}, Purpose::Map);
    intake_->take({at("way.gpx")}, Purpose::Map);
    finish();
    QCOMPARE(asked_, QStringList());
    QCOMPARE(mission().airfields.size(), std::size_t(1));
    QVERIFY(mission().targets.empty());
    QVERIFY2(refusals_.size() == 1 && refusals_[0].contains("way.gpx"), qPrintable(refusals_.join('|')));
  }

  void oneBadFile_addsNothingOfItsRequest() {
    copy("mountain.tif", "m.tif");
    write("readme.txt", "hello");
    write("places.csv", "name,latitude,longitude\nHut,46.5,9.5\n");
    intake_->take({at("m.tif"), at("places.csv"), at("readme.txt")}, Purpose::Any);
    intake_->take({at("places.csv")}, Purpose::Any);  // the next one is not its business
    finish();
    QVERIFY2(refusals_.size() == 1 && refusals_[0].contains("readme.txt"), qPrintable(refusals_.join('|')));
    QVERIFY(mission().terrain.empty());
    QCOMPARE(steps(), QStringList{"Import targets from places.csv"});
  }

  void bigFile_leavesTheWindowTurning() {
    write("world.csv", tableOf(1'000'000));
    int turns = 0;
    QTimer timer;
    connect(&timer, &QTimer::timeout, this, [&turns] { ++turns; });
    timer.start(0);
    QSignalSpy working(intake_.get(), &FileIntake::working);
    intake_->take({at("world.csv")}, Purpose::Targets);
    QCOMPARE(working.last()[0].toString(), QStringLiteral("Reading world.csv"));
    finish();
    QVERIFY2(turns > 0, "the event loop stood still");
    QVERIFY2(refusals_.size() == 1 && refusals_[0].contains("1000000 places"), qPrintable(refusals_.join('|')));
    QCOMPARE(working.last()[0].toString(), QString());
    QVERIFY(shown_.isEmpty());
  }

  void cancel_dropsWhatIsReadAndWhatWaits() {
    write("big.csv", tableOf(300'000));
    copy("mountain.tif", "m.tif");
    QSignalSpy working(intake_.get(), &FileIntake::working);
    intake_->take({at("big.csv")}, Purpose::Any);
    intake_->take({at("m.tif")}, Purpose::Any);
    intake_->cancel();
    QVERIFY(!intake_->isBusy());
    QCOMPARE(working.last()[0].toString(), QString());
    const qsizetype said = working.count();
    intake_->cancel();  // nothing is there to be cancelled
    QCOMPARE(working.count(), said);
    write("places.csv", "name,latitude,longitude\nHut,46.5,9.5\n");
    intake_->take({at("places.csv")}, Purpose::Targets);
    finish();
    QCOMPARE(steps(), QStringList{"Import targets from places.csv"});
    QCOMPARE(shown_, QStringList{"places.csv"});
    QCOMPARE(refusals_, QStringList());
  }

  void anotherDocument_getsNothingOfTheOneBefore() {
    copy("mountain.tif", "m.tif");
    write("places.csv", "name,latitude,longitude\nHut,46.5,9.5\n");
    intake_->take({at("m.tif")}, Purpose::Any);
    intake_->take({at("places.csv")}, Purpose::Targets);
    desk_->document().startNew();
    QVERIFY(!intake_->isBusy());
    QTest::qWait(0);
    intake_->take({at("places.csv")}, Purpose::Targets);  // whose answer comes after those of the ones before would have
    finish();
    QCOMPARE(shown_, QStringList{"places.csv"});
    QCOMPARE(steps(), QStringList{"Import targets from places.csv"});
  }

  void documentReplacedWhileAsking_getsNothing() {
    write("strip.cup", "name,code,country,lat,lon,elev,style,rwdir,rwlen,freq,desc\nStrip,,CH,4632.046N,00953.046E,500m,2,120,400m,,\n");
    write("places.csv", "name,latitude,longitude\nHut,46.5,9.5\n");
    which_ = [this](const QString&) {
      desk_->document().startNew();
      return Holds::Airfields;
    };
    choose_ = [this](const TargetsOfFile& file) {
      desk_->document().startNew();
      return std::optional(*file.found);
    };
    intake_->take({at("strip.cup"), at("places.csv")}, Purpose::Any);
    finish();
    QVERIFY(shown_.isEmpty());
    intake_->take({at("places.csv")}, Purpose::Targets);
    finish();
    QCOMPARE(shown_, QStringList{"places.csv"});
    QCOMPARE(desk_->document().undoStack().count(), 0);
    QVERIFY(mission().airfields.empty() && mission().targets.empty());
  }

  void editsMadeMeanwhile_areKeptAndNamesAreUniqueAmongThem() {
    write("places.csv", "name,latitude,longitude\nHut,46.5,9.5\nDam,46.6,9.5\nTop,46.7,9.5\n");
    intake_->take({at("places.csv")}, Purpose::Targets);
    edit("Hut", {47.0, 9.0});
    choose_ = [this](const TargetsOfFile& file) {
      edit("Dam", {47.1, 9.0});
      edit("Other", {46.7, 9.5});  // where Top is
      return std::optional(*file.found);
    };
    finish();
    QCOMPARE(names(), (QStringList{"Hut", "Dam", "Other", "Hut 2", "Dam 2"}));
    QCOMPARE(added_.size(), std::size_t(1));
    QCOMPARE(added_[0].targets.size(), std::size_t(2));
    QVERIFY2(added_[0].notes.size() == 1 && added_[0].notes[0].find("at the place of another target (Top)") != std::string::npos,
             added_[0].notes.empty() ? "no note" : added_[0].notes[0].c_str());
    desk_->document().undoStack().undo();
    QCOMPARE(names(), (QStringList{"Hut", "Dam", "Other"}));
  }

  void fileAddedMeanwhileByAnotherWay_isNotAddedTwice() {
    copy("mountain.tif", "m.tif");
    intake_->take({at("m.tif")}, Purpose::Any);
    desk_->document().edit("Add", [this](mission::Mission& m) { m.terrain.push_back(at("m.tif").toStdString()); });
    finish();
    QCOMPARE(mission().terrain.size(), std::size_t(1));
    QVERIFY2(refusals_.size() == 1 && refusals_[0].contains("part of the mission already"), qPrintable(refusals_.join('|')));
  }

  void severalRequests_keepTheirOrder() {
    write("a.csv", tableOf(4000));
    write("b.csv", "name,latitude,longitude\nHut,47.5,9.5\n");
    copy("mountain.tif", "m.tif");
    bool isNested = false;
    choose_ = [&](const TargetsOfFile& file) {
      if (!isNested) {
        isNested = true;
        intake_->take({at("c.csv")}, Purpose::Any);  // dropped while a dialog is open
        for (int i = 0; i < 50; ++i) {
          QCoreApplication::processEvents();
        }
      }
      return std::optional(*file.found);
    };
    write("c.csv", "name,latitude,longitude\nDam,47.6,9.5\n");
    intake_->take({at("a.csv")}, Purpose::Any);
    intake_->take({at("m.tif")}, Purpose::Any);
    intake_->take({at("b.csv")}, Purpose::Targets);
    finish();
    QCOMPARE(steps(), (QStringList{"Import targets from a.csv", "Add terrain", "Import targets from b.csv", "Import targets from c.csv"}));
    QCOMPARE(mission().targets.size(), std::size_t(4002));
  }

  void calledOff_addsNothingAndGoesOn() {
    write("a.csv", "name,latitude,longitude\nHut,46.5,9.5\n");
    write("b.csv", "name,latitude,longitude\nDam,46.6,9.5\n");
    choose_ = [](const TargetsOfFile& file) { return file.path.endsWith("a.csv") ? std::nullopt : std::optional(*file.found); };
    intake_->take({at("a.csv"), at("b.csv")}, Purpose::Targets);
    finish();
    QCOMPARE(shown_, (QStringList{"a.csv", "b.csv"}));
    QCOMPARE(steps(), QStringList{"Import targets from b.csv"});
  }

  void whatOtherOptionsMayHelp_isShownAndNotRefused() {
    write("track.gpx", R"(<gpx version="1.1"><trk><trkseg><trkpt lat="46.5" lon="9.5"/><trkpt lat="46.6" lon="9.5"/></trkseg></trk></gpx>)");
    write("land.geojson", R"({"type":"Feature","properties":{"name":"Land"},"geometry":{"type":"Polygon","coordinates":)"
                          R"([[[0,-60],[80,-60],[80,60],[0,60],[0,-60]]]}})");
    std::vector<std::size_t> sizes;
    choose_ = [&](const TargetsOfFile& file) -> std::optional<formats::ImportedTargets> {
      if (file.path.endsWith("track.gpx")) {
        sizes.push_back(file.found->targets.size());
        formats::TargetImportOptions options;
        options.tracks = true;
        return *file.read(options, Job());
      }
      sizes.push_back(file.found ? 1 : 0);
      return std::nullopt;
    };
    intake_->take({at("track.gpx"), at("land.geojson")}, Purpose::Targets);
    finish();
    QCOMPARE(refusals_, QStringList());
    QCOMPARE(sizes, (std::vector<std::size_t>{0, 0}));
    QCOMPARE(mission().targets.size(), std::size_t(2));
  }

  void unreadableTargets_areOneSentence_data() {
    QTest::addColumn<QByteArray>("content");
    QTest::addColumn<QString>("word");
    QTest::newRow("none of them") << QByteArray("hello") << "no file of targets";
    QTest::newRow("broken") << QByteArray("name,latitude,longitude\n\"open") << "row 2";
    QTest::newRow("nothing in it") << QByteArray("name,latitude,longitude\n") << "no places";
  }

  void unreadableTargets_areOneSentence() {
    QFETCH(QByteArray, content);
    QFETCH(QString, word);
    write("file.csv", content);
    intake_->take({at("file.csv")}, Purpose::Targets);
    finish();
    QVERIFY2(refusals_.size() == 1 && refusals_[0].contains("file.csv") && refusals_[0].contains(word), qPrintable(refusals_.join('|')));
    QVERIFY(shown_.isEmpty() && !desk_->document().isModified());
  }

private:
  [[nodiscard]] QString at(const QString& name) const { return folder_->filePath(name); }
  void copy(const QString& from, const QString& to) const { QVERIFY(QFile::copy(kMaps + from, at(to))); }
  void write(const QString& name, const QByteArray& bytes) const {
    QFile file(at(name));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
  }
  void finish() { QTRY_VERIFY_WITH_TIMEOUT(!intake_->isBusy(), kPatience); }
  [[nodiscard]] const mission::Mission& mission() const { return desk_->document().mission(); }
  void edit(const std::string& name, geo::LatLon place) const {
    desk_->document().edit("Add target", [&](mission::Mission& m) {
      m.targets.push_back({name, place, 100.0, mission::HeightReference::AboveGround});
    });
  }
  [[nodiscard]] QStringList names() const {
    QStringList names;
    for (const mission::Target& target : mission().targets) {
      names << QString::fromStdString(target.name);
    }
    return names;
  }
  [[nodiscard]] QStringList steps() const {
    QStringList steps;
    for (int i = 0; i < desk_->document().undoStack().count(); ++i) {
      steps << desk_->document().undoStack().text(i);
    }
    return steps;
  }

  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<jobs::Workspace> desk_;
  std::unique_ptr<FileIntake> intake_;
  std::function<Holds(const QString&)> which_;
  std::function<std::optional<formats::ImportedTargets>(const TargetsOfFile&)> choose_;
  QStringList asked_;
  QStringList shown_;
  QStringList refusals_;
  std::vector<formats::ImportedTargets> added_;
};

QTEST_GUILESS_MAIN(TestFileIntake)
#include "tst_file_intake.moc"
