#include "core/terrain/proj_files.h"

#include "core/base/local_file.h"

#include <cstdio>
#include <dlfcn.h>
#include <proj.h>

namespace vp::terrain::detail {
namespace {

std::FILE* fileOf(PROJ_FILE_HANDLE* handle) {
  return reinterpret_cast<std::FILE*>(handle);
}

/// PROJ's own way to files (src/filemanager.cpp there) but for what may be opened.
const PROJ_FILE_API kOrdinaryFiles{
    .version = 1,
    .open_cbk = [](PJ_CONTEXT* /*context*/, const char* name, PROJ_OPEN_ACCESS access, void* /*user*/) -> PROJ_FILE_HANDLE* {
      const bool isAllowed = access == PROJ_OPEN_ACCESS_READ_ONLY && kindOfFile(name) == FileKind::Ordinary;
      return isAllowed ? reinterpret_cast<PROJ_FILE_HANDLE*>(std::fopen(name, "rb")) : nullptr;
    },
    .read_cbk = [](PJ_CONTEXT* /*context*/, PROJ_FILE_HANDLE* file, void* bytes, std::size_t count,
                   void* /*user*/) { return std::fread(bytes, 1, count, fileOf(file)); },
    .write_cbk = [](PJ_CONTEXT* /*context*/, PROJ_FILE_HANDLE* /*file*/, const void* /*bytes*/, std::size_t /*count*/,
                    void* /*user*/) { return std::size_t{0}; },
    .seek_cbk = [](PJ_CONTEXT* /*context*/, PROJ_FILE_HANDLE* file, long long offset, int whence,
                   void* /*user*/) { return std::fseek(fileOf(file), static_cast<long>(offset), whence) == 0 ? 1 : 0; },
    .tell_cbk = [](PJ_CONTEXT* /*context*/, PROJ_FILE_HANDLE* file,
                   void* /*user*/) { return static_cast<unsigned long long>(std::ftell(fileOf(file))); },
    .close_cbk = [](PJ_CONTEXT* /*context*/, PROJ_FILE_HANDLE* file, void* /*user*/) { std::fclose(fileOf(file)); },
    .exists_cbk = [](PJ_CONTEXT* /*context*/, const char* name, void* /*user*/) { return kindOfFile(name) == FileKind::Missing ? 0 : 1; },
    .mkdir_cbk = [](PJ_CONTEXT* /*context*/, const char* /*name*/, void* /*user*/) { return 0; },
    .unlink_cbk = [](PJ_CONTEXT* /*context*/, const char* /*name*/, void* /*user*/) { return 0; },
    .rename_cbk = [](PJ_CONTEXT* /*context*/, const char* /*from*/, const char* /*to*/, void* /*user*/) { return 0; },
};

}  // namespace

bool isProjGuarded() {
  return dlsym(RTLD_DEFAULT, "proj_context_create") == reinterpret_cast<void*>(&proj_context_create);
}

}  // namespace vp::terrain::detail

/// In the place of PROJ's function of this name, which it calls.
extern "C" __attribute__((visibility("default"))) PJ_CONTEXT* proj_context_create() {
  using Create = PJ_CONTEXT* (*)();
  static const auto create = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "proj_context_create"));
  PJ_CONTEXT* context = create != nullptr ? create() : nullptr;
  if (context != nullptr) {
    proj_context_set_fileapi(context, &vp::terrain::detail::kOrdinaryFiles, nullptr);
  }
  return context;
}
