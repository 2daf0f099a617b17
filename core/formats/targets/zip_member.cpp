#include "core/formats/targets/zip_member.h"

#include "core/formats/inflate.h"
#include "core/formats/limits.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace vp::formats {
namespace {

constexpr std::size_t kMostBytes = kMostXmlBytes;
static_assert(kMostBytes == std::size_t{64} << 20, "the sentences below say so");
constexpr std::size_t kEndSize = 22;    // end of central directory
constexpr std::size_t kEntrySize = 46;  // entry of the central directory
constexpr std::size_t kLocalSize = 30;  // header before a member
constexpr std::size_t kMostComment = 65535;
constexpr std::uint32_t kDeflated = 8;  // method; 0 is stored

std::uint32_t number(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint32_t value = 0;
  for (std::size_t i = size; i-- > 0;) {
    value = (value << 8) | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

bool endsWith(std::string_view name, std::string_view ending) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; };
  return name.size() >= ending.size() && std::equal(name.end() - static_cast<std::ptrdiff_t>(ending.size()), name.end(), ending.begin(), same);
}

struct Entry {
  std::uint32_t flags, method, packed, local;
};

/// Looks through the central directory; nothing if there is no such member or the directory is damaged.
std::optional<Entry> findEntry(std::string_view zip, std::string_view ending) {
  const std::size_t last = zip.size() < kEndSize ? 0 : zip.size() - kEndSize;
  const std::size_t first = last > kMostComment ? last - kMostComment : 0;
  const std::size_t end = zip.rfind("PK\x05\x06", last);
  if (zip.size() < kEndSize || end == std::string_view::npos || end < first) {
    return std::nullopt;
  }
  std::size_t at = number(zip, end + 16, 4);
  const std::uint32_t count = number(zip, end + 10, 2);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (at > zip.size() || zip.size() - at < kEntrySize || zip.substr(at, 4) != "PK\x01\x02") {
      return std::nullopt;
    }
    const std::size_t nameSize = number(zip, at + 28, 2);
    const std::size_t rest = static_cast<std::size_t>(number(zip, at + 30, 2)) + number(zip, at + 32, 2);
    if (zip.size() - at - kEntrySize < nameSize) {
      return std::nullopt;
    }
    if (endsWith(zip.substr(at + kEntrySize, nameSize), ending)) {
      return Entry{number(zip, at + 8, 2), number(zip, at + 10, 2), number(zip, at + 20, 4), number(zip, at + 42, 4)};
    }
    at += kEntrySize + nameSize + rest;
  }
  return std::nullopt;
}

tl::unexpected<Error> damaged(const std::string& path) {
  return fail(Errc::BadFile, "the zip archive is damaged or cut short; save it again", path);
}

Result<std::string> inflated(const std::string& path, std::string_view packed) {
  std::string text;
  switch (inflateBytes(packed, Packing::Raw, kMostBytes, text)) {
    case Inflation::Done:
      return text;
    case Inflation::TooLarge:
      return fail(Errc::BadFile, "unpacks to more than 64 MiB; this is no file that the program reads", path);
    case Inflation::NoMemory:
      return fail(Errc::BadFile, "cannot be unpacked: out of memory", path);
    case Inflation::Damaged:
      break;
  }
  return damaged(path);
}

}  // namespace

Result<std::string> zipMember(const std::string& path, std::string_view archive, std::string_view ending) {
  const std::optional<Entry> entry = findEntry(archive, ending);
  if (!entry) {
    return fail(Errc::BadFile, "the zip archive is damaged or cut short, or has no " + std::string(ending) + " in it", path);
  }
  if ((entry->flags & 1u) != 0 || (entry->method != 0 && entry->method != kDeflated)) {
    return fail(Errc::BadFile, "the archive is encrypted or packed in a way that is not read; save it again", path);
  }
  const std::size_t at = entry->local;
  if (at > archive.size() || archive.size() - at < kLocalSize || archive.substr(at, 4) != "PK\x03\x04") {
    return damaged(path);
  }
  const std::size_t begin = at + kLocalSize + number(archive, at + 26, 2) + number(archive, at + 28, 2);
  if (begin > archive.size() || archive.size() - begin < entry->packed) {
    return damaged(path);
  }
  const std::string_view packed = archive.substr(begin, entry->packed);
  if (entry->method != 0) {
    return inflated(path, packed);
  }
  return packed.size() > kMostBytes ? Result<std::string>(fail(Errc::BadFile, "holds more than 64 MiB; this is no file that the program reads", path))
                                    : std::string(packed);
}

}  // namespace vp::formats
