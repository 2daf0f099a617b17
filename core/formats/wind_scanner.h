#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace vp::formats {

/** A text read from its beginning by words and numbers, upper and lower case the same. */
class WindScanner {
public:
  explicit WindScanner(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

  [[nodiscard]] std::size_t at() const { return at_; }
  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] bool atEnd() const { return at_ >= text_.size(); }
  /** The next character in upper case, 0 at the end. */
  [[nodiscard]] char peek() const;
  void moveTo(std::size_t at) { at_ = at; }
  void skipSpaces();  ///< line ends are none
  /** Takes a text if it is next. @param word  in upper case */
  bool take(std::string_view word);
  /** Takes +-, +/- or the sign for it, and spaces around. */
  bool takePlusMinus();
  std::string_view takeDigits();
  std::string takeLetters();  ///< in upper case
  /** Takes digits, and a point and digits after it; nothing if no digit is next. */
  std::optional<double> takeNumber();

  /** What is wrong at a place: quotes the text, or its neighbourhood where it is long. @param expected  a clause */
  [[nodiscard]] tl::unexpected<Error> fault(Errc code, std::size_t at, const std::string& expected) const;
  [[nodiscard]] tl::unexpected<Error> fault(const std::string& expected) const { return fault(Errc::BadFormat, at_, expected); }

private:
  std::string_view text_;
  std::size_t at_;
};

}  // namespace vp::formats
