// Weather and people in the real window: drawn with the mouse, put right, saved, read again, and kept out of by the landings that are asked for.
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "app/gui/weather_controller.h"
#include "core/emergency/landing_outcome.h"
#include "core/formats/weather_file.h"
#include "core/risk/population.h"
#include "tests/gui/operator.h"
#include "ui/document/landing_case.h"
#include "ui/map/map_view.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPoint>
#include <QTabWidget>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <memory>

using namespace vp;
using test::inDialog;

namespace {

constexpr int kLong = 240'000;  // ms; patience, not a measurement

}  // namespace

class TestDrawWeather : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  std::unique_ptr<gui::MainWindow> window_;

  [[nodiscard]] jobs::Workspace& desk() const { return window_->workspace(); }
  [[nodiscard]] map::MapView& map() const { return window_->mapView(); }
  [[nodiscard]] const std::vector<mission::WeatherCell>& weather() const { return desk().document().mission().weather; }
  [[nodiscard]] std::shared_ptr<const document::LandingCase> shown() const { return desk().view().landing(); }
  [[nodiscard]] bool isAnswered() const { return shown() != nullptr && !shown()->isRunning && !shown()->landings.empty(); }
  [[nodiscard]] QPoint onMap(double x, double y) const { return map().camera().toScreen({x, y}).toPoint(); }
  template <typename Widget>
  [[nodiscard]] Widget* child(const char* name) const {
    return window_->findChild<Widget*>(QLatin1String(name));
  }

  void click(double x, double y) { QTest::mouseClick(&map(), Qt::LeftButton, {}, onMap(x, y)); }

  /// Clicks the corners one after the other and the last one twice, as an operator does.
  void draw(const std::vector<geo::Point>& corners) {
    for (const geo::Point& corner : corners) {
      click(corner.x, corner.y);
    }
    QTest::mouseDClick(&map(), Qt::LeftButton, {}, onMap(corners.back().x, corners.back().y));
  }

  void drag(QPoint from, QPoint to) {
    QTest::mousePress(&map(), Qt::LeftButton, {}, from);
    QTest::mouseMove(&map(), (from + to) / 2);
    QTest::mouseMove(&map(), to);
    QTest::mouseRelease(&map(), Qt::LeftButton, {}, to);
  }

  /// Asks what the menu offers at a place, all planners, at a height.
  void engineOutAt(geo::Point place, double altitude, const QString& planner) {
    auto* choice = child<QComboBox>("landingPlanner");
    choice->setCurrentIndex(choice->findData(planner));
    const std::unique_ptr<QMenu> menu = map().contextMenuAt(map().camera().toScreen(place));
    for (QAction* entry : menu->actions()) {
      if (entry->text().startsWith(QStringLiteral("Engine out here"))) {
        entry->trigger();
      }
    }
    const double feet = std::round(altitude / 0.3048);
    child<QDoubleSpinBox>("landingAltitude")->setValue(feet);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered() && std::abs(shown()->altitude - feet * 0.3048) < 1.0, kLong);
  }

  QString write(const char* name, const QByteArray& text) {
    QFile file(folder_.filePath(QLatin1String(name)));
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? file.fileName() : QString();
  }

