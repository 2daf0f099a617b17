// Plans all bundled and real missions, calm, in an uncertain wind, in layers and on two days of a pilot, and lets volplane-cli verify fly random
// engine failures over each plan. Usage: second_opinion POINTS FOLDER. Plans that lie in the folder already are taken as they are. Writes a report
// for each plan and table.md into it; ends with 1 if any point is unsafe, the checker refuses a plan, or something else fails.
#include "tests/support/cli_run.h"
#include "tests/support/data_folder.h"
#include "tests/support/real_missions.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QProcess>
#include <QTextStream>
#include <QThread>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace vp::test;

namespace {

struct Condition {
  const char* name;
  const char* words;
  QStringList options;
  double share = 1.0;  ///< of points: where wind and air change with height a point takes ten times as long
};

const std::vector<Condition>& conditions() {
  static const std::vector<Condition> list{
      {"calm", "calm", {}},
      {"wind", "240±20/15±5kt", {"--wind", "240+-20/15+-5kt"}},
      {"layers", "180/5kt at 0 ft, 250/20kt at 6000 ft", {"--wind", "0ft 180/5kt; 6000ft 250/20kt"}},
      {"day",
       "motor glider HK 36, ISA+10, QNH 1005, reaction 3 s and 10 m, final of 600 m with a surface of 1 : 20, 240±20/3±2kt at 0 ft, 270±20/15±5kt at "
       "8000 ft",
       {"--aircraft", "motorglider-hk36", "--air", "ISA+10", "--qnh", "1005", "--reaction", "3s", "--reaction-loss", "10m", "--approach",
        "straight:600m", "--obstacle-surface", "0.05:60m", "--wind", "0ft 240+-20/3+-2kt; 8000ft 270+-20/15+-5kt"},
       0.1},
      {"loaded",
       "172 with the polar of [1] and the masses (680 to 1043 kg), roll rate and powers of the handbook, ISA+10, 55 % power, reaction 3 s and 10 m, "
       "240±20/5±3kt",
       {"--aircraft", "loaded.json", "--air", "ISA+10", "--reaction", "3s", "--reaction-loss", "10m", "--power", "55 %", "--propeller", "windmilling",
        "--wind", "240+-20/5+-3kt"},
       0.1},
  };
  return list;
}

struct Case {
  QString name;     ///< of the mission
  QString mission;  ///< file; empty where the plan is there
  QString plan;     ///< file
  const Condition* condition = nullptr;
};

struct Run {
  int status = -1;
  QByteArray out;
  QByteArray err;
};

/// However long it takes.
Run run(const QStringList& arguments, const QDir& folder) {
  QProcess process;
  process.setWorkingDirectory(folder.path());
  process.start(QStringLiteral(VOLPLANE_BIN_DIR "/volplane-cli"), arguments);
  process.waitForFinished(-1);
  const bool isDone = process.exitStatus() == QProcess::NormalExit && process.error() == QProcess::UnknownError;
  return {isDone ? process.exitCode() : -1, process.readAllStandardOutput(), process.readAllStandardError()};
}

/// A 172 with everything that a profile may have, which still reaches runways in the mountains.
void writeAircraft(const QDir& folder) {
  QJsonObject aircraft = QJsonDocument::fromJson(readAll(QStringLiteral(VOLPLANE_SOURCE_DIR "/resources/aircraft/cessna172-handbook.json"))).object();
  aircraft["name"] = "Cessna 172, masses and powers of the handbook, polar of the source papers";
  aircraft["zeroLiftDrag"] = 0.0341;  // [1] Table 1, as is the induced drag
  aircraft["inducedDrag"] = 0.053;
  aircraft["windmillingDrag"] = 0.0341;
  aircraft["stoppedDrag"] = 0.03;
  writeAll(folder.filePath("loaded.json"), QJsonDocument(aircraft).toJson());
}

/// All conditions for the missions that take seconds, still air for the others.
bool isFlownIn(const QString& mission, const Condition& condition) {
  const QByteArray name = condition.name;
  if (name == "calm") {
    return true;
  }
  if (name == "loaded") {
    return mission == "alpine-n10" || mission == "real-2" || mission == "real-3";
  }
  return mission == "alpine-n10" || mission.startsWith("real") || (mission == "mountain-n20" && name != "day");
}

std::vector<Case> casesIn(const QDir& folder) {
  std::vector<std::pair<QString, QString>> missions;
  const QDir maps(QStringLiteral(VOLPLANE_SOURCE_DIR "/maps"));
  for (const QString& file : maps.entryList({"*.vpm"})) {
    if (!QJsonDocument::fromJson(readAll(maps.filePath(file))).object()["targets"].toArray().isEmpty()) {
      missions.emplace_back(QFileInfo(file).completeBaseName(), maps.filePath(file));
    }
  }
  if (const QString data = dataFolder(); !data.isEmpty()) {
    int number = 0;
    for (const RealMission& mission : realMissions(data)) {
      const QString name = QStringLiteral("real-%1").arg(++number);
      writeAll(folder.filePath(name + ".vpm"), mission.text());
      missions.emplace_back(name, folder.filePath(name + ".vpm"));
    }
  }
  std::vector<Case> cases;
  for (const QString& file : maps.entryList({"*.vpp"})) {
    cases.push_back({file, {}, maps.filePath(file), &conditions().front()});
  }
  for (const auto& [name, file] : missions) {
    for (const Condition& condition : conditions()) {
      if (isFlownIn(name, condition)) {
        cases.push_back({name, file, folder.filePath(QStringLiteral("%1-%2.vpp").arg(name, QLatin1String(condition.name))), &condition});
      }
    }
  }
  return cases;
}

/// Least of one kind, as a cell of the table.
QString leastOf(const QJsonObject& report, const char* kind) {
  for (const QJsonValue& margin : report["margins"].toArray()) {
    if (margin["kind"].toString() == QLatin1String(kind)) {
      return QString::number(margin["least_m"].toDouble(), 'f', 2);
    }
  }
  return "-";
}

struct Totals {
  double points = 0.0;
  double unsafe = 0.0;
  int plans = 0;
  int refused = 0;
  int failed = 0;
};

/// @return a line of the table; empty if the mission has no plan
QString judge(const Case& one, const QString& points, const QDir& folder, Totals& totals, QTextStream& say) {
  if (!one.mission.isEmpty() && !QFile::exists(one.plan)) {
    const Run planned = run(
        QStringList{"-q", "plan", one.mission, "-o", one.plan, "--threads", QString::number(QThread::idealThreadCount())} + one.condition->options,
        folder);
    if (planned.status != 0) {
      (planned.status == 1 ? totals.refused : totals.failed) += 1;
      say << one.name << ", " << one.condition->name << ": no plan: " << planned.err.trimmed() << Qt::endl;
      return {};
    }
  }
  const QString file =
      folder.filePath(QStringLiteral("%1-%2.json").arg(one.mission.isEmpty() ? one.name + "-as-bundled" : one.name, one.condition->name));
  QFile::remove(file);
  QElapsedTimer timer;
  timer.start();
  const Run verified = run({"verify", one.plan, "--independent-samples", points, "--seed", "1", "--threads",
                            QString::number(QThread::idealThreadCount()), "--report", file},
                           folder);
  const double seconds = static_cast<double>(timer.elapsed()) / 1000.0;
  const QJsonObject report = QJsonDocument::fromJson(readAll(file)).object();
  if (verified.status != 0 || report["format"] != "volplane-second-opinion") {
    ++totals.failed;
    say << one.name << ", " << one.condition->name << ": ends with " << verified.status << ":\n" << verified.out << verified.err << Qt::endl;
  }
  ++totals.plans;
  totals.points += report["samples"].toDouble();
  totals.unsafe += report["unsafe"].toDouble();
  const QJsonObject work = report["work"].toObject();
  return QStringLiteral("| %1 | %2 | %3 | %4 | %5 | %6 | %7 | %8 | %9 | %10 | %11 |")
      .arg(one.mission.isEmpty() ? one.name : report["mission"].toString(), one.mission.isEmpty() ? "as bundled" : one.condition->name)
      .arg(report["samples"].toDouble(), 0, 'f', 0)
      .arg(report["unsafe"].toDouble(), 0, 'f', 0)
      .arg(leastOf(report, "tour.clearance"), leastOf(report, "glide.clearance"), leastOf(report, "glide.dynamics"), leastOf(report, "glide.arrival"))
      .arg(work["glides"].toDouble(), 0, 'f', 0)
      .arg(work["metresFlown"].toDouble() / 1000.0, 0, 'f', 0)
      .arg(seconds, 0, 'f', 0);
}

/// What stands below the table.
QString sumOf(const Totals& totals) {
  QString text = QStringLiteral("\n%1 plans, %2 points, %3 unsafe; %4 missions have no plan in their conditions.\n")
                     .arg(totals.plans)
                     .arg(totals.points, 0, 'f', 0)
                     .arg(totals.unsafe, 0, 'f', 0)
                     .arg(totals.refused);
  for (const Condition& condition : conditions()) {
    text += QStringLiteral("%1: %2. ").arg(QLatin1String(condition.name), QString::fromUtf8(condition.words));
  }
  return text + "\n";
}

}  // namespace

