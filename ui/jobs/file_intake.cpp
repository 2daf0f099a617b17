#include "ui/jobs/file_intake.h"

#include "core/formats/population_file.h"
#include "ui/jobs/workspace.h"
#include "ui/style/core_text.h"

#include <QFileInfo>
#include <QScopedValueRollback>

#include <utility>

namespace vp::jobs {
namespace {

constexpr std::size_t kMostShown = 100'000;  // targets to choose from; a list of more helps nobody, and each takes about a kilobyte while it is read

/// Files given as population, whole or refused: a file that is none must not be named by a mission.
Result<SortedFiles> populationFiles(const QStringList& paths) {
  SortedFiles files;
  for (const QString& path : paths) {
    const std::string native = QFileInfo(path).absoluteFilePath().toStdString();
    if (const Result<formats::PopulationReport> read = formats::readPopulation(native); !read) {
      return forward(read);
    }
    files.map.population.push_back(native);
  }
  return files;
}

}  // namespace

FileIntake::FileIntake(Workspace& workspace, Operator operatorSays, QObject* parent)
    : QObject(parent), workspace_(workspace), operator_(std::move(operatorSays)) {
  connect(&workspace_.document(), &document::MissionDocument::replaced, this, &FileIntake::cancel);
  connect(&runner_, &JobRunner::progressed, this, [this](double, const QString& name) { emit working(tr("Reading %1").arg(name)); });
}

void FileIntake::take(const QStringList& paths, Purpose purpose) {
  const bool waits = isBusy();
  requests_.push_back({paths, purpose});
  if (!waits) {
    next();
  }
}

void FileIntake::cancel() {
  if (isBusy()) {
    ++generation_;
    requests_.clear();
    targets_.clear();
    weather_.clear();
    runner_.cancel();
    emit working({});
  }
}

void FileIntake::next() {
  while (targets_.isEmpty() && weather_.isEmpty() && !requests_.empty()) {
    const Request request = std::move(requests_.front());
    requests_.pop_front();
    if (request.purpose == Purpose::Targets) {
      targets_ = request.paths;
    } else if (request.purpose == Purpose::Weather) {
      weather_ = request.paths;
    } else {
      sort(request);
      return;
    }
  }
  if (!weather_.isEmpty()) {
    readWeather(weather_.takeFirst());
  } else if (!targets_.isEmpty()) {
    read(targets_.takeFirst());
  } else {
    emit working({});
  }
}

void FileIntake::refuse(const Error& error) {
  emit refused(error);
  next();
}

void FileIntake::sort(const Request& request) {
  emit working(tr("Reading %n file(s)", nullptr, static_cast<int>(request.paths.size())));
  runner_.start<SortedFiles>(
      [paths = request.paths, purpose = request.purpose](const Job& job) -> Result<SortedFiles> {
        if (purpose == Purpose::Any) {
          return sortAllFiles(paths, job);
        }
        if (purpose == Purpose::Population) {
          return populationFiles(paths);
        }
        Result<NewFiles> map = sortFiles(paths, job);
        if (!map) {
          return forward(map);
        }
        return SortedFiles{std::move(*map), {}, {}, {}};
      },
      [this](Result<SortedFiles> files) { sorted(std::move(files)); });
}

/// Has the operator say what each doubtful file is. @return false if all of it was cancelled meanwhile
bool FileIntake::askAbout(SortedFiles& files) {
  const unsigned generation = generation_;
  const QScopedValueRollback asking(isAsking_, true);
  for (const QString& path : std::exchange(files.either, {})) {
    emit working({});
    const Holds holds = operator_.which(path);
    if (generation != generation_) {
      return false;
    }
    if (holds == Holds::Targets) {
      files.targets << path;
    } else if (holds == Holds::Airfields) {
      files.map.airfields.push_back({path.toStdString(), {}});
    }
  }
  return true;
}

void FileIntake::sorted(Result<SortedFiles> files) {
  if (!files) {
    refuse(files.error());
    return;
  }
  if (!askAbout(*files)) {
    next();
    return;
  }
  if (files->map.count() > 0) {
    if (const Result<void> added = workspace_.add(files->map); !added) {
      refuse(added.error());
      return;
    }
  }
  targets_ = files->targets;
  weather_ = files->weather;
  next();
}

void FileIntake::readWeather(const QString& path) {
  emit working(tr("Reading %1").arg(QFileInfo(path).fileName()));
  runner_.start<formats::WeatherReport>([native = path.toStdString()](const Job&) { return formats::readWeather(native); },
                                        [this, path](const Result<formats::WeatherReport>& report) {
                                          if (!report) {
                                            refuse(report.error());
                                            return;
                                          }
                                          addWeather(path, *report);
                                          next();
                                        });
}

/// Cells that no planner can use are left out, each with its sentence.
void FileIntake::addWeather(const QString& path, const formats::WeatherReport& report) {
  QStringList notes;
  for (const std::string& note : report.notes) {
    notes << style::coreText(note);
  }
  const std::shared_ptr<const document::TerrainData>& terrain = workspace_.situation().terrain;
  std::vector<mission::WeatherCell> usable;
  for (const mission::WeatherCell& cell : report.cells) {
    const std::string problem = document::weatherProblem(cell, terrain ? terrain->frame : geo::LocalFrame(cell.outline.front()));
    if (problem.empty()) {
      usable.push_back(cell);
    } else {
      notes << tr("Left out: %1").arg(style::coreText(problem));
    }
  }
  workspace_.document().edit(tr("Add weather from %1").arg(QFileInfo(path).fileName()),
                             [&](mission::Mission& m) { m.weather.insert(m.weather.end(), usable.begin(), usable.end()); });
  emit weatherAdded(path, static_cast<int>(usable.size()), notes);
}

void FileIntake::read(const QString& path) {
  emit working(tr("Reading %1").arg(QFileInfo(path).fileName()));
  const TargetsOfFile::Reader reader = [native = path.toStdString(), mission = workspace_.document().sharedMission()](
                                           formats::TargetImportOptions options, const Job& job) {
    options.most = kMostShown;
    options.tracksAlone = true;
    return formats::importTargets(native, options, mission->targets, job);
  };
  runner_.start<formats::ImportedTargets>([reader](const Job& job) { return reader({}, job); },
                                          [this, path, reader](TargetsOfFile::Found found) {
                                            targetsRead({path, std::move(found), reader});
                                          });
}

void FileIntake::targetsRead(const TargetsOfFile& file) {
  if (!file.found && file.found.error().code != Errc::OutOfRange) {
    refuse(file.found.error());
    return;
  }
  const unsigned generation = generation_;
  std::optional<formats::ImportedTargets> chosen;
  {
    const QScopedValueRollback asking(isAsking_, true);
    emit working({});
    chosen = operator_.choose(file);
  }
  if (chosen && generation == generation_) {
    addTargets(file.path, *chosen);
  }
  next();
}

/// The mission may have changed since the file was read.
void FileIntake::addTargets(const QString& path, const formats::ImportedTargets& chosen) {
  document::MissionDocument& document = workspace_.document();
  formats::ImportedTargets fitted = formats::fitTargets(chosen.targets, document.mission().targets);
  document.edit(tr("Import targets from %1").arg(QFileInfo(path).fileName()),
                [&](mission::Mission& m) { m.targets.insert(m.targets.end(), fitted.targets.begin(), fitted.targets.end()); });
  fitted.notes.insert(fitted.notes.begin(), chosen.notes.begin(), chosen.notes.end());
  emit targetsAdded(path, fitted);
}

}  // namespace vp::jobs
