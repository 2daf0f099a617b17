#pragma once

#include "core/formats/csv.h"
#include "core/geo/local_frame.h"

#include <optional>
#include <string_view>

namespace vp::formats {

/** Columns of a SeeYou .cup by the names of the 2018 and 2022 formats and of older exports ("Title", "Latitude", "Direction"). */
struct CupColumns {
  int name, code, latitude, longitude, elevation, style, direction, length, width;

  explicit CupColumns(const CsvColumns& columns);
  /** The name of a column that must be there and is not, or null. */
  [[nodiscard]] const char* missing() const;
};

/** Degrees of "DDMM.mmmN" (2 digits of degrees, sides "NS") or "DDDMM.mmmE" (3 digits, sides "EW"); nothing if it is not that. */
std::optional<double> parseCupAngle(std::string_view text, std::size_t degreeDigits, std::string_view hemispheres);

/** True where the next line begins the tasks of the file. */
bool beginsCupTasks(const CsvReader& csv);

}  // namespace vp::formats
