#include "core/formats/json_reader.h"

#include "core/base/plain_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>

namespace vp::formats {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::max();

std::string rangeText(const Range& range) {
  const std::string unit = *range.unit == '\0' ? "" : std::string(" ") + range.unit;
  if (range.low == -kUnlimited && range.high == kUnlimited) {
    return "a finite number";
  }
  if (range.high == kUnlimited) {
    return fmt::format("{} {}{}", range.aboveLow ? "more than" : "at least", range.low, unit);
  }
  if (range.aboveLow) {
    return fmt::format("more than {} and at most {}{}", range.low, range.high, unit);
  }
  return fmt::format("{} to {}{}", range.low, range.high, unit);
}

bool isInside(double value, const Range& range) {
  return (range.aboveLow ? value > range.low : value >= range.low) && value <= range.high;
}

std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
      const std::size_t change = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({change, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// A finite value in degrees whose radians are exactly `angle`, if a decimal of at most 17 digits gives one.
std::optional<double> exactDegrees(Angle angle) {
  std::array<char, 40> buffer{};
  for (int digits = 1; digits <= 17; ++digits) {
    const auto written = std::to_chars(buffer.data(), buffer.data() + buffer.size(), angle.degrees(), std::chars_format::general, digits);
    double degrees = 0.0;
    std::from_chars(buffer.data(), written.ptr, degrees);
    if (Angle::degrees(degrees) == angle) {
      return degrees;
    }
  }
  for (const double neighbour : {std::nextafter(angle.degrees(), -kUnlimited), std::nextafter(angle.degrees(), kUnlimited)}) {
    if (Angle::degrees(neighbour) == angle) {
      return neighbour;
    }
  }
  return std::nullopt;
}

}  // namespace

void ReadContext::report(Errc code, const std::string& pointer, const std::string& sentence) {
  if (!error_) {
    const TextPlace place = locateJson(text_, pointer);
    constexpr std::size_t kLongest = 1000;  // bytes; both may quote texts of the file
    constexpr std::size_t kLongestPointer = 300;
    error_ = Error{
        code, plainText(sentence, kLongest),
        fmt::format("{}, line {}, column {} ({})", file_, place.line, place.column, pointer.empty() ? "/" : plainText(pointer, kLongestPointer))};
  }
}

ObjectReader::ObjectReader(const JsonValue& value, std::string pointer, ReadContext& context)
    : value_(&value), pointer_(std::move(pointer)), context_(&context) {
  if (value.as<JsonValue::Object>() == nullptr) {
    context.report(Errc::BadFormat, pointer_, fmt::format("must be an object in braces {{...}}, not {}", value.describe()));
  }
}

const JsonValue* ObjectReader::find(const std::string& name) {
  if (std::find(known_.begin(), known_.end(), name) == known_.end()) {
    known_.push_back(name);
  }
  return value_->find(name);
}

const JsonValue* ObjectReader::require(const std::string& name) {
  const JsonValue* found = find(name);
  if (found == nullptr && !context_->error()) {
    std::vector<std::string> others;
    if (const auto* members = value_->as<JsonValue::Object>()) {
      for (const JsonMember& member : *members) {
        others.push_back(member.key);
      }
    }
    const std::string near = nearestWord(name, others);
    const bool misspelt = !near.empty() && std::find(known_.begin(), known_.end(), near) == known_.end();
    context_->report(
        Errc::BadFormat, pointer_,
        misspelt ? fmt::format("\"{}\" is missing; is {} meant?", name, quoteJson(near)) : fmt::format("\"{}\" is missing; add it", name));
  }
  return found;
}

double readNumber(const JsonValue& value, const std::string& pointer, const Range& range, ReadContext& context) {
  if (!value.isNumber()) {
    context.report(Errc::BadFormat, pointer, fmt::format("must be a number, {}, not {}", rangeText(range), value.describe()));
    return 0.0;
  }
  const double number = value.number();
  if (!std::isfinite(number) || !isInside(number, range)) {
    context.report(Errc::OutOfRange, pointer, fmt::format("must be {}, not {}", rangeText(range), value.describe()));
    return 0.0;
  }
  return number;
}

double ObjectReader::number(const std::string& name, const Range& range) {
  const JsonValue* found = require(name);
  return found != nullptr ? readNumber(*found, pointerTo(name), range, *context_) : 0.0;
}

double ObjectReader::number(const std::string& name, const Range& range, double otherwise) {
  return maybeNumber(name, range).value_or(otherwise);
}

std::optional<double> ObjectReader::maybeNumber(const std::string& name, const Range& range) {
  const JsonValue* found = find(name);
  return found != nullptr ? std::optional(readNumber(*found, pointerTo(name), range, *context_)) : std::nullopt;
}

std::int64_t ObjectReader::integer(const std::string& name, std::int64_t low, std::int64_t high) {
  return require(name) != nullptr ? integer(name, low, high, low) : low;
}

std::int64_t ObjectReader::integer(const std::string& name, std::int64_t low, std::int64_t high, std::int64_t otherwise) {
  const JsonValue* found = find(name);
  if (found == nullptr) {
    return otherwise;
  }
  const auto* value = found->as<std::int64_t>();
  if (value != nullptr && *value >= low && *value <= high) {
    return *value;
  }
  const std::string bounds = high == std::numeric_limits<std::int64_t>::max() ? fmt::format("at least {}", low) : fmt::format("{} to {}", low, high);
  report(found->isNumber() ? Errc::OutOfRange : Errc::BadFormat, name, fmt::format("must be a whole number, {}, not {}", bounds, found->describe()));
  return otherwise;
}

std::uint64_t ObjectReader::natural(const std::string& name, std::uint64_t otherwise) {
  const JsonValue* found = find(name);
  if (found == nullptr) {
    return otherwise;
  }
  if (const auto* natural = found->as<std::uint64_t>()) {
    return *natural;
  }
  if (const auto* value = found->as<std::int64_t>(); value != nullptr && *value >= 0) {
    return static_cast<std::uint64_t>(*value);
  }
  report(found->isNumber() ? Errc::OutOfRange : Errc::BadFormat, name,
         fmt::format("must be a whole number, 0 to 18446744073709551615, not {}", found->describe()));
  return otherwise;
}

bool ObjectReader::flag(const std::string& name, bool otherwise) {
  const JsonValue* found = find(name);
  if (found == nullptr) {
    return otherwise;
  }
  const auto* value = found->as<bool>();
  if (value == nullptr) {
    report(Errc::BadFormat, name, fmt::format("must be true or false, not {}", found->describe()));
  }
  return value != nullptr ? *value : otherwise;
}

std::string ObjectReader::notEmpty(const std::string& name, std::string value) {
  if (value.empty()) {
    report(Errc::OutOfRange, name, "must not be empty");
  }
  return value;
}

std::string ObjectReader::text(const std::string& name) {
  return plainText(path(name));
}

std::string ObjectReader::text(const std::string& name, const std::string& otherwise) {
  return plainText(path(name, otherwise));
}

std::string ObjectReader::path(const std::string& name) {
  return require(name) != nullptr ? notEmpty(name, path(name, {})) : std::string();
}

std::string ObjectReader::path(const std::string& name, const std::string& otherwise) {
  const JsonValue* found = find(name);
  if (found == nullptr) {
    return otherwise;
  }
  const auto* value = found->as<std::string>();
  if (value == nullptr) {
    report(Errc::BadFormat, name, fmt::format("must be text in quotes, not {}", found->describe()));
  }
  return value != nullptr ? *value : otherwise;
}

std::vector<std::pair<const JsonValue*, std::string>> ObjectReader::elements(const std::string& name) {
  std::vector<std::pair<const JsonValue*, std::string>> found;
  const JsonValue* value = find(name);
  if (value == nullptr) {
    return found;
  }
  const auto* list = value->as<JsonValue::Array>();
  if (list == nullptr) {
    report(Errc::BadFormat, name, fmt::format("must be a list in brackets [...], not {}", value->describe()));
    return found;
  }
  for (std::size_t i = 0; i < list->size(); ++i) {
    found.emplace_back(&(*list)[i], fmt::format("{}/{}/{}", pointer_, name, i));
  }
  return found;
}

std::vector<std::string> ObjectReader::verbatim(const std::string& name) {
  std::vector<std::string> found;
  for (const auto& [value, pointer] : elements(name)) {
    if (const auto* text = value->as<std::string>()) {
      found.push_back(*text);
    } else {
      context_->report(Errc::BadFormat, pointer, fmt::format("must be text in quotes, not {}", value->describe()));
    }
  }
  return found;
}

std::vector<std::string> ObjectReader::notEmpty(const std::string& name, std::vector<std::string> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i].empty()) {
      report(Errc::OutOfRange, fmt::format("{}/{}", name, i), "must not be empty");
    }
  }
  return values;
}

