// The map by mouse and keys: what it asks for, what it shows others, what stays where it was. In one file though long: all of it
// drives one view on one fixture, and a reader looks for what a click does in one place.
#include "tests/ui/map/map_fixture.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <cmath>
#include <memory>

using namespace vp;
using namespace vp::map;
using namespace vp::map::testing;

namespace {

QStringList entriesOf(MapView& view, QPointF at) {
  QStringList texts;
  const std::unique_ptr<QMenu> menu = view.contextMenuAt(at);
  for (const QAction* action : menu->actions()) {
    if (!action->isSeparator()) {
      texts.push_back(action->text());
    }
  }
  return texts;
}

void trigger(MapView& view, QPointF at, const QString& text) {
  const std::unique_ptr<QMenu> menu = view.contextMenuAt(at);
  for (QAction* action : menu->actions()) {
    if (action->text() == text) {
      action->trigger();
      return;
    }
  }
  QFAIL(qPrintable(QStringLiteral("no entry ") + text));
}

void move(MapView& view, QPoint to) {
  QTest::mouseMove(&view, to);
}

void wheel(MapView& view, QPointF at, int degrees8) {
  QWheelEvent event(at, view.mapToGlobal(at), {}, {0, degrees8}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&view, &event);
}

}  // namespace

class TestMapView : public QObject {
  Q_OBJECT

private:
  std::unique_ptr<document::ViewState> state_;
  std::unique_ptr<MapView> view_;
  document::Situation situation_;

  [[nodiscard]] QPoint at(geo::Point place) const { return view_->camera().toScreen(place).toPoint(); }
  [[nodiscard]] geo::Point placeOf(const QList<QVariant>& arguments, int index) const {
    return situation_.terrain->frame.toPoint(arguments[index].value<geo::LatLon>());
  }

private slots:
  void init() {
    state_ = std::make_unique<document::ViewState>();
    view_ = std::make_unique<MapView>(*state_);
    view_->resize(800, 600);
    situation_ = racetrack();
    view_->setSituation(situation_);
    view_->show();
    view_->setFocus();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    view_->setCamera(MapCamera({0.0, 0.0}, 16.0, {}));
  }
  void cleanup() {
    view_.reset();
    state_.reset();
  }

  void wheel_keepsThePointUnderTheCursor() {
    const QPointF anchor(220.0, 410.0);
    const geo::Point held = view_->camera().toGround(anchor);
    const double before = view_->camera().metresPerPixel();
    wheel(*view_, anchor, 240);
    QVERIFY(view_->camera().metresPerPixel() < 0.6 * before);
    QVERIFY(geo::distance(view_->camera().toGround(anchor), held) < 1e-6);
    wheel(*view_, anchor, -240);
    QCOMPARE(view_->camera().metresPerPixel(), MapCamera({}, before, {1.0, 1.0}).withScale(before).metresPerPixel());
  }

