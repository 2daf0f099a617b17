#pragma once

#include "core/base/result.h"
#include "core/tour/gtsp.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace vp::tour {

/** A generalized TSP as a GTSPLIB file describes it. Nodes count from 0 here, from 1 in the file. */
struct GtspInstance {
  std::string name;
  GtspProblem problem;
};

/** Reads a GTSPLIB file (also gzipped): TYPE GTSP or AGTSP, EDGE_WEIGHT_TYPE EXPLICIT with every full, triangular and
 *  diagonal format of TSPLIB, or EUC_2D, CEIL_2D, MAN_2D, MAX_2D, GEO and ATT with rounding as TSPLIB prescribes.
 *  @errors BadFile - cannot be read; BadFormat - names the line and the remedy; Unsupported - another problem or weight type
 *  @source Reinelt 1995, TSPLIB 95; Fischetti, Salazar, Toth 1997 for the set sections */
Result<GtspInstance> loadGtspLib(const std::filesystem::path& file);

/** The same from text; `where` names the source in errors. */
Result<GtspInstance> parseGtspLib(std::string_view text, const std::string& where);

}  // namespace vp::tour