std::vector<std::string> ObjectReader::texts(const std::string& name) {
  std::vector<std::string> found = verbatim(name);
  std::transform(found.begin(), found.end(), found.begin(), [](const std::string& text) { return plainText(text); });
  return found;
}

std::vector<std::string> ObjectReader::names(const std::string& name) {
  return notEmpty(name, texts(name));
}

std::vector<std::string> ObjectReader::paths(const std::string& name) {
  return notEmpty(name, verbatim(name));
}

std::string ObjectReader::angleField(const std::string& name) {
  const bool inRadians = has(name + "_rad");
  if (inRadians && value_->find(name + "_deg") != nullptr) {
    report(Errc::BadFormat, name + "_rad", fmt::format("\"{}_deg\" is given too; keep one of them", name));
  }
  return name + (inRadians ? "_rad" : "_deg");
}

Angle ObjectReader::angle(const std::string& name, const Range& degrees) {
  const std::string field = angleField(name);
  if (field.ends_with("_deg")) {
    return Angle::degrees(number(field, degrees));
  }
  const Range radians{Angle::degrees(degrees.low).radians(), Angle::degrees(degrees.high).radians(), "rad", degrees.aboveLow};
  return Angle::radians(number(field, radians));
}

std::vector<Angle> ObjectReader::angles(const std::string& name, const Range& degrees) {
  const std::string field = angleField(name);
  const bool inDegrees = field.ends_with("_deg");
  std::vector<Angle> found;
  for (const auto& [value, pointer] : elements(field)) {
    const Range radians{Angle::degrees(degrees.low).radians(), Angle::degrees(degrees.high).radians(), "rad", degrees.aboveLow};
    const double number = readNumber(*value, pointer, inDegrees ? degrees : radians, *context_);
    found.push_back(inDegrees ? Angle::degrees(number) : Angle::radians(number));
  }
  find(name + "_deg");
  return found;
}

