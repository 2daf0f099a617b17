// Fetching terrain and airfields in the window, from a server on 127.0.0.1, and the map of lowest safe altitudes.
#include "app/gui/fetch_controller.h"
#include "app/gui/file_controller.h"
#include "app/gui/main_window.h"
#include "tests/core/fetch/bucket.h"
#include "tests/gui/operator.h"
#include "ui/dialogs/fetch_terrain_dialog.h"
#include "ui/map/map_view.h"

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <QWidget>

#include <memory>

using namespace vp;
using namespace vp::test;
using Kind = dialogs::MessageBanner::Kind;

namespace {

constexpr int kLong = 120'000;  // ms; patience, not a measurement

const std::string kAirports =
    "\"id\",\"ident\",\"type\",\"name\",\"latitude_deg\",\"longitude_deg\",\"elevation_ft\"\n1,\"LSXX\",\"small_airport\",\"field\",46.3,8.4,3000\n";
const std::string kRunways =
    "\"airport_ident\",\"length_ft\",\"width_ft\",\"surface\",\"lighted\",\"closed\",\"le_ident\",\"le_latitude_deg\",\"le_longitude_deg\",\"le_"
    "elevation_ft\","
    "\"le_heading_degT\",\"le_displaced_threshold_ft\",\"he_ident\",\"he_latitude_deg\",\"he_longitude_deg\",\"he_elevation_ft\",\"he_heading_degT\","
    "\"he_displaced_threshold_ft\"\n\"LSXX\",3000,60,\"GRS\",0,0,\"09\",,,,90,,\"27\",,,,270,\n";

template <typename Widget>
Widget& in(QWidget& parent, const char* name) {
  auto* found = parent.findChild<Widget*>(QLatin1String(name));
  if (found == nullptr) {
    qFatal("no widget %s", name);
  }
  return *found;
}

void click(QDialog& dialog, const char* name) {
  QTest::mouseClick(&in<QPushButton>(dialog, name), Qt::LeftButton);
}

}  // namespace

class TestFetch : public QObject {
  Q_OBJECT

  std::unique_ptr<FileServer> server_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<gui::MainWindow> window_;

  [[nodiscard]] const mission::Mission& mission() const { return window_->workspace().document().mission(); }
  /// Fills the dialog in and asks for the size.
  void askAround(QDialog& dialog) const {
    in<QLineEdit>(dialog, "fetchOutput").setText(folder_->filePath(QStringLiteral("area.tif")));
    QTest::keyClicks(&in<QLineEdit>(dialog, "fetchPlace"), QStringLiteral("46.3 8.45"));
    in<QDoubleSpinBox>(dialog, "fetchRadius").setValue(8.0);
    QVERIFY(!in<QPushButton>(dialog, "fetchStart").isEnabled());
    click(dialog, "fetchAsk");
  }

private slots:
  void init() {
    for (const char* name : {"http_proxy", "HTTP_PROXY", "all_proxy", "ALL_PROXY"}) {
      qunsetenv(name);
    }
    server_ = std::make_unique<FileServer>();
    fetch::test::stock(*server_, {{46, 8}}, 300, 300);
    server_->put("/airports.csv", kAirports);
    server_->put("/runways.csv", kRunways);
    folder_ = std::make_unique<QTemporaryDir>();
    qputenv("XDG_CACHE_HOME", folder_->filePath(QStringLiteral("cache")).toLocal8Bit());
    qputenv("VOLPLANE_TERRAIN_URL", server_->address().c_str());
    qputenv("VOLPLANE_AIRFIELDS_URL", server_->address().c_str());
    window_ = std::make_unique<gui::MainWindow>(folder_->filePath(QStringLiteral("settings.ini")));
    window_->show();
    window_->files().startNew();
  }
  void cleanup() { window_.reset(); }

  void start_usesNoNetwork() {
    QTRY_COMPARE_WITH_TIMEOUT(window_->workspace().activity(), jobs::Workspace::Activity::Idle, kLong);
    QVERIFY(server_->requests().empty());
  }

