#include "core/formats/atomic_file.h"

#include "core/formats/temporary_file.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace vp::formats {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> refused(const std::string& path, const std::string& why) {
  return fail(Errc::OutputFailed, "cannot be written: " + why, path);
}

/// 0, or the error number.
int writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) {
        continue;
      }
      return errno;
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

Result<void> writeDirectly(const std::string& path, std::string_view bytes) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) {
    return refused(path, writeFailureReason(errno));
  }
  int code = writeAll(descriptor, bytes);
  if (::close(descriptor) != 0 && code == 0) {
    code = errno;
  }
  return code == 0 ? Result<void>() : refused(path, writeFailureReason(code));
}

/// Flushes the folder entry, so that the rename survives a power cut. Some file systems cannot; the data is safe by then.
void flushFolder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);
    ::close(descriptor);
  }
}

std::string folderOf(const std::string& path) {
  const fs::path whole(path);
  return whole.has_parent_path() ? whole.parent_path().string() : ".";
}

/// Where a file goes, and whose permissions it takes over.
struct Place {
  std::string path;    ///< as it was named
  std::string target;  ///< behind symbolic links
  std::optional<mode_t> mode;
  bool isDevice = false;
};

/// A file that is whole and on the disk, but not in its place yet.
struct Staged {
  Place place;
  TemporaryFile file;
};

Result<Place> placeOf(const std::string& path) {
  if (path.empty()) {
    return fail(Errc::OutputFailed, "no file name was given for the output");
  }
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT) {
      return refused(path, writeFailureReason(errno));
    }
    return path.back() == '/' ? Result<Place>(refused(path, "this names a folder; add a file name")) : Place{path, path, std::nullopt, false};
  }
  if (S_ISDIR(status.st_mode)) {
    return refused(path, "a folder has this name; choose another file name");
  }
  if (!S_ISREG(status.st_mode)) {
    return Place{path, path, std::nullopt, true};
  }
  if (::access(path.c_str(), W_OK) != 0) {
    return refused(path, errno == EROFS ? writeFailureReason(errno) : "the file is write-protected; remove the protection or choose another name");
  }
  std::error_code code;
  const fs::path target = fs::canonical(path, code);
  return Place{path, code ? path : target.string(), status.st_mode & 07777, false};
}

Result<Staged> stage(Place place, std::string_view bytes) {
  int code = 0;
  std::optional<TemporaryFile> file = TemporaryFile::create(folderOf(place.target), "tmp", code);
  if (!file) {
    return refused(place.path, writeFailureReason(code));
  }
  code = writeAll(file->descriptor(), bytes);
  if (code == 0 && ((place.mode && ::fchmod(file->descriptor(), *place.mode) != 0) || ::fsync(file->descriptor()) != 0)) {
    code = errno;
  }
  if (code != 0) {
    return refused(place.path, writeFailureReason(code));
  }
  return Staged{std::move(place), std::move(*file)};
}

Result<void> putInPlace(Staged& staged) {
  if (const int code = staged.file.moveTo(staged.place.target); code != 0) {
    return refused(staged.place.path, writeFailureReason(code));
  }
  flushFolder(folderOf(staged.place.target));
  return {};
}

}  // namespace

std::string writeFailureReason(int code) {
  switch (code) {
    case EACCES:
    case EPERM:
      return "there is no permission to write there; choose another folder or change its permissions";
    case EROFS:
      return "the file system is read-only; choose another folder";
    case ENOSPC:
    case EDQUOT:
      return "the disk is full; free some space or choose another folder";
    case EFBIG:
      return "the file would be larger than the system allows";
    case ENOENT:
    case ENOTDIR:
      return "there is no such folder; create it first";
    case ENAMETOOLONG:
      return "the file name is too long; choose a shorter one";
    default:
      return std::generic_category().message(code) + "; choose another place";
  }
}

Result<void> writeFileAtomically(const std::string& path, std::string_view bytes) {
  return writeFilesAtomically({{path, bytes}});
}

Result<void> writeFilesAtomically(const std::vector<FileToWrite>& files) {
  std::vector<Staged> staged;
  for (const FileToWrite& file : files) {
    Result<Place> place = placeOf(file.path);
    if (!place) {
      return forward(place);
    }
    if (place->isDevice) {
      if (Result<void> done = writeDirectly(file.path, file.bytes); !done) {
        return done;
      }
      continue;
    }
    Result<Staged> one = stage(std::move(*place), file.bytes);
    if (!one) {
      return forward(one);
    }
    staged.push_back(std::move(*one));
  }
  for (Staged& one : staged) {
    if (Result<void> done = putInPlace(one); !done) {
      return done;
    }
  }
  return {};
}

}  // namespace vp::formats
