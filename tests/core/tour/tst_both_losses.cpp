// Planner and checker, each by its own derivation, on the same sheared layers: what the planner charges is never below what the checker asks for, so
// no plan is refused late; nor is it far above.
#include "core/air/wind_shear.h"
#include "core/aircraft/glide_bands.h"
#include "core/aircraft/wind_check.h"
#include "core/formats/aircraft_file.h"
#include "core/safety/glide_rates.h"

#include <QTest>

#include <algorithm>
#include <random>

using namespace vp;

namespace {

class Random {
public:
  double between(double low, double high) { return low + (high - low) * std::uniform_real_distribution<double>(0.0, 1.0)(engine_); }
  bool once(int in) { return std::uniform_int_distribution<int>(1, in)(engine_) == 1; }

private:
  std::mt19937_64 engine_{20261130};
};

air::WindLayer layer(Random& random, double altitude, double strongest) {
  const double most = random.between(0.0, strongest);
  const double least = random.once(2) ? most : random.between(0.0, most);
  return {geo::HeightMsl::fromMetres(altitude), {random.between(0.0, 360.0), random.once(2) ? 0.0 : random.between(0.0, 60.0), least, most}};
}

}  // namespace

class TestBothLosses : public QObject {
  Q_OBJECT

private slots:
  void layers_data() {
    QTest::addColumn<QString>("aircraft");
    for (const char* name : {"cessna172-elasp", "cessna172-handbook", "motorglider-hk36", "uav-aerosonde"}) {
      QTest::newRow(name) << QStringLiteral(VOLPLANE_SOURCE_DIR "/resources/aircraft/") + QLatin1String(name) + QStringLiteral(".json");
    }
  }
  void layers() {
    QFETCH(QString, aircraft);
    auto profile = formats::readAircraft(aircraft.toStdString());
    QVERIFY(profile.has_value());
    profile->leastMass_kg = profile->mostMass_kg = std::nullopt;
    Random random;
    double farthest = 0.0;
    double strongestShear = 0.0;
    int compared = 0;
    for (int i = 0; compared < 30; ++i) {
      QVERIFY(i < 300);
      const double strongest = random.between(0.1, 0.6) * profile->bestGlideSpeed.si();
      const double height = random.once(3) ? random.between(60.0, 300.0) : random.between(300.0, 2000.0);
      const std::vector<air::WindLayer> layers{layer(random, 0.0, strongest), layer(random, height, strongest)};
      const aircraft::GlideConditions conditions{.winds = layers};
      if (aircraft::windFault(*profile, conditions)) {
        continue;
      }
      ++compared;
      const aircraft::GlideModel model(*profile, conditions);
      const aircraft::GlideModel& between = model.bands()->between(1, 1);
      safety::GlideRates rates(*profile, layers);
      QCOMPARE(rates.bandCount(), std::size_t{3});
      strongestShear = std::max(strongestShear, profile->bestGlideSpeed.si() * between.shear() / kGravity.si());
      for (double course = 0.0; course < 6.2; course += 0.31) {
        const double asked = rates.alongIn(1, course, {flight::Turn::Straight, 0.0, 1.0}).upTo(1.0);
        const double charged = between.lossOver(std::cos(course), std::sin(course));
        QVERIFY2(charged >= asked, qPrintable(QString("straight: %1 charged, %2 asked").arg(charged, 0, 'g', 12).arg(asked, 0, 'g', 12)));
        farthest = std::max(farthest, charged / asked);
      }
      for (std::size_t radius = 0; radius <= model.glideRadii().size(); ++radius) {
        const double metres = radius < model.glideRadii().size() ? model.glideRadii()[radius] : model.tourRadius();
        for (double course = 0.0; course < 6.2; course += 0.62) {
          const double angle = random.between(0.2, 3.0);
          const double asked = rates.alongIn(1, course, {flight::Turn::Left, metres, angle * metres}).upTo(angle * metres);
          const double charged = between.courseLossOf(radius)->turn(course, angle);
          QVERIFY2(charged >= asked, qPrintable(QString("turn: %1 charged, %2 asked, shear %3, wind %4")
                                                    .arg(charged, 0, 'g', 12)
                                                    .arg(asked, 0, 'g', 12)
                                                    .arg(profile->bestGlideSpeed.si() * between.shear() / kGravity.si())
                                                    .arg(strongest / profile->bestGlideSpeed.si())));
        }
      }
    }
    qInfo() << "straight at most" << farthest << "of what is asked; strongest shear" << strongestShear;
    QVERIFY(strongestShear > 0.15);
    QVERIFY2(farthest < 1.02, qPrintable(QString::number(farthest)));
  }
};

QTEST_GUILESS_MAIN(TestBothLosses)
#include "tst_both_losses.moc"
