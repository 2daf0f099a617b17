// GeoPackage by GDAL: a layer each for the flown path, waypoints, decision points, glides, targets and runways. WGS 84; heights are
// metres above mean sea level and stand in the attributes as well.
#include "core/formats/exports/diversions.h"
#include "core/formats/exports/gdal_file.h"
#include "core/formats/exports/writers.h"

#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include <memory>

namespace vp::formats::exports {
namespace {

constexpr double kChordError = 2.0;  // m

/// A feature to be filled and added to its layer.
class Feature {
public:
  explicit Feature(OGRLayerH layer) : layer_(layer), feature_(OGR_F_Create(OGR_L_GetLayerDefn(layer))) {}
  ~Feature() { OGR_F_Destroy(feature_); }
  Feature(const Feature&) = delete;
  Feature& operator=(const Feature&) = delete;

  void text(const char* name, const std::string& value) { OGR_F_SetFieldString(feature_, OGR_F_GetFieldIndex(feature_, name), value.c_str()); }
  void number(const char* name, double value) { OGR_F_SetFieldDouble(feature_, OGR_F_GetFieldIndex(feature_, name), value); }
  bool addPoint(geo::LatLon place, double altitude) {
    OGRGeometryH point = OGR_G_CreateGeometry(wkbPoint25D);
    OGR_G_SetPoint(point, 0, place.longitude_deg, place.latitude_deg, altitude);
    OGR_F_SetGeometryDirectly(feature_, point);
    return OGR_L_CreateFeature(layer_, feature_) == OGRERR_NONE;
  }
  template <typename Points>
  bool addLine(const Points& points) {
    OGRGeometryH line = OGR_G_CreateGeometry(wkbLineString25D);
    for (const auto& point : points) {
      OGR_G_AddPoint(line, point.place.longitude_deg, point.place.latitude_deg, point.altitude);
    }
    OGR_F_SetGeometryDirectly(feature_, line);
    return OGR_L_CreateFeature(layer_, feature_) == OGRERR_NONE;
  }

private:
  OGRLayerH layer_;
  OGRFeatureH feature_;
};

class Package {
public:
  explicit Package(const std::string& name) : wgs84_(OSRNewSpatialReference(nullptr)) {
    OSRImportFromEPSG(wgs84_, 4326);
    OSRSetAxisMappingStrategy(wgs84_, OAMS_TRADITIONAL_GIS_ORDER);
    GDALDriverH driver = GDALGetDriverByName("GPKG");
    data_ = driver != nullptr ? GDALCreate(driver, name.c_str(), 0, 0, 0, GDT_Unknown, nullptr) : nullptr;
    if (data_ != nullptr) {
      GDALDatasetStartTransaction(data_, FALSE);
    }
  }
  ~Package() {
    close();
    OSRDestroySpatialReference(wgs84_);
  }
  Package(const Package&) = delete;
  Package& operator=(const Package&) = delete;

