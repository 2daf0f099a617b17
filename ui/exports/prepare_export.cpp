#include "ui/exports/prepare_export.h"

#include <QCoreApplication>
#include <QString>

#include <algorithm>
#include <map>

namespace vp::exports {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Exports)
};

/// A fixed text of the core in the language of the window. This room is made without ui/style, which takes sentences with figures apart.
QString shown(const std::string& text) {
  return QCoreApplication::translate("Core", text.c_str());
}

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

QString precisionOf(double stepsPerDegree) {
  constexpr double kMetresPerDegree = 111200.0;
  return Words::tr("places to %1 m").arg(kMetresPerDegree / stepsPerDegree, 0, 'f', 1);
}

QString amount(double value, const std::string& unit) {
  return QStringLiteral("%1 %2").arg(value, 0, 'f', 1).arg(QString::fromStdString(unit));
}

/// What flying the waypoints costs, said also where it is nothing.
void remarkOnMargins(const CheckedRoute& checked, PreparedExport& prepared) {
  constexpr double kWorthSaying = 0.05;
  bool isLess = false;
  for (const MarginChange& margin : checked.margins) {
    if (margin.route < margin.tour - kWorthSaying) {
      isLess = true;
      prepared.remarks.push_back(
          {false, Words::tr("%1: least margin %2 on the tour, %3 flown from waypoint to waypoint")
                      .arg(QString::fromStdString(marginInWords(margin.kind)), amount(margin.tour, margin.unit), amount(margin.route, margin.unit))
                      .toStdString()});
    }
  }
  if (!isLess && !checked.margins.empty()) {
    prepared.remarks.push_back({false, Words::tr("flown from waypoint to waypoint no least margin is smaller than on the tour").toStdString()});
  }
}

/// What mends a route that leaves the tour by a little too much.
QString remedyFor(bool isCoarse) {
  return isCoarse ? Words::tr(
                        "plan again with a shorter step between decision points, or export to a format that holds places more finely, "
                        "such as GPX")
                  : Words::tr("plan again with a shorter step between decision points");
}

/// Whether another format holds places more finely.
bool isCoarsePrecision(double stepsPerDegree) {
  const std::vector<formats::ExportFormat>& all = formats::exportFormats();
  return std::any_of(all.begin(), all.end(), [stepsPerDegree](const auto& format) { return format.stepsPerDegree > stepsPerDegree; });
}

/// The formats of a request that share a precision, in words.
std::string formatsOf(const ExportRequest& request, double stepsPerDegree) {
  std::string names;
  for (const std::string& name : request.formats) {
    const formats::ExportFormat* format = formats::findExportFormat(name);
    if (format != nullptr && format->stepsPerDegree == stepsPerDegree) {
      names += (names.empty() ? "" : ", ") + shown(format->what).toStdString();
    }
  }
  return names;
}

/// @param formats  those that the route is for, in words
void remarkOnRoute(const CheckedRoute& checked, const std::string& formats, PreparedExport& prepared) {
  const mission::Route& route = checked.route;
  const auto add = [&](bool isWarning, std::string text) { prepared.remarks.push_back({isWarning, std::move(text)}); };
  add(false,
      Words::tr("%n waypoints, %1: flown with fly-by turns of %2 m radius the path is at most %3 m beside and %4 m above the tour, never below it; "
                "targets are passed within %5 m",
                nullptr, static_cast<int>(route.waypoints.size()))
          .arg(precisionOf(route.stepsPerDegree), QString::number(route.waypoints.front().turnRadius, 'f', 0), QString::number(route.lateral, 'f', 1),
               QString::number(route.above, 'f', 0), QString::number(route.visit, 'f', 1))
          .toStdString());
  if (!route.guarantee.empty()) {
    add(false, route.guarantee);
  }
  remarkOnMargins(checked, prepared);
  if (!checked.isVerified) {
    const auto refuse = [&](const std::string& text) {
      add(true, text);
      prepared.refusal += (prepared.refusal.empty() ? "" : "; ") + text;
    };
    refuse((checked.findings.empty() ? Words::tr("%1: the waypoint route could not be verified")
                                     : Words::tr("%1: flown from waypoint to waypoint the route is NOT SAFE"))
               .arg(QString::fromStdString(formats))
               .toStdString());
    for (std::size_t i = 0; i < std::min(kFindingsShown, checked.findings.size()); ++i) {
      refuse(checked.findings[i].text);
    }
    if (!checked.findings.empty()) {
      refuse(remedyFor(isCoarsePrecision(route.stepsPerDegree)).toStdString());
    }
  }
}

void remarkOnPlan(const mission::Plan& plan, PreparedExport& prepared) {
  if (!plan.certificate) {
    prepared.remarks.push_back(
        {true, Words::tr("this plan is UNVERIFIED: no one has shown that a glide to a runway exists from every point of it").toStdString()});
  } else {
    for (const std::string& warning : plan.certificate->warnings) {
      prepared.remarks.push_back({false, warning});
    }
  }
  if (!plan.spirals.empty()) {
    prepared.remarks.push_back({true, Words::tr("%n spirals down to low targets are not part of the waypoints: the route passes above these targets",
                                                nullptr, static_cast<int>(plan.spirals.size()))
                                          .toStdString()});
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
        {false, Words::tr("%1: %2 points are more than the %3 that it takes, so there are %4 files, each beginning where the one before ended")
                    .arg(shown(format.what))
                    .arg(route.waypoints.size() + (route.isClosed ? 1 : 0))
                    .arg(format.mostPoints)
                    .arg(parts.size())
                    .toStdString()});
  }
  if (isUnverified && !format.holdsMark) {
    prepared.remarks.push_back(
        {true, Words::tr("%1: nothing in this file can say that it is unverified; name the file so").arg(shown(format.what)).toStdString()});
  }
  if (!format.loses.empty()) {
    prepared.remarks.push_back({false, QStringLiteral("%1: %2").arg(shown(format.what), shown(format.loses)).toStdString()});
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
      return fail(Errc::OutOfRange, Words::tr("there is no export format %1").arg(QString::fromStdString(request.formats[i])).toStdString());
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
      return fail(Errc::Cancelled, Words::tr("stopped while exporting; nothing was written").toStdString());
    }
  }
  return prepared;
}

std::string marginInWords(const std::string& kind) {
  static const std::map<std::string, const char*> words{
      {"tour.clearance", QT_TRANSLATE_NOOP("Exports", "tour above terrain and clearance")},
      {"tour.glide", QT_TRANSLATE_NOOP("Exports", "tour above what the glide needs")},
      {"tour.climb", QT_TRANSLATE_NOOP("Exports", "climb angle below the steepest allowed")},
      {"tour.descent", QT_TRANSLATE_NOOP("Exports", "descent angle below the steepest allowed")},
      {"tour.ceiling", QT_TRANSLATE_NOOP("Exports", "tour below the ceiling")},
      {"glide.clearance", QT_TRANSLATE_NOOP("Exports", "engine-out glides above terrain and clearance")},
      {"glide.dynamics", QT_TRANSLATE_NOOP("Exports", "engine-out glides above terrain less what rolling may cost")},
      {"glide.arrival", QT_TRANSLATE_NOOP("Exports", "engine-out glides above the runway on arrival")},
      {"target.height", QT_TRANSLATE_NOOP("Exports", "height at which a target is passed above it")},
      {"spiral.clearance", QT_TRANSLATE_NOOP("Exports", "spirals above terrain and clearance")},
  };
  const auto found = words.find(kind);
  return found == words.end() ? kind : QCoreApplication::translate("Exports", found->second).toStdString();
}

}  // namespace vp::exports
