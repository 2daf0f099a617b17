// Files of weather: fields by name, heights with units, what is written is read back exactly, what is refused.
#include "core/formats/weather_file.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <random>

using namespace vp;

namespace {

QByteArray feature(const QByteArray& properties, const QByteArray& ring = "[[8,47],[8.01,47],[8.01,47.01],[8,47.01],[8,47]]") {
  return R"({"type": "Feature", "properties": )" + properties + R"(, "geometry": {"type": "Polygon", "coordinates": [)" + ring + "]}}";
}

class Folder {
public:
  std::string path(const QString& name) const { return folder_.filePath(name).toStdString(); }
  std::string write(const QString& name, const QByteArray& features) const {
    QFile file(folder_.filePath(name));
    (void)file.open(QIODevice::WriteOnly);
    file.write(R"({"type": "FeatureCollection", "features": [)" + features + "]}");
    return file.fileName().toStdString();
  }

private:
  QTemporaryDir folder_;
};

}  // namespace

class TestWeatherFile : public QObject {
  Q_OBJECT

private slots:
  void written_isReadBackExactly() {
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<mission::WeatherCell> cells;
    for (int i = 0; i < 200; ++i) {
      mission::WeatherCell cell;
      cell.name = i % 3 == 0 ? "" : i % 3 == 1 ? "storm \"west\" of Chur" : "Böe 7";
      for (int k = 0; k < 3 + i % 5; ++k) {
        cell.outline.push_back({90.0 * unit(random), 360.0 * unit(random) - 180.0});
      }
      if (i % 2 == 0) {
        cell.floor = 5000.0 * unit(random);
      }
      if (i % 5 != 0) {
        cell.top = i % 7 == 0 ? 9000.0 : 5000.0 + 9000.0 * unit(random);
      }
      cell.success = i % 4 == 0 ? 1.0 : unit(random) + 1e-9;
      cell.perDistance = i % 6 == 0 ? 1852.0 : 1e4 * unit(random) + 1.0;
      cells.push_back(cell);
    }
    const Folder folder;
    const std::string path = folder.path("w.geojson");
    const Result<void> written = formats::writeWeather(path, cells);
    QVERIFY2(written.has_value(), written ? "" : written.error().message().c_str());
    const auto report = formats::readWeather(path);
    QVERIFY2(report.has_value(), report ? "" : report.error().message().c_str());
    QVERIFY(report->notes.empty());
    QCOMPARE(report->cells.size(), cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
      QVERIFY2(report->cells[i] == cells[i], qPrintable(QString("cell %1").arg(i)));
    }
  }

  void fields_areFoundByName() {
    const Folder folder;
    const std::string path =
        folder.write("w.geojson", feature(R"({"Name": "Cb", "FLOOR_FT": 10000, "TOP_FT": "25000", "SUCCESS": 0.8, "PER_NM": 2})") + "," +
                                      feature(R"({"hazard": "ICE", "base": "FL100", "top": "3500 m", "success": 0.95, "per_km": 5})") + "," +
                                      feature(R"({"BASE": "SFC", "TOP": "12000ft", "success": 0.5, "PER_M": 800})") + "," + feature(R"({"id": 7})"));
    const auto report = formats::readWeather(path);
    QVERIFY2(report.has_value(), report ? "" : report.error().message().c_str());
    QCOMPARE(report->cells.size(), std::size_t{4});
    const std::vector<mission::WeatherCell>& cells = report->cells;
    QCOMPARE(cells[0].name, std::string("Cb"));
    QVERIFY(cells[0].outline.size() == 4 && cells[0].outline[1] == (geo::LatLon{47.0, 8.01}));
    QVERIFY(std::abs(*cells[0].floor - 3048.0) < 1e-9 && std::abs(*cells[0].top - 7620.0) < 1e-9);
    QVERIFY(cells[0].success == 0.8 && cells[0].perDistance == 3704.0);
    QVERIFY(cells[1].name == "ICE" && std::abs(*cells[1].floor - 3048.0) < 1e-9 && *cells[1].top == 3500.0 && cells[1].perDistance == 5000.0);
    QVERIFY(!cells[2].floor && std::abs(*cells[2].top - 3657.6) < 1e-9 && cells[2].perDistance == 800.0);
    QVERIFY(!cells[3].floor && !cells[3].top && cells[3].success == 0.9 && cells[3].perDistance == 1852.0);
    QCOMPARE(report->notes.size(), std::size_t{1});
    QVERIFY(report->notes[0].find("1 cell does not say how likely it is to come through") != std::string::npos);
  }

  void partsBecomeCells_holesAreNamed() {
    const Folder folder;
    const std::string path = folder.write("m.geojson", R"({"type": "Feature", "properties": {"success": 0.9}, "geometry": {"type": "MultiPolygon",
      "coordinates": [[[[8,47],[8.1,47],[8.1,47.1],[8,47]],[[8.05,47.01],[8.06,47.01],[8.06,47.02],[8.05,47.01]]],[[[9,47],[9.1,47],[9,47.1],[9,47]]]]}})");
    const auto report = formats::readWeather(path);
    QVERIFY(report.has_value());
    QCOMPARE(report->cells.size(), std::size_t{2});
    QVERIFY(report->notes.size() == 1 && report->notes[0].find("a hole, which counts as weather too") != std::string::npos);
  }

  void whatCannotBeRead_isRefused_data() {
    QTest::addColumn<QByteArray>("features");
    QTest::addColumn<QString>("part");
    const auto row = [](const char* name, const QByteArray& features, const char* part) { QTest::newRow(name) << features << QString(part); };
    row("height without unit", feature(R"({"name": "Cb", "TOP": 25000})"),
        "feature 1 (Cb): TOP is \"25000\"; give it with its unit, for example 3000 m, 25000 ft or FL250");
    row("success in words", feature(R"({"SUCCESS": "good"})"), "feature 1: SUCCESS is \"good\"; give a number");
    row("points", R"({"type": "Feature", "properties": {}, "geometry": {"type": "Point", "coordinates": [8, 47]}})", "has no polygons");
    row("nothing", {}, "no feature has a polygon");
  }
  void whatCannotBeRead_isRefused() {
    QFETCH(QByteArray, features);
    QFETCH(QString, part);
    const Folder folder;
    const auto report = formats::readWeather(folder.write("w.geojson", features));
    QVERIFY(!report);
    QVERIFY2(QString::fromStdString(report.error().message()).contains(part), report.error().message().c_str());
    QVERIFY(report.error().where.ends_with("w.geojson"));
  }

  void numbersThatAreNone_areNotWritten() {
    const Folder folder;
    mission::WeatherCell cell;
    cell.outline = {{47.0, 8.0}, {47.0, 8.1}, {47.1, 8.0}};
    cell.top = std::numeric_limits<double>::quiet_NaN();
    const Result<void> written = formats::writeWeather(folder.path("w.geojson"), {cell});
    QVERIFY(!written && written.error().code == Errc::OutOfRange);
    QVERIFY(!QFile::exists(QString::fromStdString(folder.path("w.geojson"))));
  }
};

QTEST_APPLESS_MAIN(TestWeatherFile)
#include "tst_weather_file.moc"
