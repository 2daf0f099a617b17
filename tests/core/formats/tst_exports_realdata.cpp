// What other programs say of our files: the published schemas by xmllint, GDAL's and gpsbabel's readers.
#include "core/formats/exports/export_formats.h"
#include "core/route/build_route.h"
#include "tests/core/formats/format_samples.h"
#include "tests/support/quick_plan.h"

#include <QProcess>

using namespace vp;
using namespace vp::formats;

namespace {

struct Run {
  int status = -1;
  QString text;
};

Run run(const QString& program, const QStringList& arguments) {
  QProcess process;
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(program, arguments);
  process.waitForFinished(60'000);
  return {process.error() == QProcess::FailedToStart ? -1 : process.exitCode(), QString::fromUtf8(process.readAll())};
}

}  // namespace

class TestExportsRealdata : public QObject {
  Q_OBJECT
private slots:
  void initTestCase() {
    if (!samples::dataFolder()) {
      QSKIP("the folder with the published schemas is not here; set VOLPLANE_DATA to it");
    }
    schemas_ = QString::fromStdString(*samples::dataFolder()) + "/schemas/";
    for (const ExportFormat& format : exportFormats()) {
      const mission::Plan plan = samples::sampleTour();
      route::RouteOptions options;
      options.stepsPerDegree = format.stepsPerDegree;
      const auto built = route::buildRoute(plan, nullptr, options, Job{});
      QVERIFY(built);
      count_ = static_cast<int>(built->route.waypoints.size());
      folder_.write(format.name + "." + format.extension, *format.write({plan, &built->route}));
    }
    mission::Mission home = test::quickMission(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm");
    home.home = mission::HomeBase{"MTSW/13", "MTNE/12"};
    const test::QuickPlan made = test::quickPlan(home);
    const auto ground = route::prepareGround(*made.plan, made.loaded.terrain, Job{});
    QVERIFY(ground);
    const auto built = route::buildRoute(*made.plan, &*ground, {}, Job{});
    QVERIFY(built);
    for (const char* name : {"gpx", "kml", "lnmpln", "gpkg"}) {
      folder_.write(std::string("home.") + name, *findExportFormat(name)->write({*made.plan, &built->route}));
    }
    homeCount_ = static_cast<int>(built->route.waypoints.size());
  }

  void xmlFile_isValidByItsSchema_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("schema");
    QTest::newRow("GPX") << "gpx.gpx"
                         << "gpx11.xsd";
    QTest::newRow("KML") << "kml.kml"
                         << "kml22gx.xsd";
    QTest::newRow("Little Navmap") << "lnmpln.lnmpln"
                                   << "lnmpln.xsd";
    QTest::newRow("GPX from home") << "home.gpx"
                                   << "gpx11.xsd";
    QTest::newRow("KML from home") << "home.kml"
                                   << "kml22gx.xsd";
    QTest::newRow("Little Navmap from home") << "home.lnmpln"
                                             << "lnmpln.xsd";
  }
  void xmlFile_isValidByItsSchema() {
    QFETCH(QString, file);
    QFETCH(QString, schema);
    const Run judged = run("xmllint", {"--noout", "--nonet", "--schema", schemas_ + schema, path(file)});
    QVERIFY2(judged.status == 0, qPrintable(judged.text));
  }

  void gdal_readsLayersAndPlaces_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("layer");
    QTest::addColumn<int>("features");
    QTest::newRow("GPX route points") << "gpx.gpx"
                                      << "route_points" << count_ + 1;
    QTest::newRow("KML waypoints") << "kml.kml"
                                   << "Waypoints" << count_;
    QTest::newRow("KMZ waypoints") << "kmz.kmz"
                                   << "Waypoints" << count_;
    QTest::newRow("GeoPackage waypoints") << "gpkg.gpkg"
                                          << "waypoints" << count_;
    QTest::newRow("GeoPackage tour") << "gpkg.gpkg"
                                     << "tour" << 1;
    QTest::newRow("GPX route from home") << "home.gpx"
                                         << "route_points" << homeCount_;
    QTest::newRow("GeoPackage from home") << "home.gpkg"
                                          << "waypoints" << homeCount_;
  }
  void gdal_readsLayersAndPlaces() {
    QFETCH(QString, file);
    QFETCH(QString, layer);
    QFETCH(int, features);
    const Run read = run("ogrinfo", {"-ro", "-so", path(file), layer});
    QVERIFY2(read.status == 0 && read.text.contains(QStringLiteral("Feature Count: %1\n").arg(features)), qPrintable(read.text));
    QVERIFY2(!read.text.contains("Warning") && !read.text.contains("ERROR"), qPrintable(read.text));
  }

  void gpsbabel_readsPointsAndTrack_data() {
    QTest::addColumn<QString>("kind");
    QTest::addColumn<QString>("file");
    QTest::newRow("GPX") << "gpx"
                         << "gpx.gpx";
    QTest::newRow("KML") << "kml"
                         << "kml.kml";
  }
  void gpsbabel_readsPointsAndTrack() {
    QFETCH(QString, kind);
    QFETCH(QString, file);
    const Run read = run("gpsbabel", {"-r", "-w", "-t", "-i", kind, "-f", path(file), "-o", "gpx", "-F", "-"});
    QVERIFY2(read.status == 0 && read.text.contains("Target 1"), qPrintable(read.text.left(500)));
  }

private:
  [[nodiscard]] QString path(const QString& file) const { return QString::fromStdString(folder_.path(file.toStdString())); }
  samples::Folder folder_;
  QString schemas_;
  int count_ = 0;
  int homeCount_ = 0;
};

QTEST_APPLESS_MAIN(TestExportsRealdata)
#include "tst_exports_realdata.moc"
