#pragma once

namespace vp::terrain::detail {

/** True if PROJ opens files by the rule of core/base/local_file alone: ordinary ones of this computer, for reading. PROJ reads grids of datum shifts
 *  wherever a coordinate system names them, while GDAL opens the file that holds the system and before anybody can look at it, and would wait
 *  for ever at a named pipe. GDAL gives no way to its contexts of PROJ, so this file puts itself in the place of proj_context_create, which makes
 *  each of them.   @threads pure */
bool isProjGuarded();

}  // namespace vp::terrain::detail
