// One landing path judged: rules broken one at a time, and random paths against dense samples.

#include "core/safety/ground_path.h"
#include "core/safety/landing_check.h"
#include "tests/core/safety/plan_fixture.h"
#include "tests/support/path_check.h"
#include "tests/support/wind_flight.h"

#include <QTest>

#include <limits>

using namespace vp;

namespace {

using flight::Piece;
using flight::Turn;
using mission::ApproachKind;

/// Altitude at the touchdown point of paths that keep 100 m over ground of 0 m.
constexpr double kEnd = 110.0;

/** A mission, its terrain and a path down to its runway, begun in a turn. */
struct Landing {
  test::PlanFixture fixture;
  mission::LandingPath path;

  Landing() { leadTo({}, kEnd); }

  mission::Mission& mission() { return fixture.mission(); }
  mission::SiteInFrame& site() { return fixture.plan().sites[0]; }
  [[nodiscard]] safety::GlideRates rates() { return {safety::conditionsOf(fixture.plan()), mission().aircraft}; }

  /// A path to a pose beside the touchdown pose, and the last part of the approach that the mission asks for.
  void leadTo(const geo::Pose& beside, double end, double steeper = 1.0) {
    safety::GlideRates loss = rates();
    const geo::Pose gate = safety::gateOf(site().pose, mission().approach);
    path.start = {-1500.0, 900.0, 0.3};
    path.site = 0;
    std::vector<Piece> pieces =
        test::glideTo(path.start, {gate.x + beside.x, gate.y + beside.y, gate.heading + beside.heading}, loss.leastGlideRadius());
    const std::vector<Piece> last = fixture.lastPart(loss);
    pieces.insert(pieces.end(), last.begin(), last.end());
    setPieces(pieces, end, steeper);
  }
  /// Altitudes that lose on each piece what its dearest metre loses, times a factor.
  void setPieces(const std::vector<Piece>& pieces, double end, double steeper = 1.0) {
    safety::GlideRates loss = rates();
    setPieces(loss, pieces, end, steeper);
  }
  void setPieces(safety::GlideRates& loss, const std::vector<Piece>& pieces, double end, double steeper) {
    path.legs.clear();
    std::vector<double> lost;
    geo::Pose pose = path.start;
    for (const Piece& piece : pieces) {
      double dearest = 0.0;
      const safety::LossAlong along = loss.along(pose.heading, piece);
      for (double at = 0.0; at < piece.length;) {
        const double next = std::min(along.nextBreak(at), piece.length);
        dearest = std::max(dearest, along.rateAt(0.5 * (at + next)));
        at = next;
      }
      lost.push_back(steeper * dearest * piece.length);
      pose = safety::endOfPiece(pose, piece);
    }
    double altitude = end;
    for (const double one : lost) {
      altitude += one;
    }
    path.altitude = altitude;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      altitude -= lost[i];
      path.legs.push_back({pieces[i], altitude});
    }
  }
  void shift(double metres) {
    path.altitude += metres;
    for (mission::LandingLeg& leg : path.legs) {
      leg.endAltitude += metres;
    }
  }
  /// The site as mission and plan have it.
  template <typename Change>
  void changeSite(const Change& change) {
    change(site().site);
    for (mission::LandingSite& given : mission().sites) {
      change(given);
    }
  }
  [[nodiscard]] safety::LandingReport report(const terrain::ElevationGrid& grid) const {
    const mission::Plan& plan = fixture.builder.plan();
    return safety::checkLanding({plan.mission, plan.sites, plan.frameOrigin, grid}, path);
  }
  [[nodiscard]] safety::LandingReport report() const { return report(fixture.terrain.grid()); }
};

using Change = std::function<void(Landing&)>;

safety::SafetyReport asPlans(const safety::LandingReport& report) {
  return {report.findings, report.margins, {}};
}

/// Of a straight leg in the middle of the path.
std::size_t straightLeg(const Landing& l) {
  for (std::size_t i = 0; i < l.path.legs.size(); ++i) {
    if (l.path.legs[i].piece.turn == Turn::Straight && l.path.legs[i].piece.length > 500.0) {
      return i;
    }
  }
  return 0;
}

void approach(Landing& l, ApproachKind kind) {
  l.mission().approach.kind = kind;
  l.leadTo({}, kEnd);
}

}  // namespace

