// The libFuzzer program: `fuzz_readers --reader=NAME` drives the reader of that name; `--readers` lists the names, `--longest=NAME` says how many
// bytes an input of that reader may have. One program for all, because linking each with all of core takes longer than compiling it.
#include "tests/fuzz/readers.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string_view>

namespace {

const vp::fuzz::Reader* chosen = nullptr;

}  // namespace

/// Called once by libFuzzer, which passes over arguments that begin with two dashes.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  constexpr std::string_view kOption = "--reader=";
  constexpr std::string_view kLongest = "--longest=";
  for (int i = 1; i < *count; ++i) {
    const std::string_view argument = (*arguments)[i];
    if (argument == "--readers") {
      for (const vp::fuzz::Reader& reader : vp::fuzz::readers()) {
        std::puts(reader.name);
      }
      std::exit(0);
    }
    if (argument.starts_with(kLongest)) {
      const vp::fuzz::Reader* asked = vp::fuzz::readerOf(argument.substr(kLongest.size()));
      std::printf("%zu\n", asked != nullptr ? asked->longest : 0);
      std::exit(asked != nullptr ? 0 : 2);
    }
    chosen = argument.starts_with(kOption) ? vp::fuzz::readerOf(argument.substr(kOption.size())) : chosen;
  }
  if (chosen == nullptr) {
    std::fputs("name a reader with --reader=NAME; --readers lists them\n", stderr);
    std::exit(2);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static vp::fuzz::InputFile file(*chosen);
  const vp::fuzz::Outcome outcome = file.read({reinterpret_cast<const char*>(data), size});
  if (!outcome.complaint.empty()) {
    std::fprintf(stderr, "complaint: %s\n", outcome.complaint.c_str());
    std::abort();
  }
  return 0;
}
