// The profile under mouse, wheel and keys, and the cursor that it shares with the other views.
#include "tests/support/planned_tour.h"
#include "ui/profile/profile_view.h"

#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <cmath>

using namespace vp;

namespace {

void wheel(QWidget& widget, QPointF at, int notches, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QWheelEvent event(at, widget.mapToGlobal(at), QPoint(), QPoint(0, 120 * notches), Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

}  // namespace

class TestProfileView : public QObject {
  Q_OBJECT

  document::Situation situation_;
  std::unique_ptr<document::ViewState> state_;
  std::unique_ptr<profile::ProfileView> view_;

  [[nodiscard]] QPointF placeOf(double distance) const {
    const profile::PlotScale& scale = view_->renderer()->scale();
    return {scale.xOf(distance), scale.area().center().y()};
  }

private slots:
  void initTestCase() {
    situation_ = test::plannedSituation();
    QVERIFY(situation_.plan->plan().certificate.has_value());
  }

  void init() {
    state_ = std::make_unique<document::ViewState>();
    view_ = std::make_unique<profile::ProfileView>(*state_);
    view_->resize(1000, 300);
    view_->setSituation(situation_);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
  }

  void hover_setsTheSharedCursor_andLeavingClearsIt() {
    QSignalSpy moved(state_.get(), &document::ViewState::cursorChanged);
    const double distance = 0.37 * situation_.plan->length();
    QTest::mouseMove(view_.get(), placeOf(distance).toPoint());
    QTRY_VERIFY(state_->hovered().has_value());
    QVERIFY(std::abs(*state_->hovered() - distance) < 1.5 * situation_.plan->length() / view_->renderer()->scale().area().width());
    QVERIFY(moved.count() >= 1);
    QEvent leave(QEvent::Leave);
    QApplication::sendEvent(view_.get(), &leave);
    QVERIFY(!state_->hovered());
  }

  void hoverElsewhere_marksTheProfile() {
    const QImage before = view_->grab().toImage();
    const double distance = 0.6 * situation_.plan->length();
    state_->setHovered(distance);
    const QImage after = view_->grab().toImage();
    test::keepPicture(after, QStringLiteral("view-hover"));
    const QPointF place = placeOf(distance);
    const QPoint low(static_cast<int>(std::lround(place.x())), static_cast<int>(view_->renderer()->frame().bottom()) - 3);
    QVERIFY(before.pixelColor(low) != after.pixelColor(low) || before.pixelColor(low + QPoint(1, 0)) != after.pixelColor(low + QPoint(1, 0)));
    state_->setHovered(std::nullopt);
    QCOMPARE(view_->grab().toImage(), before);
  }

  void click_pins_andDoubleClickShowsThePlace() {
    const double distance = 0.25 * situation_.plan->length();
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::NoModifier, placeOf(distance).toPoint());
    QVERIFY(state_->pinned().has_value());
    QVERIFY(std::abs(*state_->pinned() - distance) < 1.5 * situation_.plan->length() / view_->renderer()->scale().area().width());
    QSignalSpy shown(state_.get(), &document::ViewState::placeRequested);
    QTest::mouseDClick(view_.get(), Qt::LeftButton, Qt::NoModifier, placeOf(distance).toPoint());
    QCOMPARE(shown.count(), 1);
    const auto place = shown.at(0).at(0).value<geo::Point>();
    QVERIFY(geo::distance(place, situation_.plan->at(distance).pose.point()) < 60.0);
  }

  void wheel_keepsThePointUnderTheCursor() {
    const profile::PlotWindow all = view_->window();
    const QPointF at = placeOf(0.7 * situation_.plan->length());
    const double under = view_->renderer()->scale().distanceAt(at.x());
    wheel(*view_, at, 3);
    QVERIFY(view_->window().width() < 0.6 * all.width());
    QVERIFY(std::abs(view_->renderer()->scale().distanceAt(at.x()) - under) < 1e-6 * all.width());
    QCOMPARE(view_->window().height(), all.height());
    const double altitude = view_->renderer()->scale().altitudeAt(at.y());
    wheel(*view_, at, 2, Qt::ShiftModifier);
    QVERIFY(view_->window().height() < all.height());
    QVERIFY(std::abs(view_->renderer()->scale().altitudeAt(at.y()) - altitude) < 1e-6 * all.height());
    test::keepPicture(view_->grab().toImage(), QStringLiteral("view-zoomed"));
    wheel(*view_, at, -30);
    wheel(*view_, at, -30, Qt::ShiftModifier);
    QCOMPARE(view_->window(), all);  // never out of the tour
    wheel(*view_, at, 60);
    QVERIFY(view_->window().width() >= 199.0);
  }

  void drag_pans_withoutPinning() {
    wheel(*view_, placeOf(0.5 * situation_.plan->length()), 5);
    const profile::PlotWindow before = view_->window();
    const QPoint from = view_->renderer()->frame().center().toPoint();
    QTest::mousePress(view_.get(), Qt::LeftButton, Qt::NoModifier, from);
    QTest::mouseMove(view_.get(), from + QPoint(-40, 0));
    QTest::mouseMove(view_.get(), from + QPoint(-80, 0));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, Qt::NoModifier, from + QPoint(-80, 0));
    const double expected = before.from + 80.0 / view_->renderer()->scale().area().width() * before.width();
    QVERIFY2(std::abs(view_->window().from - expected) < 0.01 * before.width(), qPrintable(QString::number(view_->window().from - before.from)));
    QVERIFY(!state_->pinned());
  }

