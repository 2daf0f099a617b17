// The map of lowest safe altitudes as other programs read it.
#include "core/charts/safe_altitude_chart.h"
#include "core/formats/height_map.h"
#include "core/landing/build_roadmap.h"
#include "core/landing/safe_altitude_map.h"
#include "tests/support/mountain.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <array>
#include <cmath>
#include <memory>

using namespace vp;
using namespace vp::charts;

namespace {

using Dataset = std::unique_ptr<GDALDataset>;

Dataset opened(const QString& path, unsigned kind) {
  GDALAllRegister();
  return Dataset(GDALDataset::Open(qPrintable(path), kind));
}

float valueAt(GDALDataset& raster, int band, int column, int rowFromSouth) {
  float value = 0.0F;
  const CPLErr state = raster.GetRasterBand(band)->RasterIO(GF_Read, column, raster.GetRasterYSize() - 1 - rowFromSouth, 1, 1, &value, 1, 1,
                                                            GDT_Float32, 0, 0, nullptr);
  return state == CE_None ? value : std::nanf("");
}

}  // namespace

class TestSafeAltitudeChart : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    world_ = test::mountainWorld();
    landing::RoadmapRequest request;
    request.area = world_.terrain.grid().extent();
    roadmap_ = *landing::buildRoadmap(world_, mission::PlannerSettings{}, request, Job{});
    mission_.name = "Tour & <test>";
    mission_.aircraft = test::paperCessna();
    request_.area = {-2000.0, -2000.0, 2050.0, 1000.0};
    request_.cell = 150.0;
    request_.count = 4;
  }

  void tiff_holdsTheValuesInTheirPlaces() {
    QTemporaryDir folder;
    const QString path = folder.filePath("map.tif");
    const Result<ChartSummary> summary = write(path, request_);
    QVERIFY2(summary.has_value(), summary ? "" : summary.error().message().c_str());
    QCOMPARE(summary->columns, 27);
    QCOMPARE(summary->rows, 20);
    QCOMPARE(summary->bands, std::size_t{5});
    const Dataset raster = opened(path, GDAL_OF_RASTER);
    QVERIFY(raster != nullptr);
    QCOMPARE(raster->GetRasterCount(), 5);
    landing::MapRequest asked{request_.area, 150.0, {}, Angle::kPi / 4.0, 1};
    const geo::LatLon middle = frame_.toLatLon({25.0, -500.0});
    for (int i = 0; i < 4; ++i) {
      asked.headings.push_back(frame_.headingOf(Angle::degrees(90.0 * i), middle));
    }
    const Result<landing::SafeAltitudeMap> map = landing::safeAltitudeMap(world_, *roadmap_, asked, Job{});
    const std::vector<float> worst = map->worst();
    int known = 0;
    for (int row = 0; row < 20; ++row) {
      for (int column = 0; column < 27; ++column) {
        const auto i = static_cast<std::size_t>(row * 27 + column);
        known += std::isfinite(worst[i]) ? 1 : 0;
        QCOMPARE(valueAt(*raster, 1, column, row), std::isfinite(worst[i]) ? worst[i] : -32767.0F);
        QCOMPARE(valueAt(*raster, 3, column, row), std::isfinite(map->need[1][i]) ? map->need[1][i] : -32767.0F);
      }
    }
    QVERIFY(known > 300);
    QCOMPARE(QString(raster->GetRasterBand(3)->GetMetadataItem("VOLPLANE_COURSE")), QString("90.0"));
    QCOMPARE(QString(raster->GetRasterBand(1)->GetUnitType()), QString("m"));
    QCOMPARE(QString(raster->GetMetadataItem("VOLPLANE_CLEARANCE_M")), QString("100"));
    QVERIFY(QString(raster->GetMetadataItem("VOLPLANE_AIRCRAFT")).contains("Cessna"));
    QCOMPARE(QString(raster->GetMetadataItem("VOLPLANE_REACTION_TIME_S")), QString("0"));
    QCOMPARE(QString(raster->GetMetadataItem("VOLPLANE_APPROACH")), QString("at the touchdown point, by any curve"));
  }

  void tiff_liesWhereItsFrameIs() {
    QTemporaryDir folder;
    const QString path = folder.filePath("map.tif");
    ChartRequest request = request_;
    request.courses = Courses::One;
    QVERIFY(write(path, request).has_value());
    const Dataset raster = opened(path, GDAL_OF_RASTER);
    QCOMPARE(raster->GetRasterCount(), 1);
    std::array<double, 6> at{};
    raster->GetGeoTransform(at.data());
    OGRSpatialReference degrees;
    degrees.importFromEPSG(4326);
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> toDegrees(OGRCreateCoordinateTransformation(raster->GetSpatialRef(), &degrees));
    QVERIFY(toDegrees != nullptr);
    double x = at[0];
    double y = at[3] + at[5] * raster->GetRasterYSize();
    QVERIFY(toDegrees->Transform(1, &x, &y) != 0);
    const geo::LatLon corner = frame_.toLatLon({-2000.0, -2000.0});
    QVERIFY(geo::geodesicDistance(corner, {y, x}).si() < 0.01);
  }

  void contours_areNowhereBelowTheCells() {
    const Result<landing::SafeAltitudeMap> map =
        landing::safeAltitudeMap(world_, *roadmap_, {request_.area, 50.0, {0.0, 1.5708, 3.1416, 4.7124}, 0.7854, 2}, Job{});
    formats::HeightMap heights{"", frame_, map->originX, map->originY, map->cell, map->columns, map->rows, {{"worst", map->worst(), {}}}, {}};
    const Result<std::vector<formats::Contour>> contours = formats::contoursOf(heights, 0, 100.0, Job{});
    QVERIFY(contours.has_value());
    std::size_t points = 0;
    for (const formats::Contour& contour : *contours) {
      QVERIFY(std::abs(std::remainder(contour.altitude, 100.0)) < 1e-6);
      for (const geo::LatLon& place : contour.points) {
        const geo::Point point = frame_.toPoint(place);
        const int column = std::clamp(static_cast<int>(std::floor((point.x - map->originX) / map->cell)), 0, map->columns - 1);
        const int row = std::clamp(static_cast<int>(std::floor((point.y - map->originY) / map->cell)), 0, map->rows - 1);
        const float value = heights.bands[0].values[static_cast<std::size_t>(row * map->columns + column)];
        QVERIFY2(static_cast<double>(value) <= contour.altitude + 0.5, qPrintable(QString("%1 at %2").arg(double(value)).arg(contour.altitude)));
        ++points;
      }
    }
    QVERIFY(points > 500);
  }

  void kmlAndGeoPackage_holdTheSameContours() {
    QTemporaryDir folder;
    ChartRequest request = request_;
    request.courses = Courses::Worst;
    request.cell = 75.0;
    const Result<ChartSummary> kml = write(folder.filePath("map.kml"), request);
    const Result<ChartSummary> package = write(folder.filePath("map.gpkg"), request);
    QVERIFY(kml.has_value() && package.has_value());
    QVERIFY(kml->contours > 3);
    QFile file(folder.filePath("map.kml"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray text = file.readAll();
    QCOMPARE(static_cast<std::size_t>(text.count("<Placemark>")), kml->contours);
    QCOMPARE(static_cast<std::size_t>(text.count("<altitudeMode>absolute</altitudeMode>")), kml->contours);
    QVERIFY(text.contains("Tour &amp; &lt;test&gt;"));
    const Dataset lines = opened(folder.filePath("map.gpkg"), GDAL_OF_VECTOR);
    QVERIFY(lines != nullptr);
    OGRLayer* layer = lines->GetLayerByName("contours");
    QVERIFY(layer != nullptr);
    QCOMPARE(static_cast<std::size_t>(layer->GetFeatureCount()), package->contours);
    const std::unique_ptr<OGRFeature> feature(layer->GetNextFeature());
    const auto* line = feature->GetGeometryRef()->toLineString();
    QCOMPARE(line->getZ(0), feature->GetFieldAsDouble("altitude_m"));
    const geo::Point point = frame_.toPoint({line->getY(0), line->getX(0)});
    QVERIFY(request.area.grown(1.0).contains(point));
  }

  void badRequest_writesNothing() {
    QTemporaryDir folder;
    QVERIFY(!write(folder.filePath("map.txt"), request_).has_value());
    ChartRequest request = request_;
    request.interval = 0.0001;
    const Result<ChartSummary> dense = write(folder.filePath("map.kml"), request);
    QVERIFY(!dense.has_value());
    QVERIFY2(dense.error().what.find("wider interval") != std::string::npos, dense.error().what.c_str());
    const Result<ChartSummary> nowhere = write(folder.filePath("no/map.tif"), request_);
    QVERIFY(!nowhere.has_value());
    QCOMPARE(nowhere.error().code, Errc::OutputFailed);
    std::stop_source stop;
    stop.request_stop();
    const Result<ChartSummary> stopped =
        writeSafeAltitudeChart(world_, *roadmap_, frame_, mission_, request_, folder.filePath("map.tif").toStdString(), Job(stop.get_token()));
    QCOMPARE(stopped.error().code, Errc::Cancelled);
    QVERIFY(QDir(folder.path()).isEmpty());
  }

private:
  [[nodiscard]] Result<ChartSummary> write(const QString& path, const ChartRequest& request) const {
    return writeSafeAltitudeChart(world_, *roadmap_, frame_, mission_, request, path.toStdString(), Job{});
  }

  landing::World world_;
  std::shared_ptr<const landing::Roadmap> roadmap_;
  geo::LocalFrame frame_{{47.0, 11.0}};
  mission::Mission mission_;
  ChartRequest request_;
};

QTEST_APPLESS_MAIN(TestSafeAltitudeChart)
#include "tst_safe_altitude_chart.moc"
