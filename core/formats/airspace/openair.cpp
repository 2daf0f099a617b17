#include "core/formats/airspace/openair.h"

#include "core/base/plain_text.h"
#include "core/base/quantity.h"
#include "core/formats/airfield_candidates.h"
#include "core/formats/airspace/openair_fields.h"
#include "core/formats/csv.h"
#include "core/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace vp::formats {
namespace {

using geo::LatLon;
using mission::Airspace;
using mission::AirspaceLimit;

constexpr double kMostOff = 1.0;        // m, corners of an arc from its true line
constexpr double kLargestRadius = 1e6;  // m

/// Corners on an arc so close that the line between two of them leaves the arc by at most kMostOff.
std::size_t cornersOf(double radius, double sweep) {
  const double step = 2.0 * std::acos(1.0 - std::min(0.5, kMostOff / radius));
  return static_cast<std::size_t>(std::clamp(std::ceil(sweep / step), 4.0, 4000.0));
}

class OpenAirReader {
public:
  void readLine(std::string_view line, std::size_t number) {
    line = trimmed(line.substr(0, std::min(line.find('*'), line.size())));
    if (line.empty()) {
      return;
    }
    const OpenAirLine fields(line);
    if (fields.code == "AC") {
      finish();
      current_ = Airspace();
      current_.kind = plainText(fields.value);
      begin_ = number;
      isOpen_ = true;
      ++records;
    } else if (isOpen_) {
      readRecord(fields, number);
    }
  }

  /// Puts the airspace read last among the others, or says why not.
  void finish() {
    if (!isOpen_) {
      return;
    }
    isOpen_ = false;
    const std::string where = fmt::format("{} in line {}", current_.name.empty() ? "no name" : current_.name, begin_);
    if (fault_.empty() && (!hasFloor_ || !hasCeiling_)) {
      fault_ = "floor or ceiling missing";
    }
    auto& outline = current_.outline;
    outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
    if (outline.size() > 1 && outline.front() == outline.back()) {
      outline.pop_back();
    }
    if (fault_.empty() && outline.size() < 3) {
      fault_ = "less than three corners";
    }
    if (fault_.empty() && corners_ + outline.size() > kMostAirspacesCorners) {
      fault_ = fmt::format("more than {} corners in the file; take the part of it for the region", kMostAirspacesCorners);
    }
    if (fault_.empty()) {
      corners_ += outline.size();
      report.airspaces.push_back(std::move(current_));
    } else {
      leftOut.add(fault_, where);
    }
    fault_.clear();
    hasFloor_ = hasCeiling_ = false;
    centre_.reset();
    direction_ = 1.0;
  }

  AirspaceReport report;
  LeftOut leftOut;
  LeftOut inWords;
  std::size_t records = 0;

private:
  void readRecord(const OpenAirLine& fields, std::size_t number) {
    const std::string_view code = fields.code;
    if (code == "AN") {
      current_.name = plainText(fields.value);
    } else if (code == "AY") {
      const bool saysNothing = current_.kind == "UNC" || current_.kind == "Q" || current_.kind.empty();
      current_.kind = saysNothing ? plainText(fields.value) : current_.kind;
    } else if (code == "AL" || code == "AH") {
      readLimit(fields.value, code == "AL", number);
    } else if (code == "V") {
      readVariable(fields.value, number);
    } else if (code == "DP") {
      addCorner(parseOpenAirPlace(fields.value), number);
    } else if (code == "DC") {
      addCircle(fields.value, number);
    } else if (code == "DA") {
      addArcByAngles(fields.value, number);
    } else if (code == "DB") {
      addArcByEnds(fields.value, number);
    }
    if (current_.outline.size() > kMostAirspaceCorners) {
      current_.outline.clear();
      setFault("too many corners", number);
    }
  }

  void setFault(const std::string& fault, std::size_t number) {
    if (fault_.empty()) {
      fault_ = fault;
      leftOut.add(fault + ", so its airspace", fmt::format("line {}", number));
    }
  }

  void readLimit(std::string_view text, bool isFloor, std::size_t number) {
    const AirspaceLimit limit = parseOpenAirLimit(text, isFloor);
    if (limit.kind == AirspaceLimit::Kind::Unknown) {
      inWords.add(isFloor ? "a floor counts as the surface" : "a ceiling counts as none", fmt::format("line {}", number));
    }
    (isFloor ? current_.floor : current_.ceiling) = limit;
    (isFloor ? hasFloor_ : hasCeiling_) = true;
  }

  void readVariable(std::string_view text, std::size_t number) {
    const std::size_t equals = text.find('=');
    const std::string_view name = trimmed(text.substr(0, std::min(equals, text.size())));
    const std::string_view value = equals == std::string_view::npos ? std::string_view() : trimmed(text.substr(equals + 1));
    if (name == "X" || name == "x") {
      centre_ = parseOpenAirPlace(value);
      if (!centre_) {
        setFault("centre is no place", number);
      }
    } else if (name == "D" || name == "d") {
      direction_ = value.starts_with('-') ? -1.0 : 1.0;
    }
  }

  void addCorner(const std::optional<LatLon>& place, std::size_t number) {
    if (place) {
      current_.outline.push_back(*place);
    } else {
      setFault("corner is no place", number);
    }
  }

