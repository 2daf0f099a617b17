// Placemarks of KML: points and the corners of lines become places, polygons areas.
#include "core/formats/csv.h"
#include "core/formats/targets/found_targets.h"
#include "core/formats/targets/xml_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace vp::formats {
namespace {

/// Places of a "lon,lat,alt lon,lat,alt" text; a tuple that is none counts as a fault.
std::vector<FoundTargets::Place> placesOf(std::string_view text, std::size_t& faults) {
  constexpr std::string_view kBlanks = " \t\r\n";
  std::vector<FoundTargets::Place> places;
  while (true) {
    const std::size_t begin = text.find_first_not_of(kBlanks);
    if (begin == std::string_view::npos) {
      return places;
    }
    text.remove_prefix(begin);
    const std::string_view tuple = text.substr(0, text.find_first_of(kBlanks));
    text.remove_prefix(tuple.size());
    const std::size_t first = tuple.find(',');
    const std::size_t second = first == std::string_view::npos ? first : tuple.find(',', first + 1);
    const std::optional<geo::LatLon> position =
        first == std::string_view::npos ? std::nullopt : placeOfDegrees(tuple.substr(first + 1, second - first - 1), tuple.substr(0, first));
    if (!position) {
      ++faults;
      continue;
    }
    places.push_back({{}, *position, second == std::string_view::npos ? std::nullopt : parseNumber(tuple.substr(second + 1)), {}});
  }
}

std::vector<geo::LatLon> ringOf(pugi::xml_node boundary, std::size_t& faults) {
  std::vector<geo::LatLon> ring;
  for (const FoundTargets::Place& place : placesOf(childOf(childOf(boundary, "LinearRing"), "coordinates").text().get(), faults)) {
    ring.push_back(place.position);
  }
  if (ring.size() > 1 && ring.front() == ring.back()) {
    ring.pop_back();
  }
  return ring;
}

class KmlReader {
public:
  KmlReader(const XmlText& xml, bool tracks, FoundTargets& found) : xml_(&xml), tracks_(tracks), found_(&found) {}

  /// An element of a placemark, or anything else, which is passed over.
  void read(pugi::xml_node node) {
    const std::string_view kind = localName(node);
    if (kind == "Placemark") {
      name_ = textOf(node, "name");
    } else if (kind == "NetworkLink") {
      found_->leftOut.add("link to another file, which is not followed", where(node));
    } else if (kind == "Point" || kind == "LineString") {
      readPlaces(node);
    } else if (kind == "Polygon") {
      readPolygon(node);
    } else if (kind == "Track") {
      readTrack(node);
    }
  }

private:
  [[nodiscard]] std::string where(pugi::xml_node node) const { return fmt::format("line {}", xml_->lineOf(node)); }

  void noteFaults(std::size_t faults, pugi::xml_node node) {
    if (faults > 0) {
      found_->leftOut.add("a coordinate is no place in degrees", faults == 1 ? where(node) : fmt::format("{} in {}", faults, where(node)));
    }
  }

  void readPlaces(pugi::xml_node node) {
    std::size_t faults = 0;
    std::vector<FoundTargets::Place> places = placesOf(childOf(node, "coordinates").text().get(), faults);
    noteFaults(faults, node);
    const std::string mode = textOf(node, "altitudeMode");
    for (FoundTargets::Place& place : places) {
      place.name = name_;
      place.heightAboveGround_m = mode == "relativeToGround" ? place.heightMsl_m : std::nullopt;
      place.heightMsl_m = mode == "absolute" ? place.heightMsl_m : std::nullopt;
      found_->places.push_back(std::move(place));
    }
  }

  void readPolygon(pugi::xml_node node) {
    std::size_t faults = 0;
    FoundTargets::Area area{name_, ringOf(childOf(node, "outerBoundaryIs"), faults), {}};
    for (const pugi::xml_node child : node.children()) {
      if (localName(child) == "innerBoundaryIs") {
        area.holes.push_back(ringOf(child, faults));
      }
    }
    noteFaults(faults, node);
    if (area.ring.size() < 3) {
      found_->leftOut.add("polygon of less than three corners", where(node));
      return;
    }
    found_->areas.push_back(std::move(area));
  }

  void readTrack(pugi::xml_node node) {
    for (const pugi::xml_node coord : node.children()) {
      if (localName(coord) != "coord") {
        continue;
      }
      if (!tracks_) {
        ++found_->trackPoints;
        continue;
      }
      std::string text = coord.text().get();
      std::string_view rest = trimmed(text);
      const std::size_t blank = std::min(rest.find(' '), rest.size());
      const std::string_view longitude = rest.substr(0, blank);
      rest = trimmed(rest.substr(blank));
      const std::optional<geo::LatLon> position = placeOfDegrees(rest.substr(0, std::min(rest.find(' '), rest.size())), longitude);
      if (!position) {
        found_->leftOut.add("a coordinate is no place in degrees", where(coord));
        continue;
      }
      found_->places.push_back({name_, *position, {}, {}});
    }
  }

  const XmlText* xml_;
  bool tracks_;
  FoundTargets* found_;
  std::string name_;
};

}  // namespace

Result<void> findKmlTargets(const std::string& path, const std::string& text, bool tracks, FoundTargets& found) {
  const Result<XmlText> xml = XmlText::parse(path, text);
  if (!xml) {
    return forward(xml);
  }
  found.heightsAreFlown = true;
  KmlReader reader(*xml, tracks, found);
  for (pugi::xml_node node = xml->root(); node; node = nextElement(node)) {
    if (found.job.stopRequested()) {
      return readingStopped();
    }
    reader.read(node);
  }
  return {};
}

}  // namespace vp::formats
