#pragma once

#include "core/base/quantity.h"

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace vp::formats {

/** Names that a field may have in tables and GeoJSON properties that people write themselves. Case, spaces, and the signs
 *  _ - . ( ) do not matter: "Elevation (ft)" is "elevation_ft". */
class FieldNames {
public:
  /** @param spellings  of each field, in the order of the fields */
  explicit FieldNames(const std::vector<std::vector<const char*>>& spellings);

  /** Which field a name means, or -1. */
  [[nodiscard]] int find(std::string_view name) const;
  [[nodiscard]] std::size_t count() const { return count_; }

private:
  std::unordered_map<std::string, int> fields_;
  std::size_t count_ = 0;
};

/** The values of one row or feature by field; empty where it has none. */
using FieldValues = std::vector<std::string>;

/** "," or ";" or a tab: which of them the first line of a table has most of. */
char separatorOf(std::string_view firstLine);

/** A number, with a comma for the decimal point where the text has one and no point. Finite. */
std::optional<double> parseDecimal(std::string_view text);

/** A length with or without its unit: "590 m", "1640ft", "0.3nm", "0.2ml", "12 km".
 *  @param plain  metres of one unit where none is written; 0 = a unit must be written */
std::optional<Length> parseLengthWithUnit(std::string_view text, double plain);

/** yes, true, 1, x, y, ja, oui, si; no, false, 0, n and "" for no; nothing for other words. */
std::optional<bool> parseYesNo(std::string_view text);

}  // namespace vp::formats