  void leftDrag_onGround_pans() {
    const geo::Point held = view_->camera().toGround({400.0, 100.0});
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, {400, 100});
    move(*view_, {420, 110});
    move(*view_, {500, 160});
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, {500, 160});
    QVERIFY(geo::distance(view_->camera().toGround({500.0, 160.0}), held) < 1.0);
    QVERIFY(!state_->pinned());
  }

  void middleDrag_pansInAnyTool() {
    view_->setTool(MapView::Tool::AddTarget);
    QSignalSpy added(view_.get(), &MapView::targetAddRequested);
    const geo::Point held = view_->camera().toGround({400.0, 300.0});
    QTest::mousePress(view_.get(), Qt::MiddleButton, {}, {400, 300});
    move(*view_, {430, 350});
    QTest::mouseRelease(view_.get(), Qt::MiddleButton, {}, {430, 350});
    QVERIFY(geo::distance(view_->camera().toGround({430.0, 350.0}), held) < 1.0);
    QCOMPARE(added.count(), 0);
  }

  void spaceAndMove_pans() {
    move(*view_, {300, 300});
    QTest::keyPress(view_.get(), Qt::Key_Space);
    const geo::Point held = view_->camera().toGround({300.0, 300.0});
    move(*view_, {340, 280});
    QVERIFY(geo::distance(view_->camera().toGround({340.0, 280.0}), held) < 1.0);
    QTest::keyRelease(view_.get(), Qt::Key_Space);
    const MapCamera after = view_->camera();
    move(*view_, {100, 100});
    QCOMPARE(view_->camera(), after);
  }

  void addTool_click_asksForATargetThere_andStays() {
    QSignalSpy added(view_.get(), &MapView::targetAddRequested);
    QSignalSpy tool(view_.get(), &MapView::toolChanged);
    view_->setTool(MapView::Tool::AddTarget);
    QCOMPARE(view_->cursor().shape(), Qt::CrossCursor);
    const QPoint first = at({1000.0, 2000.0});
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, first);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at({-2000.0, 2500.0}));
    QCOMPARE(added.count(), 2);
    QVERIFY(geo::distance(placeOf(added[0], 0), view_->camera().toGround(first)) < 0.01);
    QCOMPARE(added[0][1].toInt(), -1);
    QCOMPARE(view_->tool(), MapView::Tool::AddTarget);
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QCOMPARE(view_->tool(), MapView::Tool::Select);
    QCOMPARE(tool.count(), 2);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, first);
    QCOMPARE(added.count(), 2);
  }

  void addTool_clickOnALeg_insertsBeforeTheNextTarget() {
    QSignalSpy added(view_.get(), &MapView::targetAddRequested);
    view_->setTool(MapView::Tool::AddTarget);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at({1500.0, -500.0}));  // past target 0, before target 1
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at({-1500.0, 500.0}));  // past target 1, before target 0
    QCOMPARE(added.count(), 2);
    QCOMPARE(added[0][1].toInt(), 1);
    QCOMPARE(added[1][1].toInt(), 0);
  }

  void drag_ofATarget_asksForTheMove() {
    QSignalSpy moved(view_.get(), &MapView::targetMoveRequested);
    const MapCamera before = view_->camera();
    const QPoint from = at(situation_.targets->at(1).point);
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
    QCOMPARE(state_->selectedTarget(), 1);
    move(*view_, from + QPoint(40, -30));
    move(*view_, from + QPoint(60, -50));
    QCOMPARE(moved.count(), 0);
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, from + QPoint(60, -50));
    QCOMPARE(moved.count(), 1);
    QCOMPARE(moved[0][0].toInt(), 1);
    QVERIFY(geo::distance(placeOf(moved[0], 1), view_->camera().toGround(from + QPoint(60, -50))) < 0.01);
    QCOMPARE(view_->camera(), before);
  }

  void click_onATarget_selectsWithoutMoving() {
    QSignalSpy moved(view_.get(), &MapView::targetMoveRequested);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at(situation_.targets->at(0).point) + QPoint(3, 2));
    QCOMPARE(state_->selectedTarget(), 0);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at({0.0, 3000.0}));
    QCOMPARE(state_->selectedTarget(), -1);
    QCOMPARE(moved.count(), 0);
  }

  void drag_cancelled_movesNothing_data() {
    QTest::addColumn<bool>("byMouse");
    QTest::newRow("Esc") << false;
    QTest::newRow("right click") << true;
  }
  void drag_cancelled_movesNothing() {
    QFETCH(bool, byMouse);
    QSignalSpy moved(view_.get(), &MapView::targetMoveRequested);
    const QPoint from = at(situation_.targets->at(0).point);
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
    move(*view_, from + QPoint(50, 50));
    if (byMouse) {
      QTest::mousePress(view_.get(), Qt::RightButton, {}, from + QPoint(50, 50));
      QTest::mouseRelease(view_.get(), Qt::RightButton, {}, from + QPoint(50, 50));
    } else {
      QTest::keyClick(view_.get(), Qt::Key_Escape);
    }
    move(*view_, from + QPoint(80, 50));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, from + QPoint(80, 50));
    QCOMPARE(moved.count(), 0);
  }

  void drag_showsTheTargetUnderTheMouse() {
    QTRY_VERIFY(view_->grab().width() > 0 && view_->isComplete());
    const QPoint from = at(situation_.targets->at(0).point);
    const QPoint to = from + QPoint(30, 120);
    const QColor ink = style::ChartColors::of(style::Theme::Light).target;
    QVERIFY(!hasColorNear(view_->grab().toImage(), to, 3, ink));
    QTest::mousePress(view_.get(), Qt::LeftButton, {}, from);
    move(*view_, from + QPoint(20, 20));
    move(*view_, to);
    QVERIFY(hasColorNear(view_->grab().toImage(), to, 3, ink));
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QVERIFY(!hasColorNear(view_->grab().toImage(), to, 3, ink));
    QTest::mouseRelease(view_.get(), Qt::LeftButton, {}, to);
  }

  void hover_overTheTour_setsTheSharedCursorAndClearsIt() {
    move(*view_, at({800.0, -500.0}));
    QVERIFY(state_->hovered().has_value());
    const geo::Point shown = situation_.plan->at(*state_->hovered()).pose.point();
    QVERIFY(geo::distance(shown, {800.0, -500.0}) < view_->camera().metresPerPixel() * 2.0);
    QCOMPARE(view_->cursor().shape(), Qt::PointingHandCursor);
    move(*view_, at({0.0, 2500.0}));
    QVERIFY(!state_->hovered());
    QCOMPARE(view_->cursor().shape(), Qt::ArrowCursor);
    move(*view_, at({800.0, -500.0}));
    QVERIFY(state_->hovered().has_value());
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(view_.get(), &leave);
    QVERIFY(!state_->hovered());
  }

  void hover_elsewhere_leavesOtherViewsCursorAlone() {
    state_->setHovered(1234.0);
    move(*view_, at({0.0, 2500.0}));
    move(*view_, at({10.0, 2600.0}));
    QCOMPARE(state_->hovered(), std::optional(1234.0));
  }

  void hover_ofAnotherView_drawsTheGlideHere() {
    QTRY_VERIFY(view_->grab().width() > 0 && view_->isComplete());
    const document::EngineOut glide = situation_.plan->engineOutAt(2400.0);
    const QPointF middle = view_->camera().toScreen(glide.path[glide.path.size() * 2 / 3].pose.point());
    const QColor color = style::ChartColors::of(style::Theme::Light).glide(glide.margin);
    QVERIFY(!hasColorNear(view_->grab().toImage(), middle, 1, color));
    state_->setHovered(2400.0);
    QVERIFY(hasColorNear(view_->grab().toImage(), middle, 1, color));
  }

  void click_onTheTour_pins() {
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at({-1200.0, 500.0}));
    QVERIFY(state_->pinned().has_value());
    QVERIFY(geo::distance(situation_.plan->at(*state_->pinned()).pose.point(), {-1200.0, 500.0}) < 40.0);
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QVERIFY(!state_->pinned());
  }

  void pointer_isReportedAsAPlaceAndAsNothingWhenItLeaves() {
    QSignalSpy pointer(view_.get(), &MapView::pointerMoved);
    move(*view_, {210, 333});
    QVERIFY(pointer.count() > 0);
    const auto place = pointer.last()[0].value<std::optional<geo::LatLon>>();
    QVERIFY(place.has_value());
    QVERIFY(geo::distance(situation_.terrain->frame.toPoint(*place), view_->camera().toGround({210.0, 333.0})) < 0.01);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(view_.get(), &leave);
    QVERIFY(!pointer.last()[0].value<std::optional<geo::LatLon>>());
  }

  void placeUnderThePointer_isThatOfTheMapWhenItMoves() {
    move(*view_, {150, 150});
    move(*view_, {210, 333});
    QSignalSpy pointer(view_.get(), &MapView::pointerMoved);
    state_->showPlace({900.0, -700.0});
    QVERIFY(pointer.count() > 0);
    const auto place = pointer.last()[0].value<std::optional<geo::LatLon>>();
    QVERIFY(place.has_value());
    QVERIFY(geo::distance(situation_.terrain->frame.toPoint(*place), view_->camera().toGround({210.0, 333.0})) < 0.01);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(view_.get(), &leave);
    pointer.clear();
    view_->zoomIn();
    QCOMPARE(pointer.count(), 0);  // no pointer, no place
  }

  void keys_panZoomAndGoHome() {
    const MapCamera start = view_->camera();
    QTest::keyClick(view_.get(), Qt::Key_Right);
    QVERIFY(view_->camera().centre().x > start.centre().x);
    QTest::keyClick(view_.get(), Qt::Key_Up);
    QVERIFY(view_->camera().centre().y > start.centre().y);
    QTest::keyClick(view_.get(), Qt::Key_PageUp);
    QVERIFY(view_->camera().metresPerPixel() < start.metresPerPixel());
    QTest::keyClick(view_.get(), Qt::Key_PageDown);
    QTest::keyClick(view_.get(), Qt::Key_Minus);
    QVERIFY(view_->camera().metresPerPixel() > start.metresPerPixel());
    QTest::keyClick(view_.get(), Qt::Key_Home, Qt::ControlModifier);
    for (const document::TourSample& sample : situation_.plan->samples()) {
      QVERIFY(view_->camera().screen().contains(view_->camera().toScreen(sample.state.pose.point())));
    }
  }

  void history_goesBackAndForward() {
    const MapCamera first = view_->camera();
    view_->centreOn({2000.0, 2000.0});
    const MapCamera second = view_->camera();
    view_->zoomToTarget(1);
    QVERIFY(view_->camera().metresPerPixel() < second.metresPerPixel());
    const MapCamera third = view_->camera();
    QTest::keyClick(view_.get(), Qt::Key_Left, Qt::AltModifier);
    QCOMPARE(view_->camera(), second);
    QTest::keyClick(view_.get(), Qt::Key_Left, Qt::AltModifier);
    QCOMPARE(view_->camera(), first);
    QTest::keyClick(view_.get(), Qt::Key_Right, Qt::AltModifier);
    QTest::keyClick(view_.get(), Qt::Key_Right, Qt::AltModifier);
    QCOMPARE(view_->camera(), third);
    QVERIFY(!view_->canGoForward());
  }

  void doubleClick_onATarget_zoomsToIt() {
    const geo::Point target = situation_.targets->at(1).point;
    QTest::mouseDClick(view_.get(), Qt::LeftButton, {}, at(target));
    QVERIFY(geo::distance(view_->camera().centre(), target) < 1.0);
    QVERIFY(view_->camera().metresPerPixel() < 13.0);
  }

  void deleteKey_asksToRemoveTheSelectedTarget() {
    QSignalSpy removed(view_.get(), &MapView::targetRemoveRequested);
    QTest::keyClick(view_.get(), Qt::Key_Delete);
    QCOMPARE(removed.count(), 0);
    state_->selectTarget(1);
    QTest::keyClick(view_.get(), Qt::Key_Delete);
    QCOMPARE(removed.count(), 1);
    QCOMPARE(removed[0][0].toInt(), 1);
  }

  void contextMenu_namesTheObject() {
    const QStringList target = entriesOf(*view_, at(situation_.targets->at(0).point));
    QVERIFY(target.contains(QStringLiteral("Move target 1…")));
    QVERIFY(target.contains(QStringLiteral("Rename target 1…")));
    QVERIFY(target.contains(QStringLiteral("Delete target 1")));
    // an ampersand in a name is written, not taken for a mnemonic
    QVERIFY(entriesOf(*view_, at(situation_.targets->at(1).point)).contains(QStringLiteral("Delete target Castle && Lake")));
    QVERIFY(entriesOf(*view_, at({-3560.0, -3000.0})).contains(QStringLiteral("Exclude runway LSZA 09")));
    QVERIFY(entriesOf(*view_, at({-2840.0, -3000.0})).contains(QStringLiteral("Exclude runway LSZA 27")));
    QVERIFY(entriesOf(*view_, at({3000.0, 3400.0})).contains(QStringLiteral("Use runway LSZX 18 again")));
    QVERIFY(entriesOf(*view_, at({1000.0, -500.0})).contains(QStringLiteral("Insert target before target Castle && Lake")));
    const QPoint ground = at({0.0, 3000.0});
    const QString where = style::Units::position(situation_.terrain->frame.toLatLon(view_->camera().toGround(ground)));
    QVERIFY(entriesOf(*view_, ground).contains(QStringLiteral("Add target at ") + where));
    QVERIFY(entriesOf(*view_, ground).contains(QStringLiteral("Measure from here")));
  }

  void contextMenu_ofAnAirspace_asksForItsUse() {
    mission::Airspace airspace{"BERN & TMA", "C", {mission::AirspaceLimit::Kind::Msl, 1200.0}, {mission::AirspaceLimit::Kind::Msl, 3000.0}, {}};
    for (const geo::Point& corner : {geo::Point{-1000.0, 2500.0}, {1000.0, 2500.0}, {0.0, 3500.0}}) {
      airspace.outline.push_back(situation_.terrain->frame.toLatLon(corner));
    }
    mission::AirspaceSettings settings;
    settings.otherwise = mission::AirspaceUse::Warn;
    situation_.airspaces = std::make_shared<const std::vector<document::ShownAirspace>>(
        std::vector<document::ShownAirspace>{document::shownAirspace(airspace, settings, situation_.terrain->frame)});
    view_->setSituation(situation_);
    view_->setCamera(MapCamera({0.0, 0.0}, 16.0, view_->camera().size()));
    QVERIFY(entriesOf(*view_, at({0.0, 2000.0})).filter(QStringLiteral("Airspace")).isEmpty());
    const std::unique_ptr<QMenu> menu = view_->contextMenuAt(at({0.0, 2800.0}));
    QAction* entry = menu->actions().front();
    QVERIFY2(entry->text().startsWith(QStringLiteral("Airspace C BERN && TMA, ")), qPrintable(entry->text()));
    const QList<QAction*> uses = entry->menu()->actions();
    QSignalSpy asked(view_.get(), &MapView::airspaceUseRequested);
    QSignalSpy rules(view_.get(), &MapView::airspaceRulesRequested);
    QVERIFY(uses[2]->isChecked() && uses[2]->text() == QStringLiteral("Warn when entered"));
    uses[3]->trigger();
    QCOMPARE(asked[0][0].toString(), QString());
    QCOMPARE(asked[0][1].toString(), QStringLiteral("BERN & TMA"));
    QCOMPARE(asked[0][2].value<mission::AirspaceUse>(), mission::AirspaceUse::Forbid);
    uses[4]->menu()->actions().front()->trigger();
    QCOMPARE(asked[1][0].toString(), QStringLiteral("C"));
    QCOMPARE(asked[1][2].value<mission::AirspaceUse>(), mission::AirspaceUse::Hide);
    uses.back()->trigger();
    QCOMPARE(rules.count(), 1);
  }

  void contextMenu_entriesAskForWhatTheySay() {
    QSignalSpy removed(view_.get(), &MapView::targetRemoveRequested);
    QSignalSpy renamed(view_.get(), &MapView::targetRenameRequested);
    QSignalSpy edited(view_.get(), &MapView::targetEditRequested);
    QSignalSpy excluded(view_.get(), &MapView::siteExcludeRequested);
    QSignalSpy home(view_.get(), &MapView::homeRequested);
    QSignalSpy added(view_.get(), &MapView::targetAddRequested);
    const QPoint target = at(situation_.targets->at(0).point);
    trigger(*view_, target, QStringLiteral("Delete target 1"));
    trigger(*view_, target, QStringLiteral("Rename target 1…"));
    trigger(*view_, target, QStringLiteral("Edit height of target 1…"));
    QCOMPARE(removed.count() + renamed.count() + edited.count(), 3);
    trigger(*view_, at({-3560.0, -3000.0}), QStringLiteral("Start and end at LSZA 09"));
    QCOMPARE(home[0], (QVariantList{QStringLiteral("LSZA/09"), QStringLiteral("LSZA/09")}));
    trigger(*view_, at({-3560.0, -3000.0}), QStringLiteral("Exclude runway LSZA 09"));
    QCOMPARE(excluded[0][0].toString(), QStringLiteral("LSZA/09"));
    QCOMPARE(excluded[0][1].toBool(), true);
    trigger(*view_, at({3000.0, 3400.0}), QStringLiteral("Use runway LSZX 18 again"));
    QCOMPARE(excluded[1][0].toString(), QStringLiteral("LSZX/18"));
    QCOMPARE(excluded[1][1].toBool(), false);
    trigger(*view_, at({1000.0, -500.0}), QStringLiteral("Insert target before target Castle && Lake"));
    QCOMPARE(added[0][1].toInt(), 1);
    trigger(*view_, at({1000.0, -500.0}), QStringLiteral("Show an engine failure here"));
    QVERIFY(state_->pinned().has_value());
  }

  void contextMenu_move_carriesTheTargetUntilAClick() {
    QSignalSpy moved(view_.get(), &MapView::targetMoveRequested);
    trigger(*view_, at(situation_.targets->at(0).point), QStringLiteral("Move target 1…"));
    QCOMPARE(view_->cursor().shape(), Qt::SizeAllCursor);
    const QPoint to = at({1500.0, 2500.0});
    move(*view_, to);
    QCOMPARE(moved.count(), 0);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, to);
    QCOMPARE(moved.count(), 1);
    QCOMPARE(moved[0][0].toInt(), 0);
    QVERIFY(geo::distance(placeOf(moved[0], 1), view_->camera().toGround(to)) < 0.01);
    trigger(*view_, at(situation_.targets->at(0).point), QStringLiteral("Move target 1…"));
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, to);
    QCOMPARE(moved.count(), 1);
  }

  void carriedTarget_removedMeanwhile_isLetGo() {
    QSignalSpy moved(view_.get(), &MapView::targetMoveRequested);
    view_->moveTarget(1);
    auto targets = std::make_shared<std::vector<document::ShownTarget>>(*situation_.targets);
    targets->pop_back();
    situation_.targets = targets;
    view_->setSituation(situation_);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at({1500.0, 2500.0}));
    QCOMPARE(moved.count(), 0);
  }

  void measureTool_drawsALineAndLeavesOnEscape() {
    QTRY_VERIFY(view_->grab().width() > 0 && view_->isComplete());
    view_->setTool(MapView::Tool::Measure);
    const QPoint from(200, 100);
    const QPoint to(500, 100);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, from);
    move(*view_, to);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, to);
    const QColor ink = style::ChartColors::of(style::Theme::Light).selection;
    const QImage image = view_->grab().toImage();
    int found = 0;
    for (int x = 210; x < 490; ++x) {
      found += hasColorNear(image, QPointF(x, 100.0), 0, ink, 60) ? 1 : 0;
    }
    QVERIFY2(found > 100, qPrintable(QString::number(found)));
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QVERIFY(!hasColorNear(view_->grab().toImage(), QPointF(350.0, 100.0), 10, ink, 60));
    QTest::keyClick(view_.get(), Qt::Key_Escape);
    QCOMPARE(view_->tool(), MapView::Tool::Select);
  }

  void shiftClick_drawsRangeRings_againOnTheMiddleRemovesThem() {
    QTRY_VERIFY(view_->grab().width() > 0 && view_->isComplete());
    const QPoint middle = at({-1000.0, 2000.0});
    const geo::Point place = view_->camera().toGround(middle);
    const QColor ink = style::ChartColors::of(style::Theme::Light).selection;
    // 1 NM north-east of the middle by the geodesic: where nothing else is drawn
    const geo::LocalFrame& frame = situation_.terrain->frame;
    const geo::LatLon north = geo::geodesicDestination(frame.toLatLon(place), Angle::degrees(20.0), Length::fromSi(kMetresPerNauticalMile));
    const QPointF onRing = view_->camera().toScreen(frame.toPoint(north));
    QVERIFY(!hasColorNear(view_->grab().toImage(), onRing, 1, ink, 60));
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ShiftModifier, middle);
    QCOMPARE(view_->rings().count(), 1U);
    QVERIFY(hasColorNear(view_->grab().toImage(), onRing, 1, ink, 60));
    move(*view_, middle + QPoint(30, 0));
    move(*view_, middle + QPoint(2, 1));
    QCOMPARE(view_->cursor().shape(), Qt::PointingHandCursor);
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ShiftModifier, at({2000.0, 2500.0}));
    QCOMPARE(view_->rings().count(), 2U);
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ShiftModifier, middle + QPoint(2, 1));
    QCOMPARE(view_->rings().count(), 1U);
    QVERIFY(!hasColorNear(view_->grab().toImage(), onRing, 1, ink, 60));
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at({2000.0, 2500.0}));
    QCOMPARE(view_->rings().count(), 0U);
  }

  void rangeRings_followTheUnits_andAreRemovedByMenu() {
    QTRY_VERIFY(view_->grab().width() > 0 && view_->isComplete());
    const geo::Point place{0.0, 2600.0};
    trigger(*view_, at(place), QStringLiteral("Range rings from here"));
    QCOMPARE(view_->rings().count(), 1U);
    state_->setUnits(style::Units(style::UnitSystem::Metric));
    const geo::LocalFrame& frame = situation_.terrain->frame;
    const geo::LatLon middle = frame.toLatLon(view_->camera().toGround(at(place)));
    const geo::LatLon edge = geo::geodesicDestination(middle, Angle::degrees(20.0), Length::fromSi(1000.0));
    const QColor ink = style::ChartColors::of(style::Theme::Light).selection;
    QVERIFY(hasColorNear(view_->grab().toImage(), view_->camera().toScreen(frame.toPoint(edge)), 1, ink, 60));
    trigger(*view_, at(place), QStringLiteral("Remove the range rings here"));
    QCOMPARE(view_->rings().count(), 0U);
    view_->toggleRings(place);
    view_->toggleRings({500.0, 500.0});
    view_->clearRings();
    QCOMPARE(view_->rings().count(), 0U);
  }

  void clickWithKeys_doesWhatTheManualSays() {
    QSignalSpy added(view_.get(), &MapView::targetAddRequested);
    QSignalSpy moved(view_.get(), &MapView::targetMoveRequested);
    const QPoint ground = at({1000.0, 2000.0});
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ShiftModifier | Qt::AltModifier, ground);
    QCOMPARE(added.count(), 1);
    QCOMPARE(added[0][1].toInt(), -1);
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ControlModifier | Qt::AltModifier, at({1000.0, -1200.0}));
    QCOMPARE(added.count(), 2);
    QCOMPARE(added[1][1].toInt(), 1);  // the leg below leads to the second target
    QTest::mouseClick(view_.get(), Qt::LeftButton, Qt::ControlModifier, at(situation_.targets->at(0).point));
    QCOMPARE(view_->tool(), MapView::Tool::Measure);
    QCOMPARE(state_->selectedTarget(), -1);
    QCOMPARE(moved.count(), 0);
  }

  void click_onARunway_namesItToTheWindow() {
    QSignalSpy clicked(view_.get(), &MapView::siteClicked);
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, at({-3560.0, -3000.0}));
    QCOMPARE(clicked.count(), 1);
    QCOMPARE(clicked[0][0].toString(), QStringLiteral("LSZA/09"));
  }

  void showPlan_bringsTheWholeTourIntoView() {
    view_->setCamera(MapCamera({30000.0, 0.0}, 2.0, {}));
    view_->showPlan();
    for (const document::TourSample& sample : situation_.plan->samples()) {
      QVERIFY(view_->camera().screen().contains(view_->camera().toScreen(sample.state.pose.point())));
    }
    QVERIFY2(view_->camera().metresPerPixel() < 10.0, "and no smaller than it has to be");
  }

  void placeRequest_bringsItIntoView() {
    state_->showPlace({4000.0, 4000.0});
    QVERIFY(geo::distance(view_->camera().centre(), {4000.0, 4000.0}) < 1e-6);
  }

  void objects_underPanning_stayWithTheGround() {
    QTRY_VERIFY(view_->grab().width() > 0 && view_->isComplete());
    const QColor ink = style::ChartColors::of(style::Theme::Light).route;
    for (const QPointF step : {QPointF(37.0, 21.0), QPointF(90.0, -40.0), QPointF(120.0, 10.0)}) {
      view_->setCamera(view_->camera().panned(step));
      const QPointF on = view_->camera().toScreen({-1500.0, -500.0});
      QVERIFY(hasColorNear(view_->grab().toImage(), on, 3, ink));
    }
  }

  void themeAndSituation_changeThePicture() {
    QTRY_VERIFY(view_->grab().width() > 0 && view_->isComplete());
    const QRgb light = view_->grab().toImage().pixel(400, 80);
    state_->setTheme(style::Theme::Dark);
    QTRY_VERIFY(qGray(view_->grab().toImage().pixel(400, 80)) < qGray(light) - 40 && view_->isComplete());
    document::Situation outdated = situation_;
    outdated.planIsCurrent = false;
    view_->setSituation(outdated);
    QCOMPARE(countColor(view_->grab().toImage(), style::ChartColors::of(style::Theme::Dark).route), 0);
  }

  void newTerrain_inAnotherFrame_bringsItIntoView() {
    view_->centreOn({90000.0, 90000.0});
    document::Situation other;
    auto terrain = std::make_shared<document::TerrainData>(*situation_.terrain);
    terrain->frame = geo::LocalFrame({40.0, 3.0});
    other.terrain = terrain;
    view_->setSituation(other);
    QVERIFY(view_->camera().screen().contains(view_->camera().toScreen({0.0, 0.0})));
    QVERIFY(!view_->canGoBack());
  }

  void firstContent_isBroughtIntoView_untilSomebodyClicks() {
    MapView fresh(*state_);
    fresh.resize(600, 400);
    document::Situation loading;
    loading.terrain = situation_.terrain;
    fresh.setSituation(loading);
    const MapCamera onTerrain = fresh.camera();
    fresh.setSituation(situation_);
    QVERIFY(fresh.camera().metresPerPixel() < onTerrain.metresPerPixel());
    const MapCamera onTour = fresh.camera();
    QTest::mouseClick(&fresh, Qt::LeftButton, {}, {20, 20});
    fresh.setSituation(loading);
    QCOMPARE(fresh.camera(), onTour);
  }

  void emptyMap_saysWhatToDoNext() {
    MapView empty(*state_);
    empty.resize(600, 400);
    const QImage image = empty.grab().toImage();
    QVERIFY(countColor(image, style::ChartColors::of(style::Theme::Light).text, 40) > 300);
    QVERIFY(empty.contextMenuAt({100.0, 100.0}) != nullptr);
    QSignalSpy added(&empty, &MapView::targetAddRequested);
    empty.setTool(MapView::Tool::AddTarget);
    QTest::mouseClick(&empty, Qt::LeftButton, {}, {100, 100});
    QCOMPARE(added.count(), 0);
  }

  void accessibility_isNamed() {
    QCOMPARE(view_->accessibleName(), QStringLiteral("Map"));
    QVERIFY(!view_->accessibleDescription().isEmpty());
  }
};

QTEST_MAIN(TestMapView)
#include "tst_map_view.moc"
