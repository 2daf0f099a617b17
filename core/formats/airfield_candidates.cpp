#include "core/formats/airfield_candidates.h"

#include "core/base/plain_text.h"
#include "core/formats/limits.h"
#include "core/geo/local_frame.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <set>

namespace vp::formats {
namespace {

using geo::LatLon;
using mission::LandingSite;

constexpr Length kShortest = Length::fromSi(30.0);             // ends closer than this are one place written twice
constexpr Length kFarthest = Length::fromSi(15000.0);          // an end farther from its airport is a slip of the file
constexpr double kHeadingTolerance_deg = 5.0;                  // between published heading and geometry
constexpr double kLengthTolerance = 0.1;                       // between published length and geometry
constexpr Length kElevationTolerance = Length::fromSi(100.0);  // between threshold and airport; the steepest altiports have 65 m

/// The two ends of a runway once they are known.
struct Ends {
  LatLon low;
  LatLon high;
  Angle lowCourse;  ///< landing from low towards high
  Angle highCourse;
  std::optional<Length> length;
  bool lowUsable = true;
  bool highUsable = true;
  std::vector<std::string> approximations;
};

Angle opposite(Angle course) {
  return Angle::degrees(std::fmod(course.degrees() + 180.0, 360.0));
}

/// Both ends are in the file: geometry counts.
Ends givenEnds(const RunwayGeometry& runway) {
  Ends ends{*runway.low.place, *runway.high.place, {}, {}, {}, true, true, {}};
  ends.lowCourse = geo::geodesicCourse(ends.low, ends.high);
  ends.highCourse = geo::geodesicCourse(ends.high, ends.low);
  const Length distance = geo::geodesicDistance(ends.low, ends.high);
  ends.length = distance;
  if (runway.course) {
    const double difference = courseDifference(runway.course->degrees(), ends.lowCourse.degrees());
    if (difference > kHeadingTolerance_deg) {
      ends.approximations.push_back(fmt::format("heading in the file differs by {:.0f} degrees from the runway ends; the ends count", difference));
    }
  }
  if (runway.length) {
    const double ratio = *runway.length / distance;
    if (ratio > 1.0 + kLengthTolerance || ratio < 1.0 / (1.0 + kLengthTolerance)) {
      ends.approximations.push_back(fmt::format("length in the file is {:.0f} m but the runway ends are {:.0f} m apart; the shorter counts",
                                                runway.length->si(), distance.si()));
    }
    ends.length = std::min(distance, *runway.length);
  }
  return ends;
}

/// One end is in the file: the other lies its length away; without a length only the given end is of use.
Ends endsFromOne(const RunwayGeometry& runway) {
  const bool haveLow = runway.low.place.has_value();
  const LatLon given = haveLow ? *runway.low.place : *runway.high.place;
  const Angle away = haveLow ? *runway.course : opposite(*runway.course);
  const LatLon other = runway.length ? geo::geodesicDestination(given, away, *runway.length) : given;
  Ends ends{haveLow ? given : other, haveLow ? other : given, *runway.course, opposite(*runway.course), runway.length, true, true, {}};
  if (runway.length) {
    ends.approximations.emplace_back("one runway end derived from the other, length and heading");
  } else {
    ends.lowUsable = haveLow;
    ends.highUsable = !haveLow;
    ends.approximations.emplace_back("runway length unknown");
  }
  return ends;
}

/// No end is in the file: both lie about the airport's position.
Ends endsFromCentre(const RunwayGeometry& runway) {
  Ends ends{runway.centre, runway.centre, *runway.course, opposite(*runway.course), runway.length, true, true, {}};
  if (runway.length) {
    ends.low = geo::geodesicDestination(runway.centre, opposite(*runway.course), *runway.length / 2.0);
    ends.high = geo::geodesicDestination(runway.centre, *runway.course, *runway.length / 2.0);
    ends.approximations.emplace_back("runway ends derived from the airport's position, length and heading");
  } else {
    ends.approximations.emplace_back("runway length unknown; the airport's position is taken as touchdown point");
  }
  return ends;
}

/// Elevation of a threshold and what is said about it; nothing if no elevation is known.
std::optional<geo::HeightMsl> elevationOf(const RunwayGeometry::End& end, const RunwayGeometry& runway, std::vector<std::string>& approximations) {
  if (!end.elevation) {
    if (runway.elevation) {
      approximations.emplace_back("elevation of the airport, not of the threshold");
    }
    return runway.elevation;
  }
  if (runway.elevation && (*end.elevation - *runway.elevation > kElevationTolerance || *runway.elevation - *end.elevation > kElevationTolerance)) {
    approximations.push_back(fmt::format("elevation of the threshold ({:.0f} m) and of the airport ({:.0f} m) disagree; the higher counts",
                                         end.elevation->metres(), runway.elevation->metres()));
    return std::max(*end.elevation, *runway.elevation);
  }
  return end.elevation;
}

void addEnd(const RunwayGeometry& runway, bool isLow, const Ends& ends, const Candidate& common, std::vector<Candidate>& candidates,
            LeftOut& leftOut) {
  const RunwayGeometry::End& end = isLow ? runway.low : runway.high;
  if (end.ident.empty() || !(isLow ? ends.lowUsable : ends.highUsable)) {
    return;
  }
  if (candidates.size() >= kMostSites) {
    leftOut.add(fmt::format("more than {} landing sites; take the part of the file for the region", kMostSites), end.ident);
    return;
  }
  Candidate candidate = common;
  LandingSite& site = candidate.site;
  site.runwayIdent = end.ident;
  site.id = site.airportIdent + "/" + end.ident;
  site.approximations.insert(site.approximations.end(), ends.approximations.begin(), ends.approximations.end());
  site.landingCourse = isLow ? ends.lowCourse : ends.highCourse;
  site.touchdown = isLow ? ends.low : ends.high;
  site.length = ends.length;
  if (end.displaced.si() > 0.0) {
    site.touchdown = geo::geodesicDestination(site.touchdown, site.landingCourse, end.displaced);
    if (site.length) {
      site.length = *site.length - end.displaced;
    }
  }
  if (end.displaced.si() < 0.0 || (site.length && site.length->si() <= 0.0)) {
    leftOut.add("displaced threshold negative or beyond the runway", site.id);
    return;
  }
  if (const auto elevation = elevationOf(end, runway, site.approximations)) {
    site.elevation = *elevation;
  } else {
    site.elevationFromTerrain = true;
    site.approximations.emplace_back("no elevation in the file, the terrain's is used");
  }
  candidates.push_back(std::move(candidate));
}

/// The name without the ending #2 of makeIdsUnique.
std::string baseId(const std::string& id) {
  return id.substr(0, id.rfind('#'));
}

bool names(const std::vector<std::string>& entries, const LandingSite& site, std::set<std::string>& matched) {
  bool found = false;
  for (const std::string& entry : entries) {
    if (entry == site.id || entry == baseId(site.id) || (entry == site.airportIdent && !entry.empty())) {
      matched.insert(entry);
      found = true;
    }
  }
  return found;
}

/// That an operator excluded a site, in his own words where he gave some.
std::string whyExcluded(const mission::SiteFilter& filter, const LandingSite& site) {
  const auto note = std::find_if(filter.notes.begin(), filter.notes.end(), [&](const mission::SiteNote& n) {
    return n.site == site.id || n.site == baseId(site.id) || (n.site == site.airportIdent && !n.site.empty());
  });
  return note == filter.notes.end() || note->text.empty() ? "excluded by the mission" : "excluded by the mission: " + note->text;
}

/// Why the filter leaves a site out; "" if it stays.
std::string reasonAgainst(const Candidate& candidate, const mission::SiteFilter& filter) {
  const LandingSite& site = candidate.site;
  if (candidate.closed && !filter.closed) {
    return "closed";
  }
  if (site.surface == mission::Surface::Water && !filter.water) {
    return "water";
  }
  if (site.isApproximate() && !filter.approximate) {
    return "geometry only approximate, which the mission does not accept";
  }
  if (filter.minLength && site.length && *site.length < *filter.minLength) {
    return fmt::format("shorter than {:.0f} m", filter.minLength->si());
  }
  if (filter.minWidth && site.width && *site.width < *filter.minWidth) {
    return fmt::format("narrower than {:.0f} m", filter.minWidth->si());
  }
  if (!filter.surfaces.empty() && std::find(filter.surfaces.begin(), filter.surfaces.end(), site.surface) == filter.surfaces.end()) {
    return site.surface == mission::Surface::Unknown ? "surface unknown" : "surface not among those that the mission allows";
  }
  if (filter.lighted && !site.lighted) {
    return "not lighted, as far as the file says";
  }
  return {};
}

/// Runways whose sites other than the chosen ones must not be used: opposite ends of one-way sites.
std::set<std::size_t> oneWayOpposites(const std::vector<Candidate>& candidates, const mission::SiteFilter& filter, std::set<std::string>& matched) {
  std::set<std::size_t> opposites;
  for (const Candidate& kept : candidates) {
    const auto isKept = [&](const std::string& entry) { return entry == kept.site.id; };
    if (std::none_of(filter.oneWay.begin(), filter.oneWay.end(), isKept)) {
      continue;
    }
    matched.insert(kept.site.id);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      if (candidates[i].runway == kept.runway && kept.runway >= 0 && candidates[i].site.id != kept.site.id) {
        opposites.insert(i);
      }
    }
  }
  return opposites;
}

template <typename SiteOf, typename Items>
void numberEqualIds(Items& items, SiteOf siteOf) {
  std::map<std::string, int> seen;
  std::set<std::string> used;
  for (auto& item : items) {
    used.insert(siteOf(item).id);
  }
  for (auto& item : items) {
    LandingSite& site = siteOf(item);
    const std::string id = site.id;
    int& count = seen[id];
    if (++count == 1) {
      continue;
    }
    do {
      site.id = fmt::format("{}#{}", id, count);
    } while (used.count(site.id) > 0 && ++count > 0);
    used.insert(site.id);
  }
}

}  // namespace

