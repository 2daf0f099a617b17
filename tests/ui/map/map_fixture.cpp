#include "tests/ui/map/map_fixture.h"

#include "core/base/expect.h"
#include "core/flight/curve_sampling.h"
#include "core/formats/aircraft_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vp::map::testing {
namespace {

constexpr double kStraight = 4000.0;
constexpr double kRadius = 500.0;
constexpr double kStep = 200.0;
constexpr double kSafe = 800.0;

mission::SiteInFrame siteAt(const geo::LocalFrame& frame, const std::string& airport, const std::string& runway, geo::Pose pose) {
  mission::SiteInFrame site;
  site.site.id = airport + "/" + runway;
  site.site.airportIdent = airport;
  site.site.airportName = "Field " + airport;
  site.site.runwayIdent = runway;
  site.site.touchdown = frame.toLatLon(pose.point());
  site.site.elevation = geo::HeightMsl::fromMetres(400.0);
  site.site.length = Length::fromSi(800.0);
  site.site.width = Length::fromSi(30.0);
  site.pose = pose;
  return site;
}

void addPieces(mission::Plan& plan, geo::Pose& pose, flight::Turn turn, double length, double altitude) {
  const int parts = static_cast<int>(std::ceil(length / kStep));
  for (int i = 0; i < parts; ++i) {
    mission::DecisionPoint point;
    point.pose = pose;
    point.altitude = altitude;
    point.safeAltitude = kSafe;
    point.onward = {turn, turn == flight::Turn::Straight ? 0.0 : kRadius, length / parts};
    point.witness.site = 0;
    point.witness.pieces = {{flight::Turn::Right, 100.0, 0.5 * Angle::kPi * 100.0}, {flight::Turn::Straight, 0.0, 900.0}};
    plan.tour.push_back(point);
    pose = flight::endOf(pose, point.onward);
  }
}

}  // namespace

std::shared_ptr<const document::TerrainData> groundOf(const std::function<double(double x, double y)>& height) {
  const int side = static_cast<int>(kFieldSize / kFieldCell);
  std::vector<float> values;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      values.push_back(static_cast<float>(height(-0.5 * kFieldSize + (column + 0.5) * kFieldCell, -0.5 * kFieldSize + (row + 0.5) * kFieldCell)));
    }
  }
  auto grid = std::make_shared<const terrain::ElevationGrid>(-0.5 * kFieldSize, -0.5 * kFieldSize, kFieldCell, side, side, std::move(values));
  return document::makeTerrainData(geo::LocalFrame({46.6, 9.9}), std::move(grid), {});
}

std::shared_ptr<const landing::SafeAltitudeField> fieldOf(const std::function<float(double x, double y, int heading)>& altitude) {
  auto field = std::make_shared<landing::SafeAltitudeField>();
  field->originX = -5000.0;
  field->originY = -5000.0;
  field->cell = 250.0;
  field->columns = 40;
  field->rows = 40;
  field->headings = 4;
  for (int row = 0; row < 40; ++row) {
    for (int column = 0; column < 40; ++column) {
      for (int heading = 0; heading < 4; ++heading) {
        field->altitude.push_back(altitude(-5000.0 + (column + 0.5) * 250.0, -5000.0 + (row + 0.5) * 250.0, heading));
      }
    }
  }
  return field;
}

document::Situation racetrack(double altitude) {
  document::Situation situation;
  situation.terrain = groundOf([](double, double) { return 400.0; });
  const geo::LocalFrame& frame = situation.terrain->frame;

  auto plan = std::make_shared<mission::Plan>();
  const auto aircraft = formats::readAircraft(VOLPLANE_SOURCE_DIR "/resources/aircraft/cessna172-elasp.json");
  VP_EXPECT(aircraft.has_value());
  plan->mission.aircraft = *aircraft;
  plan->frameOrigin = frame.origin();
  plan->sites = {siteAt(frame, "LSZA", "09", {-3600.0, -3000.0, 0.0})};
  geo::Pose pose{-0.5 * kStraight, -kRadius, 0.0};
  addPieces(*plan, pose, flight::Turn::Straight, kStraight, altitude);
  addPieces(*plan, pose, flight::Turn::Left, Angle::kPi * kRadius, altitude);
  addPieces(*plan, pose, flight::Turn::Straight, kStraight, altitude);
  addPieces(*plan, pose, flight::Turn::Left, Angle::kPi * kRadius, altitude);
  plan->certificate.emplace();

  auto targets = std::make_shared<std::vector<document::ShownTarget>>();
  const auto addTarget = [&](const std::string& name, geo::Point at) {
    mission::Target target{name, frame.toLatLon(at), 200.0, mission::HeightReference::AboveGround};
    targets->push_back({target, at, 600.0, ""});
    plan->targets.push_back({target, at, 600.0});
    for (mission::DecisionPoint& point : plan->tour) {
      if (geo::distance(point.pose.point(), at) < 1.0) {
        point.target = static_cast<int>(targets->size()) - 1;
      }
    }
  };
  addTarget("1", {0.0, -kRadius});
  addTarget("Castle & Lake", {0.0, kRadius});
  situation.targets = targets;

  auto sites = std::make_shared<std::vector<document::ShownSite>>();
  sites->push_back({plan->sites[0], true});
  sites->push_back({siteAt(frame, "LSZA", "27", {-2800.0, -3000.0, Angle::kPi}), true});
  sites->push_back({siteAt(frame, "LSZX", "18", {3000.0, 3500.0, -0.5 * Angle::kPi}), false});
  situation.sites = sites;
  situation.plan = std::make_shared<const document::PlanView>(plan, situation.terrain);
  return situation;
}

int difference(QRgb a, QRgb b) {
  return std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b))});
}

bool hasColorNear(const QImage& image, QPointF at, int reach, const QColor& color, int tolerance) {
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const QPoint p = at.toPoint() + QPoint(dx, dy);
      if (image.rect().contains(p) && difference(image.pixel(p), color.rgb()) <= tolerance) {
        return true;
      }
    }
  }
  return false;
}

int countColor(const QImage& image, const QColor& color, int tolerance) {
  int count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      count += difference(image.pixel(x, y), color.rgb()) <= tolerance ? 1 : 0;
    }
  }
  return count;
}

}  // namespace vp::map::testing
