#pragma once

#include "core/formats/airfields.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vp::formats {

/** A landing site as read, before the filter. The (at most two) candidates of one runway are each other's opposite. */
struct Candidate {
  mission::LandingSite site;
  int runway = -1;  ///< counts the runways of a file; -1 = belongs to none
  bool closed = false;
};

/** What was left out, grouped by reason, in the order that the reasons first came up. */
class LeftOut {
public:
  void add(const std::string& reason, const std::string& what);
  /** "12 left out: closed (LSZX/09, LSZX/27, ...)"; @param what  instead of "left out" */
  [[nodiscard]] std::vector<std::string> sentences(const std::string& what = "left out") const;

private:
  struct Group {
    std::string reason;
    std::size_t count = 0;
    std::vector<std::string> examples;
  };
  std::vector<Group> groups_;
};

/** One physical runway with what is known of it; turned into its sites by addRunway. */
struct RunwayGeometry {
  struct End {
    std::string ident;                 ///< "" = this end cannot be landed on
    std::optional<geo::LatLon> place;  ///< of the runway's end
    std::optional<geo::HeightMsl> elevation;
    Length displaced;  ///< threshold from the runway's end
  };
  End low;
  End high;
  geo::LatLon centre;                       ///< of the airport, stands in for the middle of the runway
  std::optional<Angle> course;              ///< true, from low to high
  std::optional<Length> length;             ///< as the file says
  std::optional<geo::HeightMsl> elevation;  ///< of the airport
};

/** Appends the candidates of a runway: both ends, derived where the file has none; what is derived is marked.
 *  @param common  fields that both sites share; its approximations are kept */
void addRunway(const RunwayGeometry& runway, const Candidate& common, std::vector<Candidate>& candidates, LeftOut& leftOut);

/** Unique ids, then the filter, then the area. */
AirfieldReport applyFilter(std::vector<Candidate> candidates, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area,
                           LeftOut leftOut);

/** The area grown by more than any runway's extent: where airports lie whose runways may reach into it. */
std::optional<geo::GeoBox> grownArea(const std::optional<geo::GeoBox>& area);

/** A finite number that is the whole text, with an optional sign; nothing otherwise. */
std::optional<double> parseNumber(std::string_view text);

/** Difference of two courses, 0 to 180 degrees. */
double courseDifference(double a_deg, double b_deg);

}  // namespace vp::formats
