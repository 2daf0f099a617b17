// The worlds of Figs. 3 and 4 of Vana, Faigl, Slama 2020, from mission file to safe altitude, against what their
// captions and closed form say. The figures' colours cannot be read off, so the closed form is the reference: above flat
// ground the least loss is that of the best single Dubins glide, found here over all words and radii by itself.
#include "core/base/quantity.h"
#include "core/flight/curve_sampling.h"
#include "core/flight/dubins.h"
#include "core/formats/mission_file.h"
#include "core/formats/mission_loader.h"
#include "core/landing/rrt_star.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <string>

using namespace vp;

namespace {

constexpr unsigned kSeed = 34;
constexpr double kBlock = 450.0;   // m, caption of Fig. 4
constexpr double kInner = 4800.0;  // m from the middle: poses keep the turns of their glides inside the map
constexpr double kMixed = 15.0;    // m that glides of several banks may save over the best single one, see flatGround_...
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// What the tests ask of a world.
struct Figure {
  landing::World world;
  landing::TreeRoadmap roadmap;
};

/// @param samples  -1 for those that the mission names
std::optional<Figure> load(const std::string& name, int samples = -1) {
  const std::string folder = VOLPLANE_SOURCE_DIR "/maps";
  const auto mission = formats::readMission(folder + "/" + name + ".vpm");
  if (!mission) {
    qWarning("%s", mission.error().message().c_str());
    return std::nullopt;
  }
  const auto loaded = formats::loadMission(*mission, folder, Job{});
  if (!loaded) {
    qWarning("%s", loaded.error().message().c_str());
    return std::nullopt;
  }
  Figure figure;
  figure.world.terrain = terrain::TerrainPyramid(loaded->terrain);
  figure.world.glide = aircraft::GlideModel(mission->aircraft);
  figure.world.sites = loaded->sites;
  figure.world.clearance = mission->safety.clearance.si();
  figure.world.arrivalMargin = mission->safety.arrivalMargin.si();
  landing::RrtStarOptions options;
  options.area = loaded->terrain->extent();
  options.samples = samples >= 0 ? samples : mission->planner.roadmapSamples.value_or(0);
  options.seed = mission->planner.seed;
  auto roadmap = landing::buildRrtStarRoadmap(figure.world, options, Job{});
  if (!roadmap) {
    qWarning("%s", roadmap.error().message().c_str());
    return std::nullopt;
  }
  figure.roadmap = std::move(*roadmap);
  return figure;
}

/// Height lost on the best single Dubins glide, without ground: all six words at all radii.
double bestDirectLoss(const landing::World& world, const geo::Pose& from, const geo::Pose& to) {
  double best = kInfinite;
  for (const double radius : world.glide.glideRadii()) {
    for (const flight::Word word : flight::kWords) {
      if (const auto path = flight::dubinsWord(from, to, radius, word)) {
        best = std::min(best, path->straight() * world.glide.straightLoss() + path->turned() * world.glide.lossAt(radius));
      }
    }
  }
  return best;
}

/// Required altitude at each site's glide, site by site; ground matters nowhere but at the site.
double directAltitude(const landing::World& world, std::size_t site, const geo::Pose& from) {
  return world.sites[site].site.elevation.metres() + bestDirectLoss(world, from, world.sites[site].pose);
}

class Poses {
public:
  explicit Poses(unsigned seed) : engine_(seed) {}
  geo::Pose next() { return {place_(engine_), place_(engine_), heading_(engine_)}; }

private:
  std::mt19937_64 engine_;
  std::uniform_real_distribution<double> place_{-kInner, kInner};
  std::uniform_real_distribution<double> heading_{0.0, 2.0 * Angle::kPi};
};

QString at(const geo::Pose& pose, double a, double b) {
  return QString("(%1, %2, %3): %4 against %5").arg(pose.x).arg(pose.y).arg(pose.heading).arg(a).arg(b);
}

}  // namespace

class TestFigures : public QObject {
  Q_OBJECT

private:
  std::optional<Figure> flat_;
  std::optional<Figure> two_;
  std::optional<Figure> blocks_;
  landing::QueryScratch scratch_;

  double altitude(const Figure& figure, const geo::Pose& pose, int* site = nullptr) {
    const auto answer = figure.roadmap.query(figure.world, pose, scratch_);
    if (!answer) {
      return kInfinite;
    }
    if (site != nullptr) {
      *site = answer->site;
    }
    return answer->altitude;
  }

private slots:
  void initTestCase() {
    qInfo("seed %u", kSeed);
    flat_ = load("flat");
    two_ = load("two-runways");
    blocks_ = load("three-blocks");
    QVERIFY(flat_ && two_ && blocks_);
    QCOMPARE(flat_->roadmap.nodes().size(), std::size_t{7501});
    QCOMPARE(two_->world.sites.size(), std::size_t{2});
  }

