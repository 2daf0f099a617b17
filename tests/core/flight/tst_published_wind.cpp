// [3] section 6.2: a Cessna 182 from 4,000 ft, 7.33 NM at 4.4 degrees in still air, becomes 7.73 NM at 4.18 degrees on average with 10 kt of
// partly tailwind. The path itself is printed only as a picture (Fig. 14). What the text gives: it begins on an easterly course (6.1), ends
// on runway 14 of Republic Airport (true course 127 degrees), and the wind of 10 kt blows towards 180 degrees. So the path taken here is the
// simplest with these courses: one right turn from east onto the final course, then straight; its length in still air is the paper's.
#include "core/aircraft/glide_conditions.h"
#include "core/flight/piece_loss.h"
#include "core/formats/aircraft_file.h"

#include <QTest>

#include <cmath>

using namespace vp;

namespace {

constexpr double kCalmLength = 7.33;    // NM
constexpr double kWindLength = 7.73;    // NM
constexpr double kCalmAngle = 4.4;      // degrees
constexpr double kWindAngle = 4.18;     // degrees
constexpr double kFinalCourse = 127.0;  // degrees true
constexpr double kWithin = 0.03;        // as the issue asks
constexpr double kBlowsFrom = 0.0;      // degrees true: towards 180

double mathematical(double trueCourse) {
  return Angle::degrees(90.0 - trueCourse).radians();
}

/// Turn from east onto the final course, and straight to a total length. m
std::vector<flight::Piece> pathOf(double length, double radius) {
  const double turned = radius * Angle::degrees(kFinalCourse - 90.0).radians();
  return {{flight::Turn::Right, radius, turned}, {flight::Turn::Straight, 0.0, length - turned}};
}

double lossOf(const aircraft::GlideModel& model, double length) {
  double sum = 0.0;
  for (const double loss : flight::lossesOf(model, {0.0, 0.0, mathematical(90.0)}, pathOf(length, model.glideRadii().front()))) {
    sum += loss;
  }
  return sum;
}

aircraft::AircraftProfile cessna182() {
  const auto profile = formats::findAircraft("cessna182-gradient", "");
  return profile.value();
}

bool isWithin(double value, double published) {
  return std::abs(value / published - 1.0) < kWithin;
}

}  // namespace

class TestPublishedWind : public QObject {
  Q_OBJECT

private slots:
  void paper3_calm() {
    const aircraft::GlideModel calm(cessna182());
    QVERIFY(isWithin(Angle::radians(std::atan(calm.straightLoss())).degrees(), kCalmAngle));
  }

  void paper3_heights_areTheSame() {
    // both of the paper's paths lose the same height: 4.18 degrees is the mean over the distance, and the comparison means something
    const double calm = kCalmLength * tan(Angle::degrees(kCalmAngle));
    const double windy = kWindLength * tan(Angle::degrees(kWindAngle));
    QVERIFY(std::abs(windy / calm - 1.0) < 0.005);
  }

  void paper3_tenKnots_stretchTheGlide() {
    const aircraft::AircraftProfile profile = cessna182();
    const aircraft::GlideModel calm(profile);
    constexpr double kTenKnots = 10.0 * kMpsPerKnot;
    const aircraft::GlideModel windy(profile, {.winds = {{geo::HeightMsl(), {kBlowsFrom, 0.0, kTenKnots, kTenKnots}}}});
    const double height = lossOf(calm, kCalmLength * kMetresPerNauticalMile);
    double shorter = kCalmLength * kMetresPerNauticalMile;
    double longer = 2.0 * shorter;
    while (longer - shorter > 1e-3) {
      const double middle = 0.5 * (shorter + longer);
      (lossOf(windy, middle) < height ? shorter : longer) = middle;
    }
    const double length = shorter / kMetresPerNauticalMile;
    const double angle = Angle::radians(std::atan(height / shorter)).degrees();
    qInfo("%.2f NM at %.2f degrees (published: %.2f NM at %.2f)", length, angle, kWindLength, kWindAngle);
    QVERIFY2(isWithin(length, kWindLength), qPrintable(QString::number(length)));
    // against the paper's angle as the paper's polar gives it: the ratio of the two angles, not the 1.6 % between the polars
    const double calmAngle = Angle::radians(std::atan(height / (kCalmLength * kMetresPerNauticalMile))).degrees();
    QVERIFY2(isWithin(angle / calmAngle, kWindAngle / kCalmAngle), qPrintable(QString::number(angle / calmAngle)));
  }
};

QTEST_APPLESS_MAIN(TestPublishedWind)
#include "tst_published_wind.moc"
