// Weather on a leg: known answers, random cells against plain sampling, and what is refused.
#include "core/flight/curve_sampling.h"
#include "core/risk/weather.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace vp;
using flight::Piece;
using flight::Turn;

namespace {

const geo::LocalFrame kFrame({46.5, 9.8});
constexpr double kMile = 1852.0;

mission::WeatherCell cellOf(const std::vector<geo::Point>& ring, std::optional<double> floor, std::optional<double> top, double success,
                            double perDistance = kMile) {
  mission::WeatherCell cell;
  cell.name = "storm";
  for (const geo::Point& point : ring) {
    cell.outline.push_back(kFrame.toLatLon(point));
  }
  cell.floor = floor;
  cell.top = top;
  cell.success = success;
  cell.perDistance = perDistance;
  return cell;
}

std::vector<geo::Point> square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

std::shared_ptr<const risk::Weather> weatherOf(const std::vector<mission::WeatherCell>& cells) {
  return *risk::Weather::from(cells, kFrame);
}

Piece straight(double length) {
  return {Turn::Straight, 0.0, length};
}

bool isNear(double value, double expected, double within) {
  if (std::abs(value - expected) <= within) {
    return true;
  }
  qWarning("%.12g instead of %.12g", value, expected);
  return false;
}

}  // namespace

class TestWeather : public QObject {
  Q_OBJECT

private slots:
  void straightThrough_isTheProbabilityPerDistance() {
    const risk::WeatherRisk risk(weatherOf({cellOf(square(1000.0, -500.0, 2.0 * kMile), std::nullopt, std::nullopt, 0.8)}));
    const double met = risk.of({0.0, 0.0, 0.0}, straight(20000.0), 3000.0, 2000.0);
    QVERIFY(isNear(std::exp(-met), 0.64, 1e-6));  // two nautical miles
    QVERIFY(isNear(risk.of({0.0, 9000.0, 0.0}, straight(20000.0), 3000.0, 2000.0), 0.0, 0.0));
    QVERIFY(isNear(risk.of({0.0, 0.0, 0.0}, straight(0.0), 3000.0, 3000.0), 0.0, 0.0));
  }

  void alongASide_countsHalf_andCornersNothing() {
    const risk::WeatherRisk risk(weatherOf({cellOf(square(0.0, 0.0, 1000.0), std::nullopt, std::nullopt, 0.5, 1000.0)}));
    QVERIFY(isNear(risk.of({-500.0, 0.0, 0.0}, straight(3000.0), 1000.0, 1000.0), 0.5 * std::log(2.0), 1e-9));
    QVERIFY(isNear(risk.of({-1000.0, 1000.0, -0.25 * Angle::kPi}, straight(1000.0), 1000.0, 1000.0), 0.0, 1e-9));
  }

  void floorAndTop_cutDescents() {
    // 10 km at 1 : 10 from 2500 m: in the layer of 1800 to 2200 m on 4 of the 10 km
    const risk::WeatherRisk risk(weatherOf({cellOf(square(-1e4, -1e4, 4e4), 1800.0, 2200.0, 0.9, 1000.0)}));
    const geo::Pose from{0.0, 0.0, 0.0};
    QVERIFY(isNear(risk.of(from, straight(10000.0), 2500.0, 1500.0), -4.0 * std::log(0.9), 1e-9));
    QVERIFY(isNear(risk.of(from, straight(10000.0), 1500.0, 2500.0), -4.0 * std::log(0.9), 1e-9));
    QVERIFY(isNear(risk.of(from, straight(10000.0), 2000.0, 2000.0), -10.0 * std::log(0.9), 1e-9));
    QVERIFY(isNear(risk.of(from, straight(10000.0), 2200.0, 2200.0), -10.0 * std::log(0.9), 1e-9));  // the top belongs to it
    QVERIFY(isNear(risk.of(from, straight(10000.0), 2300.0, 2201.0), 0.0, 0.0));
    QVERIFY(isNear(risk.of(from, straight(10000.0), 1799.0, 100.0), 0.0, 0.0));
  }

