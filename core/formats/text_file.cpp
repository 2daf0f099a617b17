#include "core/formats/text_file.h"

#include "core/base/local_file.h"
#include "core/formats/inflate.h"

#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <system_error>

namespace vp::formats {
namespace {

namespace fs = std::filesystem;

Result<std::string> tooLarge(const std::string& path, std::size_t most) {
  return fail(Errc::BadFile, fmt::format("larger than {} MiB; this is no file that the program reads", most >> 20), path);
}

Result<std::string> readPlain(const std::string& path, std::size_t most) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes;
  std::array<char, 65536> block{};
  while (file) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    bytes.append(block.data(), static_cast<std::size_t>(file.gcount()));
    if (bytes.size() > most) {
      return tooLarge(path, most);
    }
  }
  if (!file.eof()) {
    return fail(Errc::BadFile, "cannot be read: " + std::generic_category().message(errno) + "; check its permissions", path);
  }
  return bytes;
}

Result<std::string> inflateGzip(const std::string& path, const std::string& packed, std::size_t most) {
  std::string text;
  switch (inflateBytes(packed, Packing::Gzip, most, text)) {
    case Inflation::Done:
      return text;
    case Inflation::TooLarge:
      return tooLarge(path, most);
    case Inflation::NoMemory:
      return fail(Errc::BadFile, "cannot be unpacked: out of memory", path);
    case Inflation::Damaged:
      break;
  }
  return fail(Errc::BadFile, "the gzip file is damaged or cut short; download it again", path);
}

}  // namespace

std::string fileName(const std::string& path) {
  return fs::path(path).filename().string();
}

Result<std::string> readFile(const std::string& path, std::size_t most) {
  if (const Result<void> local = checkLocalFile(path, most); !local) {
    return forward(local);
  }
  errno = 0;
  Result<std::string> bytes = readPlain(path, most);
  if (bytes && bytes->size() >= 2 && (*bytes)[0] == '\x1f' && (*bytes)[1] == '\x8b') {
    return inflateGzip(path, *bytes, most);
  }
  return bytes;
}

Result<std::string> readStart(const std::string& path, std::size_t bytes) {
  if (const Result<void> local = checkLocalFile(path, std::numeric_limits<std::uint64_t>::max()); !local) {
    return forward(local);
  }
  const std::unique_ptr<gzFile_s, int (*)(gzFile)> file(gzopen(path.c_str(), "rb"), gzclose);  // reads plain files as they are
  std::string start(bytes, '\0');
  const int got = file ? gzread(file.get(), start.data(), static_cast<unsigned>(bytes)) : -1;
  if (got < 0) {
    return fail(Errc::BadFile, "cannot be read; check that it exists and its permissions", path);
  }
  start.resize(static_cast<std::size_t>(got));
  return start;
}

Result<std::string> readText(const std::string& path, std::size_t most) {
  Result<std::string> bytes = readFile(path, most);
  if (!bytes) {
    return bytes;
  }
  std::string& text = *bytes;
  if (text.starts_with("\xEF\xBB\xBF")) {
    text.erase(0, 3);
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return fail(Errc::BadFormat, "the text is UTF-16; save it as UTF-8", path);
  }
  if (text.find('\0') != std::string::npos) {
    return fail(Errc::BadFormat, "this is not a text file; check that the right file was named", path);
  }
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    c = (byte < 0x20 && c != '\n' && c != '\r' && c != '\t') || byte == 0x7F ? ' ' : c;
  }
  return isUtf8(text) ? std::move(text) : fromWindows1252(text);
}

bool isUtf8(std::string_view bytes) {
  for (std::size_t i = 0; i < bytes.size();) {
    const auto lead = static_cast<unsigned char>(bytes[i]);
    const std::size_t length = lead < 0x80                   ? 1
                               : lead >= 0xC2 && lead < 0xE0 ? 2
                               : lead >= 0xE0 && lead < 0xF0 ? 3
                               : lead >= 0xF0 && lead < 0xF5 ? 4
                                                             : 0;
    if (length == 0 || i + length > bytes.size()) {
      return false;
    }
    std::uint32_t point = length == 1 ? lead : lead & (0x7Fu >> length);
    for (std::size_t k = 1; k < length; ++k) {
      const auto next = static_cast<unsigned char>(bytes[i + k]);
      if ((next & 0xC0) != 0x80) {
        return false;
      }
      point = (point << 6) | (next & 0x3Fu);
    }
    const bool overlong = (length == 3 && point < 0x800) || (length == 4 && point < 0x10000);
    if (overlong || point > 0x10FFFF || (point >= 0xD800 && point <= 0xDFFF)) {
      return false;
    }
    i += length;
  }
  return true;
}

std::string fromWindows1252(std::string_view bytes) {
  // Code points of 0x80..0x9F; 0 where Windows-1252 has none. Source: unicode.org CP1252.TXT.
  constexpr std::array<std::uint16_t, 32> kHigh{0x20AC, 0,      0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
                                                0x2039, 0x0152, 0,      0x017D, 0,      0,      0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
                                                0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0,      0x017E, 0x0178};
  std::string text;
  text.reserve(bytes.size() + bytes.size() / 16);
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    std::uint32_t point = byte;
    if (byte >= 0x80 && byte < 0xA0) {
      point = kHigh[byte - 0x80u] != 0 ? kHigh[byte - 0x80u] : 0xFFFDu;
    }
    if (point < 0x80) {
      text += c;
    } else if (point < 0x800) {
      text += static_cast<char>(0xC0u | (point >> 6));
      text += static_cast<char>(0x80u | (point & 0x3Fu));
    } else {
      text += static_cast<char>(0xE0u | (point >> 12));
      text += static_cast<char>(0x80u | ((point >> 6) & 0x3Fu));
      text += static_cast<char>(0x80u | (point & 0x3Fu));
    }
  }
  return text;
}

}  // namespace vp::formats