void LeftOut::add(const std::string& reason, const std::string& what) {
  auto group = std::find_if(groups_.begin(), groups_.end(), [&](const Group& g) { return g.reason == reason; });
  if (group == groups_.end()) {
    group = groups_.insert(groups_.end(), Group{reason, 0, {}});
  }
  ++group->count;
  constexpr std::size_t kExamples = 5;
  constexpr std::size_t kLongestExample = 80;  // bytes
  if (group->examples.size() < kExamples) {
    group->examples.push_back(plainText(what, kLongestExample));
  }
}

std::vector<std::string> LeftOut::sentences(const std::string& what) const {
  std::vector<std::string> sentences;
  for (const Group& group : groups_) {
    sentences.push_back(fmt::format("{} {}: {} ({}{})", group.count, what, group.reason, fmt::join(group.examples, ", "),
                                    group.count > group.examples.size() ? ", ..." : ""));
  }
  return sentences;
}

void addRunway(const RunwayGeometry& runway, const Candidate& common, std::vector<Candidate>& candidates, LeftOut& leftOut) {
  const std::string name = fmt::format("{}/{}", common.site.airportIdent, runway.low.ident.empty() ? runway.high.ident : runway.low.ident);
  for (const RunwayGeometry::End* end : {&runway.low, &runway.high}) {
    if (end->place && geo::geodesicDistance(*end->place, runway.centre) > kFarthest) {
      leftOut.add("runway end more than 15 km from its airport", name);
      return;
    }
  }
  const bool both = runway.low.place && runway.high.place && geo::geodesicDistance(*runway.low.place, *runway.high.place) >= kShortest;
  if (!both && !runway.course) {
    leftOut.add("no heading and not both runway ends in the file", name);
    return;
  }
  const bool samePlace = !both && runway.low.place && runway.high.place;
  const Ends ends = both ? givenEnds(runway) : samePlace || (!runway.low.place && !runway.high.place) ? endsFromCentre(runway) : endsFromOne(runway);
  addEnd(runway, true, ends, common, candidates, leftOut);
  addEnd(runway, false, ends, common, candidates, leftOut);
}

