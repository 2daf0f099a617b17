// The operator's whole job in the real window, by mouse and keys: terrain, airfields, filter, targets, undo, plan, cancel, plan
// again, look at the glides, export, save, open again. Runs without a display, and under Xvfb with the OpenGL view.
#include "app/gui/main_window.h"
#include "core/formats/plan_file.h"
#include "tests/gui/operator.h"
#include "ui/dialogs/message_banner.h"
#include "ui/document/settings.h"
#include "ui/map/map_view.h"
#include "ui/panels/engine_out_panel.h"
#include "ui/panels/site_panel.h"
#include "ui/profile/profile_view.h"
#include "ui/profile/tour_curves.h"
#include "ui/scene3d/scene_view.h"

#include <QAbstractItemModel>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QColor>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QModelIndex>
#include <QPoint>
#include <QPointF>
#include <QPointer>
#include <QPushButton>
#include <QSlider>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <memory>

using namespace vp;
using namespace vp::test;
using Activity = jobs::Workspace::Activity;

namespace {

constexpr int kLong = 120'000;  // ms; patience, not a measurement

QString bundled(const char* name) {
  return QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/") + QLatin1String(name);
}

}  // namespace

class TestWholeJob : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  std::unique_ptr<gui::MainWindow> window_;

  [[nodiscard]] jobs::Workspace& desk() const { return window_->workspace(); }
  [[nodiscard]] const mission::Mission& mission() const { return window_->workspace().document().mission(); }
  [[nodiscard]] map::MapView& map() const { return window_->mapView(); }
  [[nodiscard]] QPoint onScreen(geo::Point ground) const { return map().camera().toScreen(ground).toPoint(); }
  void trigger(const char* name) const {
    QAction* action = window_->action(QLatin1String(name));
    QVERIFY2(action != nullptr && action->isEnabled(), name);
    action->trigger();
  }
  /// Keys of the window's own actions, which need it to be the active one.
  void keys(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const {
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QTest::keyClick(window_.get(), key, modifiers);
  }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) const { QTest::keyClick(&map(), key, modifiers); }

