#pragma once

#include <string>

namespace vp::terrain {

/** Version of the GDAL library in use, for example "3.6.2". */
std::string gdalVersion();

/** Version of the PROJ library in use, for example "9.1.1". */
std::string projVersion();

}  // namespace vp::terrain
