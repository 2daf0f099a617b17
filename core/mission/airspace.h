#pragma once

#include "core/geo/local_frame.h"

#include <optional>
#include <string>
#include <vector>

namespace vp::mission {

/** The floor or the ceiling of an airspace. */
struct AirspaceLimit {
  enum class Kind {
    Surface,      ///< the ground, as a floor
    Msl,          ///< above mean sea level
    AboveGround,  ///< above the ground below
    FlightLevel,  ///< pressure altitude; counted as MSL, that is, in a standard atmosphere with QNH 1013.25 hPa
    Unlimited,    ///< no ceiling
    Unknown,      ///< the file says it in words ("NOTAM"): a floor counts as the surface, a ceiling as none
  };
  Kind kind = Kind::Surface;
  double metres = 0.0;  ///< of Msl, AboveGround and FlightLevel
  bool operator==(const AirspaceLimit&) const = default;
};

/** A volume of the air: an outline of straight sides between corners, a floor and a ceiling. */
struct Airspace {
  std::string name;
  std::string kind;  ///< class or type as the file has it: "C", "CTR", "R"
  AirspaceLimit floor;
  AirspaceLimit ceiling;
  std::vector<geo::LatLon> outline;  ///< three or more corners, not closed; circles and arcs are drawn with corners (see the reader)
  bool operator==(const Airspace&) const = default;
};

/** What is done about an airspace. */
enum class AirspaceUse {
  Hide,    ///< not even shown
  Show,    ///< drawn, nothing else
  Warn,    ///< a tour or glide that enters it is a warning
  Forbid,  ///< a tour that enters it is refused by the checker; a glide that enters it is a warning: an emergency may
};

/** A rule for all airspaces of a kind or for those of one name. */
struct AirspaceRule {
  std::string kind;  ///< "C"; empty where `name` is given
  std::string name;  ///< "BERN TMA 1"; goes before rules on kinds
  AirspaceUse use = AirspaceUse::Warn;
  bool operator==(const AirspaceRule&) const = default;
};

/** The airspaces of a mission. */
struct AirspaceSettings {
  std::vector<std::string> files;  ///< OpenAir, paths relative to the mission file
  std::vector<AirspaceRule> rules;
  AirspaceUse otherwise = AirspaceUse::Show;  ///< of airspaces that no rule names
  bool operator==(const AirspaceSettings&) const = default;
};

/** Gives all airspaces of a kind, or with an empty kind those of a name, a rule of their own; nothing: takes it away. */
inline void setRule(AirspaceSettings& settings, const std::string& kind, const std::string& name, std::optional<AirspaceUse> use) {
  std::erase_if(settings.rules, [&](const AirspaceRule& rule) { return rule.kind == kind && rule.name == name; });
  if (use) {
    settings.rules.push_back({kind, name, *use});
  }
}

/** What the settings say of an airspace: a rule on its name, else the first on its kind, else `otherwise`. */
inline AirspaceUse useOf(const Airspace& airspace, const AirspaceSettings& settings) {
  AirspaceUse use = settings.otherwise;
  bool isFound = false;
  for (const AirspaceRule& rule : settings.rules) {
    if (!rule.name.empty() && rule.name == airspace.name) {
      return rule.use;
    }
    if (!isFound && rule.name.empty() && rule.kind == airspace.kind) {
      use = rule.use;
      isFound = true;
    }
  }
  return use;
}

}  // namespace vp::mission
