#include "core/formats/surface.h"

#include <array>
#include <string>
#include <utility>

namespace vp::formats {
namespace {

using mission::Surface;
using Word = std::pair<std::string_view, Surface>;

/// Words that mean a surface only as a whole.
constexpr std::array<Word, 19> kWhole{{{"A", Surface::Hard},
                                       {"B", Surface::Hard},
                                       {"C", Surface::Hard},
                                       {"CON", Surface::Hard},
                                       {"COP", Surface::Hard},
                                       {"PAD", Surface::Unknown},
                                       {"PER", Surface::Hard},
                                       {"TAR", Surface::Hard},
                                       {"MAC", Surface::Hard},
                                       {"MAT", Surface::Hard},
                                       {"G", Surface::Grass},
                                       {"GR", Surface::Grass},
                                       {"GRA", Surface::Grass},
                                       {"GRE", Surface::Dirt},
                                       {"L", Surface::Dirt},
                                       {"N", Surface::Dirt},
                                       {"S", Surface::Dirt},
                                       {"TER", Surface::Dirt},
                                       {"PIC", Surface::Gravel}}};

/// Beginnings of words, of which the longest that fits counts. GRE is graded or rolled earth, LAT laterite, PEM part
/// concrete or bitumen, PSP pierced steel planking, picarra a lateritic gravel.
constexpr std::array<Word, 102> kBeginnings{{
    {"ASP", Surface::Hard},          {"ASH", Surface::Hard},          {"APSH", Surface::Hard},      {"ASF", Surface::Hard},
    {"ASB", Surface::Hard},          {"BIT", Surface::Hard},          {"BLACKTOP", Surface::Hard},  {"BRI", Surface::Hard},
    {"CCN", Surface::Hard},          {"CDNCRETE", Surface::Hard},     {"CEM", Surface::Hard},       {"CERAMIC", Surface::Hard},
    {"CHIPSEAL", Surface::Hard},     {"COCCRETE", Surface::Hard},     {"COCRETE", Surface::Hard},   {"COMPOSITE", Surface::Hard},
    {"CONC", Surface::Hard},         {"CRETE", Surface::Hard},        {"DECK", Surface::Hard},      {"FORMIG", Surface::Hard},
    {"HARD", Surface::Hard},         {"MACADAM", Surface::Hard},      {"MARSTON", Surface::Hard},   {"MATS", Surface::Hard},
    {"MET", Surface::Hard},          {"MTAL", Surface::Hard},         {"STEEL", Surface::Hard},     {"ALUM", Surface::Hard},
    {"AUMIN", Surface::Hard},        {"PAVE", Surface::Hard},         {"PAVING", Surface::Hard},    {"PEM", Surface::Hard},
    {"PFC", Surface::Hard},          {"PIERCED", Surface::Hard},      {"PSP", Surface::Hard},       {"ROOF", Surface::Hard},
    {"SEALED", Surface::Hard},       {"TARMAC", Surface::Hard},       {"TARRED", Surface::Hard},    {"WOOD", Surface::Hard},
    {"NEOPRENE", Surface::Hard},     {"CINDER", Surface::Gravel},     {"COR", Surface::Gravel},     {"CRUSHED", Surface::Gravel},
    {"GRAV", Surface::Gravel},       {"GRV", Surface::Gravel},        {"GVL", Surface::Gravel},     {"HARDCORE", Surface::Gravel},
    {"LIMESTONE", Surface::Gravel},  {"MAICILLO", Surface::Gravel},   {"MURRAM", Surface::Gravel},  {"OILGRAVEL", Surface::Gravel},
    {"OLIGRAVEL", Surface::Gravel},  {"ROCK", Surface::Gravel},       {"SAIBRO", Surface::Gravel},  {"SHALE", Surface::Gravel},
    {"SHALY", Surface::Gravel},      {"SHELL", Surface::Gravel},      {"SLAG", Surface::Gravel},    {"STONE", Surface::Gravel},
    {"PI\xC3\x87", Surface::Gravel}, {"PI\xC3\xA7", Surface::Gravel}, {"CALICHE", Surface::Gravel}, {"CALCRETE", Surface::Gravel},
    {"AGGREGATE", Surface::Gravel},  {"ERBA", Surface::Grass},        {"GRAAS", Surface::Grass},    {"GRAS", Surface::Grass},
    {"GRS", Surface::Grass},         {"HERB", Surface::Grass},        {"MOSS", Surface::Grass},     {"SOD", Surface::Grass},
    {"TORF", Surface::Grass},        {"TUEF", Surface::Grass},        {"TURF", Surface::Grass},     {"ARG", Surface::Dirt},
    {"CLA", Surface::Dirt},          {"DIRT", Surface::Dirt},         {"DRY", Surface::Dirt},       {"EART", Surface::Dirt},
    {"EERTH", Surface::Dirt},        {"GRADED", Surface::Dirt},       {"GROUND", Surface::Dirt},    {"LAKEBED", Surface::Dirt},
    {"LAT", Surface::Dirt},          {"LOAM", Surface::Dirt},         {"MUD", Surface::Dirt},       {"NATURAL", Surface::Dirt},
    {"SALT", Surface::Dirt},         {"SAN", Surface::Dirt},          {"SILT", Surface::Dirt},      {"SOIL", Surface::Dirt},
    {"UNPAVED", Surface::Dirt},      {"UNPEVED", Surface::Dirt},      {"UNSEALED", Surface::Dirt},  {"VOLCANIC", Surface::Dirt},
    {"ZAHORRA", Surface::Dirt},      {"ICE", Surface::Snow},          {"SNO", Surface::Snow},       {"WAT", Surface::Water},
    {"ROUGH", Surface::Dirt},        {"SOFT", Surface::Dirt},
}};

bool isLetter(char c) {
  return (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80 || (c >= '0' && c <= '9');
}

Surface surfaceOfWord(std::string_view word) {
  for (const Word& known : kWhole) {
    if (word == known.first) {
      return known.second;
    }
  }
  Surface found = Surface::Unknown;
  std::size_t longest = 0;
  for (const Word& known : kBeginnings) {
    if (known.first.size() > longest && word.starts_with(known.first)) {
      longest = known.first.size();
      found = known.second;
    }
  }
  return found;
}

}  // namespace

Surface surfaceFromText(std::string_view text) {
  std::string upper(text);
  for (char& c : upper) {
    c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  }
  Surface first = Surface::Unknown;
  bool isFirst = true;
  for (std::size_t at = 0; at < upper.size();) {
    if (!isLetter(upper[at])) {
      ++at;
      continue;
    }
    std::size_t end = at;
    while (end < upper.size() && isLetter(upper[end])) {
      ++end;
    }
    const std::string_view word = std::string_view(upper).substr(at, end - at);
    at = end;
    // A single letter after the first word grades the condition (ASPH-G is asphalt in good condition).
    const Surface surface = word.size() == 1 && !isFirst ? Surface::Unknown : surfaceOfWord(word);
    isFirst = false;
    if (surface == Surface::Water) {
      return Surface::Water;
    }
    if (first == Surface::Unknown) {
      first = surface;
    }
  }
  return first;
}

}  // namespace vp::formats
