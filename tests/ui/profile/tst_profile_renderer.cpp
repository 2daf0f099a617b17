// What the profile draws is where the plan says: tour, terrain, violations, least margins.
#include "tests/support/planned_tour.h"
#include "ui/profile/glide_profile_renderer.h"
#include "ui/profile/profile_renderer.h"

#include <QElapsedTimer>
#include <QGuiApplication>
#include <QPainter>
#include <QTest>

#include <cmath>

using namespace vp;

namespace {

constexpr QSize kSize(1100, 320);

profile::ProfileStyle lightStyle() {
  return {style::Theme::Light, style::Units(), QGuiApplication::font()};
}

bool isNear(QColor a, QColor b, int tolerance = 40) {
  return std::abs(a.red() - b.red()) <= tolerance && std::abs(a.green() - b.green()) <= tolerance && std::abs(a.blue() - b.blue()) <= tolerance;
}

/// True if a pixel within `radius` of a place has about that colour.
bool hasColor(const QImage& image, QPointF place, const QColor& color, int radius = 2) {
  const double dpr = image.devicePixelRatio();
  for (int dy = -radius; dy <= radius; ++dy) {
    for (int dx = -radius; dx <= radius; ++dx) {
      const QPoint p = (place * dpr).toPoint() + QPoint(dx, dy);
      if (image.rect().contains(p) && isNear(image.pixelColor(p), color)) {
        return true;
      }
    }
  }
  return false;
}

int countColor(const QImage& image, const QColor& color, const QRectF& area, int tolerance = 30) {
  int count = 0;
  const QRect pixels = QRectF(area.topLeft() * image.devicePixelRatio(), area.size() * image.devicePixelRatio()).toRect() & image.rect();
  for (int y = pixels.top(); y <= pixels.bottom(); ++y) {
    for (int x = pixels.left(); x <= pixels.right(); ++x) {
      count += isNear(image.pixelColor(x, y), color, tolerance) ? 1 : 0;
    }
  }
  return count;
}

}  // namespace

class TestProfileRenderer : public QObject {
  Q_OBJECT

  document::Situation situation_;

private slots:
  void initTestCase() { situation_ = test::plannedSituation(); }

  void tour_isDrawnWhereTheDataSays_data() {
    QTest::addColumn<double>("dpr");
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << 1.0 << false;
    QTest::newRow("dark") << 1.0 << true;
    QTest::newRow("light, two pixels each") << 2.0 << false;
  }

  void tour_isDrawnWhereTheDataSays() {
    QFETCH(double, dpr);
    QFETCH(bool, dark);
    const style::Theme theme = dark ? style::Theme::Dark : style::Theme::Light;
    const QImage image = profile::renderProfile(situation_, kSize, dpr, theme, style::Units());
    test::keepPicture(image, QStringLiteral("profile-%1-%2").arg(dark ? "dark" : "light").arg(dpr));
    QCOMPARE(image.size(), kSize * dpr);
    const profile::ProfileRenderer renderer(situation_, lightStyle(), kSize);
    const style::ChartColors& colors = style::ChartColors::of(theme);
    int checked = 0;
    int ground = 0;
    for (double distance = 100.0; distance < situation_.plan->length() - 100.0; distance += 211.0) {
      const document::TourState state = situation_.plan->at(distance);
      const QPointF place(renderer.scale().xOf(distance), renderer.scale().yOf(state.altitude));
      QVERIFY2(hasColor(image, place, colors.route, 3), qPrintable(QString("no tour at %1 m").arg(distance)));
      const QPointF below(place.x(), 0.5 * (renderer.scale().yOf(state.ground) + renderer.scale().area().bottom()));
      ground += renderer.scale().yOf(state.ground) + 6.0 < below.y() && hasColor(image, below, colors.ground, 0) ? 1 : 0;
      ++checked;
    }
    QVERIFY(checked > 20);
    QVERIFY(ground > 5);
    QCOMPARE(countColor(image, colors.violation, renderer.scale().area(), 12), 0);  // a verified plan shows no violation
  }

