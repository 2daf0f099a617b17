#pragma once

#include "core/emergency/landing_answer.h"
#include "core/emergency/landing_request.h"
#include "core/emergency/runway_ranking.h"

#include <string>

namespace vp::cli {

/** What `land` was asked, for its report. */
struct LandQuestion {
  const emergency::LandingRequest& request;
  std::string planner;             ///< that was asked
  double roadmapSeconds = 0.0;     ///< spent on a roadmap before the clock began; 0: none
  std::vector<std::string> notes;  ///< of the mission's files
  std::vector<emergency::RankedRunway> ranking = {};
};

/** Prints the answer for a pilot: runway, way there, height in hand, terms. */
void printAnswer(const LandQuestion& question, const emergency::LandingAnswer& answer);

/** The same for a program: a JSON object as text with a newline at its end. */
std::string answerToJson(const LandQuestion& question, const emergency::LandingAnswer& answer);

}  // namespace vp::cli
