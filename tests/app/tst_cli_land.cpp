// volplane-cli land as a user runs it: runway and way, what is said where there is none, and what bad input gets.
#include "tests/support/cli_run.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using vp::test::CliResult;
using vp::test::runCli;

namespace {

const QString kMission = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine-n10.vpm");

CliResult land(const QString& at, const QStringList& options = {}, const QString& deadline = QStringLiteral("300ms")) {
  return runCli(QStringList{"land", kMission, "--at", at, "--deadline", deadline} + options);
}

}  // namespace

class TestCliLand : public QObject {
  Q_OBJECT

private slots:
  void combined_namesRunwayAndWay() {
    const CliResult said = land("-27.14060,46.56288,2600m,90");
    QCOMPARE(said.status, 0);
    QVERIFY2(said.out.contains("land at VA") && said.out.contains(" km to fly, ") && said.out.contains("m of height in hand"), said.out);
    QVERIFY2(said.out.contains("turn of ") && said.out.contains("straight on "), said.out);
    QVERIFY2(said.out.contains("verified by the checker; found by "), said.out);
  }

  /// The same way, then with a town laid across it: planners go around, or say what they fly over.
  void population_isAskedForAndTold() {
    QTemporaryDir folder;
    const QString town = folder.filePath("town.geojson");
    QFile file(town);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"POPULATION": 50000}, "geometry": {"type": "Polygon",
      "coordinates": [[[-27.16, 46.60], [-27.11, 46.60], [-27.11, 46.64], [-27.16, 46.64], [-27.16, 46.60]]]}}]})");
    file.close();
    const CliResult said = land("-27.14060,46.56288,2600m,90", {"--population", town});
    QCOMPARE(said.status, 0);
    QVERIFY2(said.out.contains("people under the path"), said.out);
    const CliResult missing = land("-27.14060,46.56288,2600m,90", {"--population", folder.filePath("none.geojson")});
    QCOMPARE(missing.status, 2);
    QVERIFY2(missing.err.contains("none.geojson"), missing.err);
  }

  /// The mission's own weather and people are used where no option names others.
  void weatherAndPeopleOfTheMission_areUsed() {
    QTemporaryDir folder;
    QFile original(kMission);
    QVERIFY(original.open(QIODevice::ReadOnly));
    QJsonObject mission = QJsonDocument::fromJson(original.readAll()).object();
    const QDir maps = QFileInfo(kMission).absoluteDir();
    mission["terrain"] = QJsonArray{maps.absoluteFilePath(mission["terrain"].toArray()[0].toString())};
    QJsonObject fields = mission["airfields"].toArray()[0].toObject();
    for (const QString& name : fields.keys()) {
      fields[name] = maps.absoluteFilePath(fields[name].toString());
    }
    mission["airfields"] = QJsonArray{fields};
    const QJsonArray ring{QJsonArray{-27.20, 46.50}, QJsonArray{-27.05, 46.50}, QJsonArray{-27.05, 46.62}, QJsonArray{-27.20, 46.62}};
    mission["weather"] = QJsonArray{QJsonObject{{"name", "storm"}, {"outline", ring}, {"success", 0.5}, {"perDistance_m", 1000}}};
    mission["population"] = QJsonArray{"people.geojson"};
    const auto write = [&](const char* name, const QByteArray& text) {
      QFile file(folder.filePath(name));
      QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    };
    write("own.vpm", QJsonDocument(mission).toJson());
    write("people.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"DENSITY":50},"geometry":
        {"type":"Polygon","coordinates":[[[-27.5,46.3],[-26.8,46.3],[-26.8,46.9],[-27.5,46.9],[-27.5,46.3]]]}}]})");
    const QStringList asked{"land",  folder.filePath("own.vpm"), "--at", "-27.14060,46.56288,2600m,90", "--deadline", "300ms", "--planner", "dlvg",
                            "--json"};
    const CliResult own = runCli(asked);
    QVERIFY2(own.status == 0 && own.out.contains("success probability in weather") && own.out.contains("people under the path"), own.out + own.err);
    QVERIFY(QFile::remove(folder.filePath("people.geojson")));
    const CliResult missing = runCli(asked);
    QVERIFY2(missing.status == 2 && missing.err.contains("people.geojson"), missing.err);
  }

  /// A storm over the valley to the south-east: the way goes around, or says what it meets; runways are ranked with it.
  void weather_isFlownAroundAndTold() {
    QTemporaryDir folder;
    const QString storm = folder.filePath("storm.geojson");
    const auto write = [&](const QByteArray& ring) {
      QFile file(storm);
      QVERIFY(file.open(QIODevice::WriteOnly));
      file.write(R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"NAME": "storm", "SUCCESS": 0.5, "PER_KM": 1},
        "geometry": {"type": "Polygon", "coordinates": [[)" +
                 ring + "]]}}]}");
    };
    write("[-27.10, 46.50], [-27.05, 46.50], [-27.05, 46.58], [-27.10, 46.58], [-27.10, 46.50]");
    const CliResult straight = land("-27.14060,46.56288,2600m,90", {"--weather", storm, "--planner", "straight", "--json"});
    const CliResult around = land("-27.14060,46.56288,2600m,90", {"--weather", storm, "--planner", "dvprm", "--json"});
    QVERIFY2(straight.status == 0 && around.status == 0, straight.out + around.out);
    const auto success = [](const CliResult& said) {
      for (const QJsonValue& term : QJsonDocument::fromJson(said.out).object()["terms"].toArray()) {
        if (term.toObject()["name"].toString() == "success probability in weather") {
          return term.toObject()["value"].toDouble();
        }
      }
      return -1.0;
    };
    QVERIFY2(success(straight) > 0.0 && success(around) >= success(straight), around.out);
    const QJsonArray ranking = QJsonDocument::fromJson(around.out).object()["ranking"].toArray();
    QVERIFY(ranking.size() > 4 && ranking[0].toObject()["reached"].toBool());
    double last = 0.0;
    for (const QJsonValue& runway : ranking) {
      const QJsonObject one = runway.toObject();
      double sum = 0.0;
      for (const QJsonValue& line : one["lines"].toArray()) {
        sum += line.toObject()["logRisk"].toDouble();
        QVERIFY(!line.toObject()["sentence"].toString().isEmpty());
      }
      QVERIFY(one["lines"].toArray().size() == 10 && std::abs(sum - one["logRisk"].toDouble()) < 1e-9 && one["logRisk"].toDouble() >= last);
      last = one["logRisk"].toDouble();
    }
    const CliResult said = land("-27.14060,46.56288,2600m,90", {"--weather", storm, "--planner", "dlvg"});
    QVERIFY2(said.out.contains("comes through the weather with a probability of ") && said.out.contains("runways by total risk, ") &&
                 said.out.contains("weather on the way: "),
             said.out);
    write("[-27.10, 46.50], [-27.05, 46.58], [-27.05, 46.50], [-27.10, 46.58], [-27.10, 46.50]");
    const CliResult crossed = land("-27.14060,46.56288,2600m,90", {"--weather", storm});
    QCOMPARE(crossed.status, 2);
    QVERIFY2(crossed.err.contains("storm.geojson: weather cell 1 (storm): sides of its outline cross each other at 46.54"), crossed.err);
    const CliResult missing = land("-27.14060,46.56288,2600m,90", {"--weather", folder.filePath("none.geojson")});
    QVERIFY2(missing.status == 2 && missing.err.contains("none.geojson"), missing.err);
  }

  void everyPlanner_answersInJson_data() {
    QTest::addColumn<QString>("planner");
    for (const char* planner : {"roadmap", "anytime", "dubins", "gradient", "hrm", "dvprm", "combined"}) {
      QTest::newRow(planner) << planner;
    }
  }
  void everyPlanner_answersInJson() {
    QFETCH(QString, planner);
    // one search from end to end, which a build with sanitizers or a busy machine does not end while others have long had an answer
    const QString deadline = planner == "gradient" ? QStringLiteral("60s") : QStringLiteral("300ms");
    const CliResult said = land("-27.14060,46.56288,8530ft,90", {"--planner", planner, "--json"}, deadline);
    QCOMPARE(said.status, 0);
    const QJsonObject json = QJsonDocument::fromJson(said.out).object();
    QVERIFY2(json["reachesRunway"].toBool() && json["verified"].toBool() && json["isRunway"].toBool(), said.out);
    QCOMPARE(json["asked"].toString(), planner);
    QVERIFY(json["site"].toString().startsWith("VA") && json["heightInHand_m"].toDouble() > 0.0);
    const QJsonArray path = json["path"].toArray();
    QVERIFY(path.size() >= 2);
    double altitude = 2600.0;
    for (const QJsonValue& leg : path) {
      QVERIFY(leg.toObject()["altitude_m"].toDouble() < altitude);
      altitude = leg.toObject()["altitude_m"].toDouble();
    }
    QVERIFY(altitude >= json["elevation_m"].toDouble());
    double cost = 0.0;
    for (const QJsonValue& term : json["terms"].toArray()) {
      cost += term.toObject()["value"].toDouble() * term.toObject()["weight"].toDouble();
    }
    QVERIFY(std::abs(cost - json["cost"].toDouble()) < 1e-6 && json["lowerBound"].toDouble() <= cost);
  }

  void inWind_theRunwayIsVerifiedToo() {
    const CliResult said = land("-27.14060,46.56288,2600m,90", {"--wind", "270/15kt", "--planner", "anytime", "--json"});
    const QJsonObject json = QJsonDocument::fromJson(said.out).object();
    QVERIFY2(said.status == 0 && json["verified"].toBool(), said.out + said.err);
  }

  void noRunwayInRange_isSaidWithTheFarthestGlide() {
    const CliResult said = land("-27.14060,46.56288,2120m,90", {"--planner", "anytime"});
    QCOMPARE(said.status, 1);
    QVERIFY2(said.out.contains("NO RUNWAY: "), said.out);
    QVERIFY2(said.out.contains("not a runway: this glide gets farthest"), said.out);
    const CliResult json = land("-27.14060,46.56288,2120m,90", {"--planner", "combined", "--json"});
    QCOMPARE(json.status, 1);
    const QJsonObject object = QJsonDocument::fromJson(json.out).object();
    QVERIFY2(!object["reachesRunway"].toBool() && !object["isRunway"].toBool(true) && !object["whyNot"].toString().isEmpty(), json.out);
  }

  void badInput_isRefusedWithASentence_data() {
    QTest::addColumn<QString>("at");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QByteArray>("part");
    const auto row = [](const char* name, const char* at, const QStringList& options, const char* part) {
      QTest::newRow(name) << QString(at) << options << QByteArray(part);
    };
    row("below the ground", "-27.14060,46.56288,1350m,90", {}, "--at: The aircraft would be below the ground: 1350 m MSL where the terrain is up to");
    row("outside", "-29.1,46.56288,2350m,90", {}, "--at: The aircraft is outside the terrain of the mission");
    row("above the ceiling", "-27.14060,46.56288,9000m,90", {"--air", "ISA"}, "above the ceiling of ");
    row("deadline of zero", "-27.14060,46.56288,2350m,90", {"--deadline", "0s"}, "--deadline: A deadline of zero leaves no time for any answer");
    row("deadline in words", "-27.14060,46.56288,2350m,90", {"--deadline", "soon"}, "--deadline: \"soon\" is no time; give for example 1s or 200ms");
    row("flight level", "-27.14060,46.56288,FL95,90", {}, "--at: \"FL95\" is no altitude; give for example 2400m or 8000ft");
    row("three numbers", "-27.14060,46.56288,2350m", {}, "give longitude,latitude,altitude,true course");
    row("course", "-27.14060,46.56288,2350m,400", {}, "--at: 400 is no course; give degrees from 0 to 360, true");
    row("not on earth", "46.56288,-127.1,2350m,90", {}, "is not on earth");
    row("planner", "-27.14060,46.56288,2350m,90", {"--planner", "autoland"}, "autoland not in {roadmap,");
  }
  void badInput_isRefusedWithASentence() {
    QFETCH(QString, at);
    QFETCH(QStringList, options);
    QFETCH(QByteArray, part);
    const CliResult said = runCli(QStringList{"land", kMission, "--at", at} + options);
    QCOMPARE(said.status, 2);
    QVERIFY2((said.err + said.out).contains(part), said.err + said.out);
  }
};

QTEST_GUILESS_MAIN(TestCliLand)
#include "tst_cli_land.moc"
