#include "core/tour/gtsp_lib.h"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

namespace vp::tour {

namespace {

constexpr int kMaxNodes = 20000;  // a full matrix of doubles of this size takes 3.2 GB

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isBlank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && isBlank(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

struct Coordinates {
  double x = 0.0;
  double y = 0.0;
};

/** TSPLIB's degrees.minutes to radians, with its own value of pi. */
double geoRadians(double value) {
  constexpr double kTsplibPi = 3.141592;
  const double degrees = std::trunc(value);
  return kTsplibPi * (degrees + 5.0 * (value - degrees) / 3.0) / 180.0;
}

double geoDistance(const Coordinates& a, const Coordinates& b) {
  constexpr double kTsplibEarthRadius_km = 6378.388;
  const double q1 = std::cos(geoRadians(a.y) - geoRadians(b.y));
  const double q2 = std::cos(geoRadians(a.x) - geoRadians(b.x));
  const double q3 = std::cos(geoRadians(a.x) + geoRadians(b.x));
  const double cosine = std::clamp(0.5 * ((1.0 + q1) * q2 - (1.0 - q1) * q3), -1.0, 1.0);
  return std::trunc(kTsplibEarthRadius_km * std::acos(cosine) + 1.0);
}

double attDistance(double dx, double dy) {
  const double exact = std::sqrt((dx * dx + dy * dy) / 10.0);
  const double rounded = std::floor(exact + 0.5);
  return rounded < exact ? rounded + 1.0 : rounded;
}

using Distance = double (*)(const Coordinates&, const Coordinates&);

Distance distanceOf(std::string_view weightType) {
  if (weightType == "EUC_2D") {
    return [](const Coordinates& a, const Coordinates& b) { return std::floor(std::hypot(a.x - b.x, a.y - b.y) + 0.5); };
  }
  if (weightType == "CEIL_2D") {
    return [](const Coordinates& a, const Coordinates& b) { return std::ceil(std::hypot(a.x - b.x, a.y - b.y)); };
  }
  if (weightType == "MAN_2D") {
    return [](const Coordinates& a, const Coordinates& b) { return std::floor(std::abs(a.x - b.x) + std::abs(a.y - b.y) + 0.5); };
  }
  if (weightType == "MAX_2D") {
    return [](const Coordinates& a, const Coordinates& b) {
      return std::max(std::floor(std::abs(a.x - b.x) + 0.5), std::floor(std::abs(a.y - b.y) + 0.5));
    };
  }
  if (weightType == "GEO") {
    return geoDistance;
  }
  if (weightType == "ATT") {
    return [](const Coordinates& a, const Coordinates& b) { return attDistance(a.x - b.x, a.y - b.y); };
  }
  return nullptr;
}

/** Which entries of the matrix a format lists, row by row; [from, to) of row i. */
struct Shape {
  bool mirrored = true;  ///< the other triangle is the same
  int (*from)(int row, int n) = nullptr;
  int (*to)(int row, int n) = nullptr;
};

std::optional<Shape> shapeOf(std::string_view format) {
  const auto zero = [](int, int) { return 0; };
  const auto same = [](int row, int) { return row; };
  const auto next = [](int row, int) { return row + 1; };
  const auto all = [](int, int n) { return n; };
  if (format == "FULL_MATRIX") {
    return Shape{false, zero, all};
  }
  // A column format of one triangle lists the entries of the other triangle row by row.
  if (format == "UPPER_ROW" || format == "LOWER_COL") {
    return Shape{true, next, all};
  }
  if (format == "LOWER_ROW" || format == "UPPER_COL") {
    return Shape{true, zero, same};
  }
  if (format == "UPPER_DIAG_ROW" || format == "LOWER_DIAG_COL") {
    return Shape{true, same, all};
  }
  if (format == "LOWER_DIAG_ROW" || format == "UPPER_DIAG_COL") {
    return Shape{true, zero, next};
  }
  return std::nullopt;
}

class Parser {
public:
  Parser(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  Result<GtspInstance> run() {
    Result<void> done = readLines();
    if (done) {
      done = checkComplete();
    }
    if (!done) {
      return forward(done);
    }
    return std::move(instance_);
  }

private:
  [[nodiscard]] tl::unexpected<Error> bad(std::string what, Errc code = Errc::BadFormat) const {
    return fail(code, std::move(what), fmt::format("{}, line {}", where_, lineOfToken()));
  }
  [[nodiscard]] std::ptrdiff_t lineOfToken() const {
    return 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(token_), '\n');
  }

  Result<void> readLines() {
    while (at_ < text_.size()) {
      const std::string_view line = trimmed(nextLine());
      if (line.empty()) {
        continue;
      }
      const std::size_t end = std::min(line.find_first_of(": \t"), line.size());
      const std::string_view key = line.substr(0, end);
      std::string_view value = trimmed(line.substr(end));
      if (!value.empty() && value.front() == ':') {
        value = trimmed(value.substr(1));
      }
      if (key == "EOF") {
        return {};
      }
      if (Result<void> done = take(key, value); !done) {
        return done;
      }
    }
    return {};
  }

  Result<void> take(std::string_view key, std::string_view value) {
    const std::string_view word = value.substr(0, std::min(value.find_first_of(" \t"), value.size()));
    if (key == "NAME") {
      instance_.name = std::string(value);
    } else if (key == "TYPE") {
      if (word != "GTSP" && word != "AGTSP") {
        return bad(fmt::format("the problem type is {}, but only GTSP and AGTSP are read; give a generalized problem", word), Errc::Unsupported);
      }
    } else if (key == "DIMENSION") {
      return takeCount(word, "DIMENSION", nodes_);
    } else if (key == "GTSP_SETS") {
      return takeCount(word, "GTSP_SETS", sets_);
    } else if (key == "EDGE_WEIGHT_TYPE") {
      weightType_ = std::string(word);
    } else if (key == "EDGE_WEIGHT_FORMAT") {
      weightFormat_ = std::string(word);
    } else if (key == "EDGE_WEIGHT_SECTION") {
      return readWeights();
    } else if (key == "NODE_COORD_SECTION") {
      return readCoordinates();
    } else if (key == "GTSP_SET_SECTION") {
      return readSets();
    } else if (key == "DISPLAY_DATA_SECTION") {
      return skipRows();
    } else if (key != "COMMENT" && key != "NODE_COORD_TYPE" && key != "DISPLAY_DATA_TYPE") {
      return bad(fmt::format("\"{}\" is not a GTSPLIB keyword that is known here; correct or remove the line", key.substr(0, 40)));
    }
    return {};
  }

  Result<void> takeCount(std::string_view word, std::string_view key, int& count) {
    const auto [end, ec] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (ec != std::errc() || end != word.data() + word.size() || count < 1 || count > kMaxNodes) {
      return bad(fmt::format("{} is \"{}\"; give a whole number from 1 to {}", key, word.substr(0, 20), kMaxNodes));
    }
    return {};
  }

  Result<void> needNodes(std::string_view section) {
    if (nodes_ == 0) {
      return bad(fmt::format("{} comes before DIMENSION; put the line \"DIMENSION : <number of nodes>\" above it", section));
    }
    return {};
  }

  Result<void> readWeights() {
    if (Result<void> ready = needNodes("EDGE_WEIGHT_SECTION"); !ready) {
      return ready;
    }
    const std::optional<Shape> shape = shapeOf(weightFormat_);
    if (!shape) {
      return bad(fmt::format("EDGE_WEIGHT_FORMAT is \"{}\"; use FULL_MATRIX or a triangular format such as UPPER_ROW", weightFormat_),
                 Errc::Unsupported);
    }
    startMatrix();
    for (int row = 0; row < nodes_; ++row) {
      for (int col = shape->from(row, nodes_); col < shape->to(row, nodes_); ++col) {
        double weight = 0.0;
        if (!nextNumber(weight)) {
          return bad(
              fmt::format("the weights end or are not a number at row {}, column {} of {}; complete EDGE_WEIGHT_SECTION", row + 1, col + 1, nodes_));
        }
        if (weight < 0.0) {
          return bad(fmt::format("the weight at row {}, column {} is negative; costs must be zero or more", row + 1, col + 1));
        }
        entry(row, col) = weight;
        if (shape->mirrored) {
          entry(col, row) = weight;
        }
      }
    }
    haveCosts_ = true;
    return {};
  }

  Result<void> readCoordinates() {
    if (Result<void> ready = needNodes("NODE_COORD_SECTION"); !ready) {
      return ready;
    }
    std::vector<std::optional<Coordinates>> points(static_cast<std::size_t>(nodes_));
    for (int row = 0; row < nodes_; ++row) {
      int id = 0;
      Coordinates point;
      if (!nextInteger(id) || !nextNumber(point.x) || !nextNumber(point.y)) {
        return bad(fmt::format("coordinate row {} of {} is not \"node x y\"; complete NODE_COORD_SECTION", row + 1, nodes_));
      }
      if (id < 1 || id > nodes_ || points[static_cast<std::size_t>(id - 1)]) {
        return bad(fmt::format("node {} is listed twice or is not from 1 to {}; number the nodes 1 to {}", id, nodes_, nodes_));
      }
      points[static_cast<std::size_t>(id - 1)] = point;
    }
    const Distance distance = distanceOf(weightType_);
    if (distance == nullptr) {
      return weightType_ == "EXPLICIT"
                 ? Result<void>{}
                 : bad(fmt::format("EDGE_WEIGHT_TYPE \"{}\" is not read; use EXPLICIT or EUC_2D", weightType_), Errc::Unsupported);
    }
    startMatrix();
    for (int i = 0; i < nodes_; ++i) {
      for (int j = 0; j < nodes_; ++j) {
        entry(i, j) = i == j ? 0.0 : distance(*points[static_cast<std::size_t>(i)], *points[static_cast<std::size_t>(j)]);
      }
    }
    haveCosts_ = true;
    return {};
  }

  Result<void> readSets() {
    if (nodes_ == 0 || sets_ == 0) {
      return bad("GTSP_SET_SECTION comes before DIMENSION or GTSP_SETS; put both lines above it");
    }
    std::vector<std::vector<int>> sets(static_cast<std::size_t>(sets_));
    std::vector<bool> used(static_cast<std::size_t>(nodes_), false);
    for (int row = 0; row < sets_; ++row) {
      int id = 0;
      if (!nextInteger(id) || id < 1 || id > sets_ || !sets[static_cast<std::size_t>(id - 1)].empty()) {
        return bad(fmt::format("set row {} does not start with a new set number from 1 to {}; correct GTSP_SET_SECTION", row + 1, sets_));
      }
      std::vector<int>& members = sets[static_cast<std::size_t>(id - 1)];
      while (true) {
        int node = 0;
        if (!nextInteger(node)) {
          return bad(fmt::format("set {} ends without -1; end every set with -1", id));
        }
        if (node == -1) {
          break;
        }
        if (node < 1 || node > nodes_ || used[static_cast<std::size_t>(node - 1)]) {
          return bad(fmt::format("node {} of set {} is in another set too or is not from 1 to {}; name every node in one set", node, id, nodes_));
        }
        used[static_cast<std::size_t>(node - 1)] = true;
        members.push_back(node - 1);
      }
      if (members.empty()) {
        return bad(fmt::format("set {} has no nodes; give it one or lower GTSP_SETS", id));
      }
    }
    if (const auto lost = std::find(used.begin(), used.end(), false); lost != used.end()) {
      return bad(fmt::format("node {} is in no set; name every node in one set", lost - used.begin() + 1));
    }
    instance_.problem.sets = std::move(sets);
    return {};
  }

  /** Passes over rows of numbers that say nothing about costs. */
  Result<void> skipRows() {
    while (at_ < text_.size()) {
      const std::size_t start = at_;
      const std::string_view row = trimmed(nextLine());
      if (!row.empty() && ((row.front() >= 'A' && row.front() <= 'Z') || (row.front() >= 'a' && row.front() <= 'z'))) {
        at_ = start;
        break;
      }
    }
    return {};
  }

  Result<void> checkComplete() {
    if (!haveCosts_) {
      return fail(Errc::BadFormat, "the file has no costs; add EDGE_WEIGHT_SECTION, or NODE_COORD_SECTION with EDGE_WEIGHT_TYPE above it", where_);
    }
    if (instance_.problem.sets.empty()) {
      return fail(Errc::BadFormat, "the file has no sets; add GTSP_SET_SECTION", where_);
    }
    instance_.problem.nodes = nodes_;
    return {};
  }

  void startMatrix() { instance_.problem.cost.assign(static_cast<std::size_t>(nodes_) * static_cast<std::size_t>(nodes_), 0.0); }
  double& entry(int row, int col) {
    return instance_.problem.cost[static_cast<std::size_t>(row) * static_cast<std::size_t>(nodes_) + static_cast<std::size_t>(col)];
  }

  std::string_view nextLine() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    token_ = at_;
    at_ = std::min(end + 1, text_.size());
    return line;
  }

  void skipBlanks() {
    while (at_ < text_.size() && isBlank(text_[at_])) {
      ++at_;
    }
    token_ = at_;
  }

  bool nextNumber(double& value) {
    skipBlanks();
    const char* begin = text_.data() + at_;
    if (at_ < text_.size() && *begin == '+') {
      ++begin;
    }
    const auto [end, ec] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (ec != std::errc() || !std::isfinite(value)) {
      return false;
    }
    at_ = static_cast<std::size_t>(end - text_.data());
    return true;
  }

  bool nextInteger(int& value) {
    double number = 0.0;
    if (!nextNumber(number) || number != std::floor(number) || std::abs(number) > 1e9) {
      return false;
    }
    value = static_cast<int>(number);
    return true;
  }

  std::string_view text_;
  const std::string& where_;
  std::size_t at_ = 0;
  std::size_t token_ = 0;  ///< where the line or number being read starts
  int nodes_ = 0;
  int sets_ = 0;
  bool haveCosts_ = false;
  std::string weightType_ = "EXPLICIT";
  std::string weightFormat_ = "FULL_MATRIX";
  GtspInstance instance_;
};

}  // namespace

Result<GtspInstance> parseGtspLib(std::string_view text, const std::string& where) {
  return Parser(text, where).run();
}

Result<GtspInstance> loadGtspLib(const std::filesystem::path& file) {
  // gzopen reads plain files too.
  gzFile in = gzopen(file.c_str(), "rb");
  if (in == nullptr) {
    return fail(Errc::BadFile, "the file cannot be opened; check the name and the permission to read it", file.string());
  }
  std::string text;
  std::array<char, 1 << 16> buffer{};
  int got = 0;
  while ((got = gzread(in, buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) {
    text.append(buffer.data(), static_cast<std::size_t>(got));
  }
  const bool damaged = gzclose(in) != Z_OK || got < 0;
  if (damaged) {
    return fail(Errc::BadFile, "the file cannot be read to its end; it is damaged or not a file: copy it again", file.string());
  }
  return parseGtspLib(text, file.string());
}

}  // namespace vp::tour
