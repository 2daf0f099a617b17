#include "core/formats/exports/export_input.h"

#include "core/base/expect.h"
#include "core/base/quantity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vp::formats {
namespace {

// Letters U+00C0 to U+017F without their accents.
constexpr const char* kPlain =
    "AAAAAAACEEEEIIIIDNOOOOOxOUUUUYTsaaaaaaaceeeeiiiidnooooo?ouuuuyty"
    "AaAaAaCcCcCcCcDdDdEeEeEeEeEeGgGgGgGgHhHhIiIiIiIiIiIiJjKkkLlLlLlL"
    "lLlNnNnNnnNnOoOoOoOoRrRrRrSsSsSsSsTtTtTtUuUuUuUuUuUuWwYyYZzZzZzs";
constexpr unsigned kFirstPlain = 0xC0;
constexpr unsigned kLastPlain = 0x17F;

/// The character that begins at `at`, which moves past it; 0xFFFD for what is no UTF-8.
unsigned nextCharacter(const std::string& text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned lead = byte(at++);
  const int more = lead < 0x80 ? 0 : lead >= 0xF0 ? 3 : lead >= 0xE0 ? 2 : lead >= 0xC0 ? 1 : -1;
  if (more < 0) {
    return 0xFFFD;
  }
  unsigned value = more == 0 ? lead : lead & (0x3Fu >> more);
  for (int i = 0; i < more; ++i) {
    if ((byte(at) & 0xC0u) != 0x80u) {
      return 0xFFFD;
    }
    value = value << 6 | (byte(at++) & 0x3Fu);
  }
  return value;
}

bool isAllowed(char c, const IdentRules& rules) {
  const bool isLetter = (c >= 'A' && c <= 'Z') || (rules.lower && c >= 'a' && c <= 'z');
  return isLetter || (c >= '0' && c <= '9') || rules.others.find(c) != std::string::npos;
}

/// `wanted`, or with a number at its end if it is taken.
std::string uniqueIdent(const std::string& wanted, std::size_t longest, std::set<std::string>& used) {
  std::string ident = wanted;
  for (int number = 2; !used.insert(ident).second; ++number) {
    const std::string ending = std::to_string(number);
    VP_EXPECT(ending.size() < longest);
    ident = wanted.substr(0, longest - ending.size()) + ending;
  }
  return ident;
}

}  // namespace

std::vector<RoutePart> partsOf(const mission::Route& route, std::size_t most) {
  const std::size_t total = route.waypoints.size() + (route.isClosed ? 1 : 0);
  if (most == 0 || total <= most) {
    return {{0, total}};
  }
  VP_EXPECT(most >= 2);
  std::vector<RoutePart> parts;
  std::size_t first = 0;
  while (first + 1 < total) {
    std::size_t end = std::min(first + most - 1, total - 1);
    if (end + 1 < total) {
      for (std::size_t at = end; at > first + most / 2; --at) {
        if (route.waypoints[at].target >= 0) {
          end = at;
          break;
        }
      }
    }
    parts.push_back({first, end - first + 1});
    first = end;
  }
  return parts;
}

std::vector<const mission::RouteWaypoint*> pointsOf(const ExportInput& input) {
  VP_EXPECT(input.route != nullptr && !input.route->waypoints.empty());
  const std::size_t waypoints = input.route->waypoints.size();
  const std::size_t count = input.count > 0 ? input.count : waypoints + (input.route->isClosed ? 1 : 0);
  std::vector<const mission::RouteWaypoint*> points;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(&input.route->waypoints[(input.first + i) % waypoints]);
  }
  return points;
}

std::vector<const mission::RouteWaypoint*> placesOf(const ExportInput& input) {
  std::vector<const mission::RouteWaypoint*> points = pointsOf(input);
  if (points.size() > 1 && points.front() == points.back()) {
    points.pop_back();
  }
  return points;
}

