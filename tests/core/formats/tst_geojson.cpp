#include "core/formats/exports/writers.h"
#include "core/geo/local_frame.h"
#include "core/mission/glide_conditions.h"
#include "tests/core/formats/format_samples.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QJsonParseError>
#include <QJsonValue>
#include <QTest>

#include <cmath>

using namespace vp;
using namespace vp::formats;

namespace {

/// The sample, whose glides the test computes without wind and at one density.
mission::Plan planInStillAir() {
  mission::Plan plan = samples::samplePlan();
  plan.mission.wind.clear();
  plan.mission.atmosphere.reset();
  return plan;
}

}  // namespace

class TestGeojson : public QObject {
  Q_OBJECT
  mission::Plan plan_ = planInStillAir();
  QJsonObject root_;

  QList<QJsonObject> ofKind(const QString& kind) const {
    QList<QJsonObject> found;
    for (const QJsonValue& feature : root_["features"].toArray()) {
      if (feature["properties"]["kind"].toString() == kind) {
        found.append(feature.toObject());
      }
    }
    return found;
  }
  geo::Point placeOf(const QJsonArray& position) const {
    return geo::LocalFrame(plan_.frameOrigin).toPoint({position[1].toDouble(), position[0].toDouble()});
  }

private slots:
  void initTestCase() {
    const std::string text = *exports::geojson({plan_});
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text), &error);
    QCOMPARE(error.error, QJsonParseError::NoError);
    root_ = document.object();
    QCOMPARE(text, *exports::geojson({plan_}));
  }

  void collection_holdsEverythingOnce() {
    QCOMPARE(root_["type"].toString(), QString("FeatureCollection"));
    QVERIFY(root_["heightNote"].toString().contains("mean sea level") && root_["heightNote"].toString().contains("ellipsoid"));
    const auto points = static_cast<qsizetype>(plan_.tour.size());
    QCOMPARE(ofKind("tour").size(), 1);
    QCOMPARE(ofKind("spiral").size(), 1);
    QCOMPARE(ofKind("target").size(), 4);
    QCOMPARE(ofKind("site").size(), 2);
    QCOMPARE(ofKind("decisionPoint").size(), points);
    QCOMPARE(ofKind("glide").size(), points);
    QCOMPARE(ofKind("departure").size(), 2);  // without and with a gliding guarantee
    QCOMPARE(ofKind("arrival").size(), 1);
    QCOMPARE(root_["features"].toArray().size(), 2 * points + 11);
    for (const QJsonValue& feature : root_["features"].toArray()) {
      QCOMPARE(feature["type"].toString(), QString("Feature"));
      QVERIFY(feature["properties"].toObject().contains("alt_msl_m") && feature["properties"].toObject().contains("alt_msl_ft"));
    }
  }

  void tour_isClosedAndNearTheCurve() {
    const QJsonObject tour = ofKind("tour").front();
    QCOMPARE(tour["geometry"]["type"].toString(), QString("LineString"));
    const QJsonArray line = tour["geometry"]["coordinates"].toArray();
    QCOMPARE(line.first().toArray(), line.last().toArray());
    QCOMPARE(tour["properties"]["alt_msl_m"].toArray().size(), line.size());
    QCOMPARE(tour["properties"]["certified"].toBool(), true);
    // Longitude first: the frame lies at 9.9 E, 46.6 N.
    QVERIFY(std::abs(line.first().toArray()[0].toDouble() - 9.9) < 0.1 && std::abs(line.first().toArray()[1].toDouble() - 46.6) < 0.1);
    double length = 0.0;
    for (qsizetype i = 1; i < line.size(); ++i) {
      length += geo::distance(placeOf(line[i - 1].toArray()), placeOf(line[i].toArray()));
    }
    const double expected = 4.0 * (2000.0 + Angle::kPi / 2.0 * 114.0);
    QVERIFY2(std::abs(length - expected) < 5.0, std::to_string(length).c_str());
    QVERIFY(std::abs(line[0].toArray()[2].toDouble() - plan_.tour[0].altitude) < 0.006);
  }

  void glide_descendsFromTheTourAtTheModelsAngle() {
    const QJsonObject glide = ofKind("glide").at(5);
    const QJsonArray line = glide["geometry"]["coordinates"].toArray();
    const mission::DecisionPoint& from = plan_.tour[5];
    QVERIFY(geo::distance(placeOf(line.first().toArray()), from.pose.point()) < 0.02);
    geo::Pose end = from.pose;
    const aircraft::GlideModel model(plan_.mission.aircraft, mission::glideConditionsOf(plan_.mission, plan_.sites));
    double loss = 0.0;
    double distance = 0.0;
    for (const flight::Piece& piece : from.witness.pieces) {
      end = flight::endOf(end, piece);
      loss += piece.length * model.lossAt(piece.radius);
      distance += piece.length;
    }
    QVERIFY(geo::distance(placeOf(line.last().toArray()), end.point()) < 0.02);
    QVERIFY(std::abs(line.last().toArray()[2].toDouble() - (from.altitude - loss)) < 0.006);
    QVERIFY(std::abs(glide["properties"]["distance_m"].toDouble() - distance) < 0.06);
    QVERIFY(std::abs(glide["properties"]["margin_m"].toDouble() - 12.5) < 0.006);
    QCOMPARE(glide["properties"]["site"].toString(), QString::fromStdString(plan_.sites[1].site.id));
    QCOMPARE(glide["properties"]["decisionPoint"].toInt(), 5);
  }

  void points_carryTheirValues() {
    const QJsonObject target = ofKind("target").at(1);
    QCOMPARE(target["properties"]["name"].toString(), QString("Target 2"));
    QVERIFY(geo::distance(placeOf(target["geometry"]["coordinates"].toArray()), plan_.targets[1].point) < 0.02);
    QVERIFY(std::abs(target["properties"]["alt_msl_ft"].toDouble() * kMetresPerFoot - plan_.targets[1].altitude) < 0.03);
    const QJsonObject visit = ofKind("decisionPoint").at(20);
    QCOMPARE(visit["properties"]["target"].toString(), QString("Target 1"));
    QVERIFY(std::abs(visit["properties"]["margin_m"].toDouble() - 12.5) < 0.006);
    QVERIFY(!ofKind("decisionPoint").at(21)["properties"].toObject().contains("target"));
    QCOMPARE(ofKind("site").at(0)["properties"]["id"].toString(), QString("LSZS/21"));
    QCOMPARE(ofKind("site").at(0)["properties"]["approximate"].toBool(), true);
  }

  void spiral_goesDownAndUpAgain() {
    const QJsonArray line = ofKind("spiral").at(0)["geometry"]["coordinates"].toArray();
    double lowest = 1e9;
    for (const QJsonValue& position : line) {
      lowest = std::min(lowest, position.toArray()[2].toDouble());
    }
    QVERIFY(std::abs(lowest - 2300.5) < 0.006);
    QVERIFY(std::abs(line.first().toArray()[2].toDouble() - 2600.0) < 0.006 && std::abs(line.last().toArray()[2].toDouble() - 2600.0) < 0.006);
    QVERIFY(geo::distance(placeOf(line.first().toArray()), placeOf(line.last().toArray())) < 0.05);
  }

  void oddPlans_areDrawnAsFarAsTheyGo() {
    mission::Plan plan = samples::samplePlan();
    plan.tour[0].witness.site = -1;
    plan.tour[1].witness.pieces = {{flight::Turn::Left, 1e-6, 1e7}};  // no glide exists on such a radius
    plan.spirals[0].target = -1;
    QVERIFY(QJsonDocument::fromJson(QByteArray::fromStdString(*exports::geojson({plan}))).isObject());
    plan.tour.clear();
    QVERIFY(QJsonDocument::fromJson(QByteArray::fromStdString(*exports::geojson({plan}))).isObject());
  }
};

QTEST_APPLESS_MAIN(TestGeojson)
#include "tst_geojson.moc"
