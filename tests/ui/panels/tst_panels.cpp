// Plan summary, targets and runways: what they show, and the edits that they ask for.
#include "core/aircraft/glide_model.h"
#include "tests/support/planned_tour.h"
#include "ui/panels/plan_summary_panel.h"
#include "ui/panels/position_text.h"
#include "ui/panels/site_model.h"
#include "ui/panels/site_panel.h"
#include "ui/panels/target_model.h"
#include "ui/panels/target_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QRegularExpression>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <cmath>

using namespace vp;
using panels::SiteModel;
using panels::TargetModel;

namespace {

bool shows(const QWidget& panel, const QString& text) {
  for (const QLabel* label : panel.findChildren<QLabel*>()) {
    if (label->text().contains(text)) {
      return true;
    }
  }
  return false;
}

}  // namespace

class TestPanels : public QObject {
  Q_OBJECT

  document::Situation situation_;
  document::ViewState state_;

private slots:
  void initTestCase() { situation_ = test::plannedSituation(); }

  void init() {
    state_.setPinned(std::nullopt);
    state_.setHovered(std::nullopt);
    state_.selectTarget(-1);
    state_.setUnits(style::Units());
  }

  void summary_namesTheStateOfThePlan() {
    panels::PlanSummaryPanel panel(state_);
    using State = panels::PlanSummaryPanel::State;
    QCOMPARE(panel.planState(), State::NoPlan);
    panel.setSituation(situation_);
    QCOMPARE(panel.planState(), State::Verified);
    QVERIFY(shows(panel, QStringLiteral("VERIFIED")));
    QVERIFY(shows(panel, QStringLiteral("From every point of this tour (%1 decision points").arg(situation_.plan->plan().tour.size())));
    QVERIFY(shows(panel, state_.units().distance(situation_.plan->plan().metrics.length)));
    document::Situation old = situation_;
    old.planIsCurrent = false;
    panel.setSituation(old);
    QCOMPARE(panel.planState(), State::OutOfDate);
    QVERIFY(shows(panel, QStringLiteral("OUT OF DATE")));
    panel.setSituation(test::withChangedPlan(situation_, [](mission::Plan& plan) { plan.certificate.reset(); }));
    QCOMPARE(panel.planState(), State::Unverified);
    QVERIFY(shows(panel, QStringLiteral("UNVERIFIED")));
  }

  void summary_statement_isInTheChosenUnits() {
    const document::Situation shown = test::withChangedPlan(situation_, [](mission::Plan& plan) {
      plan.mission.safety.clearance = Length::fromSi(100.0);
      plan.mission.safety.arrivalMargin = Length::fromSi(20.0);
      plan.spirals.push_back({0, 600.0, 300.0, flight::Turn::Left, 200.0, 3, 2});
    });
    panels::PlanSummaryPanel panel(state_);
    panel.setSituation(shown);
    const double airspeed = aircraft::GlideModel(shown.plan->plan().mission.aircraft).airspeed();
    const QRegularExpression metric(QStringLiteral("\\d (m|km|km/h|m/s)\\b"));
    const QRegularExpression aviation(QStringLiteral("\\d (ft|NM|kt)\\b"));
    const auto statement = [&panel] {
      for (const QLabel* label : panel.findChildren<QLabel*>()) {
        if (label->text().startsWith(QStringLiteral("From every point"))) {
          return label->text();
        }
      }
      return QString();
    };
    for (const QString& words : {state_.units().speed(airspeed) + QStringLiteral(" TAS"), QStringLiteral("at least 328 ft above the terrain"),
                                 QStringLiteral("at least 65 ft above the runway on arrival"),
                                 QStringLiteral("between 984 ft MSL and ") + state_.units().altitudeMsl(600.0)}) {
      QVERIFY2(statement().contains(words), qPrintable(statement()));
    }
    QVERIFY2(!statement().contains(metric), qPrintable(statement()));
    state_.setUnits(style::Units(style::UnitSystem::Metric));
    QVERIFY2(statement().contains(QStringLiteral("at least 100 m above the terrain")), qPrintable(statement()));
    QVERIFY2(!statement().contains(aviation), qPrintable(statement()));
  }

