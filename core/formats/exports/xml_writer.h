#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vp::formats {

/** Writes XML, an element per line, indented. Text is escaped; what XML 1.0 forbids (control characters, bytes that are no UTF-8)
 *  becomes U+FFFD; line breaks and tabs become spaces, so a line stays a line. @source W3C XML 1.0, section 2.2 */
class XmlWriter {
public:
  using Attributes = std::vector<std::pair<std::string, std::string>>;

  /** @param lineEnd  "\n" or "\r\n"   @param indent  spaces a level */
  explicit XmlWriter(std::string lineEnd = "\n", std::size_t indent = 2);

  void open(const std::string& name, const Attributes& attributes = {});
  void close();
  /** An element with text, or empty. */
  void element(const std::string& name, std::string_view text, const Attributes& attributes = {});
  void empty(const std::string& name, const Attributes& attributes = {});
  /** A line that is text already escaped. */
  void line(std::string_view text);

  /** Closes what is open. */
  std::string finish();

private:
  void begin(const std::string& name, const Attributes& attributes);

  std::string text_;
  std::string lineEnd_;
  std::size_t indent_;
  std::vector<std::string> open_;
};

/** Text as it stands in XML, quotes included. */
std::string escapedXml(std::string_view text);

}  // namespace vp::formats
