#pragma once

#include "core/base/result.h"
#include "core/mission/airspace.h"

#include <string>
#include <vector>

namespace vp::formats {

/** Airspaces of a file, and what could not be used. */
struct AirspaceReport {
  std::vector<mission::Airspace> airspaces;
  std::vector<std::string> notes;  ///< counted, with the lines of the file; one sentence each
};

/** Reads OpenAir (AC AN AL AH AY AF AG AX, V, DP DC DA DB; UTF-8 or Windows-1252), plain or .gz. Heights: feet unless they say
 *  m or FL; AGL, GND and SFC above ground, otherwise MSL; UNL; words ("NOTAM") and numbers that make no sense are an unknown limit. A type (AY) takes
 * the place of a class that says nothing (UNC, Q). Circles are drawn by corners outside them, arcs by corners on them, off the true line by at most 1
 * m; sides between corners are straight in the local frame. Airspaces with less than three corners, without both limits or with a place that is none
 * are left out, counted and listed by line.
 *  @errors BadFile, BadFormat - no OpenAir at all
 *  @source openaip.net and winpilot.com OpenAir descriptions; XCSoar AirspaceParser.cpp for what files really hold */
Result<AirspaceReport> readOpenAir(const std::string& path);

/** True if the beginning of a file has the records of OpenAir. */
bool isOpenAir(const std::string& path);

}  // namespace vp::formats
