// Neighbour search against a scan of all points.
#include "core/landing/spatial_index.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace vp;

class TestSpatialIndex : public QObject {
  Q_OBJECT

private slots:
  void searches_underRandomPoints_agreeWithAScan() {
    constexpr unsigned seed = 11;
    qInfo("seed %u", seed);
    std::mt19937_64 engine(seed);
    std::uniform_real_distribution<double> inside(-1000.0, 1000.0);
    std::uniform_real_distribution<double> around(-1500.0, 1500.0);  // queries and some points lie outside the extent
    landing::SpatialIndex index({-1000.0, -1000.0, 1000.0, 1000.0}, 70.0);
    QCOMPARE(index.nearest({0.0, 0.0}), -1);
    std::vector<geo::Point> points;
    for (int i = 0; i < 10000; ++i) {
      const geo::Point q{around(engine), around(engine)};
      if (!points.empty() && i % 5 == 0) {
        const double radius = std::abs(around(engine)) / 5.0;
        std::vector<int> found;
        index.within(q, radius, found);
        std::sort(found.begin(), found.end());
        std::vector<int> expected;
        double least = 1e300;
        for (std::size_t k = 0; k < points.size(); ++k) {
          const double d = geo::distance(points[k], q);
          least = std::min(least, d);
          if (d <= radius) {
            expected.push_back(static_cast<int>(k));
          }
        }
        QCOMPARE(found, expected);
        QCOMPARE(geo::distance(points[static_cast<std::size_t>(index.nearest(q))], q), least);
      }
      const geo::Point p = i % 100 == 0 ? q : geo::Point{inside(engine), inside(engine)};
      index.insert(p, static_cast<int>(points.size()));
      points.push_back(p);
    }
  }
};

QTEST_APPLESS_MAIN(TestSpatialIndex)
#include "tst_spatial_index.moc"
