#include "tests/ui/scene3d/picture_check.h"
#include "tests/ui/scene3d/scene_fixture.h"
#include "ui/scene3d/camera_presets.h"
#include "ui/scene3d/offscreen_scene.h"
#include "ui/scene3d/scene_overlay.h"
#include "ui/scene3d/scene_picture.h"

#include <QTest>

#include <set>

namespace vp::scene3d {
namespace {

constexpr QSize kSize(640, 400);

/// What a picture of the fixture is taken with.
CameraState cameraFor(const document::Situation& situation, Preset preset, double exaggeration) {
  const auto model = TerrainModel::build(situation.terrain);
  CameraController controller;
  controller.setPicture(kSize.width(), kSize.height());
  controller.setGround(cameraGround(model, exaggeration));
  controller.jumpTo(presetOrbit(preset, situation, model.get(), exaggeration, {}, controller));
  return controller.camera();
}

QImage pictureOf(const document::Situation& situation, const SceneOptions& options, const CameraSpec& camera,
                 style::Theme theme = style::Theme::Light) {
  const auto image = renderScene(situation, options, camera, kSize, theme, {});
  if (!image) {
    qWarning("%s", image.error().message().c_str());
    return {};
  }
  return *image;
}

/// The greens and browns of known ground have little blue; unknown ground is grey.
bool isTinted(QColor c) {
  return c.green() > c.blue() + 12;
}

CameraOrbit overHole() {
  return {{2600.0, -3000.0, 150.0}, 4500.0, 1.5707963, 1.2};
}

}  // namespace

class TstScenePicture : public QObject {
  Q_OBJECT

private slots:
  void tour_isWhereTheProjectionSays();
  void tour_isMissingWithoutAPlan();
  void terrain_isShadedAndNotBlank();
  void unknownGround_isHatchedGrey();
  void unknownOutside_isNotDrawnAsGround();
  void cursor_showsTheGlideInColoursOfAltitude();
  void exaggeration_isSaidAndRaisesTheMountain();
  void wind_standsBelowTheCompassAndTurnsWithTheView();
  void darkTheme_isDark();
  void pixelRatio_givesThatManyPixels();
  void sameInput_givesTheSamePicture();
  void withoutTerrain_saysSo();
  void terrainLayer_forgetsTiles();
};

void TstScenePicture::tour_isWhereTheProjectionSays() {
  const document::Situation situation = test::sceneSituation();
  const auto model = TerrainModel::build(situation.terrain);
  for (const double exaggeration : {1.0, 2.5}) {
    SceneOptions options;
    options.verticalExaggeration = exaggeration;
    options.labels = false;
    CameraSpec spec;
    spec.preset = Preset::North;
    const QImage image = pictureOf(situation, options, spec);
    const double shown = test::tourShown(image, *situation.plan, *model, cameraFor(situation, Preset::North, exaggeration), exaggeration);
    QVERIFY2(shown > 0.93, qPrintable(QString::number(shown)));  // legend and compass may cover some
  }
}

void TstScenePicture::tour_isMissingWithoutAPlan() {
  document::Situation situation = test::sceneSituation();
  situation.plan = nullptr;
  const QImage image = pictureOf(situation, {}, {});
  QVERIFY(!image.isNull());
  int magenta = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      magenta += test::isMagenta(image.pixelColor(x, y)) ? 1 : 0;
    }
  }
  QCOMPARE(magenta, 0);
}

void TstScenePicture::terrain_isShadedAndNotBlank() {
  const document::Situation situation = test::sceneSituation();
  SceneOptions options;
  options.labels = false;
  CameraSpec spec;
  spec.orbit = CameraOrbit{{-3500.0, -3200.0, 1400.0}, 6000.0, 1.5707963, 1.3};
  const QImage image = pictureOf(situation, options, spec);
  std::set<QRgb> colors;
  for (int y = 40; y < 360; ++y) {
    for (int x = 100; x < 540; ++x) {
      colors.insert(image.pixel(x, y));
    }
  }
  QVERIFY2(colors.size() > 2000, qPrintable(QString::number(colors.size())));
  // seen from above with north up, the mountain is lit from the upper left
  const auto mean = [&](QRect part) {
    qint64 sum = 0;
    for (int y = part.top(); y <= part.bottom(); ++y) {
      for (int x = part.left(); x <= part.right(); ++x) {
        sum += qGray(image.pixel(x, y));
      }
    }
    return static_cast<double>(sum) / (part.width() * part.height());
  };
  QVERIFY(mean(QRect(240, 120, 50, 50)) > mean(QRect(350, 230, 50, 50)) + 25.0);
}