  void summary_margins_jumpToTheirPlaces() {
    panels::PlanSummaryPanel panel(state_);
    panel.resize(420, 700);
    panel.setSituation(situation_);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    test::keepPicture(panel.grab().toImage(), QStringLiteral("summary"));
    const auto& margins = situation_.plan->plan().certificate->margins;
    auto* tree = panel.findChild<QTreeWidget*>();
    QCOMPARE(tree->topLevelItemCount(), static_cast<int>(margins.size()));
    QSignalSpy shown(&state_, &document::ViewState::placeRequested);
    for (std::size_t i = 0; i < margins.size(); ++i) {
      QTreeWidgetItem* item = tree->topLevelItem(static_cast<int>(i));
      QVERIFY(!item->text(0).contains(QLatin1Char('.')));  // words, not the id of a rule
      emit tree->itemActivated(item, 0);
      const auto place = shown.at(static_cast<int>(i)).at(0).value<geo::Point>();
      QVERIFY(geo::distance(place, situation_.terrain->frame.toPoint(margins[i].where)) < 0.01);
    }
    const auto tight = std::find_if(margins.begin(), margins.end(), [](const mission::Margin& m) { return m.kind == "tour.glide"; });
    QVERIFY(tight != margins.end());
    emit tree->itemActivated(tree->topLevelItem(static_cast<int>(tight - margins.begin())), 0);
    QVERIFY(state_.pinned().has_value());
    QVERIFY(geo::distance(situation_.plan->at(*state_.pinned()).pose.point(), situation_.terrain->frame.toPoint(tight->where)) < 60.0);
  }

  void summary_cutsNoSentence() {
    panels::PlanSummaryPanel panel(state_);
    panel.setSituation(test::withChangedPlan(situation_, [](mission::Plan& plan) {
      plan.certificate->warnings.push_back("landing site LSPG/21 is approximate: elevation of the airport");
    }));
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    for (int height = 400; height <= 1000; height += 40) {
      panel.resize(364, height);
      QTest::qWait(20);
      auto* area = panel.findChild<QScrollArea*>();
      int end = 0;  // of what stands above
      for (const QLabel* label : area->widget()->findChildren<QLabel*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (label->isVisible() && label->wordWrap()) {
          QVERIFY2(label->height() >= label->heightForWidth(label->width()), qPrintable(QStringLiteral("%1 px: %2").arg(height).arg(label->text())));
        }
      }
      for (const QObject* child : area->widget()->children()) {
        const auto* widget = qobject_cast<const QWidget*>(child);
        if (widget != nullptr && widget->isVisible() && widget->x() < 30 && widget->width() > 100) {
          QVERIFY2(widget->y() >= end,
                   qPrintable(QStringLiteral("%1 px: %2 overlaps").arg(height).arg(QLatin1String(widget->metaObject()->className()))));
          end = widget->y() + widget->height();
        }
      }
    }
  }

  void summary_onALowScreen_scrollsToItsEnd() {
    panels::PlanSummaryPanel panel(state_);
    panel.setSituation(situation_);
    panel.resize(364, 400);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    QCOMPARE(panel.height(), 400);
    auto* area = panel.findChild<QScrollArea*>();
    auto* margins = panel.findChild<QTreeWidget*>();
    QTRY_VERIFY(area->verticalScrollBar()->maximum() > 0);
    const int bottom = margins->mapTo(area->widget(), QPoint(0, margins->height())).y();
    QVERIFY2(bottom <= area->widget()->height(), "the last margin is on the page");
    area->verticalScrollBar()->setValue(area->verticalScrollBar()->maximum());
    QVERIFY2(margins->mapTo(&panel, QPoint(0, margins->height())).y() <= panel.height(), "and can be scrolled to");
  }

