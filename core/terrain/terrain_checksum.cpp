#include "core/base/expect.h"
#include "core/base/local_file.h"
#include "core/terrain/terrain_reader.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>

namespace vp::terrain {

Result<std::string> sha256OfFile(const std::string& path, const Job& job) {
  const FileKind kind = kindOfFile(path);
  if (kind == FileKind::Missing) {
    return fail(Errc::BadFile, "there is no such file; correct the path", path);
  }
  if (kind != FileKind::Ordinary) {
    return fail(Errc::BadFile, "this is not a file; name the file itself", path);
  }
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    return fail(Errc::BadFile, "the file cannot be opened; check that it may be read", path);
  }
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> digest(EVP_MD_CTX_new(), &EVP_MD_CTX_free);
  VP_EXPECT(digest != nullptr && EVP_DigestInit_ex(digest.get(), EVP_sha256(), nullptr) == 1);
  std::vector<char> chunk(1 << 16);
  while (in) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "reading the terrain was stopped");
    }
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    VP_EXPECT(EVP_DigestUpdate(digest.get(), chunk.data(), static_cast<std::size_t>(in.gcount())) == 1);
  }
  if (!in.eof()) {
    return fail(Errc::BadFile, "the file cannot be read to its end; check the disk and copy it again", path);
  }
  std::array<unsigned char, EVP_MAX_MD_SIZE> hash{};
  unsigned length = 0;
  VP_EXPECT(EVP_DigestFinal_ex(digest.get(), hash.data(), &length) == 1);
  std::string hex;
  for (unsigned i = 0; i < length; ++i) {
    hex += fmt::format("{:02x}", hash[i]);
  }
  return hex;
}

}  // namespace vp::terrain
