#include "core/formats/exports/diversions.h"

#include "core/aircraft/glide_model.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/piece_loss.h"
#include "core/formats/tour_path.h"
#include "core/mission/glide_conditions.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace vp::formats::exports {

std::vector<const mission::SiteInFrame*> diversionSites(const mission::Plan& plan) {
  std::vector<std::pair<int, std::size_t>> uses;
  for (std::size_t i = 0; i < plan.sites.size(); ++i) {
    uses.emplace_back(0, i);
  }
  for (const mission::DecisionPoint& point : plan.tour) {
    if (point.witness.site >= 0) {
      --uses[static_cast<std::size_t>(point.witness.site)].first;
    }
  }
  std::stable_sort(uses.begin(), uses.end());
  std::vector<const mission::SiteInFrame*> sites;
  for (const auto& [count, site] : uses) {
    if (count < 0) {
      sites.push_back(&plan.sites[site]);
    }
  }
  return sites;
}

std::vector<const mission::SiteInFrame*> diversionAirfields(const mission::Plan& plan) {
  std::vector<const mission::SiteInFrame*> airfields;
  std::set<std::string> seen;
  for (const mission::SiteInFrame* site : diversionSites(plan)) {
    if (seen.insert(site->site.airportIdent.empty() ? site->site.id : site->site.airportIdent).second) {
      airfields.push_back(site);
    }
  }
  return airfields;
}

DrawnGlide drawnGlide(const mission::Plan& plan, std::size_t index, double error) {
  const mission::DecisionPoint& from = plan.tour[index];
  DrawnGlide glide;
  if (from.witness.site < 0) {
    return glide;
  }
  const aircraft::GlideModel model(plan.mission.aircraft, mission::glideConditionsOf(plan.mission, plan.sites));
  const geo::LocalFrame frame(plan.frameOrigin);
  geo::Pose pose = from.pose;
  double altitude = from.altitude;
  glide.points.push_back({frame.toLatLon(pose.point()), altitude});
  for (const flight::Piece& piece : from.witness.pieces) {
    const double loss = altitude - flight::heightAlong(model, pose, piece, altitude, piece.length);
    const std::vector<geo::Point> points = chordPoints(pose, piece, error);
    for (std::size_t i = 0; i < points.size(); ++i) {
      glide.points.push_back({frame.toLatLon(points[i]), altitude - loss * static_cast<double>(i + 1) / static_cast<double>(points.size())});
    }
    pose = flight::endOf(pose, piece);
    altitude -= loss;
  }
  if (!std::isfinite(altitude)) {
    return {};  // a turn in which no glide exists: an unsafe plan, and nothing to draw
  }
  glide.site = from.witness.site;
  glide.margin = from.altitude - from.safeAltitude;
  glide.arrival = altitude;
  return glide;
}

}  // namespace vp::formats::exports
