#include "core/tour/home_site.h"

#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"

#include <fmt/format.h>

namespace vp::tour {

geo::Pose departureEnd(const mission::SiteInFrame& site) {
  return flight::poseAfter(site.pose, {flight::Turn::Straight, 0.0, site.site.length ? site.site.length->si() : 0.0},
                           site.site.length ? site.site.length->si() : 0.0);
}

Result<int> findHomeSite(const std::vector<mission::SiteInFrame>& sites, const std::string& id) {
  constexpr std::size_t kMostNames = 12;
  std::string names;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (sites[i].site.id == id) {
      return static_cast<int>(i);
    }
    if (i < kMostNames) {
      names += (names.empty() ? "" : ", ") + sites[i].site.id;
    }
  }
  return fail(Errc::OutOfRange, fmt::format("home {}: there is no usable landing site of that name; there are {}{}", id, names,
                                            sites.size() > kMostNames ? ", ..." : ""));
}

}  // namespace vp::tour