Q_DECLARE_METATYPE(Change)

class TestLandingCheck : public QObject {
  Q_OBJECT

  static void row(const char* name, const char* rule, Change change) { QTest::newRow(name) << QString(rule) << change; }

  static void addPathRows() {
    row("turn tighter than the aircraft's", "glide.radius", [](Landing& l) { l.path.legs[0].piece.radius -= 0.1; });
    row("flatter than the glide", "landing.slope", [](Landing& l) { l.setPieces(test::glideTo(l.path.start, l.site().pose, 70.0), kEnd, 0.999); });
    row("level", "landing.slope", [](Landing& l) { l.path.altitude = l.path.legs[0].endAltitude; });
    row("steeper than the glide, no steeper descent known", "landing.slope", [](Landing& l) { l.leadTo({}, kEnd, 1.501); });
    row("steeper than the steepest descent", "landing.slope", [](Landing& l) {
      l.mission().aircraft.steepestDescent = Angle::degrees(6.0);
      l.path.legs.push_back({{Turn::Straight, 0.0, 0.0}, kEnd});
      l.path.legs[straightLeg(l)].endAltitude -= 60.0;
      for (std::size_t i = straightLeg(l) + 1; i < l.path.legs.size(); ++i) {
        l.path.legs[i].endAltitude -= 60.0;
      }
      l.shift(60.0);
    });
    row("change of altitude on the spot", "landing.slope", [](Landing& l) { l.path.legs.push_back({{Turn::Straight, 0.0, 0.0}, kEnd - 0.01}); });
    row("flatter than the glide against the wind", "landing.slope", [](Landing& l) {
      l.mission().wind = {test::layerOf(0.0, 90.0, 10.0, 2.0, 6.0)};
      l.leadTo({}, kEnd);
      l.mission().wind[0].wind.spread_deg = 20.0;
    });
    row("in the wind of another height", "landing.slope", [](Landing& l) {
      l.mission().wind = {test::layerOf(0.0, 270.0, 10.0, 0.0, 4.0)};
      l.leadTo({}, kEnd);
      l.mission().wind.push_back(test::layerOf(700.0, 90.0, 10.0, 0.0, 4.0));
    });
    row("ground a centimetre too high", "glide.clearance", [](Landing& l) {
      const mission::LandingLeg& leg = l.path.legs[straightLeg(l)];
      geo::Pose pose = l.path.start;
      for (std::size_t i = 0; i < straightLeg(l); ++i) {
        pose = safety::endOfPiece(pose, l.path.legs[i].piece);
      }
      const double slope = (l.path.legs[straightLeg(l) - 1].endAltitude - leg.endAltitude) / leg.piece.length;
      const terrain::ElevationGrid grid = l.fixture.terrain.grid();
      const geo::Point under = safety::poseOn(pose, leg.piece, 400.0).point();
      double leaves = 400.0;  // its cell
      const auto cellOf = [](double value) { return std::floor(value / test::TestTerrain::kCell); };
      for (geo::Point at = under; cellOf(at.x) == cellOf(under.x) && cellOf(at.y) == cellOf(under.y); leaves += 0.001) {
        at = safety::poseOn(pose, leg.piece, leaves).point();
      }
      l.fixture.terrain.setCell(under.x, under.y, static_cast<float>(l.path.legs[straightLeg(l) - 1].endAltitude - slope * leaves - 100.0 + 0.01));
    });
    row("ground of unknown height", "terrain.unknown",
        [](Landing& l) { l.fixture.terrain.setCell(l.path.start.x, l.path.start.y, std::numeric_limits<float>::quiet_NaN()); });
    row("off the map", "terrain.unknown", [](Landing& l) {
      l.path.site = -1;
      l.setPieces({{Turn::Straight, 0.0, 9000.0}}, 500.0);
    });
  }

