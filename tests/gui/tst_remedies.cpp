// Every remedy that the banner offers, clicked: it has to do what its button says and lead to a plan.
#include "app/gui/main_window.h"
#include "ui/dialogs/airspace_dialog.h"
#include "ui/dialogs/field_tools.h"
#include "ui/dialogs/message_banner.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>

#include <cmath>
#include <memory>

using namespace vp;
using Activity = jobs::Workspace::Activity;
using Kind = dialogs::MessageBanner::Kind;

namespace {
constexpr int kLong = 120'000;  // ms; patience, not a measurement
}

class TestRemedies : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  std::unique_ptr<gui::MainWindow> window_;

  [[nodiscard]] jobs::Workspace& desk() const { return window_->workspace(); }
  [[nodiscard]] const mission::Mission& mission() const { return desk().document().mission(); }
  [[nodiscard]] QPushButton* button(const QString& text) const {
    QPushButton* found = nullptr;
    for (auto* candidate : window_->banner().findChildren<QPushButton*>()) {
      found = candidate->isVisible() && candidate->text().startsWith(text) ? candidate : found;
    }
    return found;
  }
  void edit(const std::function<void(mission::Mission&)>& change) const { desk().document().edit(QStringLiteral("Set up"), change); }
  /// Presses Plan and waits for how it ends.
  void plan() const {
    QTRY_COMPARE_WITH_TIMEOUT(desk().activity(), Activity::Idle, kLong);
    window_->action(QStringLiteral("planStart"))->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(desk().activity(), Activity::Idle, kLong);
  }
  /// Clicks a remedy and waits until the plan that it asks for has ended.
  void click(const QString& text) const {
    QPushButton* remedy = button(text);
    QVERIFY2(remedy != nullptr, qPrintable(text + QStringLiteral(" is not offered with: ") + window_->banner().text()));
    QSignalSpy ended(&desk(), &jobs::Workspace::planningEnded);
    QTest::mouseClick(remedy, Qt::LeftButton);
    QTRY_COMPARE_WITH_TIMEOUT(ended.count(), 1, kLong);
  }
  [[nodiscard]] bool isVerified() const {
    return desk().document().planIsCurrent() && desk().document().plan()->certificate.has_value() && window_->banner().kind() != Kind::Failure;
  }

