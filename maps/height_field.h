// A square field of terrain heights in a local metric frame, and its GeoTIFF.
#pragma once

#include "core/base/result.h"
#include "core/geo/local_frame.h"

#include <cstddef>
#include <string>
#include <vector>

namespace vp::maps {

/** Square field of posts, symmetric about the origin of a local frame: post (i, j) lies at
 *  ((i - (size-1)/2) * spacing, (j - (size-1)/2) * spacing), i to the east, j to the north; heights in metres. */
class HeightField {
public:
  HeightField(int size, double spacing, double height = 0.0);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] double spacing() const { return spacing_; }
  [[nodiscard]] double& at(int i, int j) { return heights_[index(i, j)]; }
  [[nodiscard]] double at(int i, int j) const { return heights_[index(i, j)]; }
  [[nodiscard]] std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(i);
  }
  [[nodiscard]] std::vector<double>& heights() { return heights_; }
  [[nodiscard]] const std::vector<double>& heights() const { return heights_; }

  /** Metres east (or north) of the origin of a column (or row). */
  [[nodiscard]] double coordinate(int i) const { return (i - (size_ - 1) / 2.0) * spacing_; }
  /** Column (or row) nearest to a coordinate, kept inside the field. */
  [[nodiscard]] int nearest(double coordinate) const;
  [[nodiscard]] double lowest() const;
  [[nodiscard]] double highest() const;
  /** Maps the heights linearly so that they reach from `low` to `high`. */
  void stretchTo(double low, double high);
  void roundHeights(double unit);

private:
  int size_;
  double spacing_;
  std::vector<double> heights_;
};

enum class SampleType { Int16, Float32 };

/** Writes a height field as a compressed GeoTIFF in the azimuthal equidistant projection of the frame; posts are pixel
 *  centres. @errors OutputFailed */
Result<void> writeGeoTiff(const HeightField& field, const geo::LocalFrame& frame, SampleType type, const std::string& path);

}  // namespace vp::maps
