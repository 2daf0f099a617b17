#include "core/tour/lkh_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <system_error>
#include <utility>

namespace vp::tour {

std::string toTsplib(const NoonBean& atsp) {
  std::string text = fmt::format(
      "NAME : volplane\nTYPE : ATSP\nDIMENSION : {}\nEDGE_WEIGHT_TYPE : EXPLICIT\nEDGE_WEIGHT_FORMAT : FULL_MATRIX\nEDGE_WEIGHT_SECTION\n",
      atsp.nodes);
  const auto n = static_cast<std::size_t>(atsp.nodes);
  for (std::size_t i = 0; i < atsp.cost.size(); ++i) {
    fmt::format_to(std::back_inserter(text), "{}{}", atsp.cost[i], (i + 1) % n == 0 ? '\n' : ' ');
  }
  return text + "EOF\n";
}

std::string toTourFile(const std::vector<int>& tour) {
  std::string text = fmt::format("NAME : volplane\nTYPE : TOUR\nDIMENSION : {}\nTOUR_SECTION\n", tour.size());
  for (const int node : tour) {
    fmt::format_to(std::back_inserter(text), "{}\n", node + 1);
  }
  return text + "-1\nEOF\n";
}

Result<std::vector<int>> parseTourFile(std::string_view text, int nodes, const std::string& where) {
  constexpr std::string_view kSection = "TOUR_SECTION";
  const auto bad = [&](const std::string& why) {
    return fail(Errc::BadFile,
                fmt::format("the tour that the external solver wrote cannot be used: {}; check the program or use the built-in solver", why), where);
  };
  const std::size_t section = text.find(kSection);
  if (section == std::string_view::npos) {
    return bad("it has no TOUR_SECTION");
  }
  const char* at = text.data() + section + kSection.size();
  const char* const end = text.data() + text.size();
  std::vector<int> tour;
  std::vector<bool> seen(static_cast<std::size_t>(nodes), false);
  while (tour.size() < static_cast<std::size_t>(nodes)) {
    while (at < end && (*at == ' ' || *at == '\t' || *at == '\r' || *at == '\n')) {
      ++at;
    }
    int node = 0;
    const auto [next, ec] = std::from_chars(at, end, node);
    if (ec != std::errc() || node < 1 || node > nodes || seen[static_cast<std::size_t>(node - 1)]) {
      return bad(fmt::format("entry {} is not a new node from 1 to {}", tour.size() + 1, nodes));
    }
    seen[static_cast<std::size_t>(node - 1)] = true;
    tour.push_back(node - 1);
    at = next;
  }
  return tour;
}

Result<void> writeText(const std::filesystem::path& file, const std::string& text) {
  std::ofstream out(file, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) {
    return fail(Errc::OutputFailed, "the temporary file cannot be written; free some disk space", file.string());
  }
  return {};
}

Result<std::string> readText(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    return fail(Errc::BadFile, "the external solver ended without writing this tour; run it by hand to see why, or use the built-in solver",
                file.string());
  }
  return std::string(std::istreambuf_iterator<char>(in), {});
}

Result<TemporaryFolder> TemporaryFolder::make() {
  std::error_code ec;
  const std::filesystem::path base = std::filesystem::temp_directory_path(ec);
  std::string pattern = (base / "volplane-lkh-XXXXXX").string();
  if (ec || mkdtemp(pattern.data()) == nullptr) {
    return fail(Errc::OutputFailed, "no temporary folder can be made; check TMPDIR and the free disk space", base.string());
  }
  return TemporaryFolder(pattern);
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

TemporaryFolder::~TemporaryFolder() {
  if (!path_.empty()) {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
}

}  // namespace vp::tour
