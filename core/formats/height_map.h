#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/geo/local_frame.h"

#include <map>
#include <string>
#include <vector>

namespace vp::formats {

/** A raster of altitudes over square cells of a local frame, on its way into a file of other programs. */
struct HeightMap {
  struct Band {
    std::string name;                          ///< one line, shown by other programs
    std::vector<float> values;                 ///< m MSL, [row * columns + column], rows from south to north; infinity: nothing known
    std::map<std::string, std::string> words;  ///< metadata of the band
  };
  std::string name;
  geo::LocalFrame frame;
  double originX = 0.0;  ///< m, south-west corner
  double originY = 0.0;
  double cell = 0.0;  ///< m
  int columns = 0;
  int rows = 0;
  std::vector<Band> bands;
  std::map<std::string, std::string> words;  ///< metadata of the file
};

/** A line of equal altitude. */
struct Contour {
  double altitude = 0.0;  ///< m MSL
  std::vector<geo::LatLon> points;
};

/** Writes a GeoTIFF: float32, metres, no-data -32767, north up, in the map's own local frame (azimuthal equidistant about its origin), so
 *  that no value is resampled. The file appears whole or not at all. @errors OutputFailed */
Result<void> writeHeightMapTiff(const HeightMap& map, const std::string& path);

/** Lines of equal altitude of a band, by GDAL's contour generator over the highest value around each cell: read between two lines the
 *  higher one, and it is nowhere below the value of the cell there.
 *  @param interval  m, above 0   @errors OutOfRange - more than 2,000 levels;  Cancelled */
Result<std::vector<Contour>> contoursOf(const HeightMap& map, std::size_t band, double interval, const Job& job);

/** Contours as KML 2.2: lines at their absolute altitude, one style for each altitude, from green (lowest) to red. */
std::string contoursToKml(const HeightMap& map, std::size_t band, const std::vector<Contour>& contours);

/** Contours as a GeoPackage: layer "contours" in EPSG:4326, lines with height, field altitude_m. The file appears whole or not at all.
 *  @errors OutputFailed */
Result<void> writeContoursGpkg(const HeightMap& map, std::size_t band, const std::vector<Contour>& contours, const std::string& path);

}  // namespace vp::formats
