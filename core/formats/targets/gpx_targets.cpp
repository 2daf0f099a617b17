// Places of GPX 1.0 and 1.1: wpt, rte and, by choice, trk.
#include "core/formats/targets/found_targets.h"
#include "core/formats/targets/xml_text.h"

#include <fmt/format.h>

namespace vp::formats {

Result<void> findGpxTargets(const std::string& path, const std::string& text, bool tracks, FoundTargets& found) {
  const Result<XmlText> xml = XmlText::parse(path, text);
  if (!xml) {
    return forward(xml);
  }
  if (localName(xml->root()) != "gpx") {
    return fail(Errc::BadFormat, fmt::format("the root of this XML is {}, not gpx", localName(xml->root())), path);
  }
  for (pugi::xml_node node = nextElement(xml->root()); node; node = nextElement(node)) {
    if (found.job.stopRequested()) {
      return readingStopped();
    }
    const std::string_view kind = localName(node);
    if (kind != "wpt" && kind != "rtept" && kind != "trkpt") {
      continue;
    }
    if (kind == "trkpt" && !tracks) {
      ++found.trackPoints;
      continue;
    }
    const std::optional<geo::LatLon> position = placeOfDegrees(node.attribute("lat").value(), node.attribute("lon").value());
    if (!position) {
      found.leftOut.add("lat and lon are no place in degrees", fmt::format("line {}", xml->lineOf(node)));
      continue;
    }
    found.places.push_back({textOf(node, "name"), *position, parseNumber(textOf(node, "ele")), {}});
  }
  return {};
}

}  // namespace vp::formats
