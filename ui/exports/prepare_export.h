#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/formats/exports/export_formats.h"
#include "core/route/build_route.h"
#include "core/safety/checker.h"

#include <memory>
#include <string>
#include <vector>

namespace vp::exports {

/** A plan and the terrain read afresh for it. `plan.certificate` counts as what the checker found just now. */
struct ExportRequest {
  const mission::Plan& plan;
  std::shared_ptr<const terrain::ElevationGrid> terrain;  ///< null: it cannot be read, so nothing is verified
  std::vector<std::string> terrainSha256;
  std::vector<std::string> formats;  ///< names
};

/** Least margin of one kind, of the tour and of the route flown with fly-by turns. */
struct MarginChange {
  std::string kind;
  std::string unit;
  double tour = 0.0;
  double route = 0.0;
};

/** A waypoint route at one precision, flown and judged. */
struct CheckedRoute {
  mission::Route route;
  bool isVerified = false;
  std::vector<safety::Finding> findings;  ///< violated or unknown
  std::vector<MarginChange> margins;      ///< kinds that both have
};

/** A file to be written. */
struct ExportFile {
  const formats::ExportFormat* format = nullptr;
  int part = 1;
  int parts = 1;
  std::string bytes;
};

/** What a pilot is to know before files are written. */
struct Remark {
  bool isWarning = false;  ///< true: asks for "export all the same?"
  std::string text;
};

struct PreparedExport {
  std::vector<CheckedRoute> routes;  ///< by precision
  std::vector<ExportFile> files;
  std::vector<Remark> remarks;
  bool isVerified = false;  ///< the plan and every route
  std::string refusal;      ///< which formats have an unverified route, why, and what helps, for a pilot; empty if none has
  [[nodiscard]] bool hasWarnings() const;
};

/** Builds and checks the waypoint routes that the formats need and writes the files in memory. Never refuses an unsafe plan: it
 *  says so in the remarks.
 *  @errors OutOfRange - an unknown format, or no tour; Cancelled; those of the writers */
Result<PreparedExport> prepareExport(const ExportRequest& request, const Job& job);

/** What a margin's rule means to a pilot; the rule itself if it has no words. */
std::string marginInWords(const std::string& kind);

}  // namespace vp::exports
