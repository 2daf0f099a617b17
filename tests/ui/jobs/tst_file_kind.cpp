// Files that an operator drops on the window, told apart by what they are.
#include "ui/jobs/file_kind.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace vp;
using jobs::NewFiles;
using jobs::newTo;
using jobs::sortFiles;

namespace {

const QString kMaps = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/");

}  // namespace

class TestFileKind : public QObject {
  Q_OBJECT

private slots:
  void init() {
    QVERIFY(QDir(folder_.path()).removeRecursively());
    QVERIFY(QDir().mkpath(folder_.path()));
    copy("mountain.tif", "mountain.tif");
    copy("alpine-airports.csv", "swiss_airports.csv");
    copy("alpine-runways.csv", "swiss_runways.csv");
    write("fields.cup", "name,code,country,lat,lon,elev,style,rwdir,rwlen,freq,desc\n");
  }

  void filesOfAllKinds_areSorted() {
    const Result<NewFiles> files = sortFiles({at("fields.cup"), at("swiss_runways.csv"), at("mountain.tif"), at("swiss_airports.csv")});
    QVERIFY2(files, files ? "" : files.error().message().c_str());
    QCOMPARE(files->terrain, std::vector<std::string>{at("mountain.tif").toStdString()});
    QCOMPARE(files->airfields.size(), std::size_t(2));
    QVERIFY((files->airfields[0] == mission::AirfieldSource{at("fields.cup").toStdString(), ""}));
    QVERIFY((files->airfields[1] == mission::AirfieldSource{at("swiss_airports.csv").toStdString(), at("swiss_runways.csv").toStdString()}));
  }

  void polygons_areToldByTheirFields() {
    const auto polygon = [&](const char* name, const char* properties) {
      write(name, R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{)" + QByteArray(properties) +
                      R"(},"geometry":{"type":"Polygon","coordinates":[[[9.9,46.6],[10,46.6],[10,46.7],[9.9,46.6]]]}}]})");
    };
    polygon("people.geojson", R"("NAME":"x","POPULATION":120)");
    polygon("storm.geojson", R"("NAME":"x","SUCCESS":0.8)");
    polygon("level.geojson", R"("TOP":"FL100")");
    polygon("field.geojson", R"("NAME":"x")");
    write("cities.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"name":"x","population":120},)"
                            R"("geometry":{"type":"Point","coordinates":[9.9,46.6]}}]})");
    const auto files =
        jobs::sortAllFiles({at("people.geojson"), at("storm.geojson"), at("level.geojson"), at("field.geojson"), at("cities.geojson")});
    QVERIFY2(files, files ? "" : files.error().message().c_str());
    QCOMPARE(files->map.population, std::vector<std::string>{at("people.geojson").toStdString()});
    QCOMPARE(files->weather, (QStringList{at("storm.geojson"), at("level.geojson")}));
    QCOMPARE(files->targets, (QStringList{at("field.geojson"), at("cities.geojson")}));
    const Result<NewFiles> again = newTo(
        [&] {
          mission::Mission mission;
          mission.populationFiles = files->map.population;
          return mission;
        }(),
        files->map);
    QVERIFY(!again && again.error().what.find("already") != std::string::npos);
  }

  void oneOfThePair_findsTheOtherBesideIt_data() {
    QTest::addColumn<QString>("given");
    QTest::newRow("airports") << "swiss_airports.csv";
    QTest::newRow("runways") << "swiss_runways.csv";
  }

  void oneOfThePair_findsTheOtherBesideIt() {
    QFETCH(QString, given);
    const Result<NewFiles> files = sortFiles({at(given)});
    QVERIFY2(files, files ? "" : files.error().message().c_str());
    QCOMPARE(files->airfields.size(), std::size_t(1));
    QVERIFY((files->airfields[0] == mission::AirfieldSource{at("swiss_airports.csv").toStdString(), at("swiss_runways.csv").toStdString()}));
  }

  void pairOfOtherNames_givenTogether_belongsTogether() {
    copy("alpine-airports.csv", "a.csv");
    copy("alpine-runways.csv", "b.csv");
    const Result<NewFiles> files = sortFiles({at("b.csv"), at("a.csv")});
    QVERIFY(files && files->airfields.size() == 1);
    QCOMPARE(QString::fromStdString(files->airfields[0].airports), at("a.csv"));
  }

  void whatFitsNothing_isRefusedByName_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("word");
    QTest::newRow("not there") << "none.tif"
                               << "no such file";
    QTest::newRow("text") << "readme.txt"
                          << "readme.txt";
    QTest::newRow("other csv") << "other.csv"
                               << "columns";
    QTest::newRow("airports alone") << "lonely.csv"
                                    << "runways.csv";
    QTest::newRow("mission") << "mission.vpm"
                             << "open it";
    QTest::newRow("plan") << "plan.VPP"
                          << "open it";
    QTest::newRow("folder") << "sub"
                            << "no such file";
  }

  void whatFitsNothing_isRefusedByName() {
    QFETCH(QString, name);
    QFETCH(QString, word);
    write("readme.txt", "hello");
    write("other.csv", "a,b,c\n1,2,3\n");
    copy("alpine-airports.csv", "lonely.csv");
    copy("mountain-n5.vpm", "mission.vpm");
    write("plan.VPP", "{}");
    QVERIFY(QDir(folder_.path()).mkpath("sub"));
    const Result<NewFiles> files = sortFiles({at("mountain.tif"), at(name)});
    QVERIFY(!files);
    const QString message = QString::fromStdString(files.error().message());
    QVERIFY2(message.contains(name) && message.contains(word), qPrintable(message));
  }

  void filesOfTheMission_areSkippedAndAllOfThemRefused() {
    mission::Mission mission;
    mission.terrain = {at("mountain.tif").toStdString()};
    const Result<NewFiles> some = sortFiles({at("mountain.tif"), at("fields.cup")}).and_then([&](const NewFiles& f) { return newTo(mission, f); });
    QVERIFY(some && some->terrain.empty() && some->airfields.size() == 1);
    const Result<NewFiles> none = sortFiles({at("mountain.tif")}).and_then([&](const NewFiles& f) { return newTo(mission, f); });
    QVERIFY(!none);
    QVERIFY2(none.error().message().find("mountain.tif: is part of the mission") != std::string::npos, none.error().message().c_str());
    QVERIFY(!newTo(mission, {}));
  }

  void fileGivenTwice_countsOnce() {
    const Result<NewFiles> files = sortFiles({at("mountain.tif"), at("mountain.tif"), at("fields.cup"), at("fields.cup")});
    QVERIFY(files);
    QCOMPARE(files->terrain.size(), std::size_t(1));
    QCOMPARE(files->airfields.size(), std::size_t(1));
  }

private:
  [[nodiscard]] QString at(const QString& name) const { return folder_.filePath(name); }
  void copy(const QString& from, const QString& to) const { QVERIFY(QFile::copy(kMaps + from, at(to))); }
  void write(const QString& name, const QByteArray& bytes) const {
    QFile file(at(name));
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size());
  }

  QTemporaryDir folder_;
};

QTEST_GUILESS_MAIN(TestFileKind)
#include "tst_file_kind.moc"