  static void addEndRows() {
    row("6 cm beside the touchdown point", "glide.site", [](Landing& l) { l.leadTo({0.06, 0.0, 0.0}, kEnd); });
    row("off the landing course", "glide.heading", [](Landing& l) { l.leadTo({0.0, 0.0, 0.0015}, kEnd); });
    row("too low on arrival", "glide.arrival", [](Landing& l) { l.mission().safety.arrivalMargin = Length::fromSi(kEnd + 0.01); });
    row("excluded site", "site.excluded", [](Landing& l) { l.mission().siteFilter.exclude = {l.site().site.id}; });
    row("tailwind over the limit", "site.excluded", [](Landing& l) {
      l.mission().aircraft.maxTailwind = Speed::fromSi(3.0);
      l.mission().wind = {test::layerOf(0.0, 270.0, 0.0, 3.5, 3.5)};
      l.leadTo({}, kEnd);
    });
    row("site beside its own place", "site.position", [](Landing& l) {
      l.site().pose.x += 0.6;
      l.leadTo({}, kEnd);
    });
    row("site that is not the mission's", "site.data", [](Landing& l) { l.site().site.elevation = geo::HeightMsl::fromMetres(0.1); });
    row("runway too short", "site.length", [](Landing& l) {
      l.mission().aircraft.landingDistance = Length::fromSi(500.0);
      l.changeSite([](mission::LandingSite& site) { site.length = Length::fromSi(400.0); });
    });
    row("final too short", "approach.straight", [](Landing& l) {
      approach(l, ApproachKind::Straight);
      l.mission().approach.finalLength = Length::fromSi(1001.0);
    });
    row("nearly a circle", "approach.circle", [](Landing& l) {
      approach(l, ApproachKind::Overhead);
      l.path.legs.back().piece.length -= 0.01;
    });
    row("low at the key", "approach.key", [](Landing& l) {
      approach(l, ApproachKind::Overhead);
      l.mission().approach.keyHeight = Length::fromSi(l.path.legs[l.path.legs.size() - 2].endAltitude + 0.01);
    });
    row("whole clearance at the gate", "glide.clearance", [](Landing& l) {
      l.mission().approach.surfaceSlope = 0.2;
      l.mission().safety.arrivalMargin = Length::fromSi(0.0);
      approach(l, ApproachKind::Straight);
      l.shift(100.0 - l.path.legs[l.path.legs.size() - 2].endAltitude - 0.01);
    });
  }

  static void addInputRows() {
    row("no number", "plan.number", [](Landing& l) { l.path.legs[1].endAltitude = std::nan(""); });
    row("too high for the arithmetic", "plan.number", [](Landing& l) { l.shift(1e6); });
    row("no such site", "plan.index", [](Landing& l) { l.path.site = 1; });
    row("site below -1", "plan.index", [](Landing& l) { l.path.site = -2; });
    row("straight with a radius", "plan.piece", [](Landing& l) { l.path.legs.push_back({{Turn::Straight, 100.0, 0.0}, kEnd}); });
    row("no such setting", "settings", [](Landing& l) { l.mission().safety.clearance = Length::fromSi(-1.0); });
    row("no such aircraft", "aircraft.profile", [](Landing& l) { l.mission().aircraft.mass_kg = -1.0; });
    row("wind that blows it backwards", "wind.data", [](Landing& l) { l.mission().wind = {test::layerOf(0.0, 90.0, 0.0, 40.0, 40.0)}; });
  }

private slots:
  void path_breaksExactlyItsRule_data() {
    QTest::addColumn<QString>("rule");
    QTest::addColumn<Change>("change");
    addPathRows();
    addEndRows();
    addInputRows();
  }

  void path_breaksExactlyItsRule() {
    QFETCH(QString, rule);
    QFETCH(Change, change);
    Landing landing;
    change(landing);
    const safety::LandingReport report = landing.report();
    QVERIFY2(QString::fromStdString(test::rulesBroken(asPlans(report))) == rule, test::textsOfFindings(asPlans(report)));
    QVERIFY(!report.isSafe() && !report.isFlyable());
  }