AirfieldReport applyFilter(std::vector<Candidate> candidates, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area,
                           LeftOut leftOut) {
  for (Candidate& candidate : candidates) {
    for (std::string* text : {&candidate.site.id, &candidate.site.airportName, &candidate.site.airportIdent, &candidate.site.runwayIdent}) {
      *text = plainText(*text);
    }
  }
  numberEqualIds(candidates, [](Candidate& candidate) -> LandingSite& { return candidate.site; });
  AirfieldReport report;
  std::set<std::string> matched;
  const std::set<std::size_t> opposites = oneWayOpposites(candidates, filter, matched);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    LandingSite& site = candidates[i].site;
    const bool excluded = names(filter.exclude, site, matched);
    if (area && !area->contains(site.touchdown)) {
      continue;
    }
    if (filter.minLength && !site.length) {
      site.approximations.emplace_back("length unknown, so the least length that the mission asks for is not assured");
    }
    if (filter.minWidth && !site.width) {
      site.approximations.emplace_back("width unknown, so the least width that the mission asks for is not assured");
    }
    const std::string reason = excluded                 ? whyExcluded(filter, site)
                               : opposites.count(i) > 0 ? "opposite end of a one-way runway"
                                                        : reasonAgainst(candidates[i], filter);
    if (reason.empty()) {
      report.sites.push_back(std::move(site));
    } else {
      leftOut.add(reason, site.id);
    }
  }
  report.notes = leftOut.sentences();
  report.matched.assign(matched.begin(), matched.end());
  return report;
}