  void summary_refusedPlan_listsFindingsThatJump() {
    panels::PlanSummaryPanel panel(state_);
    const document::Situation low = test::withChangedPlan(situation_, [](mission::Plan& plan) {
      plan.tour[4].altitude -= 500.0;
      plan.certificate.reset();
    });
    panel.setSituation(low);
    panel.resize(420, 700);
    std::vector<std::string> checksums;
    for (const mission::TerrainReference& file : situation_.terrain->files) {
      checksums.push_back(file.sha256);
    }
    const auto report = safety::check({low.plan->plan(), *situation_.terrain->grid, checksums}, Job{});
    QVERIFY(report && !report->isSafe() && !report->findings.empty());
    panel.setReport(*report);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    test::keepPicture(panel.grab().toImage(), QStringLiteral("summary-refused"));
    auto* list = panel.findChild<QListWidget*>();
    QCOMPARE(list->count(), static_cast<int>(report->findings.size()));
    QVERIFY(shows(panel, QStringLiteral("Why the plan was refused")));
    const auto finding = std::find_if(report->findings.begin(), report->findings.end(), [](const safety::Finding& f) { return f.tourPoint >= 0; });
    QVERIFY(finding != report->findings.end());
    emit list->itemActivated(list->item(static_cast<int>(finding - report->findings.begin())));
    QCOMPARE(*state_.pinned(), low.plan->distanceOf(static_cast<std::size_t>(finding->tourPoint)));
    panel.setReport({});
    QVERIFY(!list->isVisible());
  }

  void targets_areEditedInPlace() {
    panels::TargetPanel panel(state_);
    panel.resize(760, 300);
    panel.setSituation(situation_);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    test::keepPicture(panel.grab().toImage(), QStringLiteral("targets"));
    QSignalSpy edited(&panel, &panels::TargetPanel::targetEdited);
    TargetModel& model = panel.model();
    const mission::Target before = (*situation_.targets)[1].target;
    const auto last = [&] { return edited.last().at(1).value<mission::Target>(); };

    QVERIFY(model.setData(model.index(1, TargetModel::Name), QStringLiteral("Dam wall"), Qt::EditRole));
    QCOMPARE(edited.last().at(0).toInt(), 1);
    QCOMPARE(last().name, std::string("Dam wall"));
    QCOMPARE(last().position, before.position);
    QVERIFY(model.setData(model.index(1, TargetModel::Height), 1000.0, Qt::EditRole));
    QVERIFY(std::abs(last().height_m - 304.8) < 1e-9);
    QVERIFY(model.setData(model.index(1, TargetModel::Position), QStringLiteral("46.5, 9.75"), Qt::EditRole));
    QCOMPARE(last().position, (geo::LatLon{46.5, 9.75}));
    // changing the datum leaves the target where it is
    const double ground = situation_.terrain->grid->upperAt((*situation_.targets)[1].point);
    QVERIFY(before.reference == mission::HeightReference::AboveGround);
    QVERIFY(model.setData(model.index(1, TargetModel::Datum), static_cast<int>(mission::HeightReference::Msl), Qt::EditRole));
    QCOMPARE(last().height_m, before.height_m + ground);
    QVERIFY(last().reference == mission::HeightReference::Msl);
  }