  void path_isSafe_data() {
    QTest::addColumn<Change>("change");
    QTest::newRow("as it is") << Change([](Landing&) {});
    QTest::newRow("in wind") << Change([](Landing& l) {
      l.mission().wind = {test::layerOf(0.0, 90.0, 30.0, 2.0, 6.0)};
      l.leadTo({}, kEnd);
    });
    QTest::newRow("turning at once, whatever the reaction") << Change([](Landing& l) {
      l.mission().safety.reactionTime = Duration::fromSi(10.0);
      l.mission().safety.reactionLoss = Length::fromSi(50.0);
    });
    QTest::newRow("steeper, where the aircraft can") << Change([](Landing& l) {
      l.mission().aircraft.steepestDescent = Angle::degrees(20.0);
      l.leadTo({}, kEnd, 1.3);
    });
    QTest::newRow("down a hold of whole circles") << Change([](Landing& l) {
      std::vector<Piece> pieces{{Turn::Left, 100.0, 3.0 * 200.0 * Angle::kPi}};
      for (const mission::LandingLeg& leg : l.path.legs) {
        pieces.push_back(leg.piece);
      }
      l.setPieces(pieces, kEnd);
    });
    QTest::newRow("straight in over an obstacle surface") << Change([](Landing& l) {
      l.mission().approach.surfaceSlope = 0.05;
      l.mission().safety.arrivalMargin = Length::fromSi(0.0);
      approach(l, ApproachKind::Straight);
      l.shift(100.0 - l.path.legs[l.path.legs.size() - 2].endAltitude);
    });
    QTest::newRow("overhead, high enough at the key") << Change([](Landing& l) {
      approach(l, ApproachKind::Overhead);
      l.mission().approach.keyHeight = Length::fromSi(l.path.legs[l.path.legs.size() - 2].endAltitude);
    });
    QTest::newRow("overhead, the circle in legs") << Change([](Landing& l) {
      approach(l, ApproachKind::Overhead);
      const mission::LandingLeg circle = l.path.legs.back();
      const double above = l.path.legs[l.path.legs.size() - 2].endAltitude;
      l.path.legs.pop_back();
      for (int part = 1; part <= 4; ++part) {
        l.path.legs.push_back(
            {{circle.piece.turn, circle.piece.radius, 0.25 * circle.piece.length}, above + 0.25 * part * (circle.endAltitude - above)});
      }
    });
    QTest::newRow("in the wind of each height") << Change([](Landing& l) {
      l.mission().wind = {test::layerOf(0.0, 90.0, 10.0, 0.0, 4.0), test::layerOf(1500.0, 100.0, 10.0, 0.0, 3.0)};
      l.leadTo({}, kEnd);  // the dearest of all heights
      l.mission().aircraft.steepestDescent = Angle::degrees(30.0);
    });
  }

  void path_isSafe() {
    QFETCH(Change, change);
    Landing landing;
    change(landing);
    const safety::LandingReport report = landing.report();
    QVERIFY2(report.isSafe() && report.isFlyable(), test::textsOfFindings(asPlans(report)));
  }

  void pathToNoRunway_isFlyable_andNeverSafe() {
    Landing landing;
    landing.path.site = -1;
    landing.path.legs.pop_back();
    landing.mission().safety.arrivalMargin = Length::fromSi(1000.0);
    const safety::LandingReport report = landing.report();
    QVERIFY2(report.isFlyable() && !report.isSafe() && !report.reachesRunway, test::textsOfFindings(asPlans(report)));
    QVERIFY(std::isnan(test::marginOf(asPlans(report), "glide.arrival")));
    landing.shift(-200.0);
    QVERIFY(!landing.report().isFlyable());
  }

  void overheadCircle_inLegsThatAreNoWholeCircle_isNone() {
    Landing landing;
    approach(landing, ApproachKind::Overhead);
    const mission::LandingLeg circle = landing.path.legs.back();
    landing.path.legs.back().piece.turn = circle.piece.turn == Turn::Left ? Turn::Right : Turn::Left;  // half of it the other way round
    landing.path.legs.back().piece.length *= 0.5;
    landing.path.legs.push_back({{circle.piece.turn, circle.piece.radius, 0.5 * circle.piece.length}, circle.endAltitude});
    QVERIFY(QString::fromStdString(test::rulesBroken(asPlans(landing.report()))).contains("approach.circle"));
  }

  void shortfallsOfManyLegs_addUp() {
    Landing landing;
    const std::vector<Piece> hundred(100, {Turn::Straight, 0.0, 10.0});
    landing.path.site = -1;
    landing.setPieces(hundred, 300.0, 1.0 - 1.1e-5);  // a hundredth of a millimetre each
    QVERIFY2(landing.report().isFlyable(), test::textsOfFindings(asPlans(landing.report())));
    landing.setPieces(hundred, 300.0, 1.0 - 1.5e-5);
    QVERIFY(!landing.report().isFlyable());
  }

