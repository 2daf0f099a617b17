#include "core/formats/exports/xml_writer.h"

#include "core/base/expect.h"

namespace vp::formats {
namespace {

/// Length of the UTF-8 character that begins here and that XML allows; 0 if there is none.
std::size_t allowedLength(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) {
    return lead >= 0x20 || lead == '\t' || lead == '\n' || lead == '\r' ? 1 : 0;
  }
  const std::size_t length = lead >= 0xF0 && lead < 0xF5 ? 4 : lead >= 0xE0 && lead < 0xF0 ? 3 : lead >= 0xC2 && lead < 0xE0 ? 2 : 0;
  if (length == 0 || text.size() < length) {
    return 0;
  }
  unsigned value = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0u) != 0x80u) {
      return 0;
    }
    value = value << 6 | (next & 0x3Fu);
  }
  constexpr unsigned kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool isForbidden = value < kLeast[length] || (value >= 0xD800 && value < 0xE000) || value == 0xFFFE || value == 0xFFFF || value > 0x10FFFF;
  return isForbidden ? 0 : length;
}

}  // namespace

std::string escapedXml(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = allowedLength(text);
    switch (length == 1 ? text.front() : '\0') {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\n':
      case '\r':
      case '\t':
        result += ' ';
        break;
      default:
        result += length == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, length);
    }
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return result;
}

XmlWriter::XmlWriter(std::string lineEnd, std::size_t indent) : lineEnd_(std::move(lineEnd)), indent_(indent) {
  text_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>" + lineEnd_;
}

void XmlWriter::begin(const std::string& name, const Attributes& attributes) {
  text_.append(open_.size() * indent_, ' ');
  text_ += "<" + name;
  for (const auto& [key, value] : attributes) {
    text_ += " " + key + "=\"" + escapedXml(value) + "\"";
  }
}

void XmlWriter::open(const std::string& name, const Attributes& attributes) {
  begin(name, attributes);
  text_ += ">" + lineEnd_;
  open_.push_back(name);
}

void XmlWriter::close() {
  VP_EXPECT(!open_.empty());
  const std::string name = open_.back();
  open_.pop_back();
  text_.append(open_.size() * indent_, ' ');
  text_ += "</" + name + ">" + lineEnd_;
}

void XmlWriter::element(const std::string& name, std::string_view text, const Attributes& attributes) {
  begin(name, attributes);
  text_ += ">" + escapedXml(text) + "</" + name + ">" + lineEnd_;
}

void XmlWriter::empty(const std::string& name, const Attributes& attributes) {
  begin(name, attributes);
  text_ += "/>" + lineEnd_;
}

void XmlWriter::line(std::string_view text) {
  text_.append(open_.size() * indent_, ' ');
  text_ += text;
  text_ += lineEnd_;
}

std::string XmlWriter::finish() {
  while (!open_.empty()) {
    close();
  }
  return std::move(text_);
}

}  // namespace vp::formats
