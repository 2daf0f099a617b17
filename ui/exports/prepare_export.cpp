#include "ui/exports/prepare_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace vp::exports {
namespace {

constexpr std::size_t kFindingsShown = 3;

bool isFault(const safety::Finding& finding) {
  return finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown;
}

/// Roadmap and routes, built when they are needed.
class Routes {
public:
  explicit Routes(const ExportRequest& request) : request_(request) {}

  Result<std::size_t> at(double stepsPerDegree, PreparedExport& prepared, const Job& job) {
    for (std::size_t i = 0; i < prepared.routes.size(); ++i) {
      if (prepared.routes[i].route.stepsPerDegree == stepsPerDegree) {
        return i;
      }
    }
    Result<CheckedRoute> checked = build(stepsPerDegree, job);
    if (!checked) {
      return forward(checked);
    }
    prepared.routes.push_back(std::move(*checked));
    return prepared.routes.size() - 1;
  }

private:
  Result<CheckedRoute> build(double stepsPerDegree, const Job& job) {
    if (request_.terrain && !isPrepared_) {
      Result<route::Ground> ground = route::prepareGround(request_.plan, request_.terrain, job.part(0.0, 0.6));
      if (!ground && ground.error().code == Errc::Cancelled) {
        return forward(ground);
      }
      if (ground) {
        ground_ = std::move(*ground);
      }
      isPrepared_ = true;
    }
    route::RouteOptions options;
    options.stepsPerDegree = stepsPerDegree;
    CheckedRoute checked;
    if (ground_) {
      Result<route::BuiltRoute> built = route::buildRoute(request_.plan, &*ground_, options, job.part(0.6, 0.8));
      if (built) {
        return judged(std::move(*built), job.part(0.8, 1.0));
      }
      if (built.error().code != Errc::NoSolution) {
        return forward(built);
      }
      checked.findings.push_back({safety::Severity::Violated, "glide.site", built.error().what, -1, {}, {}});
    }
    Result<route::BuiltRoute> plain = route::buildRoute(request_.plan, nullptr, options, job);
    if (!plain) {
      return forward(plain);
    }
    checked.route = std::move(plain->route);
    return checked;
  }

  Result<CheckedRoute> judged(route::BuiltRoute built, const Job& job) const {
    const Result<safety::SafetyReport> report = safety::check({built.reflown, *request_.terrain, request_.terrainSha256}, job);
    if (!report) {
      return forward(report);
    }
    CheckedRoute checked;
    checked.route = std::move(built.route);
    checked.isVerified = report->isSafe();
    std::copy_if(report->findings.begin(), report->findings.end(), std::back_inserter(checked.findings), isFault);
    if (request_.plan.certificate) {
      for (const mission::Margin& tour : request_.plan.certificate->margins) {
        const auto same = std::find_if(report->margins.begin(), report->margins.end(), [&](const mission::Margin& m) { return m.kind == tour.kind; });
        if (same != report->margins.end()) {
          checked.margins.push_back({tour.kind, tour.unit, tour.value, same->value});
        }
      }
    }
    return checked;
  }