  /// Legs of random slopes in random winds over random ground: the margin against samples of a metre, and slopes against what winds of the set cost.
  void randomPaths_againstDenseSamples_areJudgedAlike() {
    constexpr std::uint64_t kSeed = 20270301;
    constexpr int kSets = 50;
    qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
    test::WindCases cases(kSeed);
    int flyable = 0;
    int flat = 0;
    for (int set = 0; set < kSets; ++set) {
      Landing landing;
      landing.path.site = -1;
      const bool isWindy = set % 10 == 9;  // each path then has tables of its own
      if (isWindy) {
        landing.mission().wind = cases.layers(1);
      }
      landing.mission().aircraft.steepestDescent = Angle::degrees(40.0);
      for (int cell = 0; cell < 400; ++cell) {
        const float height = static_cast<float>(500.0 * cases.unit() * cases.unit());
        landing.fixture.terrain.setCell(50.0 * cases.below(80) - 1990.0, 50.0 * cases.below(80) - 1990.0, height);
      }
      const terrain::ElevationGrid grid = landing.fixture.terrain.grid();
      safety::GlideRates rates = landing.rates();
      const double radius = rates.leastGlideRadius();
      for (int number = 0; number < (isWindy ? 30 : 230); ++number) {
        std::vector<Piece> pieces;
        for (int count = 1 + cases.below(4); count > 0; --count) {
          const auto turn = static_cast<Turn>(cases.below(3) - 1);
          pieces.push_back({turn, turn == Turn::Straight ? 0.0 : radius * (1.0 + cases.below(2)), 20.0 + 400.0 * cases.unit()});
        }
        landing.path.start = {1000.0 * (cases.unit() - 0.5), 1000.0 * (cases.unit() - 0.5), 6.0 * cases.unit()};
        landing.setPieces(rates, pieces, 100.0 + 500.0 * cases.unit(), cases.below(4) == 0 ? 0.8 + 0.2 * cases.unit() : 1.0 + 0.2 * cases.unit());
        const safety::LandingReport report = landing.report(grid);
        double sampled = 1e9;
        double above = 1e9;  // with the ground near the sample
        bool isFlat = false;
        geo::Pose pose = landing.path.start;
        double from = landing.path.altitude;
        for (const mission::LandingLeg& leg : landing.path.legs) {
          const int steps = 1 + static_cast<int>(leg.piece.length);
          const double slope = (from - leg.endAltitude) / leg.piece.length;
          for (int i = 0; i <= steps; ++i) {
            const double at = leg.piece.length * i / steps;
            const geo::Pose there = safety::poseOn(pose, leg.piece, at);
            sampled = std::min(sampled, from - slope * at - grid.upperAt(there.point()) - 100.0);
            above = std::min(above, from - slope * at - test::groundNear(grid, there.x, there.y, 1.0) - 100.0);
            const air::Wind wind = landing.mission().wind.empty() ? air::Wind() : cases.wind(landing.mission().wind);
            isFlat = isFlat || slope < test::lossIn(landing.mission().aircraft, wind, there.heading, leg.piece.radius) * (1.0 - 1e-4);
          }
          from = leg.endAltitude;
          pose = safety::endOfPiece(pose, leg.piece);
        }
        const double margin = test::marginOf(asPlans(report), "glide.clearance");
        const std::string broken = test::rulesBroken(asPlans(report));
        const QByteArray label = QString("set %1, path %2: margin %3, sampled %4, above %5, %6")
                                     .arg(set)
                                     .arg(number)
                                     .arg(margin)
                                     .arg(sampled)
                                     .arg(above)
                                     .arg(QString::fromStdString(broken))
                                     .toUtf8();
        QVERIFY2(margin <= sampled + 1e-6 && margin >= above - 1.0, label);
        QVERIFY2((broken.find("glide.clearance") != std::string::npos) == (margin < 0.0), label);
        QVERIFY2(!isFlat || broken.find("landing.slope") != std::string::npos, label);
        flat += isFlat ? 1 : 0;
        flyable += report.isFlyable() ? 1 : 0;
      }
    }
    qInfo("%d flyable, %d flatter than a glide in one of the winds tried", flyable, flat);
    QVERIFY(flyable > 1000 && flat > 1000);
  }
};

QTEST_APPLESS_MAIN(TestLandingCheck)
#include "tst_landing_check.moc"
