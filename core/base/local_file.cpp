#include "core/base/local_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace vp {
namespace {

namespace fs = std::filesystem;

/// An address has a scheme of letters before ":/"; of two slashes one may have been lost when a path was tidied.
bool isAddress(std::string_view path) {
  const std::size_t colon = path.find(":/");
  if (colon == std::string_view::npos) {
    return false;
  }
  const std::size_t slash = path.rfind('/', colon);
  const std::string_view scheme =
      path.substr(slash == std::string_view::npos ? 0 : slash + 1, colon - (slash == std::string_view::npos ? 0 : slash + 1));
  return scheme.size() > 1 && std::all_of(scheme.begin(), scheme.end(), [](unsigned char c) { return std::isalnum(c) != 0 || c == '+' || c == '-'; });
}

bool isOfKernel(const std::string& path) {
  std::error_code code;
  const std::string real = fs::canonical(path, code).string();
  return !code && (real.starts_with("/proc/") || real.starts_with("/sys/"));
}

std::string readableSize(std::uint64_t bytes) {
  return bytes >= (std::uint64_t{1} << 30) ? std::to_string(bytes >> 30) + " GiB" : std::to_string(bytes >> 20) + " MiB";
}

}  // namespace

FileKind kindOfFile(const std::string& path) {
  if (path.starts_with("/vsi")) {
    return FileKind::Remote;
  }
  std::error_code code;
  switch (fs::status(path, code).type()) {
    case fs::file_type::regular:
      return isOfKernel(path) ? FileKind::Special : FileKind::Ordinary;
    case fs::file_type::directory:
      return FileKind::Folder;
    case fs::file_type::block:
    case fs::file_type::character:
    case fs::file_type::fifo:
    case fs::file_type::socket:
      return FileKind::Special;
    default:
      return isAddress(path) ? FileKind::Remote : FileKind::Missing;
  }
}

Result<void> checkLocalFile(const std::string& path, std::uint64_t most) {
  switch (path.find('\0') == std::string::npos ? kindOfFile(path) : FileKind::Missing) {
    case FileKind::Missing:
      return fail(Errc::BadFile, "there is no such file; check the name and the folder it is relative to", path);
    case FileKind::Folder:
      return fail(Errc::BadFile, "this is a folder, not a file", path);
    case FileKind::Special:
      return fail(Errc::BadFile, "this is a device or pipe, not a file; copy what is to be read into a file", path);
    case FileKind::Remote:
      return fail(Errc::BadFile, "this is an address, and only files of this computer are read; download the file and name the copy", path);
    case FileKind::Ordinary:
      break;
  }
  std::error_code code;
  if (const std::uintmax_t size = fs::file_size(path, code); !code && size > most) {
    return fail(Errc::BadFile, "larger than " + readableSize(most) + "; this is no file that the program reads", path);
  }
  return {};
}

}  // namespace vp