  const ExportRequest& request_;
  std::optional<route::Ground> ground_;
  bool isPrepared_ = false;
};

std::string precisionOf(double stepsPerDegree) {
  constexpr double kMetresPerDegree = 111200.0;
  return fmt::format("places to {:.1f} m", kMetresPerDegree / stepsPerDegree);
}

/// What flying the waypoints costs, said also where it is nothing.
void remarkOnMargins(const CheckedRoute& checked, PreparedExport& prepared) {
  constexpr double kWorthSaying = 0.05;
  bool isLess = false;
  for (const MarginChange& margin : checked.margins) {
    if (margin.route < margin.tour - kWorthSaying) {
      isLess = true;
      prepared.remarks.push_back({false, fmt::format("{}: least margin {:.1f} {} on the tour, {:.1f} {} flown from waypoint to waypoint",
                                                     marginInWords(margin.kind), margin.tour, margin.unit, margin.route, margin.unit)});
    }
  }
  if (!isLess && !checked.margins.empty()) {
    prepared.remarks.push_back({false, "flown from waypoint to waypoint no least margin is smaller than on the tour"});
  }
}

/// What mends a route that leaves the tour by a little too much.
std::string remedyFor(double stepsPerDegree) {
  const std::vector<formats::ExportFormat>& all = formats::exportFormats();
  const bool isCoarse = std::any_of(all.begin(), all.end(), [&](const formats::ExportFormat& f) { return f.stepsPerDegree > stepsPerDegree; });
  return isCoarse ? "plan again with a shorter step between decision points, or export to a format that holds places more finely, such as GPX"
                  : "plan again with a shorter step between decision points";
}

/// The formats of a request that share a precision, in words.
std::string formatsOf(const ExportRequest& request, double stepsPerDegree) {
  std::string names;
  for (const std::string& name : request.formats) {
    const formats::ExportFormat* format = formats::findExportFormat(name);
    if (format != nullptr && format->stepsPerDegree == stepsPerDegree) {
      names += (names.empty() ? "" : ", ") + format->what;
    }
  }
  return names;
}

/// @param formats  those that the route is for, in words
void remarkOnRoute(const CheckedRoute& checked, const std::string& formats, PreparedExport& prepared) {
  const mission::Route& route = checked.route;
  const auto add = [&](bool isWarning, std::string text) { prepared.remarks.push_back({isWarning, std::move(text)}); };
  add(false, fmt::format("{} waypoints, {}: flown with fly-by turns of {:.0f} m radius the path is at most {:.1f} m beside and {:.0f} m above the "
                         "tour, never below it; targets are passed within {:.1f} m",
                         route.waypoints.size(), precisionOf(route.stepsPerDegree), route.waypoints.front().turnRadius, route.lateral, route.above,
                         route.visit));
  if (!route.guarantee.empty()) {
    add(false, route.guarantee);
  }
  remarkOnMargins(checked, prepared);
  if (!checked.isVerified) {
    const auto refuse = [&](const std::string& text) {
      add(true, text);
      prepared.refusal += (prepared.refusal.empty() ? "" : "; ") + text;
    };
    refuse(formats +
           (checked.findings.empty() ? ": the waypoint route could not be verified" : ": flown from waypoint to waypoint the route is NOT SAFE"));
    for (std::size_t i = 0; i < std::min(kFindingsShown, checked.findings.size()); ++i) {
      refuse(checked.findings[i].text);
    }
    if (!checked.findings.empty()) {
      refuse(remedyFor(route.stepsPerDegree));
    }
  }
}

void remarkOnPlan(const mission::Plan& plan, PreparedExport& prepared) {
  if (!plan.certificate) {
    prepared.remarks.push_back({true, "this plan is UNVERIFIED: no one has shown that a glide to a runway exists from every point of it"});
  } else {
    for (const std::string& warning : plan.certificate->warnings) {
      prepared.remarks.push_back({false, warning});
    }
  }
  if (!plan.spirals.empty()) {
    prepared.remarks.push_back(
        {true,
         fmt::format("{} spirals down to low targets are not part of the waypoints: the route passes above these targets", plan.spirals.size())});
  }
}

Result<void> addFiles(const ExportRequest& request, const formats::ExportFormat& format, const CheckedRoute& checked, PreparedExport& prepared) {
  const bool isUnverified = !request.plan.certificate || !checked.isVerified;
  const mission::Route route = isUnverified ? formats::markedUnverified(checked.route) : checked.route;
  const std::vector<formats::RoutePart> parts = formats::partsOf(route, format.mostPoints);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const int part = static_cast<int>(i) + 1;
    const int count = static_cast<int>(parts.size());
    Result<std::string> bytes = format.write({request.plan, &route, parts[i].first, parts[i].count, part, count});
    if (!bytes) {
      return forward(bytes);
    }
    prepared.files.push_back({&format, part, count, std::move(*bytes)});
  }
  if (parts.size() > 1) {
    prepared.remarks.push_back(
        {false, fmt::format("{}: {} points are more than the {} that it takes, so there are {} files, each beginning where the "
                            "one before ended",
                            format.what, route.waypoints.size() + (route.isClosed ? 1 : 0), format.mostPoints, parts.size())});
  }
  if (isUnverified && !format.holdsMark) {
    prepared.remarks.push_back({true, fmt::format("{}: nothing in this file can say that it is unverified; name the file so", format.what)});
  }
  if (!format.loses.empty()) {
    prepared.remarks.push_back({false, fmt::format("{}: {}", format.what, format.loses)});
  }
  return {};
}

}  // namespace

bool PreparedExport::hasWarnings() const {
  return std::any_of(remarks.begin(), remarks.end(), [](const Remark& remark) { return remark.isWarning; });
}

Result<PreparedExport> prepareExport(const ExportRequest& request, const Job& job) {
  PreparedExport prepared;
  remarkOnPlan(request.plan, prepared);
  Routes routes(request);
  prepared.isVerified = request.plan.certificate.has_value();
  for (std::size_t i = 0; i < request.formats.size(); ++i) {
    const formats::ExportFormat* format = formats::findExportFormat(request.formats[i]);
    if (format == nullptr) {
      return fail(Errc::OutOfRange, fmt::format("there is no export format {}", request.formats[i]));
    }
    const double count = static_cast<double>(request.formats.size());
    const std::size_t known = prepared.routes.size();
    const Result<std::size_t> index =
        routes.at(format->stepsPerDegree, prepared, job.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
    if (!index) {
      return forward(index);
    }
    const CheckedRoute& checked = prepared.routes[*index];
    if (prepared.routes.size() > known) {
      prepared.isVerified = prepared.isVerified && checked.isVerified;
      remarkOnRoute(checked, formatsOf(request, format->stepsPerDegree), prepared);
    }
    if (const Result<void> added = addFiles(request, *format, checked, prepared); !added) {
      return forward(added);
    }
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, "stopped while exporting; nothing was written");
    }
  }
  return prepared;
}

std::string marginInWords(const std::string& kind) {
  static const std::map<std::string, std::string> words{
      {"tour.clearance", "tour above terrain and clearance"},
      {"tour.glide", "tour above what the glide needs"},
      {"tour.climb", "climb angle below the steepest allowed"},
      {"tour.descent", "descent angle below the steepest allowed"},
      {"tour.ceiling", "tour below the ceiling"},
      {"glide.clearance", "engine-out glides above terrain and clearance"},
      {"glide.dynamics", "engine-out glides above terrain less what rolling may cost"},
      {"glide.arrival", "engine-out glides above the runway on arrival"},
      {"target.height", "height at which a target is passed above it"},
      {"spiral.clearance", "spirals above terrain and clearance"},
  };
  const auto found = words.find(kind);
  return found == words.end() ? kind : found->second;
}

}  // namespace vp::exports
