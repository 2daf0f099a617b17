// Altitude intervals through slices against an exhaustive search over a fine grid of altitudes, and altitudes along a track.
#include "core/emergency/weather/altitude_intervals.h"

#include <QTest>

#include <cmath>
#include <map>
#include <random>

using namespace vp::emergency;

namespace {

constexpr double kStep = 5.0;  // m of altitude

/// Of a slice between two altitudes: the dearest band that is touched between them, as assumption 2 of [4] has it. Altitudes of the grid lie in the
/// middle between floors and tops, which are whole tens.
double costOf(const AltitudeSlice& slice, double high, double low) {
  double most = 0.0;
  for (double z = low; z <= high + 1e-9; z += kStep) {
    double rate = 0.0;
    for (const SliceLayer& layer : slice.layers) {
      rate += layer.floor <= z && z <= layer.top ? layer.rate : 0.0;
    }
    most = std::max(most, rate);
  }
  return most * slice.length;
}

class Random {
public:
  double between(double a, double b) { return a + (b - a) * static_cast<double>(engine_() >> 11) * 0x1.0p-53; }
  double tens(double a, double b) { return 10.0 * std::round(between(a, b) / 10.0); }

private:
  std::mt19937_64 engine_{4};
};

}  // namespace

class TestAltitudeIntervals : public QObject {
  Q_OBJECT

private slots:
  void oneSlice_goesUnderOrThrough() {
    // from 1000 m, 1000 m long, slopes of 1 : 10 to 1 : 5; weather above 850 m
    AltitudeSlice slice{1000.0, 0.1, 0.2, 0.0, {{850.0, 5000.0, 1e-3}}};
    const auto through = throughSlice({{1000.0, 1000.0, 0.5, -1, 0.0, 0.0}}, slice);
    QCOMPARE(through.size(), std::size_t{2});
    QVERIFY(through[0].low == 800.0 && through[0].high == 850.0 && through[1].low == 850.0 && through[1].high == 900.0);
    QVERIFY(std::abs(through[0].cost - 1.5) < 1e-12 && std::abs(through[1].cost - 1.5) < 1e-12);  // the slice begins in it
    slice.lowest = 870.0;                                                                         // ground
    const auto above = throughSlice({{1000.0, 1000.0, 0.0, -1, 0.0, 0.0}}, slice);
    QVERIFY(above.size() == 1 && above[0].low == 870.0 && above[0].high == 900.0);
    slice.lowest = 950.0;
    QVERIFY(throughSlice({{1000.0, 1000.0, 0.0, -1, 0.0, 0.0}}, slice).empty());
  }

  void twoSlices_comeDownFirst() {
    // weather from 700 m up in the second kilometre: best is to come down to 700 m in the first
    const std::vector<AltitudeSlice> slices{{1000.0, 0.1, 0.3, 0.0, {}}, {1000.0, 0.1, 0.3, 0.0, {{700.0, 5000.0, 1e-3}}}};
    const auto altitudes = cheapestAltitudes(1000.0, slices, 0.0);
    QVERIFY(altitudes.has_value());
    QVERIFY(std::abs((*altitudes)[0] - 700.0) < 1e-9 && std::abs((*altitudes)[1] - 600.0) < 1e-9);
    const auto high = cheapestAltitudes(1000.0, slices, 650.0);  // must end so high that weather cannot be missed
    QVERIFY(high.has_value());
    QVERIFY(std::abs((*high)[0] - 900.0) < 1e-9 && std::abs((*high)[1] - 800.0) < 1e-9);
    QVERIFY(!cheapestAltitudes(1000.0, slices, 801.0));
  }

