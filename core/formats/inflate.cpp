#include "core/formats/inflate.h"

#include <zlib.h>

#include <array>
#include <memory>

namespace vp::formats {

Inflation inflateBytes(std::string_view packed, Packing packing, std::size_t most, std::string& text) {
  constexpr int kWindow = 15;  // bits; plus 16 asks for a gzip header, the negative for none
  z_stream stream{};
  if (inflateInit2(&stream, packing == Packing::Gzip ? kWindow + 16 : -kWindow) != Z_OK) {
    return Inflation::NoMemory;
  }
  const std::unique_ptr<z_stream, int (*)(z_stream*)> guard(&stream, inflateEnd);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));  // NOLINT(cppcoreguidelines-pro-type-const-cast): zlib reads only
  stream.avail_in = static_cast<uInt>(packed.size());
  std::array<char, 65536> block{};
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(block.data());
    stream.avail_out = static_cast<uInt>(block.size());
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(block.data(), block.size() - stream.avail_out);
    if (text.size() > most) {
      return Inflation::TooLarge;
    }
    if (packing == Packing::Gzip && state == Z_STREAM_END && stream.avail_in > 0) {
      state = inflateReset(&stream);  // several members one after the other are one file
    }
  }
  return state == Z_STREAM_END ? Inflation::Done : Inflation::Damaged;
}

}  // namespace vp::formats
