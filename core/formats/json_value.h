#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace vp::formats {

struct JsonMember;

/** A JSON document as plain values: keeps the order of members and tells integers from other numbers, so that the
 *  JSON library stays inside json_value.cpp. */
class JsonValue {
public:
  using Array = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;
  using Variant = std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object>;

  // Each makes a value of what it is given, so none is explicit. Defined below, where JsonMember is complete.
  JsonValue() = default;
  JsonValue(bool value);           // NOLINT(google-explicit-constructor)
  JsonValue(int value);            // NOLINT(google-explicit-constructor)
  JsonValue(std::int64_t value);   // NOLINT(google-explicit-constructor)
  JsonValue(std::uint64_t value);  // NOLINT(google-explicit-constructor)
  JsonValue(double value);         // NOLINT(google-explicit-constructor)
  JsonValue(const char* value);    // NOLINT(google-explicit-constructor)
  JsonValue(std::string value);    // NOLINT(google-explicit-constructor)
  JsonValue(Array value);          // NOLINT(google-explicit-constructor)
  JsonValue(Object value);         // NOLINT(google-explicit-constructor)

  static JsonValue array();
  static JsonValue object();
  static JsonValue strings(const std::vector<std::string>& texts);

  [[nodiscard]] const Variant& variant() const { return value_; }
  template <typename T>
  [[nodiscard]] const T* as() const {
    return std::get_if<T>(&value_);
  }
  template <typename T>
  [[nodiscard]] T* as() {
    return std::get_if<T>(&value_);
  }
  [[nodiscard]] bool isNumber() const;
  /** Any number as a double. @pre isNumber() */
  [[nodiscard]] double number() const;
  /** The member of an object, or nothing. */
  [[nodiscard]] const JsonValue* find(std::string_view key) const;

  /** Appends to an array. @pre it is one */
  void push(JsonValue value);
  /** Adds a member to an object. @pre it is one, without this key */
  void set(std::string key, JsonValue value);

  /** What a person would call it: "a number", "text", "a list"... and short values themselves. */
  [[nodiscard]] std::string describe() const;

private:
  Variant value_;
};

struct JsonMember {
  std::string key;
  JsonValue value;
};

inline JsonValue::JsonValue(bool value) : value_(value) {}
inline JsonValue::JsonValue(int value) : value_(std::int64_t{value}) {}
inline JsonValue::JsonValue(std::int64_t value) : value_(value) {}
inline JsonValue::JsonValue(std::uint64_t value) : value_(value) {}
inline JsonValue::JsonValue(double value) : value_(value) {}
inline JsonValue::JsonValue(const char* value) : value_(std::string(value)) {}
inline JsonValue::JsonValue(std::string value) : value_(std::move(value)) {}
inline JsonValue::JsonValue(Array value) : value_(std::move(value)) {}
inline JsonValue::JsonValue(Object value) : value_(std::move(value)) {}
inline JsonValue JsonValue::array() {
  return JsonValue(Array{});
}
inline JsonValue JsonValue::object() {
  return JsonValue(Object{});
}

/** A place in a text, from 1; columns count bytes. */
struct TextPlace {
  std::size_t line = 1;
  std::size_t column = 1;
};
TextPlace placeOf(std::string_view text, std::size_t offset);

/** Parses a whole text. Refuses members given twice and nesting deeper than 64.
 *  @param file  name for the error
 *  @errors BadFormat - with line and column */
Result<JsonValue> parseJson(std::string_view text, const std::string& file);

/** Where the value at a JSON pointer ("/targets/3/name") begins in a text that parseJson accepted; if there is no such
 *  value, where its nearest ancestor begins. */
TextPlace locateJson(std::string_view text, std::string_view pointer);

/** How a document is laid out: what fits on a line stays on one, other lists and objects get a line per element. */
struct JsonLayout {
  std::size_t width = 120;                ///< characters
  std::vector<std::string> lineElements;  ///< members whose list has one element per line whatever their length
};

/** The document as text, with a final line end. Doubles in the shortest form that reads back bit for bit; bytes that
 *  are not UTF-8 become U+FFFD.  @pre no double is infinite or NaN */
std::string writeJson(const JsonValue& value, const JsonLayout& layout);

/** Text as a JSON string with its quotes. */
std::string quoteJson(std::string_view text);

/** Shortest decimal that reads back as the same double, valid in JSON. @pre finite */
std::string shortestNumber(double value);

}  // namespace vp::formats
