#include "core/base/plain_text.h"

#include <cstdint>

namespace vp {
namespace {

/// Bytes of the character that begins here; 0 if none does. @source RFC 3629
std::size_t lengthOfCharacter(std::string_view text) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = at(0);
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xC2 && lead < 0xE0 ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || length > text.size()) {
    return 0;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if ((at(i) & 0xC0) != 0x80) {
      return 0;
    }
  }
  const bool isOverlong = (lead == 0xE0 && at(1) < 0xA0) || (lead == 0xF0 && at(1) < 0x90);
  const bool isNone = (lead == 0xED && at(1) >= 0xA0) || (lead == 0xF4 && at(1) >= 0x90);  // surrogates; beyond U+10FFFF
  return isOverlong || isNone ? 0 : length;
}

bool isControl(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  return lead < 0x20 || lead == 0x7F || (lead == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0);
}

}  // namespace

std::string plainText(std::string_view text, std::size_t most) {
  std::string plain;
  while (!text.empty()) {
    const std::size_t length = lengthOfCharacter(text);
    const std::string_view character = text.substr(0, length);
    const std::string_view taken = length == 0 ? "\xEF\xBF\xBD" : isControl(character) ? " " : character;
    if (plain.size() + taken.size() > most) {
      return plain + "...";
    }
    plain += taken;
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return plain;
}

}  // namespace vp