int main(int count, char** values) {
  const QCoreApplication application(count, values);
  QTextStream say(stdout);
  const QStringList arguments = QCoreApplication::arguments();
  const qint64 points = arguments.size() > 1 ? arguments[1].toLongLong() : 0;
  if (arguments.size() != 3 || points < 1 || !QDir().mkpath(arguments[2])) {
    say << "usage: second_opinion POINTS FOLDER" << Qt::endl;
    return 2;
  }
  const QDir folder(QDir(arguments[2]).absolutePath());
  writeAircraft(folder);
  std::vector<Case> cases = casesIn(folder);
  std::stable_partition(cases.begin(), cases.end(), [](const Case& one) { return QFile::exists(one.plan); });  // those are quickly done
  double shares = 0.0;
  for (const Case& one : cases) {
    shares += one.condition->share;
  }
  QString table =
      "| mission | conditions | points | unsafe | tour over clearance, least m | glide over clearance, least m | after rolling, least m | arrival, "
      "least m | "
      "glides | km flown | s |\n|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
  Totals totals;
  for (const Case& one : cases) {
    if (const QString line = judge(one, QString::number(static_cast<qint64>(std::ceil(static_cast<double>(points) * one.condition->share / shares))),
                                   folder, totals, say);
        !line.isEmpty()) {
      say << line << Qt::endl;
      table += line + "\n";
      writeAll(folder.filePath("table.md"), (table + sumOf(totals)).toUtf8());  // so that a run that is stopped leaves what it has
    }
  }
  say << "\n" << table << sumOf(totals) << Qt::endl;
  return totals.failed == 0 && totals.unsafe == 0.0 && totals.plans > 0 ? 0 : 1;
}
