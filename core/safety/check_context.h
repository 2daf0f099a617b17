#pragma once

// Inside of core/safety: the rules, one function per group, and what they share. Order and meaning: checker.cpp.

#include "core/aircraft/glide_model.h"
#include "core/base/job.h"
#include "core/safety/checker.h"
#include "core/safety/findings.h"
#include "core/safety/glide_rates.h"
#include "core/safety/roll_cost.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vp::safety {

inline constexpr double kNoHeight = std::numeric_limits<double>::infinity();

/** Decision points that belong together: the closed tour, or the guaranteed part of a way from or to home. */
struct Track {
  std::span<const mission::DecisionPoint> points;
  const char* name = "tour";
  bool isClosed = true;
  std::size_t first = 0;  ///< number of points[0] in what `name` stands for
  std::vector<double>
      required;              ///< A_w of every decision point's witness plus the reaction loss, m MSL; kNoHeight if it has none. Set by checkGlides
  std::vector<bool> tooLow;  ///< found to be too low for its own glide. Set by checkGlides
};

/** Where the flight, its engine running, is closest to its clearance. */
struct ClosestGround {
  double margin = kNoHeight;
  double altitude = 0.0;  ///< m MSL, of the flight
};

/** One plan being checked. */
struct CheckContext {
  explicit CheckContext(const SafetyInput& in) : terrain(in.terrain), input(in), plan(in.plan), frame(in.plan.frameOrigin), findings(frame) {
    track.points = in.plan.tour;
  }

  const terrain::ElevationGrid& terrain;
  const SafetyInput& input;
  const mission::Plan& plan;
  geo::LocalFrame frame;
  Findings findings;
  Margins margins;
  aircraft::GlideModel model;        ///< in still air; set by checkProfile
  GlideRates rates;                  ///< in the winds of the mission; set by checkWind
  double clearance = 0.0;            ///< m, set by checkSettings
  double arrivalMargin = 0.0;        ///< m, set by checkSettings
  double reactionLoss = 0.0;         ///< m, lost at once by every engine failure. Set by checkSettings
  std::optional<RollCost> rollCost;  ///< where the profile gives a rate of roll. Set by checkGlides
  double mostRolling = 0.0;          ///< m, that rolling may cost a whole glide. Set by checkGlides, over all tracks
  std::vector<bool> siteUsed;        ///< by a witness. Set by checkGlides
  /// m MSL, by site: lowest height at which every glide to it may be at its gate. Set by checkGlides; -kNoHeight without a glide
  std::vector<double> gateLowest;
  ClosestGround closest;  ///< set by checkTour, over all tracks
  Track track;            ///< what is being checked now: the tour, until checkHome

  [[nodiscard]] std::size_t next(std::size_t point) const { return point + 1 == track.points.size() ? 0 : point + 1; }
  [[nodiscard]] FindingPlace at(std::size_t point) const { return atPlace(point, track.points[point].pose.point()); }
  /** A place that belongs to a point of the track. */
  [[nodiscard]] FindingPlace atPlace(std::size_t point, geo::Point where) const { return {track.isClosed ? static_cast<int>(point) : -1, where}; }
  /** "tour point 12" */
  [[nodiscard]] std::string nameOf(std::size_t point) const { return std::string(track.name) + " point " + std::to_string(track.first + point); }
};

/** Numbers, indices, pieces, aircraft, settings, terrain identity: false if the rest cannot be checked. */
bool checkStructure(CheckContext& context);

/** Parts of the same: numbers of the sites and the frame, and whether the terrain can be walked over. */
void checkSiteNumbers(CheckContext& context);
bool checkGrid(CheckContext& context);

/** The aircraft, if the glide model is defined for it (then sets context.model), and the settings; false if the rest cannot be checked. */
bool checkProfile(CheckContext& context);
bool checkSettings(CheckContext& context);

/** The winds of the mission: false if the rest cannot be checked; else sets context.rates. After checkProfile and checkSettings. */
bool checkWind(CheckContext& context);

/** "calm air", "every wind from 250 to 290 degrees true at 10 to 20 kt" */
std::string windText(const std::vector<air::WindLayer>& layers);

/** Sites and targets of the plan against the embedded mission, the frame and the terrain. */
void checkSites(CheckContext& context);
void checkSite(CheckContext& context, const mission::SiteInFrame& placed);
void checkTargets(CheckContext& context);

/** Witness of every decision point of the track; fills its required and tooLow. Stops early when asked to. */
void checkGlides(CheckContext& context, const Job& job);

/** How far a glide goes straight on, or along the tour, at least [m]: what the aircraft covers over ground before its pilot reacts. */
double reactionLength(const CheckContext& context);

/** The beginning of a point's glide: nothing but the tour's own way and straights for the reaction. @return true if so */
bool checkReaction(CheckContext& context, std::size_t index);

/** Whether the runway of a site is long enough for the aircraft on the day. */
void checkLength(CheckContext& context, const mission::SiteInFrame& site);

/** The approaches of the sites that are used, as far as they are the same for all glides: slope and runway length. Then the holds over them.
 *  After all glides. */
void checkApproaches(CheckContext& context);
void checkHolds(CheckContext& context);

/** Every interval of the track, and what happens between its decision points. Stops early when asked to. */
void checkTour(CheckContext& context, const Job& job);

/** The track with the engine running: turn radius, continuity, ceiling and pitch alone. Used where no glide is promised. */
void checkPoweredTrack(CheckContext& context);

/** Visits of targets and their spirals, then lengths and costs. */
void checkVisits(CheckContext& context);
void checkMetrics(CheckContext& context);

/** The ways from and to the home runway. Changes the track, so it comes after all that is about the tour. Stops early when asked to. */
void checkHome(CheckContext& context, const Job& job);

/** Tour and glides against the airspaces that the mission warns of or forbids. Stops early when asked to. */
void checkAirspaces(CheckContext& context, const Job& job);

/** Sentences on everything that the guarantee depends on beside wind, polar and terrain, each begun by a space; empty for the settings of the source
 *  papers. */
std::string conditionsText(const CheckContext& context);

/** Warnings about the same. */
void addConditionWarnings(CheckContext& context);

/** What to tell a pilot although nothing is violated. */
void addWarnings(CheckContext& context);
mission::Certificate issueCertificate(const CheckContext& context, const std::vector<Finding>& findings, const std::vector<mission::Margin>& margins);

}  // namespace vp::safety
