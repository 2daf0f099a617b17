#include "core/formats/named_fields.h"

#include "core/formats/airfield_candidates.h"
#include "core/formats/csv.h"

#include <algorithm>
#include <array>
#include <string>

namespace vp::formats {
namespace {

std::string plainName(std::string_view name) {
  std::string plain;
  for (const char c : name) {
    if (std::string_view(" \t_-.()[]\"").find(c) == std::string_view::npos) {
      plain += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  return plain;
}

}  // namespace

FieldNames::FieldNames(const std::vector<std::vector<const char*>>& spellings) : count_(spellings.size()) {
  for (std::size_t field = 0; field < spellings.size(); ++field) {
    for (const char* spelling : spellings[field]) {
      fields_.emplace(plainName(spelling), static_cast<int>(field));
    }
  }
}

int FieldNames::find(std::string_view name) const {
  const auto found = fields_.find(plainName(name));
  return found == fields_.end() ? -1 : found->second;
}

char separatorOf(std::string_view firstLine) {
  char best = ',';
  std::ptrdiff_t most = std::count(firstLine.begin(), firstLine.end(), ',');
  for (const char c : {';', '\t'}) {
    const std::ptrdiff_t count = std::count(firstLine.begin(), firstLine.end(), c);
    if (count > most) {
      most = count;
      best = c;
    }
  }
  return best;
}

std::optional<double> parseDecimal(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || text.find('.') != std::string_view::npos) {
    return parseNumber(text);
  }
  std::string point(text);
  point[comma] = '.';
  return parseNumber(point);
}

std::optional<Length> parseLengthWithUnit(std::string_view text, double plain) {
  const std::size_t unitAt = text.find_last_of("0123456789.,") + 1;
  const std::optional<double> number = parseDecimal(trimmed(text.substr(0, unitAt)));
  const std::string unit = plainName(text.substr(std::min(unitAt, text.size())));
  constexpr double kStatuteMile = 1609.344;  // m, exact (1959)
  const double factor = unit.empty()                   ? plain
                        : unit == "m"                  ? 1.0
                        : unit == "ft" || unit == "'"  ? kMetresPerFoot
                        : unit == "km"                 ? 1000.0
                        : unit == "nm"                 ? kMetresPerNauticalMile
                        : unit == "ml" || unit == "mi" ? kStatuteMile
                                                       : 0.0;
  return number && factor > 0.0 ? std::optional(Length::fromSi(*number * factor)) : std::nullopt;
}

std::optional<bool> parseYesNo(std::string_view text) {
  static constexpr std::array<std::string_view, 8> kYes{"yes", "true", "1", "x", "y", "ja", "oui", "si"};
  static constexpr std::array<std::string_view, 6> kNo{"", "no", "false", "0", "n", "nein"};
  const std::string word = plainName(text);
  if (std::find(kYes.begin(), kYes.end(), word) != kYes.end()) {
    return true;
  }
  return std::find(kNo.begin(), kNo.end(), word) != kNo.end() ? std::optional(false) : std::nullopt;
}

}  // namespace vp::formats
