#include "core/formats/json_value.h"

#include "core/base/expect.h"
#include "core/base/plain_text.h"
#include "core/formats/limits.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace vp::formats {
namespace {

constexpr std::size_t kLongestQuote = 300;  // bytes of a text from the file in a sentence

/// Takes the events of the JSON library and builds the document; stops at the first fault.
class Builder : public nlohmann::json_sax<nlohmann::json> {
public:
  bool null() override { return put(JsonValue()); }
  bool boolean(bool value) override { return put(JsonValue(value)); }
  bool number_integer(number_integer_t value) override { return put(JsonValue(std::int64_t{value})); }
  bool number_unsigned(number_unsigned_t value) override {
    constexpr auto limit = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return put(value <= limit ? JsonValue(static_cast<std::int64_t>(value)) : JsonValue(std::uint64_t{value}));
  }
  bool number_float(number_float_t value, const string_t& /*text*/) override { return put(JsonValue(value)); }
  bool string(string_t& value) override { return put(JsonValue(std::move(value))); }
  bool binary(binary_t& /*value*/) override { return false; }
  bool start_object(std::size_t /*size*/) override { return open(JsonValue::object()); }
  bool start_array(std::size_t /*size*/) override { return open(JsonValue::array()); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }

  bool key(string_t& name) override {
    if (open_.back().as<JsonValue::Object>()->size() >= kMostJsonMembers) {
      fault_ = fmt::format("an object has more than {} members; this is no file of this program", kMostJsonMembers);
      faultPath_ = pointer();
      return false;
    }
    if (open_.back().find(name) != nullptr) {
      fault_ = fmt::format("{} is given twice; keep one of them", quoteJson(name));
      faultPath_ = pointer() + "/" + name;
      return false;
    }
    keys_.back() = std::move(name);
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token, const nlohmann::json::exception& error) override {
    position_ = position;
    token_ = token;
    const std::string what = error.what();
    const std::size_t dash = what.rfind(" - ");
    overflow_ = error.id == 406;
    library_ = dash != std::string::npos ? what.substr(dash + 3) : what;
    return false;
  }

  [[nodiscard]] std::string pointer() const {
    std::string path;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      if (i + 1 < open_.size()) {
        const auto* list = open_[i].as<JsonValue::Array>();
        path += "/" + (list != nullptr ? std::to_string(list->size()) : keys_[i]);
      }
    }
    return path;
  }

  JsonValue root_;
  std::string fault_;
  std::string faultPath_;
  std::string library_;
  std::string token_;
  std::size_t position_ = 0;
  bool overflow_ = false;

private:
  bool open(JsonValue value) {
    open_.push_back(std::move(value));
    keys_.emplace_back();
    if (open_.size() > kMostJsonDepth) {
      fault_ = fmt::format("nested deeper than {} levels; this is no file of this program", kMostJsonDepth);
      faultPath_ = pointer();
      return false;
    }
    return true;
  }
  bool close() {
    JsonValue done = std::move(open_.back());
    open_.pop_back();
    keys_.pop_back();
    return put(std::move(done));
  }
  bool put(JsonValue value) {
    if (++values_ > kMostJsonValues) {
      fault_ = fmt::format("more than {} values; this is no file of this program", kMostJsonValues);
      return false;
    }
    if (open_.empty()) {
      root_ = std::move(value);
    } else if (open_.back().as<JsonValue::Array>() != nullptr) {
      open_.back().push(std::move(value));
    } else {
      open_.back().set(std::move(keys_.back()), std::move(value));
      keys_.back().clear();
    }
    return true;
  }

  std::size_t values_ = 0;
  std::vector<JsonValue> open_;
  std::vector<std::string> keys_;  ///< name of the member being read, per open value
};

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/// Walks a text that is known to be JSON.
class Locator {
public:
  explicit Locator(std::string_view text) : text_(text) {}

