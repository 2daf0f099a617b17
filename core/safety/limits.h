#pragma once

// Every tolerance and every bound on input of the checker, in one place. Reasons: WHY.md section 6.

namespace vp::safety {

// Tolerances for the rounding of a planner and of a plan file. None of them is a margin that a planner may use up.
inline constexpr double kAltitudeTolerance = 1e-3;        // m, heights compared with required heights
inline constexpr double kClaimTolerance = 0.01;           // m, safe altitudes and target heights claimed by a plan
inline constexpr double kGapTolerance = 1e-3;             // m, between the end of a tour piece and the next decision point
inline constexpr double kGapHeadingTolerance = 1e-6;      // rad, the same
inline constexpr double kRadiusTolerance = 1e-9;          // relative
inline constexpr double kSpacingTolerance = 1e-6;         // m
inline constexpr double kArrivalPlaceTolerance = 0.05;    // m, end of a glide to the touchdown point
inline constexpr double kArrivalHeadingTolerance = 1e-3;  // rad, the same to the landing course
inline constexpr double kVisitTolerance = 0.01;           // m, decision point to target, horizontally
inline constexpr double kFrameTolerance = 0.5;            // m, place in the frame to the LatLon it came from
inline constexpr double kFrameCourseTolerance = 0.01;     // degrees, the same for landing courses
inline constexpr double kTargetHeightTolerance = 0.5;     // m, target altitude to the terrain below it plus its height
inline constexpr double kMetricsRelative = 1e-3;          // of the recomputed metric, or
inline constexpr double kMetricsAbsolute = 1.0;           // m, whichever is larger

// What a plan may contain at all. Outside these the arithmetic of the checker is not proved, so the answer is "violated".
inline constexpr double kFarthest = 1e6;         // m, from the origin of the frame in x and in y
inline constexpr double kLargestHeading = 10.0;  // rad, either sign
inline constexpr double kLowestAltitude = -1e3;  // m MSL
inline constexpr double kHighestAltitude = 1e5;  // m MSL
inline constexpr double kSmallestRadius = 1.0;   // m
inline constexpr double kLargestRadius = 1e6;    // m
inline constexpr double kLongestPath = 1e6;      // m, one piece, and one whole glide
inline constexpr double kMostCircles = 100.0;    // full circles in one piece
inline constexpr double kMostPieces = 2000.0;    // of one glide
inline constexpr double kSmallestCell = 0.1;     // m
inline constexpr double kLargestCell = 1e5;      // m
inline constexpr double kMostTurns = 1000.0;     // circles of a spiral visit, each way

// A polar better than any aircraft's is a slip of the pen that would make every glide look safe. Best glide ratio of the best
// sailplanes: about 70. Zero-lift drag of a clean sailplane: about 0.008; induced drag 1/(pi e AR) at aspect ratio 50: 0.006.
inline constexpr double kLeastDrag = 1e-3;  // C_D0, and L of C_D = C_D0 + L C_L^2
inline constexpr double kLeastLoss = 0.01;  // m of height per metre

// Wind over airspeed up to which the greatest loss of a range of airspeeds is proved to be at one of its ends (WHY.md section 9).
inline constexpr double kMostCrab = 0.98;  // [-]

// Height of the bands of altitude that airspeeds are counted in, from mean sea level on (WHY.md section 12).
inline constexpr double kBandHeight = 250.0;  // m

// Rate of climb that a service ceiling leaves: 100 ft/min.  Source: FAA, Pilot's Handbook of Aeronautical Knowledge (FAA-H-8083-25), chapter 11
inline constexpr double kClimbAtServiceCeiling = 100.0 * 0.3048 / 60.0;  // m/s

// Ground below this is no ground but a no-data value that the file did not declare (-9999, -32768). The lowest land on
// Earth is the shore of the Dead Sea, about -440 m in 2024.
inline constexpr double kLowestGround = -500.0;  // m MSL

// A climb-out before its gliding guarantee: least height over the ground per metre flown from the far end of the runway (ICAO Doc 8168
// volume II, minimum obstacle clearance of departures: 0.8 %), and the distance within which cells, being upper bounds that
// reach over the flat ground of an airfield, lie above an aircraft that has just taken off anywhere.
inline constexpr double kDepartureObstacleClearance = 0.008;  // m per m
inline constexpr double kAirfieldDistance = 1000.0;           // m

// Cells are counted as touched by a path within this distance (see cell_walk.h).
inline constexpr double kTouch = 1e-6;  // m
}  // namespace vp::safety