void TstScenePicture::unknownGround_isHatchedGrey() {
  CameraSpec spec;
  spec.orbit = overHole();
  SceneOptions options;
  options.labels = false;
  const QImage image = pictureOf(test::sceneSituation(), options, spec);
  int grey = 0;
  int dark = 0;
  const QRect hole(290, 170, 60, 60);
  for (int y = hole.top(); y <= hole.bottom(); ++y) {
    for (int x = hole.left(); x <= hole.right(); ++x) {
      const QColor c = image.pixelColor(x, y);
      grey += c.saturation() < 30 && !isTinted(c) ? 1 : 0;
      dark += c.value() < 200 ? 1 : 0;
    }
  }
  const int all = hole.width() * hole.height();
  QVERIFY2(grey > all * 98 / 100, qPrintable(QString::number(grey)));
  QVERIFY2(dark > all / 10 && dark < all / 2, qPrintable(QString::number(dark)));  // lines on a lighter base
  // the ground beside it is coloured
  QVERIFY(isTinted(image.pixelColor(200, 100)));
}

void TstScenePicture::unknownOutside_isNotDrawnAsGround() {
  const document::Situation situation = test::sceneSituation();
  CameraSpec spec;
  spec.orbit = CameraOrbit{{5600.0, 0.0, 100.0}, 3000.0, 1.5707963, 1.5};
  SceneOptions options;
  options.labels = false;
  const QImage image = pictureOf(situation, options, spec);
  QVERIFY(!isTinted(image.pixelColor(400, 200)));  // beyond the slanting edge
  QVERIFY(isTinted(image.pixelColor(160, 100)));   // this side of it
}

void TstScenePicture::cursor_showsTheGlideInColoursOfAltitude() {
  const document::Situation situation = test::sceneSituation();
  CameraSpec spec;
  spec.preset = Preset::Top;
  spec.cursor = 500.0;
  SceneOptions options;
  options.labels = false;
  options.curtain = false;
  const QImage image = pictureOf(situation, options, spec);
  const CameraState camera = cameraFor(situation, Preset::Top, 1.0);
  const AltitudeRange range = altitudeRangeOf(situation);
  const document::EngineOut glide = situation.plan->engineOutAt(500.0);
  int seen = 0;
  int right = 0;
  for (std::size_t i = glide.path.size() / 5; i < glide.path.size() * 4 / 5; ++i) {
    const document::GlidePoint& p = glide.path[i];
    const auto at = camera.project({p.pose.x, p.pose.y, p.altitude});
    const QColor expected = style::ChartColors::altitudeScale(range.fraction(p.altitude));
    const auto fits = [&](QColor c) {
      return std::abs(c.red() - expected.red()) < 24 && std::abs(c.green() - expected.green()) < 24 && std::abs(c.blue() - expected.blue()) < 24;
    };
    ++seen;
    right += at && test::isNear(image, at->x, at->y, 2, fits) ? 1 : 0;
  }
  QVERIFY2(seen > 10 && right > seen * 8 / 10, qPrintable(QStringLiteral("%1 of %2").arg(right).arg(seen)));
}

void TstScenePicture::exaggeration_isSaidAndRaisesTheMountain() {
  const document::Situation situation = test::sceneSituation();
  CameraSpec spec;
  spec.orbit = CameraOrbit{{-3500.0, -3200.0, 700.0}, 9000.0, 1.5707963, 0.15};
  SceneOptions options;
  options.labels = false;
  const QImage plain = pictureOf(situation, options, spec);
  options.verticalExaggeration = 2.0;
  const QImage raised = pictureOf(situation, options, spec);
  const auto top = [](const QImage& image) {  // first row of the middle column that is not sky
    int y = 0;
    while (y < image.height() && image.pixelColor(320, y).blue() >= image.pixelColor(320, y).red()) {
      ++y;
    }
    return y;
  };
  QVERIFY2(top(raised) < top(plain) - 40, qPrintable(QStringLiteral("%1 %2").arg(top(raised)).arg(top(plain))));
  QVERIFY(plain.copy(12, 12, 60, 20) != raised.copy(12, 12, 60, 20));
  // a panel with dark text, where without exaggeration there is sky
  bool hasText = false;
  for (int x = 20; x < 120; ++x) {
    hasText = hasText || raised.pixelColor(x, 24).value() < 120;
  }
  QVERIFY(hasText);
}

