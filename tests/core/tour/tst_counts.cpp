// How much work planning is, in counts that do not depend on the machine: they may not grow by more than a fifth unnoticed.
// tests/core/tour/counts.json holds what they were; `tst_counts --renew` writes what they are now into it.
#include "core/flight/dubins.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/landing/lattice_roadmap.h"
#include "core/tour/gtsp.h"
#include "core/tour/replan.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <functional>
#include <string>
#include <utility>
#include <vector>

using namespace vp;

namespace {

constexpr double kMayGrow = 1.2;  // issue: a count that grows by more than 20 % fails
const QString kFile = QStringLiteral(VOLPLANE_SOURCE_DIR "/tests/core/tour/counts.json");

struct Row {
  const char* name;
  const char* mission;
  int headings;
  mission::Method method;
};
constexpr Row kRows[] = {
    {"LAZY n=5 k=4", "mountain-n5.vpm", 4, mission::Method::Lazy},        {"LAZY n=5 k=8", "mountain-n5.vpm", 8, mission::Method::Lazy},
    {"BASE n=5 k=4", "mountain-n5.vpm", 4, mission::Method::Base},        {"LAZY n=20 k=8", "mountain-n20.vpm", 8, mission::Method::Lazy},
    {"LAZY alpine n=10 k=8", "alpine-n10.vpm", 8, mission::Method::Lazy},
};

Result<tour::PlanInput> load(const char* name) {
  const std::string folder = VOLPLANE_SOURCE_DIR "/maps";
  const Result<mission::Mission> mission = formats::readMission(folder + "/" + name);
  if (!mission) {
    return forward(mission);
  }
  const Result<formats::LoadedMission> loaded = formats::loadMission(*mission, folder, Job{});
  if (!loaded) {
    return forward(loaded);
  }
  return tour::PlanInput{loaded->mission, loaded->frame, loaded->terrain, loaded->terrainFiles, loaded->sites, loaded->targets, "counts"};
}

/// Counts of planning a mission, by name; empty if it cannot be planned.
QJsonObject countsOf(const Row& row) {
  Result<tour::PlanInput> input = load(row.mission);
  if (!input) {
    qWarning("%s", input.error().message().c_str());
    return {};
  }
  input->mission.planner.headings = row.headings;
  input->mission.planner.method = row.method;
  const Result<mission::Plan> plan = tour::planTour(*input, Job{});
  if (!plan) {
    qWarning("%s", plan.error().message().c_str());
    return {};
  }
  landing::LatticeStatistics lattice;
  if (!landing::buildLatticeRoadmap(tour::makeWorld(*input), {tour::roadmapArea(*input), std::nullopt}, Job{}, &lattice)) {
    return {};
  }
  const mission::PlanMetrics& m = plan->metrics;
  return {{"safe-altitude queries", static_cast<double>(m.safeQueries)},
          {"tour solutions", static_cast<double>(m.tourSolutions)},
          {"safe segments", static_cast<double>(m.safeSegments)},
          {"changes tried by refinement", static_cast<double>(m.movesTried)},
          {"lattice poses settled", static_cast<double>(lattice.settled)},
          {"lattice ground tests", static_cast<double>(lattice.groundTests)},
          {"lattice glides against the ground", static_cast<double>(lattice.legs)}};
}

/// Work of planning again after each of three targets has moved, added up.
QJsonObject countsOfReplanning() {
  Result<tour::PlanInput> input = load("mountain-n20.vpm");
  tour::Planner planner;
  if (!input || !planner.plan(*input, Job{})) {
    return {};
  }
  double queries = 0.0;
  double tried = 0.0;
  double reused = 0.0;
  for (std::size_t t = 0; t < 3; ++t) {
    mission::TargetInFrame& target = input->targets[t];
    const double height = target.altitude - input->terrain->upperAt(target.point);
    target.target.position = input->frame.toLatLon({target.point.x + 100.0, target.point.y - 50.0});
    target.point = input->frame.toPoint(target.target.position);
    target.altitude = input->terrain->upperAt(target.point) + height;
    input->mission.targets[t] = target.target;
    const Result<mission::Plan> plan = planner.plan(*input, Job{});
    if (!plan) {
      qWarning("%s", plan.error().message().c_str());
      return {};
    }
    queries += static_cast<double>(plan->metrics.safeQueries);
    tried += static_cast<double>(plan->metrics.movesTried);
    reused += planner.reused().tour && planner.reused().roadmap ? 1.0 : 0.0;
  }
  return {{"safe-altitude queries", queries}, {"changes tried", tried}, {"plans begun afresh", 3.0 - reused}};
}

/// Rounds of the tour solver alone on Dubins lengths between the targets of a mission, eight headings each.
QJsonObject countsOfTourSolver() {
  constexpr int kHeadings = 8;
  const Result<tour::PlanInput> input = load("mountain-n20.vpm");
  if (!input) {
    return {};
  }
  const double radius = aircraft::GlideModel(input->mission.aircraft).tourRadius();
  tour::GtspProblem problem;
  std::vector<geo::Pose> poses;
  for (const mission::TargetInFrame& target : input->targets) {
    problem.sets.emplace_back();
    for (int h = 0; h < kHeadings; ++h) {
      problem.sets.back().push_back(problem.nodes++);
      poses.push_back({target.point.x, target.point.y, 2.0 * Angle::kPi * h / kHeadings});
    }
  }
  for (const geo::Pose& from : poses) {
    for (const geo::Pose& to : poses) {
      problem.cost.push_back(flight::shortestDubins(from, to, radius).length());
    }
  }
  const Result<tour::GtspSolution> solution = tour::solveGtsp(problem, {}, Job{});
  return solution ? QJsonObject{{"rounds", static_cast<double>(solution->rounds)}} : QJsonObject{};
}

/// All that is counted, by name.
std::vector<std::pair<const char*, std::function<QJsonObject()>>> measures() {
  std::vector<std::pair<const char*, std::function<QJsonObject()>>> all;
  for (const Row& row : kRows) {
    all.emplace_back(row.name, [row] { return countsOf(row); });
  }
  all.emplace_back("one target moved n=20 k=8", countsOfReplanning);
  all.emplace_back("tour solver n=20 k=8", countsOfTourSolver);
  return all;
}

QJsonObject readCounts() {
  QFile file(kFile);
  return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

}  // namespace

class TestCounts : public QObject {
  Q_OBJECT

private slots:
  void planning_costsNoMoreThanItDid_data() {
    QTest::addColumn<int>("row");
    const auto all = measures();
    for (std::size_t i = 0; i < all.size(); ++i) {
      QTest::newRow(all[i].first) << static_cast<int>(i);
    }
  }

  void planning_costsNoMoreThanItDid() {
    QFETCH(int, row);
    const auto [title, measure] = measures()[static_cast<std::size_t>(row)];
    const QJsonObject known = readCounts().value(QLatin1String(title)).toObject();
    const QJsonObject now = measure();
    QVERIFY(!now.isEmpty());
    QCOMPARE(known.keys(), now.keys());
    for (const QString& name : now.keys()) {
      const double before = known.value(name).toDouble();
      const double after = now.value(name).toDouble();
      if (after < before) {
        qInfo("%s: %g, was %g", qPrintable(name), after, before);
      }
      QVERIFY2(after <= kMayGrow * before, qPrintable(QString("%1: %2, was %3").arg(name).arg(after).arg(before)));
    }
  }
};

int main(int argc, char** argv) {
  if (argc == 2 && std::string(argv[1]) == "--renew") {
    QJsonObject counts;
    for (const auto& [title, measure] : measures()) {
      counts.insert(QLatin1String(title), measure());
    }
    QFile file(kFile);
    return file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(counts).toJson()) > 0 ? 0 : 1;
  }
  TestCounts test;
  return QTest::qExec(&test, argc, argv);
}

#include "tst_counts.moc"
