#include "core/formats/targets/xml_text.h"

#include "core/formats/csv.h"
#include "core/formats/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace vp::formats {

Result<XmlText> XmlText::parse(const std::string& path, std::string text) {
  if (text.size() > kMostXmlBytes) {
    return fail(Errc::BadFormat, fmt::format("the XML is larger than {} MiB; split it", kMostXmlBytes >> 20), path);
  }
  XmlText xml;
  xml.text_ = std::move(text);
  for (std::size_t at = xml.text_.find('\n'); at != std::string::npos; at = xml.text_.find('\n', at + 1)) {
    xml.lineEnds_.push_back(at);
  }
  xml.document_ = std::make_unique<pugi::xml_document>();
  const pugi::xml_parse_result read = xml.document_->load_buffer(xml.text_.data(), xml.text_.size());
  if (!read) {
    const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(read.offset, 0));
    const auto line = std::lower_bound(xml.lineEnds_.begin(), xml.lineEnds_.end(), offset) - xml.lineEnds_.begin() + 1;
    return fail(Errc::BadFormat, fmt::format("the XML cannot be read here ({}); the file is damaged or cut short", read.description()),
                fmt::format("{}, line {}", path, line));
  }
  if (!xml.root()) {
    return fail(Errc::BadFormat, "there is no XML element in this file", path);
  }
  return xml;
}

std::size_t XmlText::lineOf(pugi::xml_node node) const {
  const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0));
  return static_cast<std::size_t>(std::lower_bound(lineEnds_.begin(), lineEnds_.end(), offset) - lineEnds_.begin()) + 1;
}

std::string_view localName(pugi::xml_node node) {
  const std::string_view name = node.name();
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node childOf(pugi::xml_node node, std::string_view name) {
  for (const pugi::xml_node child : node.children()) {
    if (child.type() == pugi::node_element && localName(child) == name) {
      return child;
    }
  }
  return {};
}

std::string textOf(pugi::xml_node node, std::string_view child) {
  std::string text = childOf(node, child).text().get();
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return std::string(trimmed(text));
}

pugi::xml_node nextElement(pugi::xml_node node) {
  do {
    pugi::xml_node next = node.first_child();
    while (!next && node) {
      next = node.next_sibling();
      node = next ? node : node.parent();
    }
    node = next;
  } while (node && node.type() != pugi::node_element);
  return node;
}

}  // namespace vp::formats
