#include "core/formats/cup_fields.h"

#include "core/formats/airfield_candidates.h"

#include <algorithm>

namespace vp::formats {

CupColumns::CupColumns(const CsvColumns& columns)
    : name(columns.find({"name", "title"})),
      code(columns.find({"code"})),
      latitude(columns.find({"lat", "latitude"})),
      longitude(columns.find({"lon", "longitude"})),
      elevation(columns.find({"elev", "elevation"})),
      style(columns.find({"style"})),
      direction(columns.find({"rwdir", "direction", "rw_dir", "runway direction"})),
      length(columns.find({"rwlen", "length", "rw_len", "runway length"})),
      width(columns.find({"rwwidth", "width", "rw_width", "runway width"})) {}

const char* CupColumns::missing() const {
  return name < 0 ? "name" : latitude < 0 ? "lat" : longitude < 0 ? "lon" : elevation < 0 ? "elev" : style < 0 ? "style" : nullptr;
}

std::optional<double> parseCupAngle(std::string_view text, std::size_t degreeDigits, std::string_view hemispheres) {
  if (text.size() < degreeDigits + 3) {
    return std::nullopt;
  }
  const std::size_t side = hemispheres.find(text.back() >= 'a' ? static_cast<char>(text.back() - 'a' + 'A') : text.back());
  const std::string_view digits = text.substr(0, degreeDigits);
  const std::string_view minuteText = text.substr(degreeDigits, text.size() - degreeDigits - 1);
  const bool twoDigits = std::min(minuteText.find('.'), minuteText.size()) == 2;  // "0900.000E" is a slip, not 90 degrees
  const bool plain = twoDigits && digits.find_first_not_of("0123456789") == std::string_view::npos &&
                     minuteText.find_first_not_of("0123456789.") == std::string_view::npos;
  const std::optional<double> degrees = parseNumber(digits);
  const std::optional<double> minutes = parseNumber(minuteText);
  if (side == std::string_view::npos || !plain || !degrees || !minutes || *minutes >= 60.0) {
    return std::nullopt;
  }
  const double value = *degrees + *minutes / 60.0;
  if (value > (degreeDigits == 2 ? 90.0 : 180.0)) {
    return std::nullopt;
  }
  return side == 0 ? value : -value;
}

bool beginsCupTasks(const CsvReader& csv) {
  return csv.peekLine().starts_with("-----Related Tasks");
}

}  // namespace vp::formats
