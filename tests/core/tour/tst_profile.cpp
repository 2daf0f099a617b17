// Altitude profiles: pitch limits hold, the majorant is the least concave one, and both only raise.
#include "core/tour/profile.h"

#include <QTest>

#include <cmath>
#include <random>
#include <vector>

using namespace vp::tour;

namespace {

constexpr unsigned kSeed = 17;
constexpr PitchLimits kLimits{0.3, 0.2};

struct Random {
  std::mt19937_64 engine{kSeed};
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
  std::vector<double> distances(std::size_t n) {
    std::vector<double> d{0.0};
    while (d.size() < n) {
      d.push_back(d.back() + (*this)(1.0, 60.0));
    }
    return d;
  }
  std::vector<double> altitudes(std::size_t n) {
    std::vector<double> a;
    while (a.size() < n) {
      a.push_back((*this)(0.0, 100.0));
    }
    return a;
  }
};

}  // namespace

class TestProfile : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() { qInfo("seed %u", kSeed); }

  void pitch_underRandomProfiles_isLeastAboveAndWithinLimits() {
    Random random;
    for (int i = 0; i < 10000; ++i) {
      const std::size_t n = 1 + random.engine() % 20;
      const auto d = random.distances(n);
      const auto before = random.altitudes(n);
      auto after = before;
      raiseForPitch(d, after, kLimits);
      for (std::size_t j = 0; j < n; ++j) {
        double least = before[j];  // the lowest profile: what any other point forces on this one
        for (std::size_t k = 0; k < n; ++k) {
          least = std::max(least, k < j ? before[k] - kLimits.descent * (d[j] - d[k]) : before[k] - kLimits.climb * (d[k] - d[j]));
        }
        QVERIFY(std::abs(after[j] - least) < 1e-9);
      }
    }
  }

  void pitchAround_underRandomLoops_holdsOnEveryStep() {
    Random random;
    for (int i = 0; i < 10000; ++i) {
      const std::size_t n = 1 + random.engine() % 20;
      std::vector<double> step;
      for (std::size_t j = 0; j < n; ++j) {
        step.push_back(random(1.0, 60.0));
      }
      const auto before = random.altitudes(n);
      auto after = before;
      raiseForPitchAround(step, after, kLimits);
      for (std::size_t j = 0; j < n; ++j) {
        const double rise = after[(j + 1) % n] - after[j];
        QVERIFY(after[j] >= before[j]);
        QVERIFY(rise <= kLimits.climb * step[j] + 1e-9 && rise >= -kLimits.descent * step[j] - 1e-9);
      }
    }
  }

  void majorant_underRandomProfiles_isTheUpperHull() {
    Random random;
    std::vector<std::size_t> scratch;
    for (int i = 0; i < 10000; ++i) {
      const std::size_t n = 2 + random.engine() % 20;
      const auto d = random.distances(n);
      const auto before = random.altitudes(n);
      auto after = before;
      concaveMajorant(d, after, scratch);
      QCOMPARE(after.front(), before.front());
      QCOMPARE(after.back(), before.back());
      for (std::size_t j = 0; j < n; ++j) {
        double hull = before[j];  // highest chord over the point
        for (std::size_t a = 0; a < j; ++a) {
          for (std::size_t b = j + 1; b < n; ++b) {
            hull = std::max(hull, before[a] + (before[b] - before[a]) * (d[j] - d[a]) / (d[b] - d[a]));
          }
        }
        QVERIFY(std::abs(after[j] - hull) < 1e-9);
        QVERIFY(after[j] >= before[j]);
      }
    }
  }

  void majorant_underPitchLimits_keepsThem() {
    Random random;
    std::vector<std::size_t> scratch;
    for (int i = 0; i < 10000; ++i) {
      const std::size_t n = 2 + random.engine() % 20;
      const auto d = random.distances(n);
      auto a = random.altitudes(n);
      raiseForPitch(d, a, kLimits);
      concaveMajorant(d, a, scratch);
      for (std::size_t j = 1; j < n; ++j) {
        const double slope = (a[j] - a[j - 1]) / (d[j] - d[j - 1]);
        QVERIFY(slope <= kLimits.climb + 1e-9 && slope >= -kLimits.descent - 1e-9);
      }
    }
  }

  void length_underKnownTriangle_isRight() { QCOMPARE(lengthInSpace(std::vector<double>{0.0, 3.0, 6.0}, std::vector<double>{0.0, 4.0, 0.0}), 10.0); }
};

QTEST_APPLESS_MAIN(TestProfile)
#include "tst_profile.moc"
