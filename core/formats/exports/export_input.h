#pragma once

#include "core/mission/plan.h"
#include "core/mission/route.h"

#include <cstddef>
#include <string>
#include <vector>

namespace vp::formats {

/** What one file is written from. A route with more points than a format takes is written as several files, each of which begins
 *  at the point where the one before ended. */
struct ExportInput {
  const mission::Plan& plan;
  const mission::Route* route = nullptr;  ///< nothing for formats that do not need one
  std::size_t first = 0;                  ///< waypoint that this file begins at
  std::size_t count = 0;                  ///< points in this file; 0: the whole route, of a closed one its first waypoint repeated at the end
  int part = 1;
  int parts = 1;
};

/** A stretch of a route: `count` points from waypoint `first` on. */
struct RoutePart {
  std::size_t first = 0;
  std::size_t count = 0;
};

/** Cuts a route into parts of at most `most` points, at targets where there is one in the later half of a part. One part
 *  if it fits or if `most` is 0. @pre most is 0 or at least 2 */
std::vector<RoutePart> partsOf(const mission::Route& route, std::size_t most);

/** The points of a file in flying order. */
std::vector<const mission::RouteWaypoint*> pointsOf(const ExportInput& input);

/** The same with each waypoint once. */
std::vector<const mission::RouteWaypoint*> placesOf(const ExportInput& input);

/** What a file of a route says that no one has shown to be safe. */
inline constexpr const char* kUnverifiedMark = "UNVERIFIED - DO NOT FLY";

/** The route with that mark, also in the note of each waypoint. */
mission::Route markedUnverified(mission::Route route);

/** The route's mark if it has one, then the mission's name, or "tour", with "part i of n" where there are several. */
std::string titleOf(const ExportInput& input);

/** Which characters an identifier may have. */
struct IdentRules {
  std::size_t longest = 10;
  bool lower = false;  ///< a-z as well as A-Z; else they become capitals
  std::string others;  ///< allowed beside letters and digits
  std::string filler;  ///< stands for every other character; may be empty
};

/** An identifier for each point: of its name, in 7-bit letters, unique among the waypoints of the route; the same for the same
 *  waypoint. Never empty. */
std::vector<std::string> identsOf(const ExportInput& input, const std::vector<const mission::RouteWaypoint*>& points, const IdentRules& rules);

/** Letters with accents as plain ones, all else beyond ASCII as '?'. */
std::string asciiOf(const std::string& utf8);

/** A text of allowed characters, cut to the longest length; what is not allowed becomes `filler`. */
std::string restrictedTo(const std::string& text, const IdentRules& rules);

/** The airport whose runway a point is the threshold of, where formats can name it: 2 to 8 capitals and digits; else "". */
std::string airportOf(const ExportInput& input, const mission::RouteWaypoint& point);

/** Its runway as two digits and a letter if it has one: "05L"; else "". */
std::string runwayOf(const ExportInput& input, const mission::RouteWaypoint& point);

/** "5620 ft MSL", with what there is to know of the place. */
std::string altitudeNote(const mission::RouteWaypoint& point);

/** Whole feet of an altitude of a route, which is in whole feet. */
long feetOf(double metres);

}  // namespace vp::formats
