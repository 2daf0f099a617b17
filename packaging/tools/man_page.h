#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace vp::packaging {

/** A manual page of section 1 as it is written: the roff source, in the macros of man(7). Text given to it is plain; what
 *  roff would take for its own (backslashes, hyphens of options, dots at the start of a line) is escaped here. */
class ManPage {
public:
  /** @param oneLine  what the program is, for the NAME section  @param date  YYYY-MM-DD  @param version  "Volplane 0.1.0" */
  ManPage(const std::string& program, const std::string& oneLine, const std::string& date, const std::string& version);

  void section(const std::string& title);
  void subsection(const std::string& title);
  void paragraph(std::string_view text);
  /** A paragraph under a term, the term in bold. */
  void item(std::string_view term, std::string_view text);
  /** An option: its names in bold, what follows them in italics; without names an argument. */
  void option(const std::vector<std::string>& names, std::string_view value, std::string_view text);
  /** Lines as they are, for commands to copy. */
  void example(const std::vector<std::string>& lines);

  [[nodiscard]] const std::string& roff() const { return roff_; }

private:
  void breakParagraph();

  std::string roff_;
};

/** Plain text as roff shows it. */
std::string escaped(std::string_view text);

}  // namespace vp::packaging