void TstScenePicture::wind_standsBelowTheCompassAndTurnsWithTheView() {
  document::Situation situation = test::sceneSituation();
  const SceneStyle style;
  QVERIFY(layOutOverlay(QSizeF(kSize), {{}, situation.wind, 1.0}, style).wind.isEmpty());
  situation.wind = {{geo::HeightMsl::fromMetres(0.0), {270.0, 20.0, 5.0, 10.0}}, {geo::HeightMsl::fromMetres(3000.0), {300.0, 10.0, 10.0, 18.0}}};
  const OverlayLayout layout = layOutOverlay(QSizeF(kSize), {{}, situation.wind, 1.0}, style);
  QVERIFY(!layout.wind.isEmpty() && layout.wind.top() >= layout.compass.bottom() && layout.wind.bottom() <= kSize.height());
  QVERIFY(layOutOverlay({300.0, 90.0}, {{}, situation.wind, 1.0}, style).wind.isEmpty());  // no room
  CameraSpec north;
  CameraSpec turned;
  turned.turn = 1.5707963;
  const QImage seenNorth = pictureOf(situation, {}, north);
  const QImage seenWest = pictureOf(situation, {}, turned);
  if (const QString folder = qEnvironmentVariable("VOLPLANE_TEST_PICTURES"); !folder.isEmpty()) {
    seenNorth.save(folder + QStringLiteral("/scene-wind.png"));
  }
  const QRect arrow = QRectF(layout.wind.topLeft(), QSizeF(40.0, layout.wind.height())).toRect();
  const QRect numbers = QRectF(layout.wind.topLeft() + QPointF(42.0, 0.0), layout.wind.size() - QSizeF(44.0, 0.0)).toRect();
  const auto dark = [](const QImage& image, const QRect& rect) {
    QImage mask = image.copy(rect).convertToFormat(QImage::Format_Grayscale8);
    std::set<std::pair<int, int>> pixels;
    for (int y = 0; y < mask.height(); ++y) {
      for (int x = 0; x < mask.width(); ++x) {
        if (mask.pixelColor(x, y).value() < 90) {
          pixels.insert({x, y});
        }
      }
    }
    return pixels;
  };
  QVERIFY(!dark(seenNorth, arrow).empty() && dark(seenNorth, arrow) != dark(seenWest, arrow));
  // the panel lets a little of the ground through, which a pixel at the edge of a letter may show
  const auto letters = dark(seenNorth, numbers);
  const auto others = dark(seenWest, numbers);
  std::size_t common = 0;
  for (const auto& pixel : letters) {
    common += others.contains(pixel) ? 1 : 0;
  }
  QVERIFY(letters.size() > 100 && 10 * common > 9 * std::max(letters.size(), others.size()));
}

void TstScenePicture::darkTheme_isDark() {
  const QImage light = pictureOf(test::sceneSituation(), {}, {});
  const QImage dark = pictureOf(test::sceneSituation(), {}, {}, style::Theme::Dark);
  const auto mean = [](const QImage& image) {
    const QImage small = image.scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    return qGray(small.pixel(0, 0));
  };
  QVERIFY2(mean(light) > 130, qPrintable(QString::number(mean(light))));
  QVERIFY2(mean(dark) < 100, qPrintable(QString::number(mean(dark))));
}

void TstScenePicture::pixelRatio_givesThatManyPixels() {
  const auto image = renderScene(test::sceneSituation(), {}, {}, QSize(320, 200), style::Theme::Light, {}, 2.0);
  QVERIFY(image.has_value());
  QCOMPARE(image->size(), QSize(640, 400));
  QCOMPARE(image->devicePixelRatio(), 2.0);
}

void TstScenePicture::sameInput_givesTheSamePicture() {
  CameraSpec spec;
  spec.preset = Preset::AlongTour;
  spec.cursor = 900.0;
  const QImage once = pictureOf(test::sceneSituation(), {}, spec);
  const QImage again = pictureOf(test::sceneSituation(), {}, spec);
  QCOMPARE(once, again);
}

void TstScenePicture::withoutTerrain_saysSo() {
  const auto image = renderScene({}, {}, {}, kSize, style::Theme::Light, {});
  QVERIFY(!image.has_value());
  QCOMPARE(image.error().code, Errc::MissingTerrain);
}

void TstScenePicture::terrainLayer_forgetsTiles() {
  // 2048 x 2048 cells have some 5,500 tiles; flying over them must not keep all
  std::vector<float> values(std::size_t{2048} * 2048);
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] = static_cast<float>(k % 97);
  }
  auto grid = std::make_shared<const terrain::ElevationGrid>(0.0, 0.0, 30.0, 2048, 2048, std::move(values));
  const auto model = TerrainModel::build(document::makeTerrainData(geo::LocalFrame({46.5, 9.9}), std::move(grid), {}));
  TerrainLayer layer(model, SceneStyle{}, nullptr);
  CameraController controller;
  controller.setGround(cameraGround(model, 1.0));
  for (int i = 0; i < 14; ++i) {
    controller.jumpTo({{4000.0 + 4000.0 * i, 30000.0, 50.0}, 3000.0, 1.57, 0.9});
    QVERIFY(layer.update(controller.camera(), 1.0, {200, 1.0}, true));
    QVERIFY(layer.tilesShown() > 20 && layer.tilesShown() <= 200);
    QVERIFY(layer.tilesKept() <= TerrainLayer::kMostTiles + 300);
  }
}

}  // namespace vp::scene3d

QTEST_MAIN(vp::scene3d::TstScenePicture)
#include "tst_scene_picture.moc"
