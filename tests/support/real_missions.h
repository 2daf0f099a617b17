#pragma once
// Missions over real terrain with real airfields, from the data folder beside the checkout.

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <vector>

namespace vp::test {

struct RealPlace {
  double latitude;
  double longitude;
};

/** Targets T1, T2, ... @param height  above ground, m */
inline QJsonArray realTargets(const std::vector<RealPlace>& places, double height) {
  QJsonArray list;
  for (const RealPlace& place : places) {
    list.append(QJsonObject{{"name", QStringLiteral("T%1").arg(list.size() + 1)},
                            {"latitude_deg", place.latitude},
                            {"longitude_deg", place.longitude},
                            {"height_m", height}});
  }
  return list;
}

struct RealMission {
  const char* name;
  QStringList terrain;
  QJsonObject airfields;
  QJsonArray targets;

  /** The text of a mission file with settings that plan within seconds. */
  [[nodiscard]] QByteArray text() const {
    return QJsonDocument(QJsonObject{{"format", "volplane-mission"},
                                     {"version", 1},
                                     {"name", name},
                                     {"terrain", QJsonArray::fromStringList(terrain)},
                                     {"airfields", QJsonArray{airfields}},
                                     {"aircraft", "cessna172-elasp"},
                                     {"targets", targets},
                                     {"planner", QJsonObject{{"step_m", 100}, {"headings", 8}}}})
        .toJson();
  }
};

/** @param data  the folder */
inline std::vector<RealMission> realMissions(const QString& data) {
  const QJsonObject alps{{"airports", data + "/airports/ourairports_alps_43-48N_4.5-13.5E_airports.csv"},
                         {"runways", data + "/airports/ourairports_alps_43-48N_4.5-13.5E_runways.csv"}};
  const QJsonObject world{{"airports", data + "/airports/ourairports_airports.csv.gz"}, {"runways", data + "/airports/ourairports_runways.csv.gz"}};
  const QJsonObject landables{{"airports", data + "/airports/CH-WPT-National-XCSoar.cup"}};
  return {
      {"Swiss Alps, ten targets over the massif, voids",
       {data + "/dem/swiss_alps_N46E008_srtm3_voids.tif"},
       alps,
       realTargets({{46.80, 8.20},
                    {46.75, 8.75},
                    {46.60, 8.50},
                    {46.50, 8.15},
                    {46.45, 8.60},
                    {46.30, 8.30},
                    {46.25, 8.80},
                    {46.15, 8.55},
                    {46.35, 8.05},
                    {46.85, 8.40}},
                   200.0)},
      {"Davos, Swiss landables",
       {data + "/dem/davos_srtm1_wgs84.tif"},
       landables,
       realTargets({{46.80, 9.83}, {46.70, 9.75}, {46.62, 9.95}, {46.95, 9.70}, {46.85, 10.05}}, 200.0)},
      {"Canberra",
       {data + "/dem/canberra_S36E149_srtm3.tif"},
       world,
       realTargets({{-35.35, 149.10}, {-35.55, 149.15}, {-35.45, 149.05}, {-35.25, 149.35}, {-35.60, 149.45}}, 200.0)},
      {"British Columbia, two tiles as one",
       {data + "/dem/bc_coast_N49W123_srtm3_voids.tif", data + "/dem/bc_coast_N49W124_srtm3_voids.tif"},
       world,
       realTargets({{49.15, -122.70}, {49.25, -122.95}, {49.20, -123.05}, {49.30, -122.60}, {49.10, -122.40}}, 250.0)},
  };
}

}  // namespace vp::test
