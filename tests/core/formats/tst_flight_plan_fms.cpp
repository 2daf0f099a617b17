// The X-Plane export against the rules of the format and against the plan, by a reader of its own.
#include "core/formats/flight_plan_fms.h"
#include "core/geo/local_frame.h"
#include "tests/core/formats/format_samples.h"

#include <QtTest>

#include <charconv>
#include <cmath>
#include <random>
#include <set>

using namespace vp;
using namespace vp::formats;

namespace {

struct Row {
  std::string ident;
  std::string via;
  double feet = 0.0;
  geo::LatLon place;
  std::string text;
};

struct Fms {
  std::vector<std::string> head;
  std::vector<Row> rows;
};

double numberOf(const std::string& text) {
  double value = std::nan("");
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ptr == text.data() + text.size() ? value : std::nan("");
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

/// Reads a file by the published rules; a broken rule is an empty result.
Fms parse(const std::string& text) {
  Fms fms;
  const std::vector<std::string> lines = split(text, '\n');
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i < 6) {
      fms.head.push_back(lines[i]);
      continue;
    }
    const std::vector<std::string> fields = split(lines[i], ' ');
    if (fields.size() != 6 || fields[0] != "28") {
      return {};
    }
    fms.rows.push_back({fields[1], fields[2], numberOf(fields[3]), {numberOf(fields[4]), numberOf(fields[5])}, lines[i]});
  }
  return fms;
}

/// Distance from a leg and altitude of the leg beside a point.
struct Beside {
  double distance = 0.0;
  double altitude = 0.0;
};
Beside beside(const Row& a, const Row& b, const geo::LocalFrame& frame, geo::Point p) {
  const geo::Point from = frame.toPoint(a.place);
  const geo::Point to = frame.toPoint(b.place);
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double square = dx * dx + dy * dy;
  const double t = square > 0.0 ? std::clamp(((p.x - from.x) * dx + (p.y - from.y) * dy) / square, 0.0, 1.0) : 0.0;
  return {std::hypot(from.x + t * dx - p.x, from.y + t * dy - p.y), (a.feet + t * (b.feet - a.feet)) * kMetresPerFoot};
}

/// Points along the tour, ten per piece, from decision point `first` on, with the plan's altitude.
std::vector<std::pair<geo::Point, double>> denseTour(const mission::Plan& plan, std::size_t first) {
  std::vector<std::pair<geo::Point, double>> points;
  for (std::size_t i = 0; i < plan.tour.size(); ++i) {
    const mission::DecisionPoint& from = plan.tour[(first + i) % plan.tour.size()];
    const mission::DecisionPoint& to = plan.tour[(first + i + 1) % plan.tour.size()];
    for (int k = 0; k < 10; ++k) {
      const geo::Pose pose = flight::poseAfter(from.pose, from.onward, from.onward.length * k / 10.0);
      points.emplace_back(pose.point(), from.altitude + (to.altitude - from.altitude) * k / 10.0);
    }
  }
  return points;
}

/// Walks along the tour and the legs together; "" if every point is within 10 m of a leg that is nowhere below it.
std::string follows(const mission::Plan& plan, std::size_t first, const Fms& fms) {
  const geo::LocalFrame frame(plan.frameOrigin);
  std::size_t leg = 0;
  for (const auto& [point, altitude] : denseTour(plan, first)) {
    bool near = false;
    for (std::size_t next = leg; next < std::min(leg + 3, fms.rows.size() - 1) && !near; ++next) {
      const Beside at = beside(fms.rows[next], fms.rows[next + 1], frame, point);
      if (at.distance < 10.0 && at.altitude >= altitude - 1e-6) {
        near = true;
        leg = next;
      }
    }
    if (!near) {
      return "leg " + std::to_string(leg) + " leaves the tour or passes below it";
    }
  }
  return leg + 2 >= fms.rows.size() ? "" : "the file ends before the tour";
}

}  // namespace

