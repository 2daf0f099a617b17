#pragma once

#include "core/base/result.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

class OGRSpatialReference;
class OGRCoordinateTransformation;

namespace vp::terrain::detail {

/// A coordinate system with x east (longitude) first, whatever its authority says.
using Crs = std::shared_ptr<const OGRSpatialReference>;

/** From anything that GDAL understands: "EPSG:21781", a PROJ string, WKT. @errors BadFormat */
Result<Crs> crsFrom(const std::string& definition);

/** Batch transformation of horizontal coordinates between two systems. Never falls back on ignoring the datum: where
 *  the shift between two datums is not known the transformation does not come about or the point fails.
 *  @threads one thread at a time */
class CrsTransform {
public:
  /** @errors Unsupported: no transformation known between them */
  static Result<CrsTransform> between(const Crs& from, const Crs& to);

  /** Transforms in place; a point that cannot be transformed becomes not-a-number. @pre x.size() == y.size() */
  void apply(std::span<double> x, std::span<double> y);

private:
  struct Closer {
    void operator()(OGRCoordinateTransformation* transformation) const;
  };
  std::unique_ptr<OGRCoordinateTransformation, Closer> transformation_;
  std::vector<int> isDone_;
};

}  // namespace vp::terrain::detail
