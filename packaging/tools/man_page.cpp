#include "packaging/tools/man_page.h"

#include <algorithm>
#include <cctype>

namespace vp::packaging {
namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += "\n.br\n";
    } else if (c == '\\') {
      result += "\\(rs";
    } else if (c == '-') {
      result += "\\-";
    } else if (c == '\'') {
      result += "\\(aq";
    } else if (c == '~') {
      result += "\\(ti";
    } else if (c == '^') {
      result += "\\(ha";
    } else if (c == '`') {
      result += "\\(ga";
    } else {
      result += c;
    }
  }
  return result.starts_with('.') ? "\\&" + result : result;
}

ManPage::ManPage(const std::string& program, const std::string& oneLine, const std::string& date, const std::string& version) {
  roff_ = ".\\\" Made by packaging/tools/make_man_pages from the command line of the program.\n.TH " + upper(escaped(program)) + " 1 \"" + date +
          "\" \"" + version + "\" \"User commands\"\n";
  section("Name");
  roff_ += escaped(program) + " \\- " + escaped(oneLine) + "\n";
}

void ManPage::section(const std::string& title) {
  roff_ += ".SH " + upper(escaped(title)) + "\n";
}

void ManPage::subsection(const std::string& title) {
  roff_ += ".SS \"" + escaped(title) + "\"\n";
}

void ManPage::breakParagraph() {
  const std::size_t lastLine = roff_.rfind('\n', roff_.size() - 2) + 1;
  if (roff_.compare(lastLine, 2, ".S") != 0) {  // a heading begins a paragraph itself
    roff_ += ".PP\n";
  }
}

void ManPage::paragraph(std::string_view text) {
  breakParagraph();
  roff_ += escaped(text) + "\n";
}

void ManPage::item(std::string_view term, std::string_view text) {
  roff_ += ".TP\n\\fB" + escaped(term) + "\\fR\n" + escaped(text) + "\n";
}

void ManPage::option(const std::vector<std::string>& names, std::string_view value, std::string_view text) {
  roff_ += ".TP\n";
  for (std::size_t i = 0; i < names.size(); ++i) {
    roff_ += (i == 0 ? "\\fB" : ", \\fB") + escaped(names[i]) + "\\fR";
  }
  if (!value.empty()) {
    roff_ += (names.empty() ? "\\fI" : " \\fI") + escaped(value) + "\\fR";
  }
  roff_ += "\n" + escaped(text) + "\n";
}

void ManPage::example(const std::vector<std::string>& lines) {
  breakParagraph();
  roff_ += ".nf\n.RS\n";
  for (const std::string& line : lines) {
    roff_ += escaped(line) + "\n";
  }
  roff_ += ".RE\n.fi\n";
}

}  // namespace vp::packaging