  std::size_t locate(std::string_view pointer) {
    skipSpace();
    while (!pointer.empty() && at_ < text_.size()) {
      pointer.remove_prefix(1);
      const std::size_t end = std::min(pointer.find('/'), pointer.size());
      const std::string_view step = pointer.substr(0, end);
      pointer.remove_prefix(end);
      const std::size_t parent = at_;
      const bool found = text_[at_] == '{' ? enterMember(step) : text_[at_] == '[' && enterElement(step);
      if (!found) {
        return parent;
      }
    }
    return at_;
  }

private:
  void skipSpace() {
    while (at_ < text_.size() && isSpace(text_[at_])) {
      ++at_;
    }
  }
  void skipString() {
    ++at_;
    while (at_ < text_.size() && text_[at_] != '"') {
      at_ += text_[at_] == '\\' ? 2 : 1;
    }
    ++at_;
  }
  void skipValue() {
    std::size_t depth = 0;
    do {
      skipSpace();
      if (at_ >= text_.size()) {
        return;
      }
      const char c = text_[at_];
      if (c == '"') {
        skipString();
      } else if (c == '{' || c == '[') {
        ++depth;
        ++at_;
      } else if (c == '}' || c == ']') {
        --depth;
        ++at_;
      } else if (c == ',' || c == ':') {
        ++at_;
      } else {
        while (at_ < text_.size() && !isSpace(text_[at_]) && std::string_view(",:]}").find(text_[at_]) == std::string_view::npos) {
          ++at_;
        }
      }
    } while (depth > 0);
  }
  bool enterMember(std::string_view name) {
    ++at_;
    for (;;) {
      skipSpace();
      if (at_ >= text_.size() || text_[at_] == '}') {
        return false;
      }
      const std::size_t key = at_;
      skipString();
      const std::string_view raw = text_.substr(key, std::min(at_, text_.size()) - key);
      skipSpace();
      ++at_;
      skipSpace();
      if (raw == quoteJson(name)) {
        return true;
      }
      skipValue();
      skipSpace();
      if (at_ < text_.size() && text_[at_] == ',') {
        ++at_;
      }
    }
  }
  bool enterElement(std::string_view index) {
    ++at_;
    for (std::size_t i = 0;; ++i) {
      skipSpace();
      if (at_ >= text_.size() || text_[at_] == ']') {
        return false;
      }
      if (std::to_string(i) == index) {
        return true;
      }
      skipValue();
      skipSpace();
      if (at_ < text_.size() && text_[at_] == ',') {
        ++at_;
      }
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

std::string where(const std::string& file, TextPlace place) {
  return fmt::format("{}, line {}, column {}", file, place.line, place.column);
}

std::string shortened(const std::string& text) {
  std::size_t begin = text.size() <= 40 ? 0 : text.size() - 40;
  while (begin < text.size() && (static_cast<unsigned char>(text[begin]) & 0xC0u) == 0x80u) {
    ++begin;  // to where a character begins
  }
  return plainText(std::string_view(text).substr(begin));
}

}  // namespace

bool JsonValue::isNumber() const {
  return as<std::int64_t>() != nullptr || as<std::uint64_t>() != nullptr || as<double>() != nullptr;
}

double JsonValue::number() const {
  if (const auto* integer = as<std::int64_t>()) {
    return static_cast<double>(*integer);
  }
  if (const auto* natural = as<std::uint64_t>()) {
    return static_cast<double>(*natural);
  }
  const auto* real = as<double>();
  VP_EXPECT(real != nullptr);
  return *real;
}

const JsonValue* JsonValue::find(std::string_view key) const {
  if (const auto* members = as<Object>()) {
    for (const JsonMember& member : *members) {
      if (member.key == key) {
        return &member.value;
      }
    }
  }
  return nullptr;
}

JsonValue JsonValue::strings(const std::vector<std::string>& texts) {
  JsonValue list = array();
  for (const std::string& text : texts) {
    list.push(text);
  }
  return list;
}

void JsonValue::push(JsonValue value) {
  auto* list = as<Array>();
  VP_EXPECT(list != nullptr);
  list->push_back(std::move(value));
}

void JsonValue::set(std::string key, JsonValue value) {
  auto* members = as<Object>();
  VP_EXPECT(members != nullptr && find(key) == nullptr);
  members->push_back({std::move(key), std::move(value)});
}

std::string JsonValue::describe() const {
  if (as<std::monostate>() != nullptr) {
    return "null";
  }
  if (const auto* flag = as<bool>()) {
    return *flag ? "true" : "false";
  }
  if (const auto* integer = as<std::int64_t>()) {
    return fmt::format("{}", *integer);
  }
  if (const auto* natural = as<std::uint64_t>()) {
    return fmt::format("{}", *natural);
  }
  if (const auto* real = as<double>()) {
    return shortestNumber(*real);
  }
  if (const auto* text = as<std::string>()) {
    return text->size() <= 40 ? quoteJson(*text) : "a long text";
  }
  return as<Array>() != nullptr ? "a list" : "an object";
}

TextPlace placeOf(std::string_view text, std::size_t offset) {
  offset = std::min(offset, text.size());
  TextPlace place;
  for (std::size_t i = 0; i < offset; ++i) {
    if (text[i] == '\n') {
      ++place.line;
      place.column = 1;
    } else {
      ++place.column;
    }
  }
  return place;
}

TextPlace locateJson(std::string_view text, std::string_view pointer) {
  return placeOf(text, Locator(text).locate(pointer));
}

Result<JsonValue> parseJson(std::string_view text, const std::string& file) {
  Builder builder;
  bool good = false;
  try {
    good = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  } catch (const nlohmann::json::exception& error) {
    return fail(Errc::BadFormat, fmt::format("this is not JSON ({})", error.what()), file);
  }
  if (good) {
    return std::move(builder.root_);
  }
  if (!builder.fault_.empty()) {
    return fail(Errc::BadFormat, builder.fault_,
                fmt::format("{} ({})", file, builder.faultPath_.empty() ? "/" : plainText(builder.faultPath_, kLongestQuote)));
  }
  // The library counts the characters it has read, so the last of them is the offending one.
  const std::size_t offset = builder.position_ > 0 ? builder.position_ - 1 : 0;
  if (builder.overflow_) {
    return fail(Errc::BadFormat, fmt::format("the number {} is too large; write a finite one", shortened(builder.token_)),
                where(file, placeOf(text, offset)));
  }
  if (offset >= text.size()) {
    return fail(Errc::BadFormat, "the JSON text ends in the middle; the file is cut short or a closing bracket is missing",
                where(file, placeOf(text, text.size())));
  }
  return fail(Errc::BadFormat, fmt::format("this is not JSON: {}; near '{}'", plainText(builder.library_, kLongestQuote), shortened(builder.token_)),
              where(file, placeOf(text, offset)));
}

}  // namespace vp::formats
