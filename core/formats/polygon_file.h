#pragma once

#include "core/base/result.h"
#include "core/formats/named_fields.h"
#include "core/geo/local_frame.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vp::formats {

/** A value of a feature; neither where the feature has none. */
struct PolygonField {
  std::string name;              ///< as the file calls it
  std::string text;              ///< UTF-8
  std::optional<double> number;  ///< as written, bit for bit where the format keeps it so
  [[nodiscard]] bool isSet() const { return !text.empty() || number.has_value(); }
};

/** A feature with its polygons in degrees of WGS 84. */
struct PolygonFeature {
  using Rings = std::vector<std::vector<geo::LatLon>>;  ///< outline, then holes; not closed
  int number = 0;                                       ///< in the file, from 1
  std::vector<PolygonField> fields;                     ///< by our fields: the first of the file that is set
  std::vector<Rings> parts;                             ///< none: it has no polygon
};

/** Polygons with fields, from GeoJSON, shapefile, GeoPackage, KML and FlatGeobuf: the first layer that has some. A coordinate system of the file is
 * turned to WGS 84; without one the coordinates must be degrees.   @threads one thread at a time */
class PolygonFile {
public:
  /** @param content  of the file, for the error: "population is read from areas with people in them"
   *  @errors BadFile - no file that OGR opens; BadFormat - no polygons, more than five million of them, coordinates that are no degrees and no
   *  coordinate system */
  static Result<PolygonFile> open(const std::string& path, const FieldNames& names, const std::string& content);

  ~PolygonFile();
  PolygonFile(PolygonFile&&) noexcept;
  PolygonFile& operator=(PolygonFile&&) noexcept;
  PolygonFile(const PolygonFile&) = delete;
  PolygonFile& operator=(const PolygonFile&) = delete;

  /** Whether any field of the file means one of ours. */
  [[nodiscard]] bool hasField(int field) const;
  /** Whether any field of the file means one of ours from `first` to `last`. */
  [[nodiscard]] bool hasAnyField(int first, int last) const;
  /** Whether one of the next few features has a polygon: files of points and lines have the same fields. Reads on. */
  [[nodiscard]] bool beginsWithPolygons();
  /** The next feature, in the order of the file. @return false: there is none   @errors BadFormat - more corners than memory should hold */
  Result<bool> next(PolygonFeature& feature);

private:
  struct State;
  explicit PolygonFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace vp::formats