AirfieldReport filterSites(const std::vector<LandingSite>& sites, const mission::SiteFilter& filter, const std::optional<geo::GeoBox>& area) {
  std::vector<Candidate> candidates;
  int runways = 0;
  for (const LandingSite& site : sites) {
    Candidate candidate{site, -1, false};
    for (const Candidate& other : candidates) {
      const double difference = courseDifference(site.landingCourse.degrees(), other.site.landingCourse.degrees());
      if (!site.airportIdent.empty() && other.site.airportIdent == site.airportIdent && difference > 170.0) {
        candidate.runway = other.runway;
      }
    }
    if (candidate.runway < 0) {
      candidate.runway = runways++;
    }
    candidates.push_back(std::move(candidate));
  }
  return applyFilter(std::move(candidates), filter, area, {});
}

void makeIdsUnique(std::vector<LandingSite>& sites) {
  numberEqualIds(sites, [](LandingSite& site) -> LandingSite& { return site; });
}

std::vector<std::string> unmatchedNames(const mission::SiteFilter& filter, const std::vector<AirfieldReport>& reports) {
  std::set<std::string> matched;
  for (const AirfieldReport& report : reports) {
    matched.insert(report.matched.begin(), report.matched.end());
  }
  std::vector<std::string> unmatched;
  for (const auto* entries : {&filter.exclude, &filter.oneWay}) {
    std::copy_if(entries->begin(), entries->end(), std::back_inserter(unmatched),
                 [&](const std::string& entry) { return matched.count(entry) == 0; });
  }
  return unmatched;
}

std::optional<geo::GeoBox> grownArea(const std::optional<geo::GeoBox>& area) {
  if (!area) {
    return std::nullopt;
  }
  constexpr double kNorth_deg = 0.2;  // 22 km
  const double farthest = std::max(std::fabs(area->southWest.latitude_deg), std::fabs(area->northEast.latitude_deg)) + kNorth_deg;
  const double east = kNorth_deg / std::max(0.01, cos(Angle::degrees(std::min(farthest, 89.5))));
  geo::GeoBox box = *area;
  box.southWest.latitude_deg -= kNorth_deg;
  box.northEast.latitude_deg += kNorth_deg;
  box.southWest.longitude_deg -= east;
  box.northEast.longitude_deg += east;
  return box;
}

std::optional<double> parseNumber(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

double courseDifference(double a_deg, double b_deg) {
  const double difference = std::fabs(std::fmod(a_deg - b_deg, 360.0));
  return std::min(difference, 360.0 - difference);
}

}  // namespace vp::formats