  [[nodiscard]] bool isUsable(double radius) const { return centre_ && radius >= 1.0 && radius <= kLargestRadius; }

  void addCircle(std::string_view text, std::size_t number) {
    const double radius = parseNumber(trimmed(text)).value_or(-1.0) * kMetresPerNauticalMile;
    if (!isUsable(radius)) {
      setFault("circle without centre or with a radius that makes no sense", number);
      return;
    }
    const std::size_t count = cornersOf(radius, 2.0 * Angle::kPi);
    const double outside = radius / std::cos(Angle::kPi / static_cast<double>(count));  // the sides touch the circle
    for (std::size_t i = 0; i < count; ++i) {
      const double course = 360.0 * static_cast<double>(i) / static_cast<double>(count);
      current_.outline.push_back(geo::geodesicDestination(*centre_, Angle::degrees(course), Length::fromSi(outside)));
    }
  }

  /// Corners from one true course to another about the centre, the way that V D= says.
  void addArc(double radius, double from_deg, double to_deg) {
    double sweep = std::fmod(direction_ * (to_deg - from_deg), 360.0);
    sweep = sweep < 0.0 ? sweep + 360.0 : sweep;
    const std::size_t count = cornersOf(radius, Angle::degrees(sweep).radians());
    for (std::size_t i = 0; i <= count; ++i) {
      const double course = from_deg + direction_ * sweep * static_cast<double>(i) / static_cast<double>(count);
      current_.outline.push_back(geo::geodesicDestination(*centre_, Angle::degrees(std::fmod(course + 720.0, 360.0)), Length::fromSi(radius)));
    }
  }

  void addArcByAngles(std::string_view text, std::size_t number) {
    const std::vector<std::string_view> parts = splitAtCommas(text);
    const std::optional<double> radius = parts.size() == 3 ? parseNumber(parts[0]) : std::nullopt;
    const std::optional<double> from = parts.size() == 3 ? parseNumber(parts[1]) : std::nullopt;
    const std::optional<double> to = parts.size() == 3 ? parseNumber(parts[2]) : std::nullopt;
    const bool isSane = radius && from && to && std::fabs(*from) <= 360.0 && std::fabs(*to) <= 360.0;
    if (!isSane || !isUsable(*radius * kMetresPerNauticalMile)) {
      setFault("arc without centre, or with a radius or angles that make no sense", number);
      return;
    }
    addArc(*radius * kMetresPerNauticalMile, *from, *to);
  }

  void addArcByEnds(std::string_view text, std::size_t number) {
    const std::vector<std::string_view> parts = splitAtCommas(text);
    const std::optional<LatLon> from = parts.size() == 2 ? parseOpenAirPlace(parts[0]) : std::nullopt;
    const std::optional<LatLon> to = parts.size() == 2 ? parseOpenAirPlace(parts[1]) : std::nullopt;
    const double radius = from && centre_ ? geo::geodesicDistance(*centre_, *from).si() : -1.0;
    if (!from || !to || !isUsable(radius)) {
      setFault("arc without centre, or between places that are none", number);
      return;
    }
    addArc(radius, geo::geodesicCourse(*centre_, *from).degrees(), geo::geodesicCourse(*centre_, *to).degrees());
    current_.outline.push_back(*to);
  }

  Airspace current_;
  std::size_t corners_ = 0;  ///< of the airspaces that are kept
  std::size_t begin_ = 0;
  bool isOpen_ = false;
  bool hasFloor_ = false;
  bool hasCeiling_ = false;
  std::string fault_;
  std::optional<LatLon> centre_;
  double direction_ = 1.0;  // +1 clockwise
};

}  // namespace

bool isOpenAir(const std::string& path) {
  constexpr std::size_t kEnough = 65536;
  const Result<std::string> start = readStart(path, kEnough);
  if (!start || start->find('\0') != std::string::npos) {
    return false;
  }
  bool hasClass = false;
  bool hasLimit = false;
  std::string_view rest = *start;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string code = OpenAirLine(trimmed(rest.substr(0, end))).code;
    hasClass = hasClass || code == "AC";
    hasLimit = hasLimit || (hasClass && (code == "AL" || code == "AH"));
    rest.remove_prefix(std::min(rest.size(), end + 1));
  }
  return hasLimit;
}

Result<AirspaceReport> readOpenAir(const std::string& path) {
  const Result<std::string> text = readText(path);
  if (!text) {
    return forward(text);
  }
  OpenAirReader reader;
  std::string_view rest = *text;
  for (std::size_t number = 1; !rest.empty(); ++number) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    reader.readLine(rest.substr(0, end), number);
    const bool isPair = end + 1 < rest.size() && rest[end] == '\r' && rest[end + 1] == '\n';
    rest.remove_prefix(std::min(rest.size(), end + (isPair ? 2 : 1)));
  }
  reader.finish();
  if (reader.records == 0) {
    return fail(Errc::BadFormat, "there is no airspace in this file; an OpenAir file has lines that begin with AC, AN, AL, AH and DP", path);
  }
  reader.report.notes = reader.leftOut.sentences();
  for (std::string& note : reader.inWords.sentences("limits given in words")) {
    reader.report.notes.push_back(std::move(note));
  }
  return std::move(reader.report);
}

}  // namespace vp::formats
