#include "ui/jobs/file_kind.h"

#include "core/formats/text_file.h"
#include "core/terrain/terrain_reader.h"

#include <QFileInfo>

#include <algorithm>
#include <initializer_list>

namespace vp::jobs {
namespace {

enum class Csv { Airports, Runways, Other };

/// By the columns that only one of the two tables has.
Csv kindOfCsv(const std::string& path) {
  constexpr std::size_t kFirstLine = 4096;
  const Result<std::string> text = formats::readStart(path, kFirstLine);
  if (!text) {
    return Csv::Other;
  }
  const std::string header = text->substr(0, text->find('\n'));
  if (header.find("le_ident") != std::string::npos || header.find("airport_ref") != std::string::npos) {
    return Csv::Runways;
  }
  return header.find("latitude_deg") != std::string::npos && header.find("ident") != std::string::npos ? Csv::Airports : Csv::Other;
}

bool endsWithAny(const QString& path, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return path.endsWith(QLatin1String(ending), Qt::CaseInsensitive); });
}

bool isCsv(const QString& path) {
  return endsWithAny(path, {".csv", ".csv.gz"});
}

/// The other file of a download: the same name with "airports" for "runways", or the reverse.
QString partnerOf(const QString& path, const QString& from, const QString& to) {
  const QFileInfo file(path);
  QString name = file.fileName();
  const qsizetype at = name.lastIndexOf(from, -1, Qt::CaseInsensitive);
  if (at < 0) {
    return {};
  }
  name.replace(at, from.size(), to);
  const QString partner = file.absolutePath() + QLatin1Char('/') + name;
  return QFileInfo::exists(partner) ? partner : QString();
}

Result<void> pairCsv(const QStringList& airports, QStringList runways, NewFiles& files) {
  for (const QString& file : airports) {
    QString partner =
        runways.size() == 1 && airports.size() == 1 ? runways.front() : partnerOf(file, QStringLiteral("airports"), QStringLiteral("runways"));
    if (partner.isEmpty()) {
      return fail(Errc::BadFile, "airports without runways; add the runways.csv of the same download together with it", file.toStdString());
    }
    runways.removeAll(partner);
    files.airfields.push_back({file.toStdString(), partner.toStdString()});
  }
  for (const QString& file : runways) {
    const QString partner = partnerOf(file, QStringLiteral("runways"), QStringLiteral("airports"));
    if (partner.isEmpty()) {
      return fail(Errc::BadFile, "runways without airports; add the airports.csv of the same download together with it", file.toStdString());
    }
    files.airfields.push_back({partner.toStdString(), file.toStdString()});
  }
  return {};
}

}  // namespace

Result<NewFiles> sortFiles(const QStringList& paths, const mission::Mission& mission) {
  NewFiles files;
  QStringList airports;
  QStringList runways;
  QStringList absolute;
  for (const QString& given : paths) {
    absolute << QFileInfo(given).absoluteFilePath();
  }
  absolute.removeDuplicates();
  for (const QString& path : absolute) {
    const std::string native = path.toStdString();
    if (!QFileInfo(path).isFile()) {
      return fail(Errc::BadFile, "there is no such file", native);
    }
    if (endsWithAny(path, {".vpm", ".vpp"})) {
      return fail(Errc::BadFile, "is a mission or plan and cannot be added to one; open it instead", native);
    }
    if (endsWithAny(path, {".cup", ".cup.gz"})) {
      files.airfields.push_back({native, {}});
    } else if (isCsv(path)) {
      switch (kindOfCsv(native)) {
        case Csv::Airports:
          airports << path;
          break;
        case Csv::Runways:
          runways << path;
          break;
        case Csv::Other:
          return fail(Errc::BadFile, "is neither the airports nor the runways table of OurAirports; its first line lacks their columns", native);
      }
    } else {
      const Result<terrain::TerrainInfo> info = terrain::inspectTerrain({native});
      if (!info) {
        return forward(info);
      }
      files.terrain.push_back(native);
    }
  }
  if (Result<void> paired = pairCsv(airports, runways, files); !paired) {
    return forward(paired);
  }
  std::erase_if(files.terrain,
                [&](const std::string& f) { return std::find(mission.terrain.begin(), mission.terrain.end(), f) != mission.terrain.end(); });
  std::erase_if(files.airfields, [&](const mission::AirfieldSource& s) {
    return std::find(mission.airfields.begin(), mission.airfields.end(), s) != mission.airfields.end();
  });
  if (files.terrain.empty() && files.airfields.empty()) {
    return fail(Errc::BadFile, "is part of the mission already", paths.isEmpty() ? "" : paths.front().toStdString());
  }
  return files;
}

}  // namespace vp::jobs