private slots:
  void initTestCase() {
    QVERIFY(folder_.isValid());
    for (const char* name : {"mountain-n5.vpm", "mountain.tif"}) {
      QVERIFY(QFile::copy(QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/") + QLatin1String(name), folder_.filePath(QLatin1String(name))));
    }
    window_ = std::make_unique<gui::MainWindow>(folder_.filePath("settings.ini"));
    window_->resize(1480, 920);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    window_->take({folder_.filePath("mountain-n5.vpm")});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().terrain && desk().situation().sites && desk().world(), kLong);
  }

  void drawn_isInTheMissionAndOnTheMap() {
    window_->action(QStringLiteral("toolWeather"))->trigger();
    QVERIFY(map().tool() == map::MapView::Tool::DrawWeather);
    inDialog(QStringLiteral("weatherDialog"), [](QDialog& dialog) {
      dialog.findChild<QLineEdit*>(QStringLiteral("weatherName"))->setText(QStringLiteral("storm"));
      dialog.findChild<QDoubleSpinBox*>(QStringLiteral("weatherSuccess"))->setValue(20.0);
      dialog.findChild<QCheckBox*>(QStringLiteral("weatherUnlimited"))->setChecked(false);
      dialog.findChild<QDoubleSpinBox*>(QStringLiteral("weatherTop"))->setValue(20000.0);
      dialog.accept();
    });
    QTRY_VERIFY(map().isComplete());
    const QImage before = map().grab().toImage();
    draw({{-700.0, -700.0}, {700.0, -700.0}, {700.0, 700.0}, {0.0, 900.0}, {-700.0, 700.0}});
    QCOMPARE(weather().size(), std::size_t{1});
    QCOMPARE(weather().front().name, std::string("storm"));
    QCOMPARE(weather().front().outline.size(), std::size_t{5});
    QCOMPARE(weather().front().success, 0.2);
    QCOMPARE(weather().front().perDistance, 1852.0);
    QVERIFY(!weather().front().floor && std::abs(*weather().front().top - 6096.0) < 1e-9);
    const geo::Point first = desk().situation().terrain->frame.toPoint(weather().front().outline.front());
    QVERIFY(geo::distance(first, {-700.0, -700.0}) < 1.5 * map().camera().metresPerPixel());
    QTRY_VERIFY(map().isComplete() && map().grab().toImage() != before);
    QCOMPARE(desk().document().undoStack().undoText(), QStringLiteral("Draw weather storm"));
  }

  void undoAndRedo_takeItAwayAndBringItBack() {
    const mission::WeatherCell drawn = weather().front();
    window_->action(QStringLiteral("editUndo"))->trigger();
    QVERIFY(weather().empty());
    QVERIFY(desk().situation().weather == nullptr && desk().situation().weatherRisk == nullptr);
    window_->action(QStringLiteral("editRedo"))->trigger();
    QVERIFY(weather().size() == 1 && weather().front() == drawn);
    QVERIFY(desk().situation().weatherRisk != nullptr);
  }

  void outlineThatCrosses_isRefusedAndStaysToBePutRight() {
    draw({{1200.0, 0.0}, {1800.0, 600.0}, {1800.0, 0.0}, {1200.0, 600.0}});
    QCOMPARE(weather().size(), std::size_t{1});
    QVERIFY2(window_->banner().text().contains(QStringLiteral("cross")), qPrintable(window_->banner().text()));
    inDialog(QStringLiteral("weatherDialog"), [](QDialog& dialog) { dialog.accept(); });
    QTest::keyClick(&map(), Qt::Key_Backspace);
    QTest::keyClick(&map(), Qt::Key_Return);  // three corners are left, which cannot cross
    QCOMPARE(weather().size(), std::size_t{2});
    QCOMPARE(weather().back().outline.size(), std::size_t{3});
    QCOMPARE(weather().back().success, 0.2);  // as the one before
    window_->action(QStringLiteral("editUndo"))->trigger();
    QCOMPARE(weather().size(), std::size_t{1});
  }

  void escape_dropsTheOutlineThenLeaves() {
    click(1200.0, 0.0);
    QTest::keyClick(&map(), Qt::Key_Escape);
    QVERIFY(map().tool() == map::MapView::Tool::DrawWeather);
    QTest::keyClick(&map(), Qt::Key_Escape);
    QVERIFY(map().tool() == map::MapView::Tool::Select);
    QVERIFY(!window_->action(QStringLiteral("toolWeather"))->isChecked());
    QCOMPARE(weather().size(), std::size_t{1});
  }

  void corner_ofTheSelectedCell_isDragged() {
    desk().view().selectWeather(-1);
    click(-550.0, -550.0);
    QCOMPARE(desk().view().selectedWeather(), 0);
    const mission::WeatherCell before = weather().front();
    drag(onMap(-700.0, -700.0), onMap(-900.0, -800.0));
    const geo::Point moved = desk().situation().terrain->frame.toPoint(weather().front().outline.front());
    QVERIFY(geo::distance(moved, {-900.0, -800.0}) < 1.5 * map().camera().metresPerPixel());
    QVERIFY(std::equal(before.outline.begin() + 1, before.outline.end(), weather().front().outline.begin() + 1));
    window_->action(QStringLiteral("editUndo"))->trigger();
    QVERIFY(weather().front() == before);
    drag(onMap(-700.0, -700.0), onMap(900.0, 0.0));  // over the other side: refused
    QVERIFY(weather().front() == before);
    QVERIFY(window_->banner().text().contains(QStringLiteral("cross")));
  }

  void menu_editsAndDeletes() {
    const auto entry = [&](const QString& text) -> void {
      const std::unique_ptr<QMenu> menu = map().contextMenuAt(map().camera().toScreen({-550.0, -550.0}));
      for (QAction* one : menu->actions()) {
        if (one->text() == text) {
          one->trigger();
          return;
        }
      }
      QFAIL(qPrintable(QStringLiteral("the menu lacks ") + text));
    };
    inDialog(QStringLiteral("weatherDialog"), [](QDialog& dialog) {
      dialog.findChild<QCheckBox*>(QStringLiteral("weatherFromGround"))->setChecked(false);
      dialog.findChild<QDoubleSpinBox*>(QStringLiteral("weatherFloor"))->setValue(-500.0);
      dialog.accept();
    });
    entry(QStringLiteral("Edit weather storm…"));
    QVERIFY(weather().front().floor && std::abs(*weather().front().floor + 500.0 * 0.3048) < 1e-9);
    QCOMPARE(weather().front().success, 0.2);  // nobody touched it
    entry(QStringLiteral("Delete weather storm"));
    QVERIFY(weather().empty());
    window_->action(QStringLiteral("editUndo"))->trigger();
    window_->action(QStringLiteral("editUndo"))->trigger();
    QVERIFY(weather().size() == 1 && !weather().front().floor);
  }

  void list_isEditedInPlace() {
    window_->action(QStringLiteral("missionWeather"))->trigger();
    auto* list = child<QTableWidget>("weatherList");
    QCOMPARE(list->rowCount(), 1);
    list->item(0, 3)->setText(QStringLiteral("25 %"));
    QCOMPARE(weather().front().success, 0.25);
    list->item(0, 1)->setText(QStringLiteral("30000"));  // above its top
    QVERIFY(!weather().front().floor);
    QCOMPARE(list->item(0, 1)->text(), QStringLiteral("GND"));
    list->item(0, 2)->setText(QStringLiteral("UNL"));
    QVERIFY(!weather().front().top);
    window_->action(QStringLiteral("editUndo"))->trigger();
    window_->action(QStringLiteral("editUndo"))->trigger();
    QCOMPARE(weather().front().success, 0.2);
    QCOMPARE(list->item(0, 3)->text(), QStringLiteral("20 % per NM"));
    child<QDialog>("weatherListDialog")->close();
  }

  void saved_isThereAfterReopening() {
    const std::vector<mission::WeatherCell> before = weather();
    const QString path = folder_.filePath("kept.vpm");
    window_->files().saveTo(path);
    QTRY_VERIFY_WITH_TIMEOUT(!desk().document().isModified(), kLong);
    window_->files().startNew();
    QTRY_VERIFY_WITH_TIMEOUT(weather().empty(), kLong);
    window_->take({path});
    QTRY_VERIFY_WITH_TIMEOUT(weather() == before, kLong);
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().terrain && desk().situation().weatherRisk && desk().situation().sites && desk().world(), kLong);
  }

  void landNow_keepsOutOfItOrSaysHowLikelyItComesThrough() {
    engineOutAt({1400.0, 200.0}, 2200.0, QStringLiteral("side by side"));
    QVERIFY(shown()->hasWeather);
    const document::ShownLanding* chosen = shown()->shown();
    QVERIFY(chosen != nullptr && chosen->site && chosen->answer.verified);
    const std::optional<double> success = document::termOf(chosen->answer, emergency::kWeatherSuccess);
    QVERIFY(success);
    const bool keepsOut = std::none_of(chosen->glide.path.begin(), chosen->glide.path.end(), [&](const auto& point) {
      return document::isInside(desk().situation().weather->front(), point.pose.point());
    });
    QCOMPARE(*success == 1.0, keepsOut);
    const QString sentence = child<QLabel>("landingSentence")->text();
    QVERIFY2(sentence.contains(keepsOut ? QStringLiteral("Keeps out of the weather") : QStringLiteral("Comes through the weather")),
             qPrintable(sentence));
    QStringList planners;
    for (const document::ShownLanding& other : shown()->landings) {
      planners << QString::fromStdString(other.answer.planner);
      if (other.answer.verified && other.site) {
        QVERIFY(*success >= *document::termOf(other.answer, emergency::kWeatherSuccess) - 1e-3);
      }
    }
    QVERIFY(planners.contains(QStringLiteral("dvprm")) && planners.contains(QStringLiteral("roadmap")));
  }

  void weatherGoneAndBack_theSideBySideChoiceFollows() {
    const auto isAsked = [this] {
      return isAnswered() && std::any_of(shown()->landings.begin(), shown()->landings.end(),
                                         [](const document::ShownLanding& landing) { return landing.answer.planner == "dvprm"; });
    };
    QVERIFY(isAsked());
    window_->weather().remove(0);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered() && !shown()->hasWeather && !shown()->landings.empty(), kLong);
    QVERIFY(!isAsked());
    desk().document().undoStack().undo();
    QTRY_VERIFY_WITH_TIMEOUT(isAsked() && shown()->hasWeather, kLong);
  }

  void insideTheStorm_theProbabilityIsTold() {
    engineOutAt({0.0, 0.0}, 2200.0, QStringLiteral("dvprm"));
    QVERIFY(shown()->shown() != nullptr && shown()->shown()->site);
    const std::optional<double> success = document::termOf(shown()->shown()->answer, emergency::kWeatherSuccess);
    QVERIFY(success && *success < 0.9);  // 600 m of it at least, at a fifth for a nautical mile
    QVERIFY(child<QLabel>("landingSentence")->text().contains(document::percentText(*success)));
    auto* terms = child<QTableView>("landingTerms");
    QCOMPARE(terms->model()->index(0, 0).data().toString(), QString::fromLatin1(emergency::kWeatherSuccess));
    QCOMPARE(terms->model()->index(0, 1).data().toString(), document::percentText(*success));
  }

  void rankedRunways_areAllThereWithTheirReasons() {
    const std::size_t usable = static_cast<std::size_t>(
        std::count_if(desk().situation().sites->begin(), desk().situation().sites->end(), [](const document::ShownSite& s) { return s.usable; }));
    QCOMPARE(shown()->runways.size(), usable);
    double before = 0.0;
    for (const document::ShownRunway& runway : shown()->runways) {
      QVERIFY(!runway.isReached || runway.logRisk >= before);
      before = runway.isReached ? runway.logRisk : before;
      double sum = 0.0;
      for (const emergency::RankingLine& line : runway.lines) {
        sum += line.logRisk;
      }
      QVERIFY(std::abs(sum - runway.logRisk) < 1e-9);
    }
    child<QTabWidget>("landingTabs")->setCurrentIndex(1);
    QCOMPARE(child<QTableView>("landingRunways")->model()->rowCount(), static_cast<int>(usable));
    QCOMPARE(shown()->selectedRunway, 0);
    QCOMPARE(child<QTableView>("landingReasons")->model()->rowCount(), static_cast<int>(shown()->runways.front().lines.size()));
    child<QTableView>("landingRunways")->selectRow(1);
    QCOMPARE(shown()->selectedRunway, 1);
    QVERIFY(shown()->shown() == &shown()->runways[1].landing);
    child<QTabWidget>("landingTabs")->setCurrentIndex(0);
    QCOMPARE(shown()->selectedRunway, -1);
  }

  void exported_isKnownForWeatherWhenItIsDropped() {
    const QString path = folder_.filePath("storm.geojson");
    window_->weather().exportTo(path);
    const auto read = formats::readWeather(path.toStdString());
    QVERIFY(read && read->cells == weather());
    test::drop(*window_, {path});
    QTRY_COMPARE_WITH_TIMEOUT(weather().size(), std::size_t{2}, kLong);
    QVERIFY(weather()[0] == weather()[1]);
    QVERIFY2(window_->banner().text().startsWith(QStringLiteral("1 weather cell(s) added")), qPrintable(window_->banner().text()));
    window_->action(QStringLiteral("editUndo"))->trigger();
    QCOMPARE(weather().size(), std::size_t{1});
  }

  void population_isKnownByItsFieldsDrawnAndCounted() {
    const geo::LocalFrame& frame = desk().situation().terrain->frame;
    QByteArray ring;
    for (const geo::Point corner : {geo::Point{-2400, -2400}, {2400, -2400}, {2400, 2400}, {-2400, 2400}, {-2400, -2400}}) {
      const geo::LatLon place = frame.toLatLon(corner);
      ring += (ring.isEmpty() ? "[" : ",[") + QByteArray::number(place.longitude_deg, 'g', 12) + ',' +
              QByteArray::number(place.latitude_deg, 'g', 12) + ']';
    }
    const QString path = write("people.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"DENSITY":800},)"
                                                 R"("geometry":{"type":"Polygon","coordinates":[[)" +
                                                     ring + "]]}}]}");
    QTRY_VERIFY(map().isComplete());
    const QImage before = map().grab().toImage();
    test::drop(*window_, {path});
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().population != nullptr, kLong);
    QCOMPARE(desk().document().mission().populationFiles, std::vector<std::string>{path.toStdString()});
    QVERIFY(std::abs(desk().situation().population->densityAt({0.0, 0.0}) - 800e-6) < 1e-12);
    QTRY_VERIFY(map().isComplete() && map().grab().toImage() != before);
    QTRY_VERIFY_WITH_TIMEOUT(isAnswered() && shown()->hasPeople, kLong);  // the question that stands is asked again
    window_->action(QStringLiteral("overlayPopulation"))->setChecked(false);
    window_->action(QStringLiteral("overlayPopulation"))->setChecked(true);
    window_->action(QStringLiteral("editUndo"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(desk().situation().population == nullptr, kLong);
  }

  void fileWithoutPeople_isRefusedInOneSentence() {
    const QString path = write("areas.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"NAME":"x"},)"
                                                R"("geometry":{"type":"Polygon","coordinates":[[[9.9,46.6],[10,46.6],[10,46.7],[9.9,46.6]]]}}]})");
    test::answerFileDialog(path);
    window_->action(QStringLiteral("filePopulation"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(window_->banner().text().contains(QStringLiteral("POPULATION")), kLong);
    QVERIFY(desk().document().mission().populationFiles.empty());
  }

  void plan_knowsNothingOfWeather() {
    QVERIFY(document::samePlanInputs(desk().document().mission(), [&] {
      mission::Mission other = desk().document().mission();
      other.weather.clear();
      other.populationFiles = {"x.geojson"};
      return other;
    }()));
  }
};

QTEST_MAIN(TestDrawWeather)
#include "tst_draw_weather.moc"