  void overlapping_addsUp_andHalvesAreTheWhole() {
    const mission::WeatherCell ice = cellOf(square(0.0, 0.0, 2000.0), 0.0, 3000.0, 0.9, 1000.0);
    const mission::WeatherCell rain = cellOf(square(1000.0, 0.0, 2000.0), std::nullopt, std::nullopt, 0.8, 1000.0);
    const geo::Pose from{-1000.0, 700.0, 0.0};
    const risk::WeatherRisk both(weatherOf({ice, rain}));
    QVERIFY(isNear(both.of(from, straight(9000.0), 1000.0, 900.0), -2.0 * std::log(0.9) - 2.0 * std::log(0.8), 1e-9));
    const risk::WeatherRisk halves(weatherOf({cellOf({{0.0, 0.0}, {900.0, 0.0}, {900.0, 2000.0}, {0.0, 2000.0}}, 0.0, 3000.0, 0.9, 1000.0),
                                              cellOf({{900.0, 0.0}, {2000.0, 0.0}, {2000.0, 2000.0}, {900.0, 2000.0}}, 0.0, 3000.0, 0.9, 1000.0)}));
    const risk::WeatherRisk whole(weatherOf({ice}));
    QVERIFY(isNear(halves.of(from, straight(9000.0), 1000.0, 900.0), whole.of(from, straight(9000.0), 1000.0, 900.0), 1e-9));
    QVERIFY(isNear(both.weather()->rateAt({1500.0, 700.0}, 500.0), -1e-3 * (std::log(0.9) + std::log(0.8)), 1e-12));
    QVERIFY(isNear(both.weather()->rateAt({1500.0, 700.0}, 3500.0), -1e-3 * std::log(0.8), 1e-12));
  }

  /// 10,000 legs through random cells: additive over a cut, and as sampled.
  void randomLegs_areAdditiveAndAsSampled() {
    std::mt19937_64 random(20261130);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<mission::WeatherCell> cells;
    for (int i = 0; i < 12; ++i) {
      const geo::Point centre{16000.0 * unit(random) - 8000.0, 16000.0 * unit(random) - 8000.0};
      std::vector<geo::Point> ring;
      const int corners = 3 + static_cast<int>(6.0 * unit(random));
      for (int k = 0; k < corners; ++k) {  // star-shaped: no sides cross
        const double angle = 2.0 * Angle::kPi * (k + 0.5 * unit(random)) / corners;
        const double radius = 500.0 + 3000.0 * unit(random);
        ring.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
      }
      const double floor = 2000.0 * unit(random);
      cells.push_back(cellOf(ring, unit(random) < 0.3 ? std::nullopt : std::optional(floor),
                             unit(random) < 0.3 ? std::nullopt : std::optional(floor + 100.0 + 1500.0 * unit(random)), 0.5 + 0.5 * unit(random)));
    }
    const std::shared_ptr<const risk::Weather> weather = weatherOf(cells);
    const risk::WeatherRisk risk(weather);
    int met = 0;
    for (int i = 0; i < 10000; ++i) {
      const geo::Pose from{20000.0 * unit(random) - 10000.0, 20000.0 * unit(random) - 10000.0, 2.0 * Angle::kPi * unit(random)};
      const double radius = 200.0 + 3000.0 * unit(random);
      const double kind = unit(random);
      const double most = kind < 0.4 ? 15000.0 : 2.0 * Angle::kPi * radius;
      const Piece piece{kind < 0.4 ? Turn::Straight : kind < 0.7 ? Turn::Left : Turn::Right, kind < 0.4 ? 0.0 : radius, most * (0.01 + unit(random))};
      const double start = 500.0 + 4000.0 * unit(random);
      const double end = start - 0.4 * piece.length * unit(random);
      const double whole = risk.of(from, piece, start, end);
      const double cut = piece.length * unit(random);
      const double middle = start + (end - start) * cut / piece.length;
      const double first = risk.of(from, {piece.turn, piece.radius, cut}, start, middle);
      const double second = risk.of(flight::poseAfter(from, piece, cut), {piece.turn, piece.radius, piece.length - cut}, middle, end);
      QVERIFY2(isNear(first + second, whole, 1e-6), qPrintable(QString("leg %1").arg(i)));
      met += whole > 0.0 ? 1 : 0;
      if (i % 20 == 0) {
        constexpr int kSteps = 2000;
        double sum = 0.0;
        for (int k = 0; k < kSteps; ++k) {
          const double share = (k + 0.5) / kSteps;
          sum += weather->rateAt(flight::poseAfter(from, piece, share * piece.length).point(), start + (end - start) * share);
        }
        // each of some crossings may be wrong by a step, at the dearest metre of all cells together
        QVERIFY2(isNear(sum * piece.length / kSteps, whole, 24.0 * piece.length / kSteps * std::log(2.0) / kMile),
                 qPrintable(QString("leg %1").arg(i)));
      }
    }
    QVERIFY(met > 2000);
  }