  void terrainAroundAPlace_fetched_isInTheMissionAndCanBeUndone() {
    inDialog(QStringLiteral("fetchTerrainDialog"), [this](QDialog& dialog) {
      QVERIFY(!in<QRadioButton>(dialog, "fetchOfMap").isEnabled());  // no terrain: the map shows no place on earth
      askAround(dialog);
      QTRY_VERIFY_WITH_TIMEOUT(in<QPushButton>(dialog, "fetchStart").isEnabled(), kLong);
      const QString size = in<QLabel>(dialog, "fetchSize").text();
      QVERIFY2(size.startsWith(QStringLiteral("1 tile: 0 on this machine, 1 to fetch (3")), qPrintable(size));
      click(dialog, "fetchStart");
    });
    window_->action(QStringLiteral("fileFetchTerrain"))->trigger();
    QCOMPARE(mission().terrain, std::vector<std::string>{folder_->filePath(QStringLiteral("area.tif")).toStdString()});
    QCOMPARE(window_->banner().kind(), Kind::Success);
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().situation().terrain != nullptr, kLong);
    window_->action(QStringLiteral("editUndo"))->trigger();
    QVERIFY(mission().terrain.empty());
  }

  void terrainOfTheMap_isOfferedWhereThereIsTerrain() {
    terrainAroundAPlace_fetched_isInTheMissionAndCanBeUndone();
    window_->action(QStringLiteral("editRedo"))->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().situation().terrain != nullptr, kLong);
    server_->stop();  // the tile is on this machine
    inDialog(QStringLiteral("fetchTerrainDialog"), [this](QDialog& dialog) {
      QVERIFY(in<QRadioButton>(dialog, "fetchOfMap").isChecked());
      in<QLineEdit>(dialog, "fetchOutput").setText(folder_->filePath(QStringLiteral("more.tif")));
      click(dialog, "fetchAsk");
      QTRY_VERIFY_WITH_TIMEOUT(in<QPushButton>(dialog, "fetchStart").isEnabled(), kLong);
      click(dialog, "fetchStart");
    });
    window_->action(QStringLiteral("fileFetchTerrain"))->trigger();
    QCOMPARE(mission().terrain.size(), std::size_t{2});
  }

  void serverThatIsGone_isToldInTheDialog() {
    server_->stop();
    inDialog(QStringLiteral("fetchTerrainDialog"), [this](QDialog& dialog) {
      askAround(dialog);
      QTRY_VERIFY_WITH_TIMEOUT(in<QLabel>(dialog, "fetchSize").text().contains(QStringLiteral("no server answers there")), kLong);
      QVERIFY(!in<QPushButton>(dialog, "fetchStart").isEnabled());
      dialog.reject();
    });
    window_->action(QStringLiteral("fileFetchTerrain"))->trigger();
    QVERIFY(mission().terrain.empty());
  }

  void cancel_whileFetching_stopsAndKeepsTheDialog() {
    inDialog(QStringLiteral("fetchTerrainDialog"), [this](QDialog& dialog) {
      askAround(dialog);
      QTRY_VERIFY_WITH_TIMEOUT(in<QPushButton>(dialog, "fetchStart").isEnabled(), kLong);
      server_->behave([](FileServer::Manners& manners) { manners.holdAfter = 1000; });
      click(dialog, "fetchStart");
      server_->waitUntilHolding();
      dialog.reject();
      QVERIFY(dialog.isVisible());
      QVERIFY(in<QLabel>(dialog, "fetchSize").text().startsWith(QStringLiteral("Stopped.")));
      server_->release();
      dialog.reject();
    });
    window_->action(QStringLiteral("fileFetchTerrain"))->trigger();
    QVERIFY(mission().terrain.empty());
  }

  void airfields_updated_areInTheMissionAndCanBeUndone() {
    QSignalSpy finished(&window_->fetches(), &gui::FetchController::finished);
    answerMessageBox(QStringLiteral("Fetch"));
    window_->action(QStringLiteral("fileUpdateAirfields"))->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kLong);
    QCOMPARE(mission().airfields.size(), std::size_t{1});
    QVERIFY2(window_->banner().text().contains(QStringLiteral("2 landing sites")), qPrintable(window_->banner().text()));
    window_->action(QStringLiteral("editUndo"))->trigger();
    QVERIFY(mission().airfields.empty());
  }

  void safeAltitudes_ofAMission_areWritten() {
    window_->take({QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/mountain-n5.vpm")});
    QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().roadmap() != nullptr, kLong);
    QSignalSpy finished(&window_->fetches(), &gui::FetchController::finished);
    const QString path = folder_->filePath(QStringLiteral("safe.tif"));
    inDialog(QStringLiteral("safeAltitudeDialog"), [path](QDialog& dialog) {
      in<QComboBox>(dialog, "chartCourses").setCurrentIndex(1);
      in<QSpinBox>(dialog, "chartCell").setValue(200);
      answerFileDialog(path);
      dialog.accept();
    });
    window_->action(QStringLiteral("export-safe-altitude"))->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, kLong);
    QVERIFY2(finished.front().front().toBool(), qPrintable(window_->banner().text()));
    QVERIFY(QFile::exists(path));
  }
};

QTEST_MAIN(TestFetch)
#include "tst_fetch.moc"
