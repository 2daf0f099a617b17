// Map, profile and 3D view of the bundled plan, drawn by volplane-cli render, look like the pictures in tests/references. After
// a wanted change of the drawing: tst_reference_pictures --renew writes them anew; look at them before they are committed.
#include "tests/support/cli_run.h"
#include "tests/support/picture_difference.h"
#include "ui/document/plan_situation.h"
#include "ui/map/render_map.h"
#include "ui/profile/profile_renderer.h"
#include "ui/scene3d/camera_presets.h"
#include "ui/scene3d/scene_picture.h"

#include <QDir>
#include <QFileInfo>
#include <QFont>
#include <QGuiApplication>
#include <QImage>
#include <QSize>
#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <cstdio>
#include <cstring>

using namespace vp;
using namespace vp::test;

namespace {

constexpr QSize kSize(800, 500);
constexpr int kStoredFactor = 2;               // references are stored at half the size, to be small
constexpr int kComparedFactor = 4;             // and compared at a quarter, where the rasteriser of fonts hardly shows
constexpr qint64 kLargestReference = 300'000;  // bytes
// Tolerances. Text without any antialiasing, the worst that another rasteriser does, stays below both.
constexpr double kMeanTolerance = 1.2;    // of 255, mean over pixels and channels
constexpr double kStrayTolerance = 0.01;  // of the pixels may differ by more than PictureDifference::kStray

const QString kPlan = QStringLiteral(VOLPLANE_SOURCE_DIR "/maps/alpine-n10.vpp");
constexpr std::array kViews{"map", "profile", "3d"};

QString referenceFile(const QString& view) {
  return QStringLiteral(VOLPLANE_SOURCE_DIR "/tests/references/alpine-n10-%1.png").arg(view);
}

/// What the command line draws. Null, with a warning, if it does not.
QImage drawnByCommand(const QString& view) {
  const QTemporaryDir folder;
  const QString file = folder.filePath(QStringLiteral("picture.png"));
  const CliResult result =
      runCli({QStringLiteral("render"), kPlan, QStringLiteral("--view"), view, QStringLiteral("-o"), file, QStringLiteral("--width"),
              QString::number(kSize.width()), QStringLiteral("--height"), QString::number(kSize.height())});
  if (result.status != 0) {
    qWarning("%s", (result.out + result.err).constData());
  }
  return QImage(file);
}

bool isWithinTolerance(const PictureDifference& difference) {
  return difference.mean <= kMeanTolerance && difference.strayShare <= kStrayTolerance;
}

QByteArray figures(const PictureDifference& difference) {
  return QByteArray("mean difference ") + QByteArray::number(difference.mean, 'f', 3) + " (limit " + QByteArray::number(kMeanTolerance) +
         "), stray pixels " + QByteArray::number(100.0 * difference.strayShare, 'f', 3) + " % (limit " + QByteArray::number(100.0 * kStrayTolerance) +
         " %)";
}

/// A picture of full size against the stored one of a view.
PictureDifference againstReference(const QImage& picture, const QString& view) {
  return differenceOf(boxScaled(picture, kComparedFactor), boxScaled(QImage(referenceFile(view)), kComparedFactor / kStoredFactor));
}

/// The picture moved, with its edge repeated where nothing is left.
QImage shifted(const QImage& picture, int by) {
  QImage result(picture.size(), QImage::Format_RGB32);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      result.setPixel(x, y, picture.pixel(std::max(0, x - by), std::max(0, y - by)));
    }
  }
  return result;
}

scene3d::CameraOrbit northOf(const document::Situation& situation) {
  const auto terrain = scene3d::TerrainModel::build(situation.terrain);
  scene3d::CameraController controller;
  controller.setPicture(kSize.width(), kSize.height());
  controller.setGround(scene3d::cameraGround(terrain, 1.0));
  return scene3d::presetOrbit(scene3d::Preset::North, situation, terrain.get(), 1.0, {}, controller);
}

/// The same terrain, runways, targets and frame without the tour; the profile, which is nothing without one, with every decision
/// point 300 m lower.
QImage drawnWithoutTour(const QString& view, const document::Situation& full) {
  document::Situation situation = full;
  if (view == QStringLiteral("profile")) {
    auto plan = std::make_shared<mission::Plan>(full.plan->plan());
    for (mission::DecisionPoint& point : plan->tour) {
      point.altitude -= 300.0;
    }
    situation.plan = std::make_shared<const document::PlanView>(plan, full.terrain);
    return profile::renderProfile(situation, kSize, 1.0, style::Theme::Light, {});
  }
  situation.plan.reset();
  if (view == QStringLiteral("map")) {
    map::MapScene scene;
    scene.situation = situation;
    return map::renderMap(scene, map::homeCamera(full, kSize), 1.0);
  }
  scene3d::CameraSpec camera;
  camera.orbit = northOf(full);
  const auto image = scene3d::renderScene(situation, {}, camera, kSize, style::Theme::Light, {});
  return image ? *image : QImage();
}

