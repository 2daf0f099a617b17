#include "ui/briefing/briefing_source.h"

#include "core/formats/mission_loader.h"
#include "ui/style/core_text.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <optional>

namespace vp::briefing {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(Briefing)
};

std::string checksumOf(const QString& path) {
  QFile file(path);
  QCryptographicHash hash(QCryptographicHash::Sha256);
  return file.open(QIODevice::ReadOnly) && hash.addData(&file) ? hash.result().toHex().toStdString() : std::string();
}

/// @param sha256  nothing: to be found
SourceFile sourceFile(const std::string& path, const std::optional<std::string>& sha256, const std::string& folder) {
  const QFileInfo info(QDir(QString::fromStdString(folder.empty() ? "." : folder)), QString::fromStdString(path));
  return {path, sha256 ? *sha256 : checksumOf(info.filePath()),
          info.exists() ? info.lastModified().toUTC().date().toString(Qt::ISODate).toStdString() : std::string()};
}

/// What has to be whole before anything can be drawn or flown.
bool isStructural(const safety::Finding& finding) {
  const bool bad = finding.severity == safety::Severity::Violated || finding.severity == safety::Severity::Unknown;
  return bad &&
         (finding.rule.starts_with("plan.") || finding.rule == "aircraft.profile" || finding.rule == "settings" || finding.rule == "terrain.grid");
}

}  // namespace

Result<BriefingSource> briefingSource(mission::Plan plan, const std::string& folder, std::chrono::year_month_day date, const Job& job) {
  std::vector<std::string> checksums;
  job.progress(0.0, Words::tr("briefing: terrain").toStdString());
  Result<terrain::ElevationGrid> grid = formats::readPlanTerrain(plan, folder, checksums, job.part(0.0, 0.3));
  if (!grid) {
    return forward(grid);
  }
  Result<safety::SafetyReport> report = safety::check({plan, *grid, checksums}, job.part(0.3, 0.7));
  if (!report) {
    return forward(report);
  }
  const auto damage = std::find_if(report->findings.begin(), report->findings.end(), isStructural);
  if (damage != report->findings.end()) {
    return fail(Errc::BadFile, Words::tr("the plan is damaged and cannot be briefed: %1").arg(style::coreText(damage->text)).toStdString());
  }
  plan.certificate = report->certificate;
  Result<TourFigures> figures = tourFigures(plan, *grid, date, job.part(0.7, 1.0));
  if (!figures) {
    return forward(figures);
  }
  BriefingSource source;
  for (const mission::TerrainReference& file : plan.terrain) {
    source.terrainFiles.push_back(sourceFile(file.path, file.sha256, folder));
  }
  for (const mission::AirfieldSource& files : plan.mission.airfields) {
    for (const std::string& path : {files.airports, files.runways}) {
      if (!path.empty()) {
        source.airfieldFiles.push_back(sourceFile(path, std::nullopt, folder));
      }
    }
  }
  source.terrain =
      document::makeTerrainData(geo::LocalFrame(plan.frameOrigin), std::make_shared<const terrain::ElevationGrid>(std::move(*grid)), plan.terrain);
  source.plan = std::make_shared<const mission::Plan>(std::move(plan));
  source.report = std::move(*report);
  source.figures = std::move(*figures);
  return source;
}

}  // namespace vp::briefing