  void arrows_stepByDecisionPoints() {
    QTest::keyClick(view_.get(), Qt::Key_Home);
    QCOMPARE(*state_->pinned(), 0.0);
    QTest::keyClick(view_.get(), Qt::Key_Right);
    QCOMPARE(*state_->pinned(), situation_.plan->distanceOf(1));
    state_->setPinned(0.5 * (situation_.plan->distanceOf(3) + situation_.plan->distanceOf(4)));
    QTest::keyClick(view_.get(), Qt::Key_Left);
    QCOMPARE(*state_->pinned(), situation_.plan->distanceOf(3));
    QTest::keyClick(view_.get(), Qt::Key_Right);
    QCOMPARE(*state_->pinned(), situation_.plan->distanceOf(4));
    QTest::keyClick(view_.get(), Qt::Key_End);
    QCOMPARE(*state_->pinned(), situation_.plan->distanceOf(situation_.plan->plan().tour.size() - 1));
    QTest::keyClick(view_.get(), Qt::Key_Right);  // around the loop
    QCOMPARE(*state_->pinned(), 0.0);
  }

  void keys_zoomAndReset() {
    const profile::PlotWindow all = view_->window();
    QTest::keyClick(view_.get(), Qt::Key_Plus);
    QTest::keyClick(view_.get(), Qt::Key_Asterisk);
    QVERIFY(view_->window().width() < all.width() && view_->window().height() < all.height());
    QTest::keyClick(view_.get(), Qt::Key_0);
    QCOMPARE(view_->window(), all);
    // a pinned point outside the shown part is brought into it
    state_->setPinned(0.9 * situation_.plan->length());
    view_->setWindow({0.0, 0.1 * all.to, all.low, all.high});
    QTest::keyClick(view_.get(), Qt::Key_Right);
    QVERIFY(*state_->pinned() >= view_->window().from && *state_->pinned() <= view_->window().to);
  }

  void zoom_staysWithTheTour() {
    view_->setWindow({1000.0, 3000.0, view_->window().low, view_->window().high});
    const profile::PlotWindow zoomed = view_->window();
    view_->setSituation(test::withChangedPlan(situation_, [](mission::Plan& plan) { plan.certificate.reset(); }));
    QCOMPARE(view_->window(), zoomed);
    view_->setSituation({});
    view_->setSituation(situation_);
    QCOMPARE(view_->window(), profile::ProfileRenderer::fullWindow(*situation_.plan));
  }

  void facts_jumpToTheirPlaces() {
    QSignalSpy shown(state_.get(), &document::ViewState::placeRequested);
    const profile::ProfileFact fact = view_->renderer()->facts()[1];
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::NoModifier, fact.rect.center().toPoint());
    QCOMPARE(*state_->pinned(), fact.distance);
    QCOMPARE(shown.count(), 1);
    QVERIFY(view_->accessibleDescription().contains(fact.text));
  }

  void unitsAndTheme_changeThePicture() {
    const QImage before = view_->grab().toImage();
    state_->setTheme(style::Theme::Dark);
    const QImage dark = view_->grab().toImage();
    QVERIFY(dark.pixelColor(2, 2).lightness() < before.pixelColor(2, 2).lightness() - 100);
    state_->setUnits(style::Units(style::UnitSystem::Metric));
    QVERIFY(view_->grab().toImage() != dark);
    QVERIFY(view_->renderer()->facts()[0].text.contains(QStringLiteral(" m AGL")));
  }

  void withoutPlan_isEmptyAndHarmless() {
    view_->setSituation({});
    wheel(*view_, {200.0, 100.0}, 2);
    QTest::mouseMove(view_.get(), QPoint(300, 100));
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::NoModifier, QPoint(300, 100));
    QTest::keyClick(view_.get(), Qt::Key_Right);
    state_->setHovered(10.0);
    const QImage empty = view_->grab().toImage();
    test::keepPicture(empty, QStringLiteral("view-empty"));
    QVERIFY(!state_->pinned());
    QVERIFY(view_->accessibleDescription().contains(QStringLiteral("Load terrain")));
  }
};

QTEST_MAIN(TestProfileView)
#include "tst_profile_view.moc"
