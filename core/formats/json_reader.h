#pragma once

#include "core/base/quantity.h"
#include "core/formats/json_value.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::formats {

/** One reading of one document: its text, and the first fault found in it. Readers go on after a fault with default
 *  values, so that they need no branch per field; whoever started the reading looks at error() at the end. */
class ReadContext {
public:
  ReadContext(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {}

  /** Records a fault; only the first counts. */
  void report(Errc code, const std::string& pointer, const std::string& sentence);
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }
  [[nodiscard]] const std::string& file() const { return file_; }

private:
  std::string file_;
  std::string_view text_;
  std::optional<Error> error_;
};

/** What a number may be. */
struct Range {
  double low = -std::numeric_limits<double>::max();
  double high = std::numeric_limits<double>::max();
  const char* unit = "";
  bool aboveLow = false;  ///< low itself is excluded
};

/** Reads the members of one JSON object by name. Every member asked for is known; finish() refuses the others. */
class ObjectReader {
public:
  ObjectReader(const JsonValue& value, std::string pointer, ReadContext& context);

  /** The member, or nothing; reports nothing. */
  const JsonValue* find(const std::string& name);
  bool has(const std::string& name) { return find(name) != nullptr; }
  /** The member; reports if it is missing. */
  const JsonValue* require(const std::string& name);

  double number(const std::string& name, const Range& range);                    ///< required
  double number(const std::string& name, const Range& range, double otherwise);  ///< `otherwise` if absent
  std::optional<double> maybeNumber(const std::string& name, const Range& range);
  std::int64_t integer(const std::string& name, std::int64_t low, std::int64_t high);  ///< required
  std::int64_t integer(const std::string& name, std::int64_t low, std::int64_t high, std::int64_t otherwise);
  std::uint64_t natural(const std::string& name, std::uint64_t otherwise);
  bool flag(const std::string& name, bool otherwise);
  // Texts are shown and printed: control characters in them become blanks (plainText), so that no file writes lines of its own on a terminal.
  std::string text(const std::string& name);                                ///< required, not empty
  std::string text(const std::string& name, const std::string& otherwise);  ///< may be empty
  std::vector<std::string> texts(const std::string& name);                  ///< absent = empty list; texts may be empty
  std::vector<std::string> names(const std::string& name);                  ///< the same, but no text may be empty
  // Names of files are kept to the byte, as the file system has them.
  std::string path(const std::string& name);                                ///< required, not empty
  std::string path(const std::string& name, const std::string& otherwise);  ///< may be empty
  std::vector<std::string> paths(const std::string& name);                  ///< absent = empty list; none may be empty
  /** An angle: NAME_deg, or NAME_rad where writeAngle had to use it; range in degrees. Required. */
  Angle angle(const std::string& name, const Range& degrees);
  /** A list of angles; empty if absent. */
  std::vector<Angle> angles(const std::string& name, const Range& degrees);

  /** One of a few words, by position in `words`; `otherwise` if absent, required if that is negative. */
  int word(const std::string& name, const std::vector<std::string>& words, int otherwise);

  /** Elements of a list with their pointers; absent = empty. */
  std::vector<std::pair<const JsonValue*, std::string>> elements(const std::string& name);

  [[nodiscard]] std::string pointerTo(const std::string& name) const { return pointer_ + "/" + name; }
  ReadContext& context() { return *context_; }
  void report(Errc code, const std::string& name, std::string sentence) { context_->report(code, pointerTo(name), std::move(sentence)); }

  /** Reports the first member that nobody asked for, with the nearest known name. */
  void finish();

private:
  std::string angleField(const std::string& name);
  std::string notEmpty(const std::string& name, std::string value);
  std::vector<std::string> notEmpty(const std::string& name, std::vector<std::string> values);
  std::vector<std::string> verbatim(const std::string& name);

  const JsonValue* value_;
  std::string pointer_;
  ReadContext* context_;
  std::vector<std::string> known_;
};

/** A number of any JSON kind inside a range, or a report and 0. */
double readNumber(const JsonValue& value, const std::string& pointer, const Range& range, ReadContext& context);

/** Checks "format" and "version". @return false if something was reported */
bool checkHeader(ObjectReader& reader, const std::string& format, std::int64_t newest);

/** Adds an angle so that reading it gives the same radians: NAME_deg with the shortest such number of degrees; the few
 *  angles that no number of degrees gives exactly are written as NAME_rad. */
void writeAngle(JsonValue& object, const std::string& name, Angle angle);
void writeAngles(JsonValue& object, const std::string& name, const std::vector<Angle>& angles);

/** The word of `words` with the least edits to `word`; "" if none is near. */
std::string nearestWord(const std::string& word, const std::vector<std::string>& words);

}  // namespace vp::formats
