#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/route/build_route.h"
#include "core/route/home_ways.h"
#include "core/route/reflown_plan.h"

#include <vector>

namespace vp::route {

/** The ways from and to home of one route: laid out, then given their altitudes, which depend on those of the closed tour and may ask for
 *  higher ones there. */
class HomeRoute {
public:
  /** @param flown  points of the closed tour's path; those where the ways join it have glides
   *  @errors as flyDeparture, flyArrival; Cancelled */
  static Result<HomeRoute> layOut(const mission::Plan& plan, const Ground* ground, const Layout& loop, const FlownPoints& flown,
                                  const RouteOptions& options, int moreCircles, const Job& job);

  /** Finds altitudes between those of the closed tour.
   *  @param loopAltitudes  by corner of the closed tour
   *  @return what the closed tour must not be below at its corners (m along it), so that the ways are as high as their glides need; empty: all is
   *  well */
  std::vector<Required> fit(const std::vector<double>& loopAltitudes);

  /** Whether the aircraft climbs to the tour and the guarantee begins where the plan says, or within a circle of it. After fit(). */
  [[nodiscard]] bool keepsItsPromise() const;

  /** Puts the ways around the closed tour's waypoints and into the reflown plan.
   *  @pre built holds the closed route and its reflown plan */
  void addTo(const std::vector<double>& loopAltitudes, BuiltRoute& built) const;

private:
  struct Way {
    HomeWay flown;
    FlownPoints points;
    std::vector<WayKnot> knots;  ///< with the ends of the way
    std::vector<double> altitudes;
    std::size_t ends = 0;  ///< knots before those of `flown`
  };
  HomeRoute(const mission::Plan& plan, const Layout& loop) : plan_(&plan), loop_(&loop) {}
  void setKnots(Way& way, bool isDeparture, const std::vector<double>& loopAltitudes) const;
  void setAltitudes(Way& way, bool isDeparture) const;
  void askFor(const Way& way, bool isDeparture, const std::vector<double>& loopAltitudes, std::vector<Required>& raised) const;
  void findGuarantee();
  [[nodiscard]] double loopDistance(std::size_t corner) const;
  [[nodiscard]] double above(const Way& way) const;
  [[nodiscard]] mission::HomePath pathOf(const Way& way, int site, int join, int guaranteed) const;
  class Names;
  void addWaypoints(mission::Route& route) const;
  void addRunway(int site, Names& names, mission::Route& route) const;
  std::size_t addDeparture(const std::vector<mission::RouteWaypoint>& loop, Names& names, mission::Route& route) const;
  void addLoop(const std::vector<mission::RouteWaypoint>& loop, std::size_t passed, Names& names, mission::Route& route) const;
  void addArrival(std::size_t lastLoop, Names& names, mission::Route& route) const;
  [[nodiscard]] mission::RouteWaypoint ownWaypoint(const Way& way, std::size_t knot, double base) const;
  bool sayGuarantee(double distance, bool hasBegun, Names& names, mission::RouteWaypoint& waypoint) const;
  void addFlown(const std::vector<double>& loopAltitudes, mission::Route& route) const;
  [[nodiscard]] std::string guaranteeText() const;

  const mission::Plan* plan_;
  const Layout* loop_;
  Way departure_;
  Way arrival_;
  Pitch pitch_;
  std::vector<std::size_t> corners_;  ///< of the closed tour, in flying order
  std::size_t guaranteed_ = 0;        ///< index into departure_.points
  bool isGroundKnown_ = false;
};

}  // namespace vp::route
