// The operator's whole job on real terrain with voids and real airfields, in the real window. Needs the data folder beside the
// checkout (or VOLPLANE_DATA). With VOLPLANE_PICTURES=FOLDER every stage is written there as a picture, light and dark.
#include "app/gui/main_window.h"
#include "core/formats/aircraft_file.h"
#include "tests/gui/operator.h"
#include "tests/support/data_folder.h"
#include "ui/dialogs/message_banner.h"
#include "ui/map/map_view.h"
#include "ui/panels/engine_out_panel.h"
#include "ui/panels/site_panel.h"
#include "ui/profile/profile_view.h"
#include "ui/scene3d/scene_view.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFile>
#include <QGuiApplication>
#include <QLabel>
#include <QPixmap>
#include <QPoint>
#include <QPushButton>
#include <QScreen>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <memory>

using namespace vp;
using namespace vp::test;
using Activity = jobs::Workspace::Activity;

namespace {

constexpr int kLong = 900'000;  // ms; patience, not a measurement

// over the massif between Rhone, Aare and Rhine, where an aircraft that glides 11.7 : 1 can keep below the ceiling of a 172
constexpr std::array<geo::LatLon, 10> kTargets{{{46.80, 8.20},
                                                {46.75, 8.75},
                                                {46.60, 8.50},
                                                {46.72, 8.05},
                                                {46.45, 8.60},
                                                {46.22, 8.32},
                                                {46.25, 8.80},
                                                {46.15, 8.55},
                                                {46.35, 8.05},
                                                {46.85, 8.40}}};

}  // namespace

class TestRealJob : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  QString data_;
  QString pictures_ = qEnvironmentVariable("VOLPLANE_PICTURES");
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
  void raise(const char* dock) const { window_->findChild<QDockWidget*>(QLatin1String(dock))->raise(); }
  [[nodiscard]] qsizetype usableSites() const {
    const auto& sites = desk().situation().sites;
    return sites ? std::count_if(sites->begin(), sites->end(), [](const document::ShownSite& s) { return s.usable; }) : 0;
  }
  /// The stage as the operator sees it, once everything is drawn.
  void picture(const char* name) const {
    if (pictures_.isEmpty()) {
      return;
    }
    for (const style::Theme theme : {style::Theme::Dark, style::Theme::Light}) {
      desk().view().setTheme(theme);
      QTRY_VERIFY_WITH_TIMEOUT(map().isComplete() && (desk().activity() == Activity::Idle || desk().activity() == Activity::Planning), kLong);
      if (scene3d::SceneView* scene = window_->sceneView(); scene != nullptr && scene->isVisible()) {
        QTRY_VERIFY_WITH_TIMEOUT(scene->isSettled() || !scene->problem().isEmpty(), kLong);
      }
      QTest::qWait(300);  // for the server's window to show what was drawn; nothing is asserted of it
      const bool onScreenNow = QGuiApplication::platformName() == QStringLiteral("xcb");
      const QPixmap shown = onScreenNow ? window_->screen()->grabWindow(window_->winId()) : window_->grab();
      const QString suffix = theme == style::Theme::Dark ? QStringLiteral("dark") : QStringLiteral("light");
      QVERIFY(shown.save(QDir(pictures_).filePath(QStringLiteral("%1-%2.png").arg(QLatin1String(name), suffix))));
    }
  }

