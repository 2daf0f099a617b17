#pragma once

// Rule ids of findings, as listed with their meaning in README.md.

namespace vp::safety::rule {

inline constexpr const char* kPlanEmpty = "plan.empty";
inline constexpr const char* kPlanNumber = "plan.number";
inline constexpr const char* kPlanIndex = "plan.index";
inline constexpr const char* kPlanPiece = "plan.piece";
inline constexpr const char* kAircraftProfile = "aircraft.profile";
inline constexpr const char* kAirAltimeter = "air.altimeter";
inline constexpr const char* kAircraftPropeller = "aircraft.propeller";
inline constexpr const char* kAircraftSpeed = "aircraft.speed";
inline constexpr const char* kAircraftWarning = "aircraft.warning";
inline constexpr const char* kWindData = "wind.data";
inline constexpr const char* kSettings = "settings";
inline constexpr const char* kSettingsClearance = "settings.clearance";
inline constexpr const char* kSettingsReaction = "settings.reaction";
inline constexpr const char* kTerrainChanged = "terrain.changed";
inline constexpr const char* kTerrainGrid = "terrain.grid";
inline constexpr const char* kTerrainUnknown = "terrain.unknown";
inline constexpr const char* kSitePosition = "site.position";
inline constexpr const char* kSiteData = "site.data";
inline constexpr const char* kSiteExcluded = "site.excluded";
inline constexpr const char* kSiteApproximate = "site.approximate";
inline constexpr const char* kSiteElevation = "site.elevation";
inline constexpr const char* kTargetData = "target.data";
inline constexpr const char* kTargetPosition = "target.position";
inline constexpr const char* kTargetAltitude = "target.altitude";
inline constexpr const char* kTargetSkipped = "target.skipped";
inline constexpr const char* kTargetMissed = "target.missed";
inline constexpr const char* kTargetLow = "target.low";
inline constexpr const char* kTargetAbove = "target.above";
inline constexpr const char* kTourGap = "tour.gap";
inline constexpr const char* kTourRadius = "tour.radius";
inline constexpr const char* kTourSpacing = "tour.spacing";
inline constexpr const char* kTourClimb = "tour.climb";
inline constexpr const char* kTourDescent = "tour.descent";
inline constexpr const char* kTourCeiling = "tour.ceiling";
inline constexpr const char* kTourClearance = "tour.clearance";
inline constexpr const char* kTourSafeAltitude = "tour.safeAltitude";
inline constexpr const char* kBetweenHeight = "between.height";
inline constexpr const char* kBetweenRadius = "between.radius";
inline constexpr const char* kBetweenClearance = "between.clearance";
inline constexpr const char* kGlideRadius = "glide.radius";
inline constexpr const char* kGlideSite = "glide.site";
inline constexpr const char* kGlideHeading = "glide.heading";
inline constexpr const char* kGlideArrival = "glide.arrival";
inline constexpr const char* kGlideClearance = "glide.clearance";
inline constexpr const char* kGlideDynamics = "glide.dynamics";
inline constexpr const char* kGlideReaction = "glide.reaction";
inline constexpr const char* kGlideSafeAltitude = "glide.safeAltitude";
inline constexpr const char* kLandingSlope = "landing.slope";
inline constexpr const char* kApproachStraight = "approach.straight";
inline constexpr const char* kApproachCircle = "approach.circle";
inline constexpr const char* kApproachSlope = "approach.slope";
inline constexpr const char* kApproachKey = "approach.key";
inline constexpr const char* kHoldMissing = "hold.missing";
inline constexpr const char* kHoldRadius = "hold.radius";
inline constexpr const char* kHoldClearance = "hold.clearance";
inline constexpr const char* kHoldSurplus = "hold.surplus";
inline constexpr const char* kSiteLength = "site.length";
inline constexpr const char* kSpiralNotAllowed = "spiral.notAllowed";
inline constexpr const char* kSpiralData = "spiral.data";
inline constexpr const char* kSpiralRadius = "spiral.radius";
inline constexpr const char* kSpiralPitch = "spiral.pitch";
inline constexpr const char* kSpiralClearance = "spiral.clearance";
inline constexpr const char* kSpiralSuspended = "spiral.suspended";
inline constexpr const char* kHomeData = "home.data";
inline constexpr const char* kHomeRunway = "home.runway";
inline constexpr const char* kHomeJoin = "home.join";
inline constexpr const char* kHomeClearance = "home.clearance";
inline constexpr const char* kHomeLow = "home.low";
inline constexpr const char* kHomeGuarantee = "home.guarantee";
inline constexpr const char* kAirspaceTour = "airspace.tour";
inline constexpr const char* kAirspaceGlide = "airspace.glide";
inline constexpr const char* kMetricsMismatch = "metrics.mismatch";
inline constexpr const char* kMetricsBound = "metrics.bound";

}  // namespace vp::safety::rule
