// A libFuzzer target for the reader that the build names in VOLPLANE_READER.
#include "tests/fuzz/readers.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static vp::fuzz::InputFile file(*vp::fuzz::readerOf(VOLPLANE_READER));
  const vp::fuzz::Outcome outcome = file.read({reinterpret_cast<const char*>(data), size});
  if (!outcome.complaint.empty()) {
    std::fprintf(stderr, "complaint: %s\n", outcome.complaint.c_str());
    std::abort();
  }
  return 0;
}