int renew() {
  for (const char* view : kViews) {
    const QImage picture = drawnByCommand(QLatin1String(view));
    const QString file = referenceFile(QLatin1String(view));
    if (picture.isNull() || !boxScaled(picture, kStoredFactor).save(file)) {
      std::fprintf(stderr, "%s NOT WRITTEN\n", qPrintable(file));
      return 1;
    }
    std::printf("%s written\n", qPrintable(file));
  }
  return 0;
}

}  // namespace

class TestReferencePictures : public QObject {
  Q_OBJECT

private slots:
  void initTestCase() {
    const auto situation = document::loadPlanSituation(kPlan.toStdString(), Job{});
    QVERIFY2(situation.has_value() && situation->plan, "the bundled plan can be read");
    situation_ = *situation;
  }

  void references_areSmallAndOfTheRightSize_data() { views(); }
  void references_areSmallAndOfTheRightSize() {
    QFETCH(QString, view);
    QCOMPARE(QImage(referenceFile(view)).size(), kSize / kStoredFactor);
    QVERIFY(QFileInfo(referenceFile(view)).size() < kLargestReference);
  }

  void bundledPlan_drawn_looksLikeTheReference_data() { views(); }
  void bundledPlan_drawn_looksLikeTheReference() {
    QFETCH(QString, view);
    const QImage picture = drawnByCommand(view);
    QCOMPARE(picture.size(), kSize);
    const PictureDifference difference = againstReference(picture, view);
    qInfo("%s", figures(difference).constData());
    if (!isWithinTolerance(difference)) {
      const QDir folder(QStringLiteral(VOLPLANE_BIN_DIR));
      const QString drawn = folder.filePath(QStringLiteral("reference-%1-drawn.png").arg(view));
      const QString differs = folder.filePath(QStringLiteral("reference-%1-difference.png").arg(view));
      picture.save(drawn);
      difference.picture.save(differs);
      QFAIL(qPrintable(QStringLiteral("%1; see %2 and %3").arg(QString::fromLatin1(figures(difference)), drawn, differs)));
    }
  }

  void tourLeftOut_isOutsideTheTolerance_data() { views(); }
  void tourLeftOut_isOutsideTheTolerance() {
    QFETCH(QString, view);
    const QImage picture = drawnWithoutTour(view, situation_);
    QCOMPARE(picture.size(), kSize);
    refuses(picture, view);
  }

  void frameShiftedByTenPixels_isOutsideTheTolerance_data() { views(); }
  void frameShiftedByTenPixels_isOutsideTheTolerance() {
    QFETCH(QString, view);
    refuses(shifted(drawnByCommand(view), 10), view);
  }

  void redAndBlueSwapped_isOutsideTheTolerance_data() { views(); }
  void redAndBlueSwapped_isOutsideTheTolerance() {
    QFETCH(QString, view);
    refuses(drawnByCommand(view).rgbSwapped(), view);
  }

  void textWithoutAntialiasing_passes_data() { views(); }
  void textWithoutAntialiasing_passes() {
    QFETCH(QString, view);
    const QFont usual = QGuiApplication::font();
    QFont other = usual;
    other.setStyleStrategy(QFont::NoAntialias);
    QGuiApplication::setFont(other);
    const QImage picture = drawnHere(view);
    QGuiApplication::setFont(usual);
    QVERIFY2(picture != drawnHere(view), "the texts are drawn otherwise");
    const PictureDifference difference = againstReference(picture, view);
    qInfo("%s", figures(difference).constData());
    QVERIFY2(isWithinTolerance(difference), figures(difference));
  }

private:
  static void views() {
    QTest::addColumn<QString>("view");
    for (const char* view : kViews) {
      QTest::newRow(view) << QString::fromLatin1(view);
    }
  }

  [[nodiscard]] QImage drawnHere(const QString& view) const {
    if (view == QStringLiteral("profile")) {
      return profile::renderProfile(situation_, kSize, 1.0, style::Theme::Light, {});
    }
    if (view == QStringLiteral("map")) {
      map::MapScene scene;
      scene.situation = situation_;
      return map::renderMap(scene, kSize, 1.0);
    }
    const auto image = scene3d::renderScene(situation_, {}, {}, kSize, style::Theme::Light, {});
    return image ? *image : QImage();
  }

  static void refuses(const QImage& picture, const QString& view) {
    const PictureDifference difference = againstReference(picture, view);
    qInfo("%s", figures(difference).constData());
    QVERIFY2(!isWithinTolerance(difference), figures(difference));
  }

  document::Situation situation_;
};

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  QGuiApplication application(argc, argv);
  if (argc == 2 && std::strcmp(argv[1], "--renew") == 0) {
    return renew();
  }
  TestReferencePictures test;
  return QTest::qExec(&test, argc, argv);
}

#include "tst_reference_pictures.moc"