  void whatCannotBe_isRefusedWithASentence_data() {
    QTest::addColumn<int>("number");
    QTest::addColumn<QString>("part");
    QTest::newRow("sides cross") << 0 << "weather cell 1 (storm): sides of its outline cross each other at 46.5";
    QTest::newRow("two corners") << 1 << "fewer than three different corners";
    QTest::newRow("success of zero") << 2 << "a probability of 0 to come through cannot be; give one above 0 and up to 1";
    QTest::newRow("success above one") << 3 << "a probability of 1.5 to come through cannot be";
    QTest::newRow("no distance") << 4 << "its probability holds for 0 m, which is no distance";
    QTest::newRow("floor above top") << 5 << "its floor at 3000 m MSL is not below its top at 2000 m MSL";
    QTest::newRow("no number") << 6 << "no finite number";
    QTest::newRow("not on Earth") << 7 << "a corner is no place on Earth";
  }
  void whatCannotBe_isRefusedWithASentence() {
    QFETCH(int, number);
    QFETCH(QString, part);
    mission::WeatherCell cell = cellOf(square(0.0, 0.0, 1000.0), 1000.0, 2000.0, 0.9);
    switch (number) {
      case 0:
        std::swap(cell.outline[1], cell.outline[2]);
        break;
      case 1:
        cell.outline.resize(2);
        cell.outline.push_back(cell.outline.back());
        break;
      case 2:
        cell.success = 0.0;
        break;
      case 3:
        cell.success = 1.5;
        break;
      case 4:
        cell.perDistance = 0.0;
        break;
      case 5:
        cell.floor = 3000.0;
        break;
      case 6:
        cell.top = std::numeric_limits<double>::infinity();
        break;
      default:
        cell.outline[0].latitude_deg = std::numeric_limits<double>::quiet_NaN();
        break;
    }
    const auto weather = risk::Weather::from({cell}, kFrame);
    QVERIFY(!weather);
    QVERIFY2(QString::fromStdString(weather.error().what).contains(part), weather.error().what.c_str());
  }

  void certainToComeThrough_isNoObstacle() {
    const std::shared_ptr<const risk::Weather> weather = weatherOf({cellOf(square(0.0, 0.0, 1000.0), 1000.0, 2000.0, 1.0)});
    QVERIFY(weather->size() == 1 && weather->levels().empty());
    QCOMPARE(risk::WeatherRisk(weather).of({-500.0, 500.0, 0.0}, straight(3000.0), 1500.0, 1500.0), 0.0);
  }
};

QTEST_APPLESS_MAIN(TestWeather)
#include "tst_weather.moc"