int ObjectReader::word(const std::string& name, const std::vector<std::string>& words, int otherwise) {
  const JsonValue* found = otherwise < 0 ? require(name) : find(name);
  if (found == nullptr) {
    return std::max(otherwise, 0);
  }
  if (const auto* text = found->as<std::string>()) {
    const auto place = std::find(words.begin(), words.end(), *text);
    if (place != words.end()) {
      return static_cast<int>(place - words.begin());
    }
  }
  report(Errc::BadFormat, name, fmt::format("must be \"{}\", not {}", fmt::join(words, "\" or \""), found->describe()));
  return std::max(otherwise, 0);
}

void ObjectReader::finish() {
  const auto* members = value_->as<JsonValue::Object>();
  if (members == nullptr || context_->error()) {
    return;
  }
  for (const JsonMember& member : *members) {
    if (std::find(known_.begin(), known_.end(), member.key) == known_.end()) {
      const std::string near = nearestWord(member.key, known_);
      report(Errc::BadFormat, member.key,
             near.empty() ? fmt::format("unknown field {}; remove it", quoteJson(member.key))
                          : fmt::format("unknown field {}; is \"{}\" meant?", quoteJson(member.key), near));
      return;
    }
  }
}

bool checkHeader(ObjectReader& reader, const std::string& format, std::int64_t newest) {
  if (reader.context().error()) {
    return false;
  }
  const std::string found = reader.text("format");
  if (!reader.context().error() && found != format) {
    reader.report(Errc::BadFormat, "format", fmt::format("this is not a {} file: its format is {}", format, quoteJson(found)));
  }
  const std::int64_t version = reader.integer("version", 1, std::numeric_limits<std::int64_t>::max());
  if (version > newest) {
    reader.report(
        Errc::NewerVersion, "version",
        fmt::format("written by a newer Volplane (version {} of the format, this program reads up to {}); update Volplane", version, newest));
  }
  return !reader.context().error();
}

void writeAngle(JsonValue& object, const std::string& name, Angle angle) {
  const std::optional<double> degrees = exactDegrees(angle);
  object.set(name + (degrees ? "_deg" : "_rad"), degrees ? *degrees : angle.radians());
}

void writeAngles(JsonValue& object, const std::string& name, const std::vector<Angle>& angles) {
  JsonValue inDegrees = JsonValue::array();
  JsonValue inRadians = JsonValue::array();
  bool exact = true;
  for (const Angle angle : angles) {
    const std::optional<double> degrees = exactDegrees(angle);
    exact = exact && degrees;
    inDegrees.push(degrees.value_or(0.0));
    inRadians.push(angle.radians());
  }
  object.set(name + (exact ? "_deg" : "_rad"), exact ? std::move(inDegrees) : std::move(inRadians));
}

std::string nearestWord(const std::string& word, const std::vector<std::string>& words) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, word.size() / 2);
  if (word.size() > 80) {
    return best;
  }
  for (const std::string& candidate : words) {
    const std::size_t edits = editDistance(word, candidate);
    if (edits < least || (edits == least && best.empty())) {
      least = edits;
      best = candidate;
    }
  }
  return best;
}

}  // namespace vp::formats
