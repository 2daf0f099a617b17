#pragma once

#include "core/base/result.h"

#include <memory>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace vp::formats {

/** An XML text with the lines of its elements. Entities of a document type are never expanded (pugixml knows none but the five
 *  of XML and characters by number), so no text grows by reading it. */
class XmlText {
public:
  /** @errors BadFormat - not well-formed, with line; larger than kMostXmlBytes */
  static Result<XmlText> parse(const std::string& path, std::string text);

  [[nodiscard]] pugi::xml_node root() const { return document_->document_element(); }
  [[nodiscard]] std::size_t lineOf(pugi::xml_node node) const;

private:
  std::string text_;
  std::vector<std::size_t> lineEnds_;
  std::unique_ptr<pugi::xml_document> document_;
};

/** The name of an element without its prefix: "Track" of "gx:Track". */
std::string_view localName(pugi::xml_node node);

/** The first child element of this local name, whatever its prefix; an empty node if there is none. */
pugi::xml_node childOf(pugi::xml_node node, std::string_view name);

/** Text of a child with blanks around it dropped; "" if there is none. */
std::string textOf(pugi::xml_node node, std::string_view child);

/** The element after this one in document order, skipping what is not an element; empty at the end. */
pugi::xml_node nextElement(pugi::xml_node node);

}  // namespace vp::formats