private slots:
  void init() {
    window_ = std::make_unique<gui::MainWindow>(folder_.filePath(QStringLiteral("settings.ini")));
    window_->show();
    window_->take({QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm")});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().sites != nullptr, kLong);
    edit([](mission::Mission& m) {  // coarse, so that it plans in a moment
      m.planner.headings = 2;
      m.planner.roadmapSamples = 1500;
    });
  }
  void cleanup() { window_.reset(); }

  void lowCeiling_namesTargetAndHeight_raisingLeadsToAPlan() {
    edit([](mission::Mission& m) { m.ceiling = geo::HeightMsl::fromMetres(700.0); });
    plan();
    const QString text = window_->banner().text();
    QVERIFY2(QRegularExpression(QStringLiteral("target T0\\d")).match(text).hasMatch(), qPrintable(text));
    QVERIFY2(text.contains(QStringLiteral("the mission's ceiling of 2\u2009297 ft MSL")), qPrintable(text));
    int clicks = 0;
    while (!isVerified() && clicks < 12) {
      ++clicks;
      const double before = mission().ceiling->metres();
      const QString says = button(QStringLiteral("Raise ceiling by")) != nullptr ? button(QStringLiteral("Raise ceiling by"))->text() : QString();
      click(QStringLiteral("Raise ceiling by"));
      QVERIFY2(says.contains(desk().view().units().height(mission().ceiling->metres() - before)), qPrintable(says));
      QCOMPARE(desk().document().undoStack().undoText(), QStringLiteral("Raise ceiling"));
    }
    QVERIFY2(isVerified(), qPrintable(window_->banner().text()));
    QVERIFY2(desk().document().plan()->mission.ceiling == mission().ceiling, "planned with the ceiling that is set now");
    for (int i = 0; i < clicks; ++i) {
      desk().document().undoStack().undo();
    }
    QCOMPARE(mission().ceiling->metres(), 700.0);
  }

  /// From a file to a refusal that names the airspace, and back to a plan by the way that the refusal points to.
  void forbiddenAirspace_overATarget_isNamedAndAllowedAgain() {
    const geo::LatLon at = mission().targets.front().position;
    QFile file(folder_.filePath(QStringLiteral("zone.txt")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QStringLiteral("AC R\nAN RANGE\nAL SFC\nAH UNL\nV X=%1 N %2 %3\nDC 0.1\n")
                   .arg(at.latitude_deg, 0, 'f', 6)
                   .arg(std::abs(at.longitude_deg), 0, 'f', 6)
                   .arg(at.longitude_deg < 0.0 ? QStringLiteral("W") : QStringLiteral("E"))
                   .toUtf8());
    file.close();
    window_->take({file.fileName()});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().airspaces != nullptr, kLong);
    QCOMPARE(desk().situation().airspaces->front().use, mission::AirspaceUse::Warn);
    QTimer::singleShot(0, window_.get(), [] {
      auto* dialog = qobject_cast<dialogs::AirspaceDialog*>(QApplication::activeModalWidget());
      QVERIFY(dialog != nullptr);
      dialogs::choose(dialog->choiceOf(QStringLiteral("R")), static_cast<int>(mission::AirspaceUse::Forbid));
      dialog->accept();
    });
    window_->action(QStringLiteral("editAirspaces"))->trigger();
    QCOMPARE(desk().document().undoStack().undoText(), QStringLiteral("Change airspace rules"));
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().airspaces != nullptr && desk().situation().airspaces->front().use == mission::AirspaceUse::Forbid,
                             kLong);
    plan();
    QVERIFY2(window_->banner().text().contains(QStringLiteral("lies inside RANGE (class R, the surface to unlimited)")),
             qPrintable(window_->banner().text()));
    QVERIFY2(window_->banner().text().contains(QStringLiteral("Mission > Airspace")), qPrintable(window_->banner().text()));
    desk().document().undoStack().undo();
    QTRY_COMPARE_WITH_TIMEOUT(desk().situation().airspaces->front().use, mission::AirspaceUse::Warn, kLong);
    plan();
    QVERIFY2(isVerified(), qPrintable(window_->banner().text()));
  }

  /// With all the rest hidden, the dialog still offers every class of the files.
  void hiddenClass_isReachedInTheDialog() {
    const geo::LatLon at = mission().targets.front().position;
    QFile file(folder_.filePath(QStringLiteral("hidden.txt")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QStringLiteral("AC W\nAN WAVE\nAL SFC\nAH UNL\nV X=%1 N %2 %3\nDC 0.1\n")
                   .arg(at.latitude_deg, 0, 'f', 6)
                   .arg(std::abs(at.longitude_deg), 0, 'f', 6)
                   .arg(at.longitude_deg < 0.0 ? QStringLiteral("W") : QStringLiteral("E"))
                   .toUtf8());
    file.close();
    window_->take({file.fileName()});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().airspaces != nullptr, kLong);
    edit([](mission::Mission& m) { m.airspace.otherwise = mission::AirspaceUse::Hide; });
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().airspaces == nullptr && desk().activity() == Activity::Idle, kLong);
    QTimer::singleShot(0, window_.get(), [] {
      auto* dialog = qobject_cast<dialogs::AirspaceDialog*>(QApplication::activeModalWidget());
      QVERIFY(dialog != nullptr);
      dialogs::choose(dialog->choiceOf(QStringLiteral("W")), static_cast<int>(mission::AirspaceUse::Warn));
      dialog->accept();
    });
    window_->action(QStringLiteral("editAirspaces"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().airspaces != nullptr, kLong);
    QCOMPARE(desk().situation().airspaces->front().use, mission::AirspaceUse::Warn);
  }

  void lowCeiling_takenAway_leadsToAPlan() {
    edit([](mission::Mission& m) { m.ceiling = geo::HeightMsl::fromMetres(700.0); });
    plan();
    click(QStringLiteral("No ceiling"));
    QVERIFY(!mission().ceiling);
    QVERIFY2(isVerified(), qPrintable(window_->banner().text()));
    QCOMPARE(desk().document().undoStack().undoText(), QStringLiteral("Remove ceiling"));
  }

  void lowCeiling_ofTheAircraft_isNamedAndNotRaised() {
    edit([](mission::Mission& m) { m.aircraft.ceiling = geo::HeightMsl::fromMetres(700.0); });
    plan();
    QVERIFY2(window_->banner().text().contains(QStringLiteral("the aircraft's ceiling of 2\u2009297 ft MSL")), qPrintable(window_->banner().text()));
    QVERIFY(button(QStringLiteral("Raise ceiling")) == nullptr);
    QVERIFY(button(QStringLiteral("Aircraft")) != nullptr);
  }

  void hardTarget_deleted_isPlannedWithout() {
    edit([](mission::Mission& m) {
      m.ceiling = geo::HeightMsl::fromMetres(700.0);
      m.targets.resize(2);
    });
    plan();
    const std::size_t before = mission().targets.size();
    click(QStringLiteral("Delete target T0"));
    QCOMPARE(mission().targets.size(), before - 1);
  }

  void allRunwaysExcluded_included_leadsToAPlan_data() {
    using Rule = std::function<void(mission::SiteFilter&)>;
    QTest::addColumn<Rule>("rule");
    QTest::newRow("by hand") << Rule([](mission::SiteFilter& f) { f.exclude = {"MTSW", "MTNE", "MTNW"}; });
    QTest::newRow("too short") << Rule([](mission::SiteFilter& f) { f.minLength = Length::fromSi(5000.0); });
  }
  void allRunwaysExcluded_included_leadsToAPlan() {
    QFETCH(std::function<void(mission::SiteFilter&)>, rule);
    edit([&](mission::Mission& m) { rule(m.siteFilter); });
    plan();
    QVERIFY2(window_->banner().text().contains(QStringLiteral("no usable runway")), qPrintable(window_->banner().text()));
    click(QStringLiteral("Include excluded runways"));
    QVERIFY2(isVerified(), qPrintable(window_->banner().text()));
    QCOMPARE(desk().document().undoStack().undoText(), QStringLiteral("Include excluded runways"));
  }

  void runwaysOfOneSideExcluded_underACeiling_included_leadToAPlan() {
    edit([](mission::Mission& m) { m.targets = {m.targets[2]}; });  // T03, in the north-east
    plan();
    QVERIFY(isVerified());
    double highest = 0.0;
    for (const mission::DecisionPoint& point : desk().document().plan()->tour) {
      highest = std::max(highest, point.altitude);
    }
    edit([&](mission::Mission& m) {
      m.ceiling = geo::HeightMsl::fromMetres(std::ceil(highest) + 20.0);
      m.siteFilter.exclude = {"MTNE", "MTNW"};
    });
    plan();
    QVERIFY2(!isVerified(), "without the runways in the north the ceiling is too low");
    QVERIFY2(window_->banner().text().contains(QStringLiteral("No safe tour")), qPrintable(window_->banner().text()));
    click(QStringLiteral("Include excluded runways"));
    QVERIFY2(isVerified(), qPrintable(window_->banner().text()));
  }

  void spirals_areToldOf_passingAboveTakesThemAway() {
    edit([](mission::Mission& m) { m.planner.lowTargets = mission::LowTargets::Descend; });
    plan();
    QVERIFY(isVerified());
    QVERIFY(!desk().document().plan()->spirals.empty());
    QVERIFY2(window_->banner().text().contains(QStringLiteral("suspended")), qPrintable(window_->banner().text()));
    click(QStringLiteral("Allow passing above"));
    QVERIFY2(isVerified(), qPrintable(window_->banner().text()));
    QVERIFY(desk().document().plan()->spirals.empty());
    QVERIFY(button(QStringLiteral("Allow passing above")) == nullptr);
    QCOMPARE(desk().document().undoStack().undoText(), QStringLiteral("Allow passing above targets"));
  }

  void filterOfARunwayThatIsGone_isToldOf_andForgotten() {
    edit([](mission::Mission& m) { m.siteFilter.exclude = {"MTSW"}; });
    edit([](mission::Mission& m) { std::erase_if(m.sites, [](const mission::LandingSite& site) { return site.airportIdent == "MTSW"; }); });
    QTRY_VERIFY_WITH_TIMEOUT(button(QStringLiteral("Include excluded runways")) != nullptr, kLong);
    QTest::mouseClick(button(QStringLiteral("Include excluded runways")), Qt::LeftButton);
    QVERIFY(mission().siteFilter.exclude.empty());
    plan();
    QVERIFY2(isVerified(), qPrintable(window_->banner().text()));
  }
};

QTEST_MAIN(TestRemedies)
#include "tst_remedies.moc"
