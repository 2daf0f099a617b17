#include "ui/jobs/file_kind.h"

#include "core/formats/airfields.h"
#include "core/formats/airspace/openair.h"
#include "core/formats/population_file.h"
#include "core/formats/targets/target_import.h"
#include "core/formats/weather_file.h"
#include "core/terrain/terrain_reader.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace vp::jobs {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(FileKind)
};

bool endsWithAny(const QString& path, std::initializer_list<const char*> endings) {
  return std::any_of(endings.begin(), endings.end(), [&](const char* ending) { return path.endsWith(QLatin1String(ending), Qt::CaseInsensitive); });
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
      return fail(Errc::BadFile, Words::tr("airports without runways; add the runways.csv of the same download together with it").toStdString(),
                  file.toStdString());
    }
    runways.removeAll(partner);
    files.airfields.push_back({file.toStdString(), partner.toStdString()});
  }
  for (const QString& file : runways) {
    const QString partner = partnerOf(file, QStringLiteral("runways"), QStringLiteral("airports"));
    if (partner.isEmpty()) {
      return fail(Errc::BadFile, Words::tr("runways without airports; add the airports.csv of the same download together with it").toStdString(),
                  file.toStdString());
    }
    files.airfields.push_back({partner.toStdString(), file.toStdString()});
  }
  return {};
}

/// One file by its content; only where that tells nothing, its name says what the reader's complaint will be about.
Result<void> sortFile(const QString& path, QStringList& airports, QStringList& runways, NewFiles& files) {
  const std::string native = path.toStdString();
  switch (formats::airfieldFileOf(native)) {
    case formats::AirfieldFile::Airports:
      airports << path;
      return {};
    case formats::AirfieldFile::Runways:
      runways << path;
      return {};
    case formats::AirfieldFile::None:
      break;
    default:
      files.airfields.push_back({native, {}});
      return {};
  }
  if (endsWithAny(path, {".cup", ".cup.gz", "apt.dat", "apt.dat.gz"})) {
    files.airfields.push_back({native, {}});
    return {};
  }
  if (endsWithAny(path, {".csv", ".csv.gz"})) {
    return fail(
        Errc::BadFile,
        Words::tr("is neither a table of OurAirports nor one of own fields; its first line lacks their columns (latitude, longitude and course_deg)")
            .toStdString(),
        native);
  }
  if (formats::isOpenAir(native)) {
    files.airspaces.push_back(native);
    return {};
  }
  if (formats::isPopulationFile(native)) {
    files.population.push_back(native);
    return {};
  }
  const Result<terrain::TerrainInfo> info = terrain::inspectTerrain({native});
  if (!info) {
    return forward(info);
  }
  files.terrain.push_back(native);
  return {};
}

/// Whether a file holds polygons with people or weather in them, which could be taken for areas to survey but for their fields.
bool sortPolygons(const QString& path, SortedFiles& files) {
  const std::string native = path.toStdString();
  if (formats::isPopulationFile(native)) {
    files.map.population.push_back(native);
  } else if (formats::isWeatherFile(native)) {
    files.weather << path;
  } else {
    return false;
  }
  return true;
}

/// What a file that may hold targets is to be; false if it holds none.
bool sortTargets(const QString& path, SortedFiles& files) {
  const std::string native = path.toStdString();
  if (formats::targetFileOf(native) == formats::TargetFile::None) {
    return false;
  }
  switch (formats::airfieldFileOf(native)) {
    case formats::AirfieldFile::None:
      files.targets << path;
      return true;
    case formats::AirfieldFile::SeeYou:
    case formats::AirfieldFile::OwnTable:
    case formats::AirfieldFile::GeoJson:
      files.either << path;
      return true;
    default:
      return false;
  }
}

Result<void> checkNamed(const QString& path) {
  if (!QFileInfo(path).isFile()) {
    return fail(Errc::BadFile, Words::tr("there is no such file").toStdString(), path.toStdString());
  }
  if (endsWithAny(path, {".vpm", ".vpp"})) {
    return fail(Errc::BadFile, Words::tr("is a mission or plan and cannot be added to one; open it instead").toStdString(), path.toStdString());
  }
  return {};
}

Result<SortedFiles> sort(const QStringList& paths, bool withTargets, const Job& job) {
  SortedFiles files;
  QStringList airports;
  QStringList runways;
  QStringList absolute;
  for (const QString& given : paths) {
    absolute << QFileInfo(given).absoluteFilePath();
  }
  absolute.removeDuplicates();
  for (const QString& path : absolute) {
    if (job.stopRequested()) {
      return fail(Errc::Cancelled, Words::tr("reading the files was stopped").toStdString());
    }
    job.progress(static_cast<double>(absolute.indexOf(path)) / static_cast<double>(absolute.size()), QFileInfo(path).fileName().toStdString());
    Result<void> sorted = checkNamed(path);
    if (sorted && !(withTargets && (sortPolygons(path, files) || sortTargets(path, files)))) {
      sorted = sortFile(path, airports, runways, files.map);
    }
    if (!sorted) {
      return forward(sorted);
    }
  }
  if (Result<void> paired = pairCsv(airports, runways, files.map); !paired) {
    return forward(paired);
  }
  return files;
}

}  // namespace

Result<NewFiles> sortFiles(const QStringList& paths, const Job& job) {
  Result<SortedFiles> sorted = sort(paths, false, job);
  if (!sorted) {
    return forward(sorted);
  }
  return std::move(sorted->map);
}

Result<SortedFiles> sortAllFiles(const QStringList& paths, const Job& job) {
  return sort(paths, true, job);
}

Result<NewFiles> newTo(const mission::Mission& mission, NewFiles files) {
  const std::string first = !files.terrain.empty()      ? files.terrain.front()
                            : !files.airfields.empty()  ? files.airfields.front().airports
                            : !files.airspaces.empty()  ? files.airspaces.front()
                            : !files.population.empty() ? files.population.front()
                                                        : std::string();
  std::erase_if(files.terrain,
                [&](const std::string& f) { return std::find(mission.terrain.begin(), mission.terrain.end(), f) != mission.terrain.end(); });
  std::erase_if(files.airfields, [&](const mission::AirfieldSource& s) {
    return std::find(mission.airfields.begin(), mission.airfields.end(), s) != mission.airfields.end();
  });
  std::erase_if(files.airspaces, [&](const std::string& f) {
    return std::find(mission.airspace.files.begin(), mission.airspace.files.end(), f) != mission.airspace.files.end();
  });
  std::erase_if(files.population, [&](const std::string& f) {
    return std::find(mission.populationFiles.begin(), mission.populationFiles.end(), f) != mission.populationFiles.end();
  });
  if (files.count() == 0) {
    return fail(Errc::BadFile, Words::tr("is part of the mission already").toStdString(), first);
  }
  return files;
}

}  // namespace vp::jobs
