// Losses by altitude: which winds and densities count where, that covers hold for all of their bands, and the heights that come of them.
#include "core/air/wind_shear.h"
#include "core/aircraft/glide_bands.h"
#include "tests/support/band_flight.h"
#include "tests/support/mountain.h"

#include <QTest>

#include <random>
#include <thread>

using namespace vp;

namespace {

air::WindLayer layer(double altitude, double from, double spread, double least, double most) {
  return {geo::HeightMsl::fromMetres(altitude), {from, spread, least, most}};
}

aircraft::GlideConditions layered() {
  return {.winds = {layer(300.0, 180.0, 30.0, 0.0, 4.0), layer(900.0, 250.0, 0.0, 9.0, 9.0), layer(1500.0, 300.0, 10.0, 5.0, 7.0)}};
}

aircraft::GlideConditions inAir(aircraft::GlideConditions conditions) {
  conditions.air = aircraft::AirRange{air::Atmosphere{-10.0, 1020.0}, geo::HeightMsl::fromMetres(350.0), geo::HeightMsl::fromMetres(2800.0)};
  return conditions;
}

/// Loss per metre to the east.
double rate(const aircraft::GlideModel& cover) {
  return cover.lossOver(1.0, 0.0);
}

/// Least start height of a glide of `length` metres east: backwards, each band with its own losses up to its edge.
double byBand(const aircraft::GlideBands& bands, double end, double length) {
  double height = end;
  for (std::size_t band = bands.above(end); length > 0.0; ++band) {
    const double perMetre = rate(bands.between(band, band));
    const double inBand = std::min(length, (bands.top(band) - height) / perMetre);
    height += inBand * perMetre;
    length -= inBand;
  }
  return height;
}

}  // namespace

class TestGlideBands : public QObject {
  Q_OBJECT

private slots:
  void edges_areLayersAndThousandsOfMetres() {
    QCOMPARE(aircraft::bandEdges({}), std::vector<double>());
    QCOMPARE(aircraft::bandEdges({.winds = {layer(300.0, 0.0, 0.0, 5.0, 5.0)}}), std::vector<double>());
    QCOMPARE(aircraft::bandEdges({.winds = {layer(300.0, 0.0, 0.0, 0.0, 0.0), layer(900.0, 0.0, 0.0, 0.0, 0.0)}}), std::vector<double>());
    QCOMPARE(aircraft::bandEdges(layered()), (std::vector<double>{300.0, 900.0, 1500.0}));
    QCOMPARE(aircraft::bandEdges(inAir({})), (std::vector<double>{1000.0, 2000.0}));
    QCOMPARE(aircraft::bandEdges(inAir(layered())), (std::vector<double>{300.0, 900.0, 1000.0, 1500.0, 2000.0}));
  }

  void bandOfAnEdge_isTheUpperForAnEndAndTheLowerForAStart() {
    const aircraft::GlideModel model(test::paperCessna(), layered());
    const aircraft::GlideBands& bands = *model.bands();
    QCOMPARE(bands.count(), std::size_t{4});
    QCOMPARE(bands.above(900.0), std::size_t{2});
    QCOMPARE(bands.below(900.0), std::size_t{1});
    QCOMPARE(bands.above(901.0), bands.below(901.0));
    QCOMPARE(bands.bottom(2), 900.0);
    QCOMPARE(bands.top(1), 900.0);
  }

  /// Each band against tables made of its own winds and airspeeds, on straights and in turns.
  void bandAlone_costsWhatItsLayersAndDensitiesDo() {
    const std::vector<air::WindLayer> winds = layered().winds;
    const aircraft::GlideModel model(test::paperCessna(), layered());
    const std::vector<std::vector<air::WindSector>> expected{
        {winds[0].wind}, {winds[0].wind, winds[1].wind}, {winds[1].wind, winds[2].wind}, {winds[2].wind}};
    const std::vector<double> shears{0.0, air::mostShear({winds[0], winds[1]}), air::mostShear({winds[1], winds[2]}), 0.0};
    aircraft::GlidePolar polar = test::polarOf(test::paperCessna());
    for (std::size_t band = 0; band < expected.size(); ++band) {
      polar.shear = polar.airspeed * shears[band] / kGravity.si();
      const aircraft::GlideModel& alone = model.bands()->between(band, band);
      QCOMPARE(alone.glideRadii(), model.glideRadii());
      for (const double radius : model.glideRadii()) {
        const aircraft::CourseLoss own(polar, expected[band], radius);
        for (double course = -3.0; course < 3.0; course += 0.1) {
          QVERIFY(std::abs(alone.lossOver(std::cos(course), std::sin(course)) / own.straightRate(std::cos(course), std::sin(course)) - 1.0) < 1e-12);
          QVERIFY(std::abs(alone.courseLoss(radius)->turn(course, 2.0) / own.turn(course, 2.0) - 1.0) < 1e-12);
        }
      }
    }
  }

  void densities_areThoseOfTheBand() {
    const aircraft::GlideModel model(test::paperCessna(), inAir({}));
    const aircraft::GlideBands& bands = *model.bands();
    QCOMPARE(bands.count(), std::size_t{3});
    for (std::size_t band = 0; band < 3; ++band) {
      const double top = std::min(2800.0, bands.top(band));
      const double density = air::density(air::Atmosphere{-10.0, 1020.0}, geo::HeightMsl::fromMetres(top));
      const double fastest = test::paperCessna().bestGlideSpeed.si() * std::sqrt(test::paperCessna().airDensity_kgm3 / density);
      QVERIFY(std::abs(bands.between(band, band).airspeed() / fastest - 1.0) < 1e-12);
    }
    const double radius = model.glideRadii().back();
    QVERIFY(bands.between(0, 0).lossAt(radius) < bands.between(1, 1).lossAt(radius));
    QCOMPARE(bands.between(2, 2).lossAt(radius), model.lossAt(radius));
  }