mission::Route markedUnverified(mission::Route route) {
  route.mark = kUnverifiedMark;
  for (mission::RouteWaypoint& waypoint : route.waypoints) {
    waypoint.note = waypoint.note.empty() ? kUnverifiedMark : fmt::format("{}, {}", kUnverifiedMark, waypoint.note);
  }
  return route;
}

std::string titleOf(const ExportInput& input) {
  const std::string& name = input.plan.mission.name;
  const std::string mark = input.route == nullptr || input.route->mark.empty() ? "" : input.route->mark + ": ";
  const std::string title = mark + (name.empty() ? "tour" : name);
  return input.parts > 1 ? fmt::format("{} part {} of {}", title, input.part, input.parts) : title;
}

std::vector<std::string> identsOf(const ExportInput& input, const std::vector<const mission::RouteWaypoint*>& points, const IdentRules& rules) {
  std::set<std::string> used;
  std::vector<std::string> all(input.route->waypoints.size());
  for (const bool isTarget : {true, false}) {  // targets first, so that they keep their names
    for (std::size_t i = 0; i < all.size(); ++i) {
      const mission::RouteWaypoint& waypoint = input.route->waypoints[i];
      if ((waypoint.target >= 0) == isTarget) {
        const std::string name = restrictedTo(waypoint.name, rules);
        all[i] = uniqueIdent(name.find_first_not_of(rules.filler + " ") == std::string::npos ? fmt::format("P{}", i + 1) : name, rules.longest, used);
      }
    }
  }
  std::vector<std::string> idents;
  idents.reserve(points.size());
  for (const mission::RouteWaypoint* point : points) {
    idents.push_back(all[static_cast<std::size_t>(point - input.route->waypoints.data())]);
  }
  return idents;
}

std::string asciiOf(const std::string& utf8) {
  std::string text;
  for (std::size_t at = 0; at < utf8.size();) {
    const unsigned c = nextCharacter(utf8, at);
    text += c < 0x80 ? static_cast<char>(c) : c >= kFirstPlain && c <= kLastPlain ? kPlain[c - kFirstPlain] : '?';
  }
  return text;
}

std::string restrictedTo(const std::string& text, const IdentRules& rules) {
  std::string result;
  for (char c : asciiOf(text)) {
    if (!rules.lower && c >= 'a' && c <= 'z') {
      c = static_cast<char>(c - 'a' + 'A');
    }
    result += isAllowed(c, rules) ? std::string(1, c) : rules.filler;
  }
  result.resize(std::min(result.size(), rules.longest));
  return result;
}

std::string airportOf(const ExportInput& input, const mission::RouteWaypoint& point) {
  constexpr std::size_t kShortest = 2;
  constexpr std::size_t kLongest = 8;  // of X-Plane
  if (point.site < 0) {
    return {};
  }
  const std::string& ident = input.plan.sites[static_cast<std::size_t>(point.site)].site.airportIdent;
  const IdentRules rules{kLongest, false, "", ""};
  const bool isNamed = ident.size() >= kShortest && ident == restrictedTo(ident, rules);
  return isNamed ? ident : std::string();
}

std::string runwayOf(const ExportInput& input, const mission::RouteWaypoint& point) {
  if (point.site < 0) {
    return {};
  }
  const std::string& ident = input.plan.sites[static_cast<std::size_t>(point.site)].site.runwayIdent;
  std::size_t digits = 0;
  while (digits < ident.size() && ident[digits] >= '0' && ident[digits] <= '9') {
    ++digits;
  }
  const bool isPlain = ident.size() == digits || (ident.size() == digits + 1 && std::string("LCR").find(ident.back()) != std::string::npos);
  return digits < 1 || digits > 2 || !isPlain ? std::string() : std::string(2 - digits, '0') + ident;
}

std::string altitudeNote(const mission::RouteWaypoint& point) {
  return fmt::format("{} ft MSL{}{}", feetOf(point.altitude), point.note.empty() ? "" : ", ", point.note);
}

long feetOf(double metres) {
  return std::lround(metres / kMetresPerFoot);
}

}  // namespace vp::formats
