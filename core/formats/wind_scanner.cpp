#include "core/formats/wind_scanner.h"

#include "core/base/plain_text.h"
#include "core/formats/json_value.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace vp::formats {
namespace {

constexpr std::size_t kLongestQuote = 60;

char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

bool isLetter(char c) {
  return c >= 'A' && c <= 'Z';
}

}  // namespace

char WindScanner::peek() const {
  return atEnd() ? '\0' : upper(text_[at_]);
}

void WindScanner::skipSpaces() {
  while (!atEnd() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r')) {
    ++at_;
  }
}

bool WindScanner::take(std::string_view word) {
  const std::string_view next = text_.substr(std::min(at_, text_.size()), word.size());
  const bool isNext = next.size() == word.size() && std::equal(next.begin(), next.end(), word.begin(), [](char a, char b) { return upper(a) == b; });
  at_ += isNext ? word.size() : 0;
  return isNext;
}

bool WindScanner::takePlusMinus() {
  const std::size_t before = at_;
  skipSpaces();
  if (take("\xC2\xB1") || take("+-") || take("+/-")) {
    skipSpaces();
    return true;
  }
  at_ = before;
  return false;
}

std::string_view WindScanner::takeDigits() {
  const std::size_t start = std::min(at_, text_.size());
  while (!atEnd() && isDigit(text_[at_])) {
    ++at_;
  }
  return text_.substr(start, at_ - start);
}

std::string WindScanner::takeLetters() {
  std::string word;
  while (isLetter(peek())) {
    word += peek();
    ++at_;
  }
  return word;
}

std::optional<double> WindScanner::takeNumber() {
  const std::size_t start = at_;
  if (takeDigits().empty()) {
    return std::nullopt;
  }
  if (peek() == '.' && at_ + 1 < text_.size() && isDigit(text_[at_ + 1])) {
    ++at_;
    takeDigits();
  }
  double value = 0.0;
  const auto [end, code] = std::from_chars(text_.data() + start, text_.data() + at_, value);
  return code == std::errc() ? std::optional(value) : std::nullopt;  // so many digits that no double holds them
}

tl::unexpected<Error> WindScanner::fault(Errc code, std::size_t at, const std::string& expected) const {
  std::string quote(text_);
  if (quote.size() > kLongestQuote) {
    const std::size_t start = at > kLongestQuote / 2 ? at - kLongestQuote / 2 : 0;
    quote = (start > 0 ? "..." : "") + quote.substr(start, kLongestQuote) + (start + kLongestQuote < quote.size() ? "..." : "");
  }
  return fail(code, fmt::format("wind {} at character {}: {}", quoteJson(plainText(quote)), at + 1, expected));
}

}  // namespace vp::formats