  void covers_loseNoLessThanEachBandAndNoMoreThanAll() {
    for (const aircraft::GlideConditions& conditions : {layered(), inAir(layered()), inAir({.winds = {layer(0.0, 200.0, 25.0, 2.0, 9.0)}})}) {
      const aircraft::GlideModel model(test::paperCessna(), conditions);
      const aircraft::GlideBands& bands = *model.bands();
      for (std::size_t first = 0; first < bands.count(); ++first) {
        for (std::size_t last = first; last < bands.count(); ++last) {
          const aircraft::GlideModel& cover = bands.between(first, last);
          QCOMPARE(cover.holdsUpTo(), bands.top(last));
          for (std::size_t radius = 0; radius <= model.glideRadii().size(); ++radius) {
            for (double course = -3.0; course < 3.0; course += 0.3) {
              const double turn = cover.courseLossOf(radius)->turn(course, 0.7);
              const double straight = cover.lossOver(std::cos(course), std::sin(course));
              for (std::size_t band = first; band <= last; ++band) {
                QVERIFY(turn >= bands.between(band, band).courseLossOf(radius)->turn(course, 0.7) * (1.0 - 1e-12));
                QVERIFY(straight >= bands.between(band, band).lossOver(std::cos(course), std::sin(course)) * (1.0 - 1e-12));
              }
              QVERIFY(straight <= model.lossOver(std::cos(course), std::sin(course)) * (1.0 + 1e-12));
              QVERIFY(straight >= model.leastLossOver(std::cos(course), std::sin(course)));
              QVERIFY(straight >= model.leastLoss());
              QVERIFY(turn <= model.courseLossOf(radius)->turn(course, 0.7) * 1.005);
            }
          }
        }
      }
    }
  }

  /// Never below the exact height, never above that with the losses of all bands; higher ends never ask for less.
  void leastStart_liesBetweenTheExactHeightAndThatOfAllAltitudes() {
    const aircraft::GlideModel model(test::paperCessna(), inAir(layered()));
    const aircraft::GlideBands& bands = *model.bands();
    const auto required = [&](double end, double length) {
      return aircraft::leastStart(model, end,
                                  [length](const aircraft::GlideModel& cover, double low, double /*giveUp*/) { return low + rate(cover) * length; });
    };
    int saved = 0;
    for (const double length : {50.0, 700.0, 4000.0, 12000.0}) {
      double before = 0.0;
      for (double end = 100.0; end < 2300.0; end += 3.7) {
        const double needed = required(end, length);
        QVERIFY(needed >= byBand(bands, end, length) - 1e-9);
        QVERIFY(needed <= end + rate(model) * length + 1e-9);
        QVERIFY(needed >= before - 1e-9);
        before = needed;
        saved += needed < end + 0.97 * rate(model) * length ? 1 : 0;
        const double limit = needed - 1.0;
        QVERIFY(!std::isfinite(aircraft::leastStart(
            model, end,
            [length](const aircraft::GlideModel& cover, double low, double giveUp) {
              const double height = low + rate(cover) * length;
              return height > giveUp ? std::numeric_limits<double>::infinity() : height;
            },
            limit)));
      }
    }
    QVERIFY(saved > 500);
  }

  /// More layers, or wider ones, are never better where they blow.
  void moreWind_neverCostsLess() {
    aircraft::GlideConditions wider = layered();
    wider.winds[1].wind.mostSpeed += 3.0;
    wider.winds[1].wind.spread_deg += 20.0;
    const aircraft::GlideModel model(test::paperCessna(), layered());
    const aircraft::GlideModel more(test::paperCessna(), wider);
    for (std::size_t band = 0; band < model.bands()->count(); ++band) {
      for (double course = -3.0; course < 3.0; course += 0.1) {
        const double own = model.bands()->between(band, band).lossOver(std::cos(course), std::sin(course));
        const double withMore = more.bands()->between(band, band).lossOver(std::cos(course), std::sin(course));
        QVERIFY(band == 0 || band == 3 ? withMore == own : withMore >= own * (1.0 - 1e-12));
      }
    }
  }

  void covers_askedForByManyThreads_areTheSame() {
    const aircraft::GlideModel model(test::paperCessna(), inAir(layered()));
    const aircraft::GlideBands& bands = *model.bands();
    std::vector<std::vector<const aircraft::GlideModel*>> seen(4);
    {
      std::vector<std::jthread> threads;
      for (std::vector<const aircraft::GlideModel*>& mine : seen) {
        threads.emplace_back([&bands, &mine] {
          for (std::size_t first = 0; first < bands.count(); ++first) {
            for (std::size_t last = first; last < bands.count(); ++last) {
              mine.push_back(&bands.between(first, last));
            }
          }
        });
      }
    }
    for (const std::vector<const aircraft::GlideModel*>& mine : seen) {
      QVERIFY(mine == seen.front());
    }
  }
};

QTEST_APPLESS_MAIN(TestGlideBands)
#include "tst_glide_bands.moc"