private slots:
  void initTestCase() {
    data_ = dataFolder();
    if (data_.isEmpty()) {
      QSKIP("the folder with real terrain is not here; set VOLPLANE_DATA to it");
    }
    QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
    window_ = std::make_unique<gui::MainWindow>(folder_.filePath("settings.ini"));
    window_->resize(1480, 920);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->activateWindow();
  }

  void files_dropped_showTerrainWithVoidsAndItsAirfields() {
    picture("01-empty");
    drop(*window_, {data_ + "/dem/swiss_alps_N46E008_srtm3_voids.tif"});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().terrain != nullptr, kLong);
    picture("02-terrain");
    const QString airfields = data_ + "/airports/ourairports_alps_43-48N_4.5-13.5E";
    drop(*window_, {airfields + "_airports.csv", airfields + "_runways.csv"});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().sites && usableSites() > 20 && desk().activity() == Activity::Idle, kLong);
    QCOMPARE(mission().airfields.size(), 1U);
    picture("03-airfields");
  }

  void shortRunways_filtered_areLeftOut() {
    const qsizetype before = usableSites();
    raise("runwaysDock");
    auto* panel = window_->findChild<panels::SitePanel*>();
    auto* shortest = panel->findChild<QDoubleSpinBox*>();
    QVERIFY(shortest != nullptr);
    shortest->setFocus();
    shortest->selectAll();
    QTest::keyClicks(shortest, QStringLiteral("2000"));
    QTest::keyClick(shortest, Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(usableSites() < before && desk().activity() == Activity::Idle, kLong);
    QVERIFY(mission().siteFilter.minLength.has_value());
    QVERIFY(std::abs(mission().siteFilter.minLength->si() - 609.6) < 0.5);  // 2000 ft
    QVERIFY(usableSites() > 5);
    for (const document::ShownSite& shown : *desk().situation().sites) {
      QVERIFY(!shown.usable || !shown.site.site.length || shown.site.site.length->si() > 609.0);
    }
    picture("04-filtered");
    raise("targetsDock");
  }

  void tenPlaces_clicked_becomeTargets() {
    trigger("viewHome");
    trigger("toolAdd");
    for (const geo::LatLon& place : kTargets) {
      const QPoint at = onScreen(desk().situation().terrain->frame.toPoint(place));
      QVERIFY(map().rect().contains(at));
      QTest::mouseClick(&map(), Qt::LeftButton, {}, at);
    }
    QCOMPARE(mission().targets.size(), kTargets.size());
    QTest::keyClick(&map(), Qt::Key_Escape);
    for (const document::ShownTarget& target : *desk().situation().targets) {
      QVERIFY2(target.altitude.has_value(), target.problem.c_str());
    }
    picture("05-targets");
  }

  void glideOfTheHandbook_isTooSteepHere_whichIsSaid() {
    trigger("planStart");
    QTRY_VERIFY_WITH_TIMEOUT(window_->banner().isVisible() && window_->banner().kind() == dialogs::MessageBanner::Kind::Failure, kLong);
    const QString said = window_->banner().text();
    QVERIFY2(said.contains(QLatin1String("above the aircraft's ceiling")) && said.contains(QLatin1String("target T")), qPrintable(said));
    const auto profile = formats::findAircraft("cessna172-operational", "");
    QVERIFY(profile.has_value());
    desk().document().edit(QStringLiteral("Change aircraft"), [&](mission::Mission& m) {
      m.aircraft = *profile;
      m.aircraftReference = "cessna172-operational";
    });
    QTRY_VERIFY_WITH_TIMEOUT(desk().activity() == Activity::Idle, kLong);
  }

  void planned_isVerified() {
    QElapsedTimer timer;
    timer.start();
    trigger("planStart");
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().sketch != nullptr || desk().activity() == Activity::Idle, kLong);
    if (desk().activity() == Activity::Planning) {
      picture("06-planning");
    }
    const auto isRefused = [this] { return window_->banner().isVisible() && window_->banner().kind() == dialogs::MessageBanner::Kind::Failure; };
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().plan != nullptr || isRefused(), kLong);
    if (isRefused()) {
      picture("07-refused");
    }
    QVERIFY2(desk().situation().plan != nullptr, qPrintable(window_->banner().text()));
    QVERIFY2(desk().situation().plan->isVerified(), qPrintable(window_->banner().text()));
    qInfo("planned and verified in %.1f s: %.1f km", 1e-3 * static_cast<double>(timer.elapsed()), 1e-3 * desk().situation().plan->length());
    picture("07-planned");
    raise("planDock");
    raise("decisionsDock");
    picture("08-plan-and-decisions");
    raise("profileDock");
    raise("engineOutDock");
  }

  void route_hovered_showsWhereTheGlideLands() {
    QVERIFY(desk().situation().plan != nullptr);
    const document::PlanView& plan = *desk().situation().plan;
    const double distance = plan.length() * 0.3;
    QTest::mouseMove(&map(), onScreen(plan.at(distance).pose.point()));
    QTRY_VERIFY(desk().view().hovered().has_value());
    const document::EngineOut glide = plan.engineOutAt(*desk().view().hovered());
    const auto runway = QString::fromStdString(plan.plan().sites[static_cast<std::size_t>(glide.site)].site.airportIdent);
    const auto labels = [this] { return window_->findChild<panels::EngineOutPanel*>()->findChildren<QLabel*>(); };
    QTRY_VERIFY(std::ranges::any_of(labels(), [&](const QLabel* label) { return label->text().contains(runway); }));
    picture("09-hovered");
    QTest::mouseMove(&map(), QPoint(3, map().height() - 3));
    QTRY_VERIFY(!desk().view().hovered().has_value());
  }

  void worstPoint_isPinnedAndDrawn() {
    QVERIFY(desk().situation().plan != nullptr);
    trigger("planWorst");
    QCOMPARE(*desk().view().pinned(), desk().situation().plan->leastGlideMargin().state.distance);
    picture("10-worst");
    trigger("overlaySafe");
    trigger("overlayMargin");
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().safeAltitudes && desk().situation().safeAltitudes->columns > 100, kLong);
    picture("11-safe-altitude");
    trigger("overlaySafe");
    trigger("overlayMargin");
  }

  void scene_shown_isDrawn() {
    QVERIFY(desk().situation().plan != nullptr);
    trigger("viewScene");
    scene3d::SceneView* scene = window_->sceneView();
    QVERIFY(scene != nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(scene->isSettled(), kLong);
    QVERIFY2(scene->problem().isEmpty(), qPrintable(scene->problem()));
    picture("12-scene");
    window_->resize(1150, 720);
    picture("13-small-window");
    window_->resize(1480, 920);
    trigger("viewScene");
  }

  void exportedSavedAndOpenedAgain_isTheSame() {
    QVERIFY(desk().situation().plan != nullptr);
    answerFileDialog(folder_.filePath("alps.fms"));
    int margins = 0;
    inDialog("exportReview", [&margins](QDialog& dialog) {  // shown although nothing warns
      margins = dialog.findChild<QTableWidget*>("exportMargins")->rowCount();
      dialog.findChild<QPushButton*>("exportWrite")->click();
    });
    trigger("export-fms");
    // more waypoints than one plan takes become alps-1of5.fms and so on
    QTRY_VERIFY_WITH_TIMEOUT(window_->banner().text().contains("written to", Qt::CaseInsensitive), kLong);
    QVERIFY(margins >= 5);
    const QStringList parts = QDir(folder_.path()).entryList({QStringLiteral("alps*.fms")});
    QVERIFY2(!parts.isEmpty(), qPrintable(window_->banner().text()));
    for (const QString& part : parts) {
      QFile written(folder_.filePath(part));
      QVERIFY(written.open(QIODevice::ReadOnly) && written.readAll().contains("1100 Version"));
    }
    picture("14-exported");
    answerFileDialog(folder_.filePath("alps.vpm"));
    trigger("fileSave");
    QTRY_VERIFY_WITH_TIMEOUT(!window_->isWindowModified(), kLong);
    gui::MainWindow other(folder_.filePath("other.ini"));
    other.show();
    other.take({folder_.filePath("alps.vpm")});
    QTRY_VERIFY_WITH_TIMEOUT(other.workspace().situation().plan != nullptr, kLong);
    QVERIFY(other.workspace().situation().planIsCurrent);
    QVERIFY(other.workspace().situation().plan->isVerified());
    QCOMPARE(other.workspace().situation().plan->length(), desk().situation().plan->length());
    other.close();
  }

  void cleanupTestCase() { window_.reset(); }
};

QTEST_MAIN(TestRealJob)
#include "tst_real_job.moc"