  [[nodiscard]] bool isOpen() const { return data_ != nullptr; }
  void close() {
    if (data_ != nullptr) {
      GDALDatasetCommitTransaction(data_);
      GDALClose(data_);
    }
    data_ = nullptr;
  }
  OGRLayerH layer(const char* name, OGRwkbGeometryType type, std::initializer_list<const char*> texts, std::initializer_list<const char*> numbers) {
    OGRLayerH layer = GDALDatasetCreateLayer(data_, name, wgs84_, type, nullptr);
    const auto add = [&](const char* field, OGRFieldType kind) {
      OGRFieldDefnH definition = OGR_Fld_Create(field, kind);
      OGR_L_CreateField(layer, definition, TRUE);
      OGR_Fld_Destroy(definition);
    };
    for (const char* field : texts) {
      add(field, OFTString);
    }
    for (const char* field : numbers) {
      add(field, OFTReal);
    }
    return layer;
  }

private:
  OGRSpatialReferenceH wgs84_;
  GDALDatasetH data_ = nullptr;
};

bool addRoute(Package& package, const ExportInput& input) {
  OGRLayerH tour = package.layer("tour", wkbLineString25D, {"name", "guarantee"}, {"length_m"});
  Feature flown(tour);
  flown.text("name", titleOf(input));
  flown.text("guarantee", input.route->guarantee);
  flown.number("length_m", input.route->length);
  bool isWritten = flown.addLine(input.route->flown);
  OGRLayerH waypoints = package.layer("waypoints", wkbPoint25D, {"name", "kind", "note"}, {"number", "alt_msl_m", "alt_msl_ft", "turn_deg"});
  int number = 0;
  for (const mission::RouteWaypoint* point : placesOf(input)) {
    Feature feature(waypoints);
    feature.text("name", point->name);
    feature.text("kind", point->site >= 0 ? "runway" : point->target >= 0 ? "target" : "turn");
    feature.text("note", point->note);
    feature.number("number", ++number);
    feature.number("alt_msl_m", point->altitude);
    feature.number("alt_msl_ft", static_cast<double>(feetOf(point->altitude)));
    feature.number("turn_deg", point->turn_deg);
    isWritten = feature.addPoint(point->place, point->altitude) && isWritten;
  }
  return isWritten;
}

bool addTourPoints(Package& package, const mission::Plan& plan) {
  bool isWritten = true;
  const geo::LocalFrame frame(plan.frameOrigin);
  OGRLayerH points = package.layer("decision_points", wkbPoint25D, {"site"}, {"number", "alt_msl_m", "safe_msl_m", "margin_m"});
  OGRLayerH glides = package.layer("glides", wkbLineString25D, {"site"}, {"number", "margin_m", "arrival_msl_m"});
  for (std::size_t i = 0; i < plan.tour.size(); ++i) {
    const mission::DecisionPoint& at = plan.tour[i];
    const std::string site = at.witness.site >= 0 ? plan.sites[static_cast<std::size_t>(at.witness.site)].site.id : "";
    Feature point(points);
    point.text("site", site);
    point.number("number", static_cast<double>(i + 1));
    point.number("alt_msl_m", at.altitude);
    point.number("safe_msl_m", at.safeAltitude);
    point.number("margin_m", at.altitude - at.safeAltitude);
    isWritten = point.addPoint(frame.toLatLon(at.pose.point()), at.altitude) && isWritten;
    const DrawnGlide drawn = drawnGlide(plan, i, kChordError);
    if (drawn.site >= 0) {
      Feature glide(glides);
      glide.text("site", site);
      glide.number("number", static_cast<double>(i + 1));
      glide.number("margin_m", drawn.margin);
      glide.number("arrival_msl_m", drawn.arrival);
      isWritten = glide.addLine(drawn.points) && isWritten;
    }
  }
  return isWritten;
}

bool addPlaces(Package& package, const mission::Plan& plan) {
  bool isWritten = true;
  OGRLayerH targets = package.layer("targets", wkbPoint25D, {"name"}, {"alt_msl_m"});
  for (const mission::TargetInFrame& target : plan.targets) {
    Feature feature(targets);
    feature.text("name", target.target.name);
    feature.number("alt_msl_m", target.altitude);
    isWritten = feature.addPoint(target.target.position, target.altitude) && isWritten;
  }
  OGRLayerH sites = package.layer("sites", wkbPoint25D, {"id", "airport"}, {"elevation_msl_m", "course_true_deg"});
  for (const mission::SiteInFrame& site : plan.sites) {
    Feature feature(sites);
    feature.text("id", site.site.id);
    feature.text("airport", site.site.airportName);
    feature.number("elevation_msl_m", site.site.elevation.metres());
    feature.number("course_true_deg", site.site.landingCourse.degrees());
    isWritten = feature.addPoint(site.site.touchdown, site.site.elevation.metres()) && isWritten;
  }
  return isWritten;
}

}  // namespace

Result<std::string> gpkg(const ExportInput& input) {
  GDALAllRegister();
  const std::string name = memoryFileName("gpkg");
  Package package(name);
  if (!package.isOpen()) {
    return fail(Errc::OutputFailed, "GDAL cannot make a GeoPackage; it needs its GPKG driver");
  }
  const bool isRouteWritten = addRoute(package, input);
  const bool isTourWritten = addTourPoints(package, input.plan);
  const bool arePlacesWritten = addPlaces(package, input.plan);
  package.close();
  Result<std::string> bytes = takeMemoryFile(name);
  if (!isRouteWritten || !isTourWritten || !arePlacesWritten) {
    return fail(Errc::OutputFailed, "GDAL could not write all of the GeoPackage");
  }
  return bytes;
}

}  // namespace vp::formats::exports