  void targets_onANarrowPanel_cutNoNumber_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<QString>("name");
    for (const int width : {300, 320, 340, 364, 420, 500, 640, 900, 1400}) {
      for (const QString& name : {QStringLiteral("T1"), QStringLiteral("Dam wall of the upper reservoir, northern end")}) {
        QTest::addRow("%d px, %d letters", width, static_cast<int>(name.size())) << width << name;
      }
    }
  }
  void targets_onANarrowPanel_cutNoNumber() {
    QFETCH(int, width);
    QFETCH(QString, name);
    document::Situation named = situation_;
    std::vector<document::ShownTarget> targets = *situation_.targets;
    targets[0].target.name = name.toStdString();
    targets[1].target.height_m = 3600.0;
    targets[1].altitude = 4200.0;
    named.targets = std::make_shared<const std::vector<document::ShownTarget>>(targets);
    panels::TargetPanel panel(state_);
    panel.resize(width, 300);
    panel.setSituation(named);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    test::keepPicture(panel.grab().toImage(), QStringLiteral("targets-%1-%2").arg(width).arg(name.size()));
    const QTableView& table = panel.table();
    const QFontMetrics cells(table.font());
    const QFontMetrics headers(table.horizontalHeader()->font());
    const int room = table.viewport()->width();
    for (int column = 0; column < TargetModel::Problem; ++column) {
      const int left = table.columnViewportPosition(column);
      const int right = left + table.columnWidth(column);
      const QString title = panel.model().headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
      QVERIFY2(right <= room || left >= room, qPrintable(QStringLiteral("%1: %2 to %3 of %4 px").arg(title).arg(left).arg(right).arg(room)));
      QVERIFY2(headers.horizontalAdvance(title) + 12 <= right - left, qPrintable(title));
      for (int row = 0; column > TargetModel::Name && row < panel.model().rowCount(); ++row) {
        const QString text = panel.model().index(row, column).data().toString();
        QVERIFY2(cells.horizontalAdvance(text) + 12 <= right - left, qPrintable(text));
      }
    }
    QVERIFY(width < 340 || table.columnViewportPosition(TargetModel::Altitude) + table.columnWidth(TargetModel::Altitude) <= room);
  }

  void targets_refuseWhatIsNone() {
    panels::TargetPanel panel(state_);
    panel.setSituation(situation_);
    TargetModel& model = panel.model();
    QSignalSpy edited(&panel, &panels::TargetPanel::targetEdited);
    QVERIFY(!model.setData(model.index(0, TargetModel::Name), QStringLiteral("  "), Qt::EditRole));
    QVERIFY(!model.setData(model.index(0, TargetModel::Name), model.index(1, TargetModel::Name).data(), Qt::EditRole));
    QVERIFY(shows(panel, QStringLiteral("already")));
    QVERIFY(!model.setData(model.index(0, TargetModel::Position), QStringLiteral("somewhere"), Qt::EditRole));
    QVERIFY(shows(panel, QStringLiteral("no position")));
    // opening an editor and leaving it unchanged edits nothing, although the shown height is rounded
    QVERIFY(model.setData(model.index(0, TargetModel::Height), model.index(0, TargetModel::Height).data(Qt::EditRole), Qt::EditRole));
    QVERIFY(model.setData(model.index(0, TargetModel::Position), model.index(0, TargetModel::Position).data(Qt::EditRole), Qt::EditRole));
    QCOMPARE(edited.count(), 0);
  }

  void targets_keyboard_editsMovesAndRemoves() {
    panels::TargetPanel panel(state_);
    panel.resize(700, 300);
    panel.setSituation(situation_);
    panel.show();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    QSignalSpy edited(&panel, &panels::TargetPanel::targetEdited);
    QSignalSpy moved(&panel, &panels::TargetPanel::moveRequested);
    QSignalSpy removed(&panel, &panels::TargetPanel::removeRequested);
    panel.table().setFocus();
    panel.table().setCurrentIndex(panel.model().index(2, TargetModel::Height));
    QCOMPARE(state_.selectedTarget(), 2);
    QTest::keyClick(&panel.table(), Qt::Key_F2);
    auto* box = panel.table().findChild<QDoubleSpinBox*>();
    QVERIFY(box != nullptr);
    QCOMPARE(box->suffix(), QStringLiteral(" ft"));
    box->selectAll();
    QTest::keyClicks(box, QStringLiteral("1500"));
    QTest::keyClick(box, Qt::Key_Return);
    QTRY_COMPARE(edited.count(), 1);
    QVERIFY(std::abs(edited.last().at(1).value<mission::Target>().height_m - 457.2) < 1e-9);
    QTest::keyClick(&panel.table(), Qt::Key_Up, Qt::ControlModifier);
    QCOMPARE(moved.count(), 1);
    QCOMPARE(moved.last().at(0).toInt(), 2);
    QCOMPARE(moved.last().at(1).toInt(), 1);
    QTest::keyClick(&panel.table(), Qt::Key_Delete);
    QCOMPARE(removed.last().at(0).toInt(), state_.selectedTarget());
    state_.selectTarget(0);
    QCOMPARE(panel.table().currentIndex().row(), 0);
    QVERIFY(!panel.findChild<QToolButton*>(QStringLiteral("moveUp"))->isEnabled());
  }

  void targets_withAProblem_sayIt() {
    document::Situation broken = situation_;
    std::vector<document::ShownTarget> targets = *situation_.targets;
    targets[1].altitude.reset();
    targets[1].problem = "lies outside the terrain; move it or load terrain that covers it";
    broken.targets = std::make_shared<const std::vector<document::ShownTarget>>(targets);
    panels::TargetPanel panel(state_);
    panel.setSituation(broken);
    QCOMPARE(panel.model().index(1, TargetModel::Problem).data().toString(), QString::fromStdString(targets[1].problem));
    QVERIFY(!panel.model().index(1, TargetModel::Name).data(Qt::DecorationRole).isNull());
    QVERIFY(shows(panel, QStringLiteral("One target cannot be planned")));
    panel.setSituation({});
    QVERIFY(shows(panel, QStringLiteral("No targets yet")));
  }

  void sites_tickAsksForExclusion_andComesBackOnlyIfItWasByHand() {
    document::Situation some = situation_;
    std::vector<document::ShownSite> sites = *situation_.sites;
    QVERIFY(sites.size() >= 3);
    sites[0].usable = false;  // by hand
    sites[1].usable = false;  // by a rule
    some.sites = std::make_shared<const std::vector<document::ShownSite>>(sites);
    panels::SitePanel panel(state_);
    panel.resize(760, 420);
    mission::SiteFilter filter;
    filter.exclude = {sites[0].site.site.id};
    panel.setFilter(filter);
    panel.setSituation(some);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    test::keepPicture(panel.grab().toImage(), QStringLiteral("sites"));
    auto* model = panel.findChild<SiteModel*>();
    QSignalSpy asked(&panel, &panels::SitePanel::excludeRequested);
    QVERIFY(model->setData(model->index(2, SiteModel::Runway), Qt::Unchecked, Qt::CheckStateRole));
    QCOMPARE(asked.last().at(0).toString(), QString::fromStdString(sites[2].site.site.id));
    QCOMPARE(asked.last().at(1).toBool(), true);
    QVERIFY(model->setData(model->index(0, SiteModel::Runway), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(asked.last().at(1).toBool(), false);
    QVERIFY(model->flags(model->index(0, SiteModel::Runway)).testFlag(Qt::ItemIsUserCheckable));
    QVERIFY(!model->flags(model->index(1, SiteModel::Runway)).testFlag(Qt::ItemIsUserCheckable));
    QVERIFY(model->index(0, SiteModel::Remarks).data().toString().contains(QStringLiteral("excluded")));
    QVERIFY(model->index(1, SiteModel::Remarks).data().toString().contains(QStringLiteral("filter")));
  }

  void sites_sortByNumber_andAreFound() {
    panels::SitePanel panel(state_);
    panel.setSituation(situation_);
    panel.table().sortByColumn(SiteModel::Course, Qt::DescendingOrder);
    double before = 1e9;
    for (int row = 0; row < panel.table().model()->rowCount(); ++row) {
      const double course = panel.table().model()->index(row, SiteModel::Course).data(0x0100).toDouble();
      QVERIFY(course <= before);
      before = course;
    }
    const std::string ident = situation_.sites->front().site.site.airportIdent;
    panel.findChild<QLineEdit*>()->setText(QString::fromStdString(ident));
    QVERIFY(panel.table().model()->rowCount() >= 1);
    for (int row = 0; row < panel.table().model()->rowCount(); ++row) {
      QVERIFY(panel.table().model()->index(row, SiteModel::Runway).data().toString().startsWith(QString::fromStdString(ident)));
    }
  }

  void sites_rules_emitTheChangedFilter() {
    panels::SitePanel panel(state_);
    mission::SiteFilter filter;
    filter.minLength = Length::fromSi(333.0);  // no whole number of feet
    filter.oneWay = {"X/01"};
    panel.setFilter(filter);
    QSignalSpy changed(&panel, &panels::SitePanel::filterChanged);
    QCOMPARE(changed.count(), 0);
    const QList<QCheckBox*> boxes = panel.findChildren<QCheckBox*>();
    QCOMPARE(boxes.size(), 4);
    boxes[2]->click();
    auto last = changed.last().at(0).value<mission::SiteFilter>();
    QVERIFY(last.water && last.approximate && !last.closed);
    QCOMPARE(last.minLength->si(), 333.0);  // kept to the bit
    QCOMPARE(last.oneWay, filter.oneWay);
    auto* length = panel.findChild<QDoubleSpinBox*>();
    length->setValue(2000.0);
    last = changed.last().at(0).value<mission::SiteFilter>();
    QVERIFY(std::abs(last.minLength->si() - 609.6) < 1e-9);
    length->setValue(0.0);
    QVERIFY(!changed.last().at(0).value<mission::SiteFilter>().minLength);
  }

  void sites_furtherRules_emitTheChangedFilter() {
    panels::SitePanel panel(state_);
    QSignalSpy changed(&panel, &panels::SitePanel::filterChanged);
    const QList<QDoubleSpinBox*> numbers = panel.findChildren<QDoubleSpinBox*>();
    QCOMPARE(numbers.size(), 3);
    numbers[1]->setValue(60.0);
    numbers[2]->setValue(12.5);
    panel.findChildren<QCheckBox*>()[3]->click();
    for (const QToolButton* button : panel.findChildren<QToolButton*>()) {
      if (button->menu() != nullptr) {
        button->menu()->actions().front()->trigger();
      }
    }
    const auto last = changed.last().at(0).value<mission::SiteFilter>();
    QVERIFY(std::abs(last.minWidth->si() - 18.288) < 1e-9);
    QVERIFY(std::abs(last.maxDistance->si() - 23150.0) < 1e-6);
    QVERIFY(last.lighted);
    QCOMPARE(last.surfaces, std::vector<mission::Surface>{mission::Surface::Hard});
    QCOMPARE(changed.count(), 4);
  }

  void sites_oneWayAndNote_areAskedForByRow() {
    panels::SitePanel panel(state_);
    panel.setSituation(situation_);
    auto* model = panel.findChild<SiteModel*>();
    const QString id = QString::fromStdString(situation_.sites->front().site.site.id);
    QSignalSpy oneWay(&panel, &panels::SitePanel::oneWayRequested);
    QSignalSpy noted(&panel, &panels::SitePanel::noteEdited);
    QVERIFY(model->setData(model->index(0, SiteModel::OneWay), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(oneWay.last(), QVariantList({id, true}));
    QVERIFY(model->setData(model->index(0, SiteModel::Note), QStringLiteral(" wires "), Qt::EditRole));
    QCOMPARE(noted.last(), QVariantList({id, QStringLiteral("wires")}));
    mission::SiteFilter filter;
    filter.oneWay = {id.toStdString()};
    filter.notes = {{situation_.sites->front().site.site.airportIdent, "sheep"}};
    panel.setFilter(filter);
    QCOMPARE(model->index(0, SiteModel::OneWay).data(Qt::CheckStateRole).toInt(), static_cast<int>(Qt::Checked));
    QCOMPARE(model->index(0, SiteModel::Note).data().toString(), QStringLiteral("sheep"));
  }

  void positions_areReadAsPeopleWriteThem_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("latitude");
    QTest::addColumn<double>("longitude");
    QTest::newRow("decimal") << "46.6003, 9.9017" << 46.6003 << 9.9017;
    QTest::newRow("decimal, south and west") << "-33.5 -70.25" << -33.5 << -70.25;
    QTest::newRow("as shown") << style::Units::position({46.60033, 9.90167}) << 46.60033 << 9.90167;
    QTest::newRow("as shown, south and west") << style::Units::position({-0.5, -70.25}) << -0.5 << -70.25;
    QTest::newRow("seconds") << "N46 36 01 E9 54 06" << 46.600278 << 9.901667;
    QTest::newRow("letters after") << "46.5N 9.75E" << 46.5 << 9.75;
    QTest::newRow("longitude first") << "9.75 E, 46.5 N" << 46.5 << 9.75;
    QTest::newRow("minutes without letters") << "46 30.0 9 45.0" << 46.5 << 9.75;
  }

  void positions_areReadAsPeopleWriteThem() {
    QFETCH(QString, text);
    QFETCH(double, latitude);
    QFETCH(double, longitude);
    const auto position = panels::parsePosition(text);
    QVERIFY(position.has_value());
    QVERIFY2(std::abs(position->latitude_deg - latitude) < 1e-4 && std::abs(position->longitude_deg - longitude) < 1e-4,
             qPrintable(QString("%1 %2").arg(position->latitude_deg).arg(position->longitude_deg)));
  }

  void positions_thatAreNone_areRefused() {
    for (const char* text :
         {"", "46.5", "46.5 N", "here", "91, 9", "46, 181", "46.5 N 9.5 N", "46 61 N 9 30 E", "46.5.3 9", "-46.5 N 9 E", "1 2 3", "46.5 30 N 9 E"}) {
      QVERIFY2(!panels::parsePosition(QString::fromLatin1(text)), text);
    }
  }
};

QTEST_MAIN(TestPanels)
#include "tst_panels.moc"