  void site_atItsOwnPose_needsItsElevation() {
    QCOMPARE(altitude(*flat_, flat_->world.sites[0].pose), 0.0);
    QCOMPARE(altitude(*blocks_, blocks_->world.sites[0].pose), 0.0);
    QCOMPARE(altitude(*two_, two_->world.sites[0].pose), 0.0);
    QCOMPARE(altitude(*two_, two_->world.sites[1].pose), 100.0);
  }

  void flatGround_givesTheBestGlide() {
    // Fig. 4, above. Glides of different bank one after the other may lose less than the best single one, never more.
    // How much less: nothing where straight flight prevails, some metres close to the runway where turning does. So the
    // answer is also held against what its own glide loses, and against what no glide can go below.
    const landing::World& world = flat_->world;
    double leastPerRadian = kInfinite;
    for (const double radius : world.glide.glideRadii()) {
      leastPerRadian = std::min(leastPerRadian, world.glide.lossAt(radius) * radius);
    }
    const geo::Pose& site = world.sites[0].pose;
    Poses poses(kSeed);
    double largest = 0.0;
    for (int i = 0; i < 10'000; ++i) {
      const geo::Pose pose = poses.next();
      const auto answer = flat_->roadmap.query(world, pose, scratch_);
      QVERIFY(answer);
      const double found = answer->altitude;
      double flown = 0.0;
      geo::Pose end = pose;
      for (const flight::Piece& piece : flat_->roadmap.witnessPieces(*answer)) {
        flown += piece.length * world.glide.lossAt(piece.radius);
        end = flight::endOf(end, piece);
      }
      QVERIFY2(std::abs(found - flown) < 1e-6, qPrintable(at(pose, found, flown)));
      QVERIFY2(geo::distance(end.point(), site.point()) < 1e-3 && std::abs(wrapPi(end.heading - site.heading)) < 1e-6,
               qPrintable(at(end, site.x, site.y)));
      const double direct = directAltitude(world, 0, pose);
      const double bound = std::max(geo::distance(pose.point(), site.point()) * world.glide.straightLoss(),
                                    std::abs(wrapPi(pose.heading - site.heading)) * leastPerRadian);
      QVERIFY2(found <= direct + 1e-6, qPrintable(at(pose, found, direct)));
      QVERIFY2(found >= bound - 1e-6, qPrintable(at(pose, found, bound)));
      largest = std::max(largest, direct - found);
    }
    qInfo("mixed banks save at most %.3f m", largest);
    QVERIFY2(largest < kMixed, qPrintable(QString::number(largest)));
  }

  void straightIn_onFlatGround_losesTheGlideAngleOfThePaper() {
    // Table 1: 4.90 degrees. 4 km out on the approach that is 343 m.
    const double found = altitude(*flat_, {-4000.0, 0.0, 0.0});
    QVERIFY2(std::abs(found - 4000.0 * std::tan(Angle::degrees(4.90).radians())) < 1.0, qPrintable(QString::number(found)));
    // Behind the runway the aircraft has to come back and turn twice: more than the distance, for every heading.
    for (int h = 0; h < 16; ++h) {
      const double behind = altitude(*flat_, {4000.0, 0.0, h * Angle::kPi / 8.0});
      QVERIFY2(behind > found + 20.0, qPrintable(QString::number(behind)));
    }
  }

  void twoRunways_eachPoseGlidesToTheLowerOne() {
    // Fig. 3: colour is the airport, which is the one that needs less; no blocks, so closed form says which.
    const landing::World& world = two_->world;
    Poses poses(kSeed + 1);
    int nearBorder = 0;
    std::array<int, 2> chosen{};
    for (int i = 0; i < 10'000; ++i) {
      const geo::Pose pose = poses.next();
      int site = -1;
      const double found = altitude(*two_, pose, &site);
      const std::array<double, 2> direct{directAltitude(world, 0, pose), directAltitude(world, 1, pose)};
      // The plateau of the second site may stand in the way of a low glide to the first.
      const double lower = std::min(direct[0], direct[1]);
      QVERIFY2(found >= lower - kMixed, qPrintable(at(pose, found, lower)));
      if (std::abs(direct[0] - direct[1]) < kMixed) {
        ++nearBorder;
        continue;
      }
      const int expected = direct[0] < direct[1] ? 0 : 1;
      if (lower < 400.0 && found > lower + 1e-6) {
        continue;  // held up by the plateau, and then the other runway may be the better one
      }
      QVERIFY2(site == expected, qPrintable(at(pose, direct[0], direct[1])));
      QVERIFY2(found <= lower + 1e-6, qPrintable(at(pose, found, lower)));
      ++chosen[static_cast<std::size_t>(site)];
    }
    QVERIFY2(chosen[0] > 1000 && chosen[1] > 1000 && nearBorder < 2000,
             qPrintable(QString("%1 %2 %3").arg(chosen[0]).arg(chosen[1]).arg(nearBorder)));
  }