  void samples_withinOnePixel_loseNoPeak() {
    // one sample in 5,000 stands out; the reduced curve must still reach it
    std::vector<document::TourSample> samples(20001);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i].state.distance = static_cast<double>(i);
      samples[i].state.altitude = i % 5000 == 2500 ? 900.0 : 100.0;
    }
    const profile::PlotScale scale(QRectF(0.0, 0.0, 200.0, 100.0), {0.0, 20000.0, 0.0, 1000.0});
    const auto lines = profile::curveOf(
        samples, [](const document::TourSample& s) { return s.state.altitude; }, scale, 1.0);
    QCOMPARE(lines.size(), std::size_t(1));
    QVERIFY2(lines[0].size() < 1000, qPrintable(QString::number(lines[0].size())));
    for (const double peak : {2500.0, 7500.0, 12500.0, 17500.0}) {
      bool found = false;
      for (const QPointF& p : lines[0]) {
        found = found || (std::abs(p.x() - scale.xOf(peak)) < 0.01 && std::abs(p.y() - scale.yOf(900.0)) < 0.01);
      }
      QVERIFY(found);
    }
    QVERIFY(std::is_sorted(lines[0].begin(), lines[0].end(), [](QPointF a, QPointF b) { return a.x() < b.x(); }));
  }

  void thinning_staysWithinItsTolerance() {
    QPolygonF line;
    for (int i = 0; i < 2000; ++i) {  // straight stretches, a noisy one, and a step straight up
      const double y = i < 700 ? 0.3 * i : i < 1400 ? 210.0 + 20.0 * std::sin(0.7 * i) : 100.0 - 0.1 * i;
      line << QPointF(0.5 * i, y);
    }
    line.insert(1000, line[1000] + QPointF(0.0, 40.0));
    const QPolygonF thin = profile::thinned(line, 0.15);
    QVERIFY2(thin.size() < line.size() / 2 && thin.size() > 200, qPrintable(QString::number(thin.size())));
    QCOMPARE(thin.first(), line.first());
    QCOMPARE(thin.last(), line.last());
    qsizetype at = 0;
    for (const QPointF& p : line) {
      while (at + 2 < thin.size() && thin[at + 1].x() < p.x()) {
        ++at;
      }
      const QPointF a = thin[at];
      const QPointF b = thin[at + 1];
      const double y = b.x() > a.x() ? a.y() + (b.y() - a.y()) * (p.x() - a.x()) / (b.x() - a.x()) : p.y();
      QVERIFY2(std::abs(p.y() - y) <= 0.16 || p.x() == line[1000].x(), qPrintable(QString("%1: %2").arg(p.x()).arg(p.y() - y)));
    }
    QVERIFY(thin.contains(line[1000]));
  }

  void marginsOfNothing_areNoViolation() {
    QCOMPARE(profile::shownMargin(-5e-4), 0.0);
    QCOMPARE(profile::shownMargin(-0.2), -0.2);
    QCOMPARE(profile::shownMargin(3.0), 3.0);
  }

  void curve_overUnknownGround_isBroken() {
    std::vector<document::TourSample> samples(100);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      samples[i].state.distance = 10.0 * static_cast<double>(i);
      samples[i].state.ground = i >= 40 && i < 60 ? std::numeric_limits<double>::infinity() : 50.0;
    }
    const profile::PlotScale scale(QRectF(0.0, 0.0, 500.0, 100.0), {0.0, 990.0, 0.0, 100.0});
    const auto lines = profile::curveOf(
        samples, [](const document::TourSample& s) { return s.state.ground; }, scale, 1.0);
    QCOMPARE(lines.size(), std::size_t(2));
    QVERIFY(std::abs(lines[0].last().x() - scale.xOf(390.0)) < 0.01);
    QVERIFY(std::abs(lines[1].first().x() - scale.xOf(600.0)) < 0.01);
  }

  void planBelowItsSafeAltitude_isFilledRed() {
    const std::size_t point = situation_.plan->plan().tour.size() / 3;
    const document::Situation low = test::withChangedPlan(situation_, [&](mission::Plan& plan) {
      for (std::size_t i = point; i < point + 8; ++i) {
        plan.tour[i].altitude = plan.tour[i].safeAltitude - 150.0;
      }
      plan.certificate.reset();
    });
    const QImage image = profile::renderProfile(low, kSize, 1.0, style::Theme::Light, style::Units());
    test::keepPicture(image, QStringLiteral("profile-violated"));
    const profile::ProfileRenderer renderer(low, lightStyle(), kSize);
    const std::vector<profile::Stretch> stretches = profile::violations(*low.plan);
    QCOMPARE(stretches.size(), std::size_t(1));
    QVERIFY(stretches[0].from <= low.plan->distanceOf(point) && stretches[0].to >= low.plan->distanceOf(point + 7));
    const double x = renderer.scale().xOf(low.plan->distanceOf(point + 4));
    const QColor red = style::ChartColors::of(style::Theme::Light).violation;
    const double top = renderer.scale().yOf(low.plan->plan().tour[point + 4].safeAltitude);
    const double bottom = renderer.scale().yOf(low.plan->plan().tour[point + 4].altitude);
    QVERIFY(countColor(image, red, QRectF(QPointF(x - 6.0, top), QPointF(x + 6.0, bottom)), 60) > 5);
    QVERIFY(hasColor(image, QPointF(x, renderer.scale().area().bottom() - 2.0), red));  // and the bar along the axis
    QVERIFY(renderer.facts()[1].isViolated);
    QVERIFY(renderer.facts()[1].text.contains(QChar(0x2212)));
    // nothing red far away from it
    const double away = renderer.scale().xOf(low.plan->distanceOf(point) + 0.5 * low.plan->length());
    QCOMPARE(countColor(image, red, QRectF(away - 40.0, renderer.scale().area().top(), 80.0, renderer.scale().area().height()), 12), 0);
  }

  void least_clearanceAndMargin_areNamedWithTheirPlaces() {
    const profile::ProfileRenderer renderer(situation_, lightStyle(), kSize);
    const style::Units units;
    const document::TourState& low = situation_.plan->leastClearance().state;
    const document::TourState& tight = situation_.plan->leastGlideMargin().state;
    QVERIFY(renderer.facts()[0].text.contains(units.heightAboveGround(low.clearance())));
    QVERIFY(renderer.facts()[0].text.contains(units.distance(low.distance)));
    QVERIFY(renderer.facts()[1].text.contains(units.margin(tight.glideMargin())));
    QCOMPARE(renderer.facts()[1].distance, tight.distance);
    QVERIFY(!renderer.facts()[0].isViolated && !renderer.facts()[1].isViolated);
    // they stay inside the picture and off the plot, also where it is narrow
    for (const int width : {300, 420, 700, 1400}) {
      const profile::ProfileRenderer narrow(situation_, lightStyle(), QSizeF(width, 260));
      for (const profile::ProfileFact& fact : narrow.facts()) {
        QVERIFY(QRectF(0.0, 0.0, width, 260.0).contains(fact.rect));
        QVERIFY(!fact.rect.intersects(narrow.frame()));
      }
      QVERIFY(narrow.frame().height() > 40.0);
    }
  }

  void outdatedPlan_isGreyed() {
    document::Situation old = situation_;
    old.planIsCurrent = false;
    const QImage image = profile::renderProfile(old, kSize, 1.0, style::Theme::Light, style::Units());
    test::keepPicture(image, QStringLiteral("profile-outdated"));
    const QImage current = profile::renderProfile(situation_, kSize, 1.0, style::Theme::Light, style::Units());
    const QColor route = style::ChartColors::of(style::Theme::Light).route;
    const QRectF all(QPointF(0.0, 0.0), kSize);
    QCOMPARE(countColor(image, route, all, 25), 0);
    QVERIFY(countColor(current, route, all, 25) > 500);
  }

  void unknownGround_isHatchedAndSaidToBeUnknown() {
    // the same plan over terrain with a hole
    const terrain::ElevationGrid& grid = *situation_.terrain->grid;
    std::vector<float> values = grid.values();
    const document::TourState middle = situation_.plan->at(0.5 * situation_.plan->length());
    for (int row = grid.rowOf(middle.pose.y - 200.0); row <= grid.rowOf(middle.pose.y + 200.0); ++row) {
      for (int column = grid.columnOf(middle.pose.x - 200.0); column <= grid.columnOf(middle.pose.x + 200.0); ++column) {
        values[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns()) + static_cast<std::size_t>(column)] = terrain::kUnknownUpper;
      }
    }
    document::Situation holed = situation_;
    holed.terrain = document::makeTerrainData(
        situation_.terrain->frame,
        std::make_shared<const terrain::ElevationGrid>(grid.originX(), grid.originY(), grid.cellSize(), grid.columns(), grid.rows(), values),
        situation_.terrain->files);
    holed.plan = std::make_shared<const document::PlanView>(std::make_shared<const mission::Plan>(situation_.plan->plan()), holed.terrain);
    const QImage image = profile::renderProfile(holed, kSize, 1.0, style::Theme::Light, style::Units());
    test::keepPicture(image, QStringLiteral("profile-unknown"));
    const profile::ProfileRenderer renderer(holed, lightStyle(), kSize);
    QVERIFY(renderer.facts()[0].isViolated);
    QVERIFY(renderer.facts()[0].text.contains(QStringLiteral("unknown")));
    const double x = renderer.scale().xOf(0.5 * holed.plan->length());
    const QRectF column(x - 3.0, renderer.scale().area().center().y(), 6.0, 0.4 * renderer.scale().area().height());
    const style::ChartColors& colors = style::ChartColors::of(style::Theme::Light);
    QVERIFY(countColor(image, colors.unknownBase, column, 8) > 20);
    QVERIFY(!profile::violations(*holed.plan).empty());  // unknown is never safe
  }

  void noPlan_saysWhatToDo() {
    document::Situation empty;
    QVERIFY(profile::emptyProfileText(empty).contains(QStringLiteral("Load terrain")));
    empty.terrain = situation_.terrain;
    QVERIFY(profile::emptyProfileText(empty).contains(QStringLiteral("Mark targets")));
    empty.targets = situation_.targets;
    QVERIFY(profile::emptyProfileText(empty).contains(QStringLiteral("Plan the tour")));
    const QImage image = profile::renderProfile(empty, kSize, 1.0, style::Theme::Light, style::Units());
    QVERIFY(countColor(image, style::ChartColors::of(style::Theme::Light).panel, QRectF(QPointF(0, 0), kSize), 4) < kSize.width() * kSize.height());
  }

  void glide_isDrawnDownToItsRunway() {
    const document::EngineOut glide = situation_.plan->engineOutAt(0.4 * situation_.plan->length());
    QImage image(QSize(420, 200), QImage::Format_ARGB32_Premultiplied);
    const style::ChartColors& colors = style::ChartColors::of(style::Theme::Light);
    image.fill(colors.panel);
    const profile::GlideProfileRenderer renderer(*situation_.plan, glide, lightStyle(), QRectF(0.0, 0.0, 420.0, 200.0));
    QPainter painter(&image);
    renderer.paint(painter);
    painter.end();
    test::keepPicture(image, QStringLiteral("glide"));
    QVERIFY(glide.path.size() > 10);
    for (std::size_t i = 1; i < glide.path.size(); i += 7) {
      const QPointF place(renderer.scale().xOf(glide.path[i].distance), renderer.scale().yOf(glide.path[i].altitude));
      QVERIFY(hasColor(image, place, colors.glide(glide.margin), 6) || hasColor(image, place, colors.text, 6));
    }
    const double elevation = situation_.plan->plan().sites[static_cast<std::size_t>(glide.site)].site.elevation.metres();
    QVERIFY(hasColor(image, QPointF(renderer.scale().xOf(glide.length) + 12.0, renderer.scale().yOf(elevation)), colors.runway, 1));
  }

  void ticks_areRoundAndFew() {
    for (const double range : {0.7, 3.0, 42.0, 999.0, 12345.0}) {
      const std::vector<double> ticks = profile::niceTicks(-0.1 * range, range, 7);
      QVERIFY(ticks.size() >= 2 && ticks.size() <= 8);
      QVERIFY(ticks.front() >= -0.1 * range - 1e-9 && ticks.back() <= range + 1e-9);
      const double step = ticks[1] - ticks[0];
      const double mantissa = step / std::pow(10.0, std::floor(std::log10(step) + 1e-9));
      QVERIFY(std::abs(mantissa - 1.0) < 1e-6 || std::abs(mantissa - 2.0) < 1e-6 || std::abs(mantissa - 5.0) < 1e-6);
    }
  }
};

QTEST_MAIN(TestProfileRenderer)
#include "tst_profile_renderer.moc"