private slots:
  void initTestCase() {
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    QCoreApplication::setApplicationVersion(QStringLiteral("test"));
    window_ = std::make_unique<gui::MainWindow>(folder_.filePath("settings.ini"));
    window_->resize(1400, 900);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->activateWindow();
    map().setFocus();
  }

  void emptyMission_planned_saysWhatIsMissing() {
    trigger("planStart");
    QVERIFY(window_->banner().isVisible());
    QVERIFY2(window_->banner().text().contains("terrain"), qPrintable(window_->banner().text()));
    QCOMPARE(desk().activity(), Activity::Idle);
  }

  void brokenTerrain_dropped_isRefusedAndChangesNothing() {
    QFile file(folder_.filePath("broken.tif"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("this is no raster");
    file.close();
    drop(*window_, {file.fileName()});
    QTRY_VERIFY(window_->banner().isVisible() && window_->banner().text().contains("broken.tif"));
    QVERIFY(mission().terrain.empty());
    QVERIFY(!desk().document().isModified());
  }

  void terrainAndAirfields_dropped_areShown() {
    drop(*window_, {bundled("alpine.tif")});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().terrain != nullptr, kLong);
    drop(*window_, {bundled("alpine-airports.csv"), bundled("alpine-runways.csv")});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().sites && desk().situation().sites->size() == 24U, kLong);
    QCOMPARE(mission().airfields.size(), 1U);
    QVERIFY(window_->isWindowModified());
  }

  void runway_uncheckedInTheTable_isLeftOut() {
    auto* panel = window_->findChild<panels::SitePanel*>();
    QVERIFY(panel != nullptr);
    QAbstractItemModel* model = panel->table().model();
    QCOMPARE(model->rowCount(), 24);
    QModelIndex row;
    for (int i = 0; i < model->rowCount(); ++i) {
      if (model->index(i, 0).data().toString().startsWith("VA05 15")) {
        row = model->index(i, 0);
      }
    }
    QVERIFY(row.isValid());
    QVERIFY(model->setData(row, Qt::Unchecked, Qt::CheckStateRole));
    const auto used = [this] {
      const auto& sites = desk().situation().sites;
      return sites ? std::count_if(sites->begin(), sites->end(), [](const document::ShownSite& s) { return s.usable; }) : 0;
    };
    QTRY_COMPARE_WITH_TIMEOUT(used(), 23, kLong);
    QCOMPARE(desk().situation().sites->size(), 24U);
    QCOMPARE(mission().siteFilter.exclude.size(), 1U);
  }

  void clicksWithTheAddTool_becomeTargets() {
    trigger("viewHome");
    trigger("toolAdd");
    const geo::Box area = desk().situation().terrain->grid->extent();
    const double w = area.maxX - area.minX;
    const double h = area.maxY - area.minY;
    for (const auto& [x, y] : {std::pair{0.35, 0.35}, std::pair{0.55, 0.40}, std::pair{0.45, 0.60}}) {
      QTest::mouseClick(&map(), Qt::LeftButton, {}, onScreen({area.minX + x * w, area.minY + y * h}));
    }
    QCOMPARE(mission().targets.size(), 3U);
    QCOMPARE(mission().targets[1].name, std::string("T02"));
    press(Qt::Key_Escape);
    QCOMPARE(map().tool(), map::MapView::Tool::Select);
    for (const document::ShownTarget& target : *desk().situation().targets) {
      QVERIFY2(target.altitude.has_value(), target.problem.c_str());
    }
  }

  void target_dragged_movesAndUndoBringsItBack() {
    const geo::LatLon before = mission().targets[1].position;
    const QPoint from = onScreen((*desk().situation().targets)[1].point);
    const QPoint to = from + QPoint(40, 25);
    QTest::mousePress(&map(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&map(), from + QPoint(10, 6));
    QTest::mouseMove(&map(), to);
    QTest::mouseRelease(&map(), Qt::LeftButton, {}, to);
    QVERIFY(!(mission().targets[1].position == before));
    const QPoint now = onScreen((*desk().situation().targets)[1].point);
    QVERIFY2((now - to).manhattanLength() <= 3, "the target lies where the mouse let it go");
    QAction* undo = window_->action("editUndo");
    QVERIFY2(undo->text().contains("T02"), qPrintable(undo->text()));
    undo->trigger();
    QVERIFY(mission().targets[1].position == before);
    window_->action("editRedo")->trigger();
    QVERIFY(!(mission().targets[1].position == before));
  }

  void targets_reordered_byKeys() {
    desk().view().selectTarget(0);
    keys(Qt::Key_Down, Qt::ControlModifier);
    QCOMPARE(mission().targets[1].name, std::string("T01"));
    QCOMPARE(desk().view().selectedTarget(), 1);
    keys(Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(mission().targets[0].name, std::string("T01"));
    QVERIFY(!window_->action("editUp")->isEnabled());
  }

  void preferences_byKeys_applyAtOnce_andLeaveTheMissionAlone() {
    const auto before = desk().document().sharedMission();
    inDialog("preferencesDialog", [this](QDialog& dialog) {
      auto* units = dialog.findChild<QComboBox*>("units");
      units->setCurrentIndex(units->findData(static_cast<int>(style::UnitSystem::Metric)));
      QVERIFY2(desk().view().units().system() == style::UnitSystem::Metric, "while the dialog is still open");
      dialog.findChild<QDoubleSpinBox*>("clearance")->setValue(222.0);
      QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    keys(Qt::Key_Comma, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(desk().view().units().system() == style::UnitSystem::Metric);
    QVERIFY(window_->action("unitsMetric")->isChecked());
    QVERIFY(desk().document().sharedMission() == before);
    const document::Settings remembered(folder_.filePath("settings.ini"));
    QVERIFY(remembered.unitSystem() == style::UnitSystem::Metric);
    QCOMPARE(remembered.missionDefaults().safety.clearance.si(), 222.0);
    trigger("unitsAviation");
    QVERIFY(document::Settings(folder_.filePath("settings.ini")).unitSystem() == style::UnitSystem::Aviation);
    gui::MainWindow next(folder_.filePath("settings.ini"));
    QCOMPARE(next.workspace().document().mission().safety.clearance.si(), 222.0);
    QVERIFY(!next.workspace().document().isModified());
  }

  void jump_toAnAirfield_movesTheMap_nonsenseDoesNot() {
    const document::ShownSite& site = desk().situation().sites->front();
    inDialog("jumpDialog", [&](QDialog& dialog) {
      auto* text = dialog.findChild<QLineEdit*>("jumpText");
      QTest::keyClicks(text, QString::fromStdString(site.site.site.airportIdent).toLower());
      QTest::keyClick(text, Qt::Key_Return);
    });
    keys(Qt::Key_Home, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(geo::distance(map().camera().centre(), site.site.pose.point()) < 1.0);
    const map::MapCamera there = map().camera();
    QString said;
    inDialog("jumpDialog", [&](QDialog& dialog) {
      auto* text = dialog.findChild<QLineEdit*>("jumpText");
      QTest::keyClicks(text, QStringLiteral("95 N 200 E"));
      QTest::keyClick(text, Qt::Key_Return);
      said = dialog.findChild<QLabel*>("jumpProblem")->text();
      QTest::keyClick(&dialog, Qt::Key_Escape);
    });
    trigger("viewJump");
    QVERIFY2(said.contains("not a position"), qPrintable(said));
    QVERIFY(map().camera() == there);
    press(Qt::Key_Left, Qt::AltModifier);  // the view before the jump
    QVERIFY(!(map().camera() == there));
  }

  void rangeRings_byShiftClick_comeAndGo() {
    const QPoint middle = map().rect().center() + QPoint(40, 60);
    QTest::mouseClick(&map(), Qt::LeftButton, Qt::ShiftModifier, middle);
    QCOMPARE(map().rings().count(), 1U);
    QTest::mouseClick(&map(), Qt::LeftButton, Qt::ShiftModifier, middle);
    QCOMPARE(map().rings().count(), 0U);
    keys(Qt::Key_R);
    QCOMPARE(map().rings().count(), 1U);
    keys(Qt::Key_R, Qt::ShiftModifier);
    QCOMPARE(map().rings().count(), 0U);
  }

  void airfields_removedInTheFileList_areBackAfterUndo() {
    trigger("missionFiles");
    QPointer<QDialog> dialog = window_->findChild<QDialog*>("missionFilesDialog");
    QVERIFY(dialog != nullptr && dialog->isVisible());
    auto* list = dialog->findChild<QTableWidget*>("missionFiles");
    QCOMPARE(list->rowCount(), 2);
    list->setCurrentCell(1, 0);
    QVERIFY(QTest::qWaitForWindowActive(dialog));
    list->setFocus();
    QTest::keyClick(list, Qt::Key_Delete);
    QVERIFY(mission().airfields.empty());
    QVERIFY2(mission().siteFilter.exclude.empty(), "nothing is left that this could name");
    QCOMPARE(list->rowCount(), 1);
    QVERIFY2(window_->action("editUndo")->text().contains("Remove airfields alpine-airports.csv"), qPrintable(window_->action("editUndo")->text()));
    QTRY_VERIFY_WITH_TIMEOUT(desk().activity() == Activity::Idle && (!desk().situation().sites || desk().situation().sites->empty()), kLong);
    trigger("editUndo");
    QCOMPARE(mission().airfields.size(), 1U);
    QCOMPARE(mission().siteFilter.exclude.size(), 1U);
    QCOMPARE(list->rowCount(), 2);
    QTRY_VERIFY_WITH_TIMEOUT(desk().activity() == Activity::Idle && desk().situation().sites && desk().situation().sites->size() == 24U, kLong);
    dialog->close();
    QTRY_VERIFY(dialog.isNull());
  }

  void planning_cancelled_leavesEverythingAsItWas() {
    trigger("planStart");
    QCOMPARE(desk().activity(), Activity::Planning);
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().sketch != nullptr || desk().activity() == Activity::Idle, kLong);
    QVERIFY2(desk().activity() == Activity::Planning, "the first snapshot comes long before the end");
    trigger("planStop");
    QTRY_COMPARE_WITH_TIMEOUT(desk().activity(), Activity::Idle, kLong);
    QVERIFY(desk().situation().plan == nullptr);
    QVERIFY(desk().document().plan() == nullptr);
    QVERIFY2(window_->banner().text().contains("stopped"), qPrintable(window_->banner().text()));
  }

  void planningAgain_endsVerifiedAndIsDrawn() {
    trigger("planStart");
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().plan != nullptr, kLong);
    QVERIFY(desk().situation().plan->isVerified());
    QVERIFY(desk().situation().planIsCurrent);
    QVERIFY2(window_->banner().text().contains("Verified"), qPrintable(window_->banner().text()));
    // the tour is where the data says: magenta in the map's own pixels, where no target's mark lies over it
    QTRY_VERIFY_WITH_TIMEOUT(map().isComplete(), kLong);
    const QImage picture = map().grab().toImage();
    const document::PlanView& plan = *desk().situation().plan;
    const QColor route = style::ChartColors::of(desk().view().theme()).route;
    int found = 0;
    int looked = 0;
    constexpr int kProbes = 40;
    constexpr double kMark = 16.0;  // px, radius of a target's mark when selected
    for (int i = 0; i < kProbes; ++i) {
      const QPointF at = map().camera().toScreen(plan.at(plan.length() * (i + 0.5) / kProbes).pose.point());
      const auto isUnder = [&](const mission::TargetInFrame& target) {
        const QPointF away = map().camera().toScreen(target.point) - at;
        return std::hypot(away.x(), away.y()) < kMark;
      };
      if (std::any_of(plan.plan().targets.begin(), plan.plan().targets.end(), isUnder)) {
        continue;
      }
      ++looked;
      const QColor pixel = picture.pixelColor((at * picture.devicePixelRatio()).toPoint());
      found += std::abs(pixel.red() - route.red()) + std::abs(pixel.green() - route.green()) + std::abs(pixel.blue() - route.blue()) < 90 ? 1 : 0;
    }
    QVERIFY2(looked > kProbes / 2 && found > looked * 3 / 4, qPrintable(QString("%1 of %2").arg(found).arg(looked)));
  }

  void pointerOnTheRoute_showsTheGlideEverywhere() {
    const document::PlanView& plan = *desk().situation().plan;
    const double distance = plan.length() * 0.3;
    QTest::mouseMove(&map(), onScreen(plan.at(distance).pose.point()));
    QTRY_VERIFY(desk().view().hovered().has_value());
    QVERIFY(std::abs(*desk().view().hovered() - distance) < 2000.0);
    const document::EngineOut glide = plan.engineOutAt(*desk().view().hovered());
    const std::string runway = plan.plan().sites[static_cast<std::size_t>(glide.site)].site.airportIdent;
    auto* panel = window_->findChild<panels::EngineOutPanel*>();
    const auto says = [&] {
      for (const QLabel* label : panel->findChildren<QLabel*>()) {
        if (label->text().contains(QString::fromStdString(runway))) {
          return true;
        }
      }
      return false;
    };
    QTRY_VERIFY2(says(), runway.c_str());
    QTest::mouseMove(&map(), QPoint(3, map().height() - 3));
    QTRY_VERIFY(!desk().view().hovered().has_value());
  }

  void leastMarginAndClearance_standInTheStatusBar_andLeadThere() {
    const document::PlanView& plan = *desk().situation().plan;
    auto* margin = window_->findChild<QToolButton*>("statusLeastMargin");
    auto* clearance = window_->findChild<QToolButton*>("statusLeastClearance");
    QVERIFY(margin->isVisible() && clearance->isVisible());
    const style::Units units = desk().view().units();
    QVERIFY2(margin->text().contains(units.margin(profile::shownMargin(plan.leastGlideMargin().state.glideMargin()))), qPrintable(margin->text()));
    QVERIFY2(clearance->text().contains(units.heightAboveGround(plan.leastClearance().state.clearance())), qPrintable(clearance->text()));
    clearance->click();
    QCOMPARE(*desk().view().pinned(), plan.leastClearance().state.distance);
    margin->click();
    QCOMPARE(*desk().view().pinned(), plan.leastGlideMargin().state.distance);
  }

  void profile_hovered_marksTheMap() {
    profile::ProfileView& profile = window_->profileView();
    const QPoint middle(profile.width() / 2, profile.height() / 2);
    QTest::mouseMove(&profile, middle + QPoint(1, 0));
    QTest::mouseMove(&profile, middle);
    QTRY_VERIFY(desk().view().hovered().has_value());
    QTest::mouseClick(&profile, Qt::LeftButton, {}, middle);
    QTRY_VERIFY(desk().view().pinned().has_value());
    QTest::mouseMove(&profile, QPoint(1, 1));
  }

  void slider_scrubsTheTour() {
    auto* slider = window_->findChild<QSlider*>("tourSlider");
    QVERIFY(slider != nullptr);
    slider->setValue(slider->minimum() + (slider->maximum() - slider->minimum()) / 4);
    QTRY_VERIFY(desk().view().pinned().has_value());
    const double quarter = desk().situation().plan->length() / 4.0;
    QVERIFY(std::abs(*desk().view().pinned() - quarter) < 0.05 * desk().situation().plan->length());
    trigger("planWorst");
    QCOMPARE(*desk().view().pinned(), desk().situation().plan->leastGlideMargin().state.distance);
  }

  void scene_shown_isDrawnOrSaysWhyNot() {
    trigger("viewScene");
    scene3d::SceneView* scene = window_->sceneView();
    QVERIFY(scene != nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(!scene->problem().isEmpty() || scene->isSettled(), kLong);
    trigger("viewScene");
    QVERIFY(!scene->isVisible());
  }

  void flightPlan_exported_isThere() {
    const QString file = folder_.filePath("tour.fms");
    answerFileDialog(file);
    int margins = 0;
    inDialog("exportReview", [&margins](QDialog& dialog) {  // shown although nothing warns
      margins = dialog.findChild<QTableWidget*>("exportMargins")->rowCount();
      dialog.findChild<QPushButton*>("exportWrite")->click();
    });
    trigger("export-fms");
    QTRY_VERIFY_WITH_TIMEOUT(window_->banner().text().contains("tour.fms"), kLong);
    QVERIFY(margins >= 5);
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(written.readAll().contains("1100 Version"));
  }

  void briefing_written_isAPdf() {
    const QString file = folder_.filePath("tour-briefing.pdf");
    bool hadDoubt = true;
    inDialog("briefingDialog", [&hadDoubt](QDialog& dialog) {
      hadDoubt = dialog.findChild<QLabel*>("briefingDoubt") != nullptr;
      dialog.findChild<QComboBox*>("briefingPaper")->setCurrentIndex(1);
      dialog.findChild<QCheckBox*>("briefingGlides")->setChecked(false);
      dialog.accept();
    });
    answerFileDialog(file);
    trigger("fileBriefing");
    QTRY_VERIFY_WITH_TIMEOUT(window_->banner().text().contains("tour-briefing.pdf"), kLong);
    QVERIFY(!hadDoubt);
    QFile written(file);
    QVERIFY(written.open(QIODevice::ReadOnly));
    const QByteArray pdf = written.readAll();
    QVERIFY(pdf.startsWith("%PDF-"));
    QVERIFY(pdf.contains("/MediaBox [0 0 612."));
  }

  void saved_andOpenedAgain_isTheSame() {
    const QString file = folder_.filePath("job.vpm");
    answerFileDialog(file);
    trigger("fileSave");
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kLong);
    QVERIFY(QFileInfo::exists(file));
    QVERIFY(QFileInfo::exists(folder_.filePath("job.vpp")));
    gui::MainWindow other(folder_.filePath("other.ini"));
    other.show();
    other.take({file});
    QTRY_VERIFY_WITH_TIMEOUT(other.workspace().situation().plan != nullptr, kLong);
    QVERIFY(other.workspace().situation().planIsCurrent);
    QVERIFY(other.workspace().situation().plan->isVerified());
    QVERIFY(document::samePlanInputs(other.workspace().document().mission(), mission()));
    QCOMPARE(other.workspace().situation().plan->length(), desk().situation().plan->length());
  }

  void tamperedPlan_opened_losesItsCertificate() {
    auto plan = formats::readPlan(folder_.filePath("job.vpp").toStdString());
    QVERIFY(plan.has_value() && plan->certificate.has_value());
    for (mission::DecisionPoint& point : plan->tour) {
      point.altitude -= 30.0;
    }
    const QString file = folder_.filePath("tampered.vpp");
    QVERIFY(formats::writePlan(*plan, file.toStdString()).has_value());
    gui::MainWindow other(folder_.filePath("tampered.ini"));
    other.show();
    other.take({file});
    QTRY_VERIFY_WITH_TIMEOUT(other.workspace().situation().plan && !other.workspace().situation().plan->isVerified(), kLong);
    QVERIFY2(other.banner().text().contains("refuses"), qPrintable(other.banner().text()));
  }

  void editAfterPlanning_marksThePlanOutOfDate_undoMakesItCurrent() {
    desk().view().selectTarget(0);
    trigger("editDelete");
    QCOMPARE(mission().targets.size(), 2U);
    QVERIFY(desk().situation().plan != nullptr);
    QVERIFY(!desk().situation().planIsCurrent);
    QVERIFY(window_->findChild<QDockWidget*>("planDock")->windowTitle().contains('!'));
    answerMessageBox("Cancel");
    trigger("export-geojson");  // asks first, and is called off
    QVERIFY(!QFileInfo::exists(folder_.filePath("job.geojson")));
    window_->action("editUndo")->trigger();
    QVERIFY(desk().situation().planIsCurrent);
  }

  void terrain_removedAndUndone_outdatesThePlanAndBringsItBack() {
    trigger("missionFiles");
    auto* dialog = window_->findChild<QDialog*>("missionFilesDialog");
    auto* list = dialog->findChild<QTableWidget*>("missionFiles");
    list->setCurrentCell(0, 0);
    QTest::mouseClick(dialog->findChild<QPushButton*>("removeFile"), Qt::LeftButton);
    QVERIFY(mission().terrain.empty());
    QVERIFY(!desk().document().planIsCurrent());
    QVERIFY(desk().document().plan() != nullptr);
    QCOMPARE(desk().document().undoStack().undoText(), QStringLiteral("Remove terrain alpine.tif"));
    dialog->close();
    trigger("editUndo");
    QVERIFY(desk().document().planIsCurrent());
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().plan != nullptr && desk().situation().planIsCurrent, kLong);
  }

  void closingAndSaving_writesTheFileFirst() {
    gui::MainWindow other(folder_.filePath("closing.ini"));
    other.show();
    other.take({folder_.filePath("job.vpm")});
    QTRY_VERIFY_WITH_TIMEOUT(other.workspace().situation().plan != nullptr, kLong);
    other.workspace().document().edit(QStringLiteral("Name"), [](mission::Mission& m) { m.name = "closed"; });
    answerMessageBox("Save");
    other.close();
    QTRY_VERIFY_WITH_TIMEOUT(!other.isVisible(), kLong);
    QFile written(folder_.filePath("job.vpm"));
    QVERIFY(written.open(QIODevice::ReadOnly));
    QVERIFY(written.readAll().contains("\"closed\""));
  }

  void opening_whileTheDocumentIsEdited_asksAgain() {
    gui::MainWindow other(folder_.filePath("editing.ini"));
    other.show();
    other.take({folder_.filePath("job.vpm")});
    other.workspace().document().edit(QStringLiteral("Name"), [](mission::Mission& m) { m.name = "typed meanwhile"; });
    bool asked = false;
    auto* timer = new QTimer(&other);
    connect(timer, &QTimer::timeout, &other, [&asked, timer] {
      if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        asked = true;
        timer->stop();
        box->button(QMessageBox::Cancel)->click();
      }
    });
    timer->start(20);
    QTRY_VERIFY_WITH_TIMEOUT(asked, kLong);
    QCOMPARE(other.workspace().document().mission().name, std::string("typed meanwhile"));
    answerMessageBox("Discard");
    other.close();
  }

  void closingWithUnsavedWork_asks() {
    desk().view().selectTarget(0);
    trigger("editDelete");
    answerMessageBox("Cancel");
    window_->close();
    QVERIFY2(window_->isVisible(), "called off");
    answerMessageBox("Discard");
    window_->close();
    QVERIFY(!window_->isVisible());
  }
};

QTEST_MAIN(TestWholeJob)
#include "tst_whole_job.moc"
