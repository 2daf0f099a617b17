// Distances, states and glides of a plan as shown, judged by the checker's own arithmetic.
#include "core/safety/witness_check.h"
#include "tests/support/quick_plan.h"
#include "ui/document/plan_view.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <random>

using namespace vp;
using document::EngineOut;
using document::PlanView;
using document::TourSample;
using document::TourState;

class TestPlanView : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    made_ = test::quickPlan(test::quickMission(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm"));
    const auto terrain = document::makeTerrainData(made_.loaded.frame, made_.loaded.terrain, made_.loaded.terrainFiles);
    view_ = std::make_unique<PlanView>(made_.plan, terrain);
    model_ = aircraft::GlideModel(made_.plan->mission.aircraft);
  }

  void distances_addUpAlongTheLoop() {
    const std::vector<mission::DecisionPoint>& tour = made_.plan->tour;
    double flown = 0.0;
    for (std::size_t i = 0; i < tour.size(); ++i) {
      QVERIFY(std::abs(view_->distanceOf(i) - flown) < 1e-6);
      const TourState state = view_->at(view_->distanceOf(i));
      QVERIFY(geo::distance(state.pose.point(), tour[i].pose.point()) < 1e-6);
      QCOMPARE(state.altitude, tour[i].altitude);
      QCOMPARE(state.safeAltitude, tour[i].safeAltitude);
      flown += tour[i].onward.length;
    }
    QVERIFY(std::abs(view_->length() - flown) < 1e-6);
    QVERIFY(view_->isVerified());
  }

  void distance_wrapsAroundTheLoop() {
    for (const double at : {0.0, 1.0, 0.37 * view_->length(), view_->length() - 1.0}) {
      for (const int rounds : {-2, -1, 1, 3}) {
        const TourState here = view_->at(at);
        const TourState there = view_->at(at + rounds * view_->length());
        QVERIFY(std::abs(here.altitude - there.altitude) < 1e-3);
        QVERIFY(geo::distance(here.pose.point(), there.pose.point()) < 1e-3);
      }
    }
  }

  void samples_followTheTourClosely() {
    const std::vector<TourSample>& samples = view_->samples();
    QCOMPARE(samples.front().state.distance, 0.0);
    QVERIFY(std::abs(samples.back().state.distance - view_->length()) < 1e-6);
    double lowestMargin = 1e9;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      const double step = samples[i + 1].state.distance - samples[i].state.distance;
      QVERIFY(step > 0.0 && step <= PlanView::kSampleStep + 1e-6);
      QVERIFY(geo::distance(samples[i].state.pose.point(), samples[i + 1].state.pose.point()) <= step + 1e-6);
      lowestMargin = std::min(lowestMargin, samples[i].state.glideMargin());
      QVERIFY(samples[i].corridor >= samples[i].state.ground);
      QVERIFY(samples[i].state.clearance() >= view_->leastClearance().state.clearance());
      QVERIFY(samples[i].state.ground <= view_->highestGround().state.ground);
    }
    QCOMPARE(view_->leastGlideMargin().state.glideMargin(), lowestMargin);
    QVERIFY2(lowestMargin >= -1e-6, qPrintable(QString::number(lowestMargin)));
  }

  void corridor_isTheHighestCellAround() {
    const terrain::ElevationGrid& grid = *made_.loaded.terrain;
    for (std::size_t i = 0; i < view_->samples().size(); i += 37) {
      const TourSample& sample = view_->samples()[i];
      double highest = -1e9;
      for (int row = 0; row < grid.rows(); ++row) {
        for (int column = 0; column < grid.columns(); ++column) {
          const geo::Point centre{grid.originX() + (column + 0.5) * grid.cellSize(), grid.originY() + (row + 0.5) * grid.cellSize()};
          const float value = grid.upperInCell(column, row);
          if (std::isfinite(value) && geo::distance(centre, sample.state.pose.point()) <= PlanView::kCorridor - grid.cellSize()) {
            highest = std::max(highest, static_cast<double>(value));
          }
        }
      }
      QVERIFY(sample.corridor >= highest);
    }
  }

  void pitchOnly_isNeverAboveTheTourAndKeepsThePitchLimits() {
    const std::vector<TourSample>& samples = view_->samples();
    const aircraft::AircraftProfile& aircraft = made_.plan->mission.aircraft;
    double gain = 0.0;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      const TourSample& sample = samples[i];
      QVERIFY(sample.pitchOnly <= sample.state.altitude + 1e-6);
      QVERIFY(sample.pitchOnly >= sample.state.ground + made_.plan->mission.safety.clearance.si() - 1e-6);
      const double rise = samples[i + 1].pitchOnly - sample.pitchOnly;
      const double step = samples[i + 1].state.distance - sample.state.distance;
      QVERIFY(rise <= step * tan(aircraft.maxClimb) + 1e-6 && -rise <= step * tan(aircraft.maxDescent) + 1e-6);
      gain = std::max(gain, sample.state.altitude - sample.pitchOnly);
    }
    QVERIFY(gain > 10.0);  // the guarantee costs height somewhere, or the curve shows nothing
  }

  /// The margin shown is never more than the checker's own, and the glide shown is the one that it proves.
  void engineOut_underTheChecker_isNeverFlattered() {
    const mission::Plan& plan = *made_.plan;
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> anywhere(0.0, view_->length());
    double worstGap = 0.0;
    for (int i = 0; i < 3000; ++i) {
      const EngineOut out = view_->engineOutAt(anywhere(random));
      QVERIFY(out.site >= 0);
      const mission::SiteInFrame& site = plan.sites[static_cast<std::size_t>(out.site)];
      const auto next = (static_cast<std::size_t>(out.from.point) + 1) % plan.tour.size();
      const mission::DecisionPoint& passed = plan.tour[static_cast<std::size_t>(out.from.point)];
      std::vector<flight::Piece> pieces{passed.onward};
      pieces.front().length = std::max(0.0, passed.onward.length - (out.from.distance - view_->distanceOf(static_cast<std::size_t>(out.from.point))));
      pieces.insert(pieces.end(), plan.tour[next].witness.pieces.begin(), plan.tour[next].witness.pieces.end());
      const double required =
          safety::requiredStartHeight(out.from.pose, pieces, site.site.elevation.metres() + plan.mission.safety.arrivalMargin.si(),
                                      *made_.loaded.terrain, plan.mission.safety.clearance.si(), model_);
      QVERIFY(std::abs(out.margin - out.from.glideMargin()) < 1e-9);
      QVERIFY2(out.margin <= out.from.altitude - required + 1e-3, qPrintable(QString::number(out.margin - (out.from.altitude - required))));
      worstGap = std::max(worstGap, (out.from.altitude - required) - out.margin);
      QVERIFY(geo::distance(out.path.back().pose.point(), site.pose.point()) < 0.01);
      QVERIFY(std::abs(std::remainder(out.path.back().pose.heading - site.pose.heading, 2.0 * Angle::kPi)) < 1e-4);
      QVERIFY(out.path.back().altitude >= site.site.elevation.metres() + plan.mission.safety.arrivalMargin.si() - 1e-3);
      QVERIFY(std::abs(out.surplus - (out.path.back().altitude - site.site.elevation.metres())) < 1e-6);
    }
    QVERIFY2(worstGap < 60.0, qPrintable(QString::number(worstGap)));  // pessimistic, but of use
  }

  void glide_losesHeightAsThePolarSays() {
    const EngineOut out = view_->engineOutAt(0.4 * view_->length());
    QVERIFY(out.path.size() > 3);
    double least = 1e9;
    for (std::size_t i = 0; i + 1 < out.path.size(); ++i) {
      const double step = out.path[i + 1].distance - out.path[i].distance;
      const double loss = (out.path[i].altitude - out.path[i + 1].altitude) / step;
      QVERIFY(step > 0.0 && step <= PlanView::kGlideSpacing + 1e-6);
      QVERIFY(loss >= model_.straightLoss() - 1e-9 && loss <= model_.lossAt(model_.minRadius()) + 1e-9);
      least = std::min(least, out.path[i].altitude - out.path[i].ground);
    }
    least = std::min(least, out.path.back().altitude - out.path.back().ground);
    QVERIFY(std::abs(out.length - out.path.back().distance) < 1e-6);
    QCOMPARE(out.leastClearance, least);
    QCOMPARE(out.path[out.leastClearanceAt].altitude - out.path[out.leastClearanceAt].ground, least);
    const double seconds = out.length / model_.airspeed();
    QVERIFY(out.seconds > seconds && out.seconds < 1.1 * seconds);
  }

  void targets_areFoundWhereTheyAreVisited() {
    for (std::size_t t = 0; t < made_.plan->targets.size(); ++t) {
      const auto at = view_->distanceOfTarget(static_cast<int>(t));
      QVERIFY(at.has_value());
      const TourState state = view_->at(*at);
      QVERIFY(geo::distance(state.pose.point(), made_.plan->targets[t].point) < 0.01);
      QVERIFY(state.altitude >= made_.plan->targets[t].altitude - 1e-6);
    }
    QVERIFY(!view_->distanceOfTarget(99).has_value());
  }

  void nearest_isOnTheTourAndWithinReach() {
    const TourState state = view_->at(0.61 * view_->length());
    const geo::Point beside{state.pose.x - 20.0 * std::sin(state.pose.heading), state.pose.y + 20.0 * std::cos(state.pose.heading)};
    const auto found = view_->nearest(beside, 50.0);
    QVERIFY(found.has_value());
    QVERIFY(geo::distance(view_->at(*found).pose.point(), beside) <= 21.0);
    QVERIFY(!view_->nearest({state.pose.x + 1e6, state.pose.y}, 50.0).has_value());
  }

private:
  test::QuickPlan made_;
  std::unique_ptr<PlanView> view_;
  aircraft::GlideModel model_;
};

QTEST_APPLESS_MAIN(TestPlanView)
#include "tst_plan_view.moc"
