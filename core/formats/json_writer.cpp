// The writing half of json_value.h.
#include "core/base/expect.h"
#include "core/formats/json_value.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vp::formats {
namespace {

class Writer {
public:
  explicit Writer(const JsonLayout& layout) : layout_(layout) {}

  void write(const JsonValue& value, std::size_t indent, const std::string& name) {
    const std::size_t start = out_.size();
    const std::size_t lineStart = out_.rfind('\n') == std::string::npos ? 0 : out_.rfind('\n') + 1;
    const bool byLine = std::find(layout_.lineElements.begin(), layout_.lineElements.end(), name) != layout_.lineElements.end();
    const auto* list = value.as<JsonValue::Array>();
    if (byLine && list != nullptr && !list->empty()) {
      writeLines(*list, indent);
      return;
    }
    if (indent > 0 && inlineUpTo(value, lineStart + layout_.width)) {
      return;
    }
    out_.resize(start);
    if (list != nullptr && !list->empty()) {
      writeList(*list, indent);
    } else if (const auto* members = value.as<JsonValue::Object>(); members != nullptr && !members->empty()) {
      writeObject(*members, indent);
    } else {
      inlineUpTo(value, std::string::npos);
    }
  }

  std::string out_;

private:
  void newLine(std::size_t indent) {
    out_ += '\n';
    out_.append(indent, ' ');
  }
  void writeLines(const JsonValue::Array& list, std::size_t indent) {
    const char* separator = "[";
    for (const JsonValue& element : list) {
      out_ += separator;
      newLine(indent + 2);
      inlineUpTo(element, std::string::npos);
      separator = ",";
    }
    newLine(indent);
    out_ += ']';
  }
  void writeList(const JsonValue::Array& list, std::size_t indent) {
    const char* separator = "[";
    for (const JsonValue& element : list) {
      out_ += separator;
      newLine(indent + 2);
      write(element, indent + 2, {});
      separator = ",";
    }
    newLine(indent);
    out_ += ']';
  }
  void writeObject(const JsonValue::Object& members, std::size_t indent) {
    const char* separator = "{";
    for (const JsonMember& member : members) {
      out_ += separator;
      newLine(indent + 2);
      out_ += quoteJson(member.key) + ": ";
      write(member.value, indent + 2, member.key);
      separator = ",";
    }
    newLine(indent);
    out_ += '}';
  }

  /// Appends the value on one line; false (and a partial text) as soon as the text passes `limit`.
  bool inlineUpTo(const JsonValue& value, std::size_t limit) {
    if (const auto* list = value.as<JsonValue::Array>()) {
      const char* separator = "[";
      for (const JsonValue& element : *list) {
        out_ += separator;
        if (!inlineUpTo(element, limit)) {
          return false;
        }
        separator = ", ";
      }
      out_ += list->empty() ? "[]" : "]";
    } else if (const auto* members = value.as<JsonValue::Object>()) {
      const char* separator = "{";
      for (const JsonMember& member : *members) {
        out_ += separator + quoteJson(member.key) + ": ";
        if (!inlineUpTo(member.value, limit)) {
          return false;
        }
        separator = ", ";
      }
      out_ += members->empty() ? "{}" : "}";
    } else if (const auto* text = value.as<std::string>()) {
      out_ += quoteJson(*text);
    } else if (const auto* flag = value.as<bool>()) {
      out_ += *flag ? "true" : "false";
    } else if (const auto* integer = value.as<std::int64_t>()) {
      out_ += fmt::format("{}", *integer);
    } else if (const auto* natural = value.as<std::uint64_t>()) {
      out_ += fmt::format("{}", *natural);
    } else if (const auto* real = value.as<double>()) {
      out_ += shortestNumber(*real);
    } else {
      out_ += "null";
    }
    return out_.size() <= limit;
  }

  const JsonLayout& layout_;
};

}  // namespace

std::string quoteJson(std::string_view text) {
  return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string shortestNumber(double value) {
  VP_EXPECT(std::isfinite(value));
  if (value == 0.0) {
    return std::signbit(value) ? "-0.0" : "0";  // "-0" would be read as an integer, which has no sign of zero
  }
  std::array<char, 32> buffer{};
  const std::to_chars_result result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  VP_EXPECT(result.ec == std::errc());
  return {buffer.data(), result.ptr};
}

std::string writeJson(const JsonValue& value, const JsonLayout& layout) {
  Writer writer(layout);
  writer.write(value, 0, {});
  return writer.out_ + "\n";
}

}  // namespace vp::formats