class TestFlightPlanFms : public QObject {
  Q_OBJECT
private slots:
  void file_keepsTheRulesOfTheFormat() {
    const mission::Plan plan = samples::samplePlan();
    const auto text = toFms1100(plan);
    QVERIFY(text);
    QVERIFY(text->find('\r') == std::string::npos && text->back() == '\n');
    const Fms fms = parse(*text);
    QCOMPARE(fms.head.size(), std::size_t{6});
    QCOMPARE(fms.head[0], std::string("I"));
    QCOMPARE(fms.head[1], std::string("1100 Version"));
    QVERIFY(QRegularExpression("^CYCLE [0-9]{4}$").match(QString::fromStdString(fms.head[2])).hasMatch());
    QCOMPARE(fms.head[3], std::string("DEP TARGET_1"));
    QCOMPARE(fms.head[4], std::string("DES TARGET_1"));
    QCOMPARE(fms.head[5], "NUMENR " + std::to_string(fms.rows.size()));
    std::set<std::string> idents;
    for (std::size_t i = 0; i < fms.rows.size(); ++i) {
      const Row& row = fms.rows[i];
      const bool last = i + 1 == fms.rows.size();
      QVERIFY2(QRegularExpression("^28 [A-Z0-9_]{1,10} (DEP|DRCT|DES) [0-9]+\\.000000 -?[0-9]+\\.[0-9]{6} -?[0-9]+\\.[0-9]{6}$")
                   .match(QString::fromStdString(row.text))
                   .hasMatch(),
               row.text.c_str());
      QCOMPARE(row.via, std::string(i == 0 ? "DEP" : last ? "DES" : "DRCT"));
      QVERIFY2(last || idents.insert(row.ident).second, row.text.c_str());
    }
    for (const char* ident : {"TARGET_1", "TARGET_2", "TARGET_3", "TARGET_4"}) {
      QVERIFY(idents.count(ident) == 1);
    }
    QCOMPARE(fms.rows.front().ident, fms.rows.back().ident);
    QCOMPARE(fms.rows.front().feet, fms.rows.back().feet);
    QVERIFY(fms.rows.front().place == fms.rows.back().place);
    QVERIFY2(fms.rows.size() < 60, std::to_string(fms.rows.size()).c_str());
    QCOMPARE(*toFms1100(plan), *text);
  }

  void legs_followTheTourAndAreNeverBelowIt() {
    const mission::Plan plan = samples::samplePlan();
    const auto text = toFms1100(plan);
    QVERIFY(text);
    QCOMPARE(follows(plan, 20, parse(*text)), std::string());  // target 1 is visited at decision point 20
  }

  void legs_ofRandomTours_areNeverBelowThem() {
    const std::uint64_t seed = 7;
    qInfo("seed %llu", static_cast<unsigned long long>(seed));
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> side(300.0, 6000.0);
    std::uniform_real_distribution<double> radius(65.0, 400.0);
    std::uniform_real_distribution<double> step(-12.0, 12.0);
    int points = 0;
    for (int i = 0; i < 60; ++i) {
      mission::Plan plan = samples::samplePlan(side(random), radius(random));
      if (i % 2 == 0) {  // a random walk that ends where it began
        std::vector<double> altitudes{2000.0};
        for (std::size_t k = 0; k < plan.tour.size(); ++k) {
          altitudes.push_back(altitudes.back() + step(random));
        }
        const double drift = (altitudes.back() - altitudes.front()) / static_cast<double>(plan.tour.size());
        for (std::size_t k = 0; k < plan.tour.size(); ++k) {
          plan.tour[k].altitude = altitudes[k] - drift * static_cast<double>(k);
        }
      }
      const auto text = toFms1100(plan);
      QVERIFY(text);
      std::size_t first = 0;
      while (plan.tour[first].target < 0) {
        ++first;
      }
      const std::string fault = follows(plan, first, parse(*text));
      QVERIFY2(fault.empty(), fault.c_str());
      points += static_cast<int>(plan.tour.size()) * 10;
    }
    QVERIFY(points >= 10000);
  }

  void altitudes_areRoundedUp() {
    mission::Plan plan = samples::samplePlan();
    for (mission::DecisionPoint& point : plan.tour) {
      point.altitude = 304.8 + 0.1;  // 1000.3 ft
    }
    for (const Row& row : parse(*toFms1100(plan)).rows) {
      QCOMPARE(row.feet, 1001.0);
    }
  }

  void names_becomeUniqueIdents() {
    mission::Plan plan = samples::samplePlan();
    const char* const names[] = {"V001", "Flüela Pass north", "Flüela Pass south", ""};
    for (std::size_t i = 0; i < 4; ++i) {
      plan.targets[i].target.name = names[i];
    }
    const Fms fms = parse(*toFms1100(plan));
    std::set<std::string> idents;
    for (std::size_t i = 0; i + 1 < fms.rows.size(); ++i) {
      QVERIFY(fms.rows[i].ident.size() <= 10 && !fms.rows[i].ident.empty());
      QVERIFY2(idents.insert(fms.rows[i].ident).second, fms.rows[i].ident.c_str());
    }
    QVERIFY(idents.count("V001") == 1 && idents.count("FL__ELA_PA") == 1 && idents.count("FL__ELA__2") == 1 && idents.count("T4") == 1);
  }

  void planWithoutTour_isRefused() {
    mission::Plan plan = samples::samplePlan();
    plan.tour.clear();
    const auto text = toFms1100(plan);
    QVERIFY(!text);
    VP_CONTAINS(text.error().what, {"no tour to export", "at least one target"});
  }
};

QTEST_APPLESS_MAIN(TestFlightPlanFms)
#include "tst_flight_plan_fms.moc"