  /// 300 tracks of up to five slices, each altitude of the grid at the end: no dearer than the grid's best, no cheaper than slopes allow.
  void randomTracks_areAsCheapAsTheGrid() {
    Random random;
    for (int track = 0; track < 300; ++track) {
      std::vector<AltitudeSlice> slices;
      const int count = 1 + static_cast<int>(random.between(0.0, 5.0));
      for (int i = 0; i < count; ++i) {
        AltitudeSlice slice;
        slice.length = 1000.0;
        slice.least = 0.05;  // whole steps of the grid: 50 to 200 m a slice
        slice.most = track % 3 == 0 ? 0.05 : 0.2;
        for (int k = static_cast<int>(random.between(0.0, 4.0)); k > 0; --k) {
          const double floor = random.tens(0.0, 900.0);
          // between the altitudes of the grid, so that none lies on a floor or top
          slice.layers.push_back({floor + 2.5, floor + random.tens(20.0, 500.0) + 2.5, random.between(1e-4, 1e-3)});
        }
        slices.push_back(slice);
      }
      const double start = 1000.0;
      std::map<int, double> best{{static_cast<int>(start / kStep), 0.0}};
      std::vector<AltitudeInterval> intervals{{start, start, 0.0, -1, 0.0, 0.0}};
      for (const AltitudeSlice& slice : slices) {
        std::map<int, double> after;
        for (const auto& [high, cost] : best) {
          const int first = high - static_cast<int>(std::lround(slice.most * slice.length / kStep));
          const int last = high - static_cast<int>(std::lround(slice.least * slice.length / kStep));
          for (int low = first; low <= last; ++low) {
            const double sum = cost + costOf(slice, high * kStep, low * kStep);
            const auto known = after.find(low);
            if (low * kStep >= slice.lowest && (known == after.end() || sum < known->second)) {
              after[low] = sum;
            }
          }
        }
        best = after;
        intervals = throughSlice(intervals, slice);
      }
      for (const auto& [at, cost] : best) {
        double found = std::numeric_limits<double>::infinity();
        for (const AltitudeInterval& interval : intervals) {
          if (interval.low <= at * kStep + 1e-6 && at * kStep <= interval.high + 1e-6) {
            found = std::min(found, interval.cost);
          }
        }
        QVERIFY2(found <= cost + 1e-9, qPrintable(QString("track %1 at %2 m: %3 against %4").arg(track).arg(at * kStep).arg(found).arg(cost)));
      }
      // and what it says can be flown
      const double end = 100.0;
      const auto altitudes = cheapestAltitudes(start, slices, end);
      double least = std::numeric_limits<double>::infinity();
      for (const AltitudeInterval& interval : intervals) {
        least = interval.high >= end ? std::min(least, interval.cost) : least;
      }
      QVERIFY(altitudes.has_value() == std::isfinite(least));
      double high = start;
      double cost = 0.0;
      for (std::size_t i = 0; altitudes && i < slices.size(); ++i) {
        const double low = (*altitudes)[i];
        QVERIFY(high - low >= slices[i].least * slices[i].length - 1e-6 && high - low <= slices[i].most * slices[i].length + 1e-6);
        double most = 0.0;
        std::vector<double> places{low + 1e-4, high - 1e-4};
        for (const SliceLayer& layer : slices[i].layers) {
          for (const double place : {layer.floor - 1e-4, layer.floor + 1e-4, layer.top - 1e-4, layer.top + 1e-4}) {
            places.push_back(std::clamp(place, low + 1e-4, high - 1e-4));
          }
        }
        for (const double place : places) {
          double rate = 0.0;
          for (const SliceLayer& layer : slices[i].layers) {
            rate += layer.floor <= place && place <= layer.top ? layer.rate : 0.0;
          }
          most = std::max(most, rate);
        }
        cost += most * slices[i].length;
        high = low;
      }
      QVERIFY2(!altitudes || cost <= least + 1e-9, qPrintable(QString("track %1: flown %2, promised %3").arg(track).arg(cost).arg(least)));
    }
  }
};

QTEST_APPLESS_MAIN(TestAltitudeIntervals)
#include "tst_altitude_intervals.moc"