  void twoRunways_borderLiesWhereBothNeedTheSame() {
    // Along lines of one heading the airport changes where the closed forms cross, to the width of 1 m of altitude.
    const landing::World& world = two_->world;
    int changes = 0;
    for (int line = 0; line < 24; ++line) {
      const double heading = line * Angle::kPi / 12.0;
      const double y = -4000.0 + 350.0 * line;
      int before = -1;
      for (double x = -kInner; x <= kInner; x += 10.0) {
        const geo::Pose pose{x, y, heading};
        int site = -1;
        const double found = altitude(*two_, pose, &site);
        if (before >= 0 && site != before) {
          ++changes;
          const double difference = directAltitude(world, 0, pose) - directAltitude(world, 1, pose);
          QVERIFY2(std::abs(difference) < kMixed, qPrintable(at(pose, found, difference)));
        }
        before = site;
      }
    }
    QVERIFY2(changes >= 15, qPrintable(QString::number(changes)));
  }

  void blocks_neverLowerThanFlatGround_andAboveTheBlocks() {
    // Fig. 4, below: same poses on both maps; obstacles only raise.
    Poses poses(kSeed + 2);
    int raised = 0;
    int over = 0;
    for (int i = 0; i < 10'000; ++i) {
      const geo::Pose pose = poses.next();
      const double found = altitude(*blocks_, pose);
      const double direct = directAltitude(blocks_->world, 0, pose);
      QVERIFY2(found >= direct - kMixed, qPrintable(at(pose, found, direct)));
      const double ground = blocks_->world.terrain.grid().upperAt(pose.point());
      QVERIFY(found >= ground);
      over += ground == kBlock ? 1 : 0;
      raised += found > direct + 5.0 ? 1 : 0;
    }
    QVERIFY2(over > 300, qPrintable(QString::number(over)));
    QVERIFY2(raised > over, qPrintable(QString::number(raised)));  // their shadows too
  }

  void behindABlock_isHigherThanOnFlatGround() {
    // From far west the straight way in meets the block across the approach (x from -3000 to -2200): over it the
    // aircraft needs 450 m at its western edge, or the way around. Both cost more than the straight glide.
    for (const double y : {-800.0, -400.0, 0.0, 400.0}) {
      const geo::Pose pose{-3300.0, y, 0.0};
      const double found = altitude(*blocks_, pose);
      const double direct = directAltitude(blocks_->world, 0, pose);
      QVERIFY2(found > direct + 20.0, qPrintable(at(pose, found, direct)));
      QVERIFY2(found <= kBlock + 340.0 * blocks_->world.glide.straightLoss() + 1e-6 + directAltitude(blocks_->world, 0, {-2960.0, y, 0.0}),
               qPrintable(at(pose, found, direct)));
    }
    // North of the northern block (y from 1600 to 2200), heading for the runway over it.
    const geo::Pose north{0.0, 2400.0, -0.5 * Angle::kPi};
    QVERIFY(altitude(*blocks_, north) > directAltitude(blocks_->world, 0, north) + 20.0);
  }

  void blocks_underGrowingRoadmap_castShrinkingShadows() {
    // Fig. 4 from left to right: the sites alone know straight ways over the blocks only, the roadmap learns the ways around.
    const std::optional<Figure> bare = load("three-blocks", 0);
    const std::optional<Figure> young = load("three-blocks", 500);
    QVERIFY(bare && young);
    Poses poses(kSeed + 4);
    double sumBare = 0.0;
    double sumYoung = 0.0;
    double sumGrown = 0.0;
    for (int i = 0; i < 2'000; ++i) {
      const geo::Pose pose = poses.next();
      const double alone = altitude(*bare, pose);
      const double grown = altitude(*blocks_, pose);
      QVERIFY2(grown <= alone + 1e-6, qPrintable(at(pose, grown, alone)));
      if (std::isfinite(alone)) {
        sumBare += alone;
        sumYoung += altitude(*young, pose);
        sumGrown += grown;
      }
    }
    QVERIFY2(sumYoung < 0.95 * sumBare && sumGrown < 0.995 * sumYoung, qPrintable(QString("%1 %2 %3").arg(sumBare).arg(sumYoung).arg(sumGrown)));
  }

  void farInFront_isAsOnFlatGround() {
    // In front of the first block, seen from the runway, nothing is in the way; nor where the flat glide is above the
    // blocks all the way over them.
    Poses poses(kSeed + 3);
    int compared = 0;
    for (int i = 0; compared < 500 && i < 200'000; ++i) {
      geo::Pose pose = poses.next();
      pose.heading = 0.1 * wrapPi(pose.heading);  // towards the east, as the landing
      const bool onFinal = pose.x > -2000.0 && pose.x < -300.0 && std::abs(pose.y) < 0.2 * std::abs(pose.x);
      if (!onFinal) {
        continue;
      }
      ++compared;
      const double direct = directAltitude(blocks_->world, 0, pose);
      const double found = altitude(*blocks_, pose);
      QVERIFY2(std::abs(found - direct) < 1.0, qPrintable(at(pose, found, direct)));
    }
    QCOMPARE(compared, 500);
  }
};

QTEST_APPLESS_MAIN(TestFigures)
#include "tst_figures.moc"
