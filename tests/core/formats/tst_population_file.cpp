// Files of population: fields by name, densities, land areas, coordinate systems, what is left out; and the census of Suffolk County.
#include "core/formats/population_file.h"
#include "tests/support/data_folder.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace vp;

namespace {

QByteArray collection(const QByteArray& features, const QByteArray& system = {}) {
  return R"({"type": "FeatureCollection", )" + system + R"("features": [)" + features + "]}";
}

/// A square of a hundredth of a degree with these properties.
QByteArray feature(const QByteArray& properties, const QByteArray& ring = "[[8,47],[8.01,47],[8.01,47.01],[8,47.01],[8,47]]") {
  return R"({"type": "Feature", "properties": )" + properties + R"(, "geometry": {"type": "Polygon", "coordinates": [)" + ring + "]}}";
}

class Folder {
public:
  std::string write(const QString& name, const QByteArray& text) {
    QFile file(folder_.filePath(name));
    (void)file.open(QIODevice::WriteOnly);
    file.write(text);
    return file.fileName().toStdString();
  }

private:
  QTemporaryDir folder_;
};

}  // namespace

class TestPopulationFile : public QObject {
  Q_OBJECT

private slots:
  void fields_areFoundByName() {
    Folder folder;
    const auto path =
        folder.write("p.geojson", collection(feature(R"({"name": "Bach", "Population": 120})") + "," + feature(R"({"Pop. density": 450.5})") + "," +
                                             feature(R"({"POP": "1200", "ALAND": 3000000})")));
    const auto report = formats::readPopulation(path);
    QVERIFY2(report.has_value(), report ? "" : report.error().message().c_str());
    QCOMPARE(report->areas.size(), std::size_t{3});
    QCOMPARE(report->areas[0].people, std::optional(120.0));
    QCOMPARE(report->areas[0].name, std::string("feature 1 (Bach)"));
    QCOMPARE(report->areas[0].source, path);
    QCOMPARE(report->areas[0].parts[0].outline.size(), std::size_t{4});
    QCOMPARE(report->areas[0].parts[0].outline[1], (geo::LatLon{47.0, 8.01}));
    QCOMPARE(report->areas[1].perSquareKm, std::optional(450.5));
    QVERIFY(!report->areas[2].people && std::abs(*report->areas[2].perSquareKm - 400.0) < 1e-9);
    QVERIFY(report->notes.empty());
  }

  void partsAndHoles_areKept() {
    Folder folder;
    const auto path = folder.write("m.geojson", collection(R"({"type": "Feature", "properties": {"people": 5}, "geometry": {"type": "MultiPolygon",
      "coordinates": [[[[8,47],[8.1,47],[8.1,47.1],[8,47]],[[8.05,47.01],[8.06,47.01],[8.06,47.02],[8.05,47.01]]],[[[9,47],[9.1,47],[9,47.1],[9,47]]]]}})"));
    const auto report = formats::readPopulation(path);
    QVERIFY(report.has_value());
    QCOMPARE(report->areas.size(), std::size_t{1});
    QCOMPARE(report->areas[0].parts.size(), std::size_t{2});
    QCOMPARE(report->areas[0].parts[0].holes.size(), std::size_t{1});
  }

  void nationalGrid_becomesDegrees() {
    Folder folder;
    // the old observatory of Bern, 46.951083 N 7.438637 E, is 2600000 / 1200000 in the Swiss grid (swisstopo, Formulas, 2016)
    const auto path =
        folder.write("ch.geojson", collection(feature(R"({"pop": 7})", "[[2600000,1200000],[2600100,1200000],[2600100,1200100],[2600000,1200000]]"),
                                              R"("crs": {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::2056"}}, )"));
    const auto report = formats::readPopulation(path);
    QVERIFY2(report.has_value(), report ? "" : report.error().message().c_str());
    const geo::LatLon corner = report->areas[0].parts[0].outline[0];
    QVERIFY(std::abs(corner.latitude_deg - 46.951083) < 2e-5 && std::abs(corner.longitude_deg - 7.438637) < 2e-5);
  }

  void unusableFeatures_areNoted() {
    Folder folder;
    const auto report =
        formats::readPopulation(folder.write("n.geojson", collection(feature(R"({"pop": 5})") + "," + feature(R"({"pop": null})") +
                                                                     R"(, {"type": "Feature", "properties": {"pop": 3}, "geometry": null})")));
    QVERIFY(report.has_value());
    QCOMPARE(report->areas.size(), std::size_t{1});
    QCOMPARE(report->notes, (std::vector<std::string>{"n.geojson: 1 feature without a polygon left out; nobody is taken to live there.",
                                                      "n.geojson: 1 feature without a number of people left out; nobody is taken to live there."}));
  }

  void badFiles_areRefused_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("words");
    QTest::newRow("empty") << QByteArray() << "no file of polygons";
    QTest::newRow("text") << QByteArray("hello") << "no file of polygons";
    QTest::newRow("no field") << collection(feature(R"({"height": 5})")) << "no field of this file says how many people";
    QTest::newRow("points") << QByteArray(R"({"type": "Feature", "properties": {"pop": 1}, "geometry": {"type": "Point", "coordinates": [8, 47]}})")
                            << "no polygons";
    QTest::newRow("no numbers") << collection(feature(R"({"pop": null, "density": null})")) << "no feature has both";
  }

  void badFiles_areRefused() {
    QFETCH(QByteArray, text);
    QFETCH(QString, words);
    Folder folder;
    const std::string path = folder.write("bad.geojson", text);
    const auto report = formats::readPopulation(path);
    QVERIFY(!report);
    QVERIFY2(QString::fromStdString(report.error().message()).contains(words), report.error().message().c_str());
    QCOMPARE(report.error().where, path);
  }

  void missingFile_isSaid() {
    const auto report = formats::readPopulation("/nowhere/people.geojson");
    QVERIFY(!report && report.error().code == Errc::BadFile);
  }

  void suffolkCounty_isTheSameInBothFormats() {
    const QString data = test::dataFolder();
    if (data.isEmpty()) {
      QSKIP("no folder with real data (VOLPLANE_DATA)");
    }
    const auto shape = formats::readPopulation((data + "/census/suffolk_tracts.shp").toStdString());
    const auto json = formats::readPopulation((data + "/census/suffolk_tracts_pop.geojson").toStdString());
    QVERIFY(shape && json);
    QCOMPARE(shape->areas.size(), std::size_t{320});
    QCOMPARE(json->areas.size(), std::size_t{320});
    double people = 0.0;
    for (std::size_t i = 0; i < 320; ++i) {
      people += *shape->areas[i].people;
      QCOMPARE(shape->areas[i].people, json->areas[i].people);
    }
    QCOMPARE(people, 1419369.0);  // as the data's description says
  }
};

QTEST_APPLESS_MAIN(TestPopulationFile)
#include "tst_population_file.moc"
