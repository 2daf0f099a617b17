#include "tests/ui/scene3d/scene_fixture.h"
#include "ui/scene3d/terrain_tile.h"
#include "ui/scene3d/tile_selection.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace vp::scene3d {
namespace {

constexpr int kQuads = TerrainModel::kTileQuads;
constexpr int kSide = TileMesh::kSide;

std::shared_ptr<const TerrainModel> sceneModel() {
  static const auto model = TerrainModel::build(test::sceneTerrain());
  return model;
}

/// Vertex (i, j) of a tile's posts.
std::array<float, 3> postOf(const TileMesh& mesh, int i, int j) {
  return mesh.vertices[static_cast<std::size_t>(j * kSide + i)];
}

double areaOf(const TileMesh& mesh, const std::vector<std::uint16_t>& triangles) {
  double area = 0.0;
  for (std::size_t k = 0; k + 2 < triangles.size(); k += 3) {
    const auto& a = mesh.vertices[triangles[k]];
    const auto& b = mesh.vertices[triangles[k + 1]];
    const auto& c = mesh.vertices[triangles[k + 2]];
    area += 0.5 * static_cast<double>((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]));
  }
  return area;
}

CameraState cameraOver(double x, double y, double height) {
  CameraState camera;
  camera.eye = {x, y - height, height};
  camera.forward = normalized({0.0, 1.0, -1.0});
  camera.up = normalized({0.0, 1.0, 1.0});
  camera.farPlane = 1e6;
  return camera;
}

}  // namespace

class TstTerrainModel : public QObject {
  Q_OBJECT

private slots:
  void levels_endWithOneTile();
  void posts_areKnownExactlyWhereTheGridIs();
  void posts_ofCoarseLevels_stayNearTheGround();
  void tiles_ofOneLevel_shareTheirEdges();
  void tiles_ofTwoLevels_meetOnCommonPosts();
  void tiles_haveSkirtsBelowAllSides();
  void tiles_coverTheKnownGroundAndNothingElse();
  void holes_getAFlatLidAtTheLowestRim();
  void edgeOfTheKnown_getsWallsToTheBase();
  void texture_hatchesUnknownAndShadesKnown();
  void contours_lieAtRoundHeightsOfTheUnit();
  void hit_findsTheGround();
  void isClear_isFalseBehindTheMountain();
  void chooseTiles_coversTheViewOnce();
  void chooseTiles_staysWithinItsBudget();
  void chooseTiles_neverShowsWhatIsNotThere();
  void build_stopsWhenAsked();
};

void TstTerrainModel::levels_endWithOneTile() {
  const auto model = sceneModel();
  QCOMPARE(model->levels(), 5);  // 240 posts: 15, 8, 4, 2 and 1 tiles along a side
  QCOMPARE(model->tileColumns(0), 15);
  QCOMPARE(model->tileColumns(3), 2);
  QCOMPARE(model->tileColumns(4), 1);
  QCOMPARE(model->tileRows(4), 1);
  QCOMPARE(model->xOf(4, model->columns(4) - 1), model->xOf(0, model->columns(0) - 1));
}

void TstTerrainModel::posts_areKnownExactlyWhereTheGridIs() {
  const auto model = sceneModel();
  const terrain::ElevationGrid& grid = *model->terrain().grid;
  for (int level = 0; level < model->levels(); ++level) {
    for (int j = 0; j < model->rows(level); ++j) {
      for (int i = 0; i < model->columns(level); ++i) {
        const geo::Point p{model->xOf(level, i), model->yOf(level, j)};
        const bool isKnown = std::isfinite(grid.upperInCell(grid.columnOf(p.x), grid.rowOf(p.y)));
        QCOMPARE(std::isfinite(model->post(level, i, j)), isKnown);
        QVERIFY(isKnown || model->touchesUnknown(level, i, j));
      }
    }
  }
  QVERIFY(!std::isfinite(model->post(0, -1, 0)));
  QVERIFY(model->touchesUnknown(1, 0, model->rows(1)));
}

void TstTerrainModel::posts_ofCoarseLevels_stayNearTheGround() {
  const auto model = sceneModel();
  const std::array<double, 5> tolerance{4.0, 10.0, 30.0, 100.0, 250.0};  // the steepest slope is 0.7, a post of level 4 means 1,200 m
  for (int level = 0; level < model->levels(); ++level) {
    for (int j = 1; j + 1 < model->rows(level); ++j) {
      for (int i = 1; i + 1 < model->columns(level); ++i) {
        const auto height = static_cast<double>(model->post(level, i, j));
        if (std::isfinite(height)) {
          const double away = std::abs(height - test::sceneHeight(model->xOf(level, i), model->yOf(level, j)));
          QVERIFY2(away < tolerance[static_cast<std::size_t>(level)], qPrintable(QStringLiteral("level %1: %2 m").arg(level).arg(away)));
        }
      }
    }
  }
}

void TstTerrainModel::tiles_ofOneLevel_shareTheirEdges() {
  const auto model = sceneModel();
  for (int level = 0; level < 4; ++level) {
    for (int row = 0; row < model->tileRows(level); ++row) {
      for (int column = 0; column + 1 < model->tileColumns(level); ++column) {
        const TileMesh west = buildTileMesh(*model, {level, column, row});
        const TileMesh east = buildTileMesh(*model, {level, column + 1, row});
        for (int j = 0; j < kSide; ++j) {
          const bool isThere = std::isfinite(model->post(level, (column + 1) * kQuads, row * kQuads + j));
          if (isThere) {
            QVERIFY(postOf(west, kQuads, j) == postOf(east, 0, j));
          }
        }
      }
    }
  }
}

void TstTerrainModel::tiles_ofTwoLevels_meetOnCommonPosts() {
  const auto model = sceneModel();
  const TileMesh coarse = buildTileMesh(*model, {1, 1, 1});
  const TileMesh fine = buildTileMesh(*model, {0, 4, 2});  // its eastern neighbour, south half
  for (int j = 0; j <= kQuads / 2; ++j) {
    const auto a = postOf(coarse, kQuads, j);
    const auto b = postOf(fine, 0, 2 * j);
    QCOMPARE(a[0], b[0]);
    QCOMPARE(a[1], b[1]);
    // the crack between the levels is never deeper than the skirt of the finer tile
    const auto skirt = fine.vertices[static_cast<std::size_t>(kSide * kSide + 3 * kSide + kQuads - 2 * j)];
    QCOMPARE(skirt[0], b[0]);
    QCOMPARE(skirt[1], b[1]);
    QVERIFY(skirt[2] < a[2]);
  }
}

void TstTerrainModel::tiles_haveSkirtsBelowAllSides() {
  const auto model = sceneModel();
  const TileMesh mesh = buildTileMesh(*model, {1, 2, 4});
  QVERIFY(mesh.isWhole);
  QCOMPARE(mesh.vertices.size(), static_cast<std::size_t>(kSide * kSide + 4 * kSide));
  for (std::size_t k = static_cast<std::size_t>(kSide * kSide); k < mesh.vertices.size(); ++k) {
    const auto& skirt = mesh.vertices[k];
    const auto above = std::find_if(mesh.vertices.begin(), mesh.vertices.begin() + kSide * kSide,
                                    [&](const auto& v) { return v[0] == skirt[0] && v[1] == skirt[1]; });
    QVERIFY(above != mesh.vertices.begin() + kSide * kSide);
    QVERIFY((*above)[2] > skirt[2]);
  }
  // all sides are closed: 2 triangles for each quad and for each edge
  QCOMPARE(wholeTileTriangles().size(), static_cast<std::size_t>((kQuads * kQuads + 4 * kQuads) * 2 * 3));
}

void TstTerrainModel::tiles_coverTheKnownGroundAndNothingElse() {
  const auto model = sceneModel();
  double expected = 0.0;
  for (int level = 0; level < model->levels(); ++level) {
    double area = 0.0;
    for (int row = 0; row < model->tileRows(level); ++row) {
      for (int column = 0; column < model->tileColumns(level); ++column) {
        const TileMesh mesh = buildTileMesh(*model, {level, column, row});
        const std::vector<std::uint16_t>& triangles = mesh.isWhole ? wholeTileTriangles() : mesh.triangles;
        area += areaOf(mesh, triangles);
        for (const std::uint16_t vertex : triangles) {
          const auto& v = mesh.vertices[vertex];
          const terrain::ElevationGrid& grid = *model->terrain().grid;
          QVERIFY(grid.columnOf(static_cast<double>(v[0])) < grid.columns());
          const float here = grid.upperInCell(grid.columnOf(static_cast<double>(v[0])), grid.rowOf(static_cast<double>(v[1])));
          QVERIFY2(std::isfinite(here), "no corner stands on unknown ground");
        }
      }
    }
    expected = level == 0 ? area : expected;
    const double part = area / expected;
    QVERIFY2(part > 0.97 && part < 1.02, qPrintable(QStringLiteral("level %1: %2").arg(level).arg(part)));
  }
}

void TstTerrainModel::holes_getAFlatLidAtTheLowestRim() {
  const auto model = sceneModel();
  const geo::Point inHole{2600.0, -3000.0};
  QVERIFY(!model->heightAt(inHole).has_value());
  const double lid = model->surfaceAt(inHole);
  QVERIFY(lid > model->base() + 10.0);
  double lowestRim = 1e9;
  for (double t = 1950.0; t <= 3250.0; t += 50.0) {
    for (const geo::Point p : {geo::Point{t, -3625.0}, geo::Point{t, -2375.0}, geo::Point{1975.0, t - 5600.0}, geo::Point{3225.0, t - 5600.0}}) {
      lowestRim = std::min(lowestRim, test::sceneHeight(p.x, p.y));
    }
  }
  QVERIFY2(std::abs(lid - lowestRim) < 8.0, qPrintable(QStringLiteral("%1 %2").arg(lid).arg(lowestRim)));
  QCOMPARE(model->surfaceAt({2200.0, -2600.0}), lid);  // flat
  double area = 0.0;
  for (int row = 0; row < model->tileRows(0); ++row) {
    for (int column = 0; column < model->tileColumns(0); ++column) {
      const TileMesh mesh = buildTileMesh(*model, {0, column, row});
      for (std::size_t k = 0; k + 3 < mesh.lidQuads.size(); k += 4) {
        area += static_cast<double>((mesh.lidQuads[k + 2][0] - mesh.lidQuads[k][0]) * (mesh.lidQuads[k + 2][1] - mesh.lidQuads[k][1]));
        QCOMPARE(mesh.lidQuads[k][2], static_cast<float>(lid));
      }
    }
  }
  QVERIFY2(std::abs(area - 1250.0 * 1250.0) < 1.0, qPrintable(QString::number(area)));  // 24 cells and the quads around them
}

void TstTerrainModel::edgeOfTheKnown_getsWallsToTheBase() {
  const auto model = sceneModel();
  const TileMesh corner = buildTileMesh(*model, {0, 0, 0});
  QVERIFY(!corner.wallQuads.empty());
  for (std::size_t k = 0; k + 3 < corner.wallQuads.size(); k += 4) {
    QCOMPARE(corner.wallQuads[k + 2][2], static_cast<float>(model->base()));
    QVERIFY(corner.wallQuads[k][2] > corner.wallQuads[k + 3][2]);
  }
  QVERIFY(buildTileMesh(*model, {0, 6, 7}).wallQuads.empty());
}

void TstTerrainModel::texture_hatchesUnknownAndShadesKnown() {
  const auto model = sceneModel();
  const TerrainPalette palette(style::Theme::Light, model->lowest(), model->highest(), 0.0);
  const auto pixel = [](const TileTexture& texture, int x, int y) {
    const std::size_t at = static_cast<std::size_t>(y * TileTexture::kSide + x) * 3;
    return TerrainPalette::Rgb{texture.rgb[at], texture.rgb[at + 1], texture.rgb[at + 2]};
  };
  const TileTexture whole = buildTileTexture(*model, palette, {4, 0, 0});
  const double texel = model->terrain().grid->cellSize() * 16.0 * kQuads / (TileTexture::kSide - 1);
  const auto at = [&](double x, double y) {
    return pixel(whole, static_cast<int>((x - model->xOf(0, 0)) / texel + 0.5), static_cast<int>((y - model->yOf(0, 0)) / texel + 0.5));
  };
  const auto hole = at(2600.0, -3000.0);
  QVERIFY(hole == palette.hatch() || hole == palette.hatchBase());
  // lit from the north-west: the mountain's north-west side is brighter than its south-east side
  const auto brightness = [](const TerrainPalette::Rgb& c) { return static_cast<int>(c[0]) + c[1] + c[2]; };
  QVERIFY(brightness(at(-4200.0, -2500.0)) > brightness(at(-2800.0, -3900.0)) + 60);
  std::size_t all = 0;
  for (std::size_t side = TileTexture::kSide; side >= 1; side /= 2) {
    all += side * side * 3;
  }
  QCOMPARE(whole.rgb.size(), all);
}

void TstTerrainModel::contours_lieAtRoundHeightsOfTheUnit() {
  const style::Units feet(style::UnitSystem::Aviation);
  const style::Units metres(style::UnitSystem::Metric);
  QCOMPARE(contourInterval(300.0, 3300.0, metres), 100.0);
  QVERIFY(std::abs(contourInterval(300.0, 3300.0, feet) - 152.4) < 1e-9);
  const TerrainPalette palette(style::Theme::Light, 0.0, 3000.0, 100.0);
  const auto brightness = [&](double height, double slope, double texel) {
    const auto c = palette.colorOf(height, slope, 0.0, texel);
    return static_cast<int>(c[0]) + c[1] + c[2];
  };
  QVERIFY(brightness(1500.0, 0.3, 10.0) < brightness(1550.0, 0.3, 10.0) - 60);
  QVERIFY(std::abs(brightness(1500.0, 0.3, 300.0) - brightness(1550.0, 0.3, 300.0)) < 12);  // too close to tell apart: none
  QVERIFY(std::abs(brightness(1500.0, 0.0, 10.0) - brightness(1550.0, 0.0, 10.0)) < 12);    // flat ground is no line
}

void TstTerrainModel::hit_findsTheGround() {
  const auto model = sceneModel();
  for (const double exaggeration : {1.0, 3.0}) {
    const Vec3 eye{-1000.0, -5000.0, 4000.0 * exaggeration};
    const Vec3 goal{1500.0, 1200.0, model->heightAt({1500.0, 1200.0}).value() * exaggeration};
    const auto hit = model->hit(eye, normalized(goal - eye), exaggeration, 1e5);
    QVERIFY(hit.has_value());
    QVERIFY2(length(*hit - goal) < 1.0, qPrintable(QString::number(length(*hit - goal))));
  }
  QVERIFY(!model->hit({0.0, 0.0, 4000.0}, {0.0, 0.0, 1.0}, 1.0, 1e5).has_value());
}

void TstTerrainModel::isClear_isFalseBehindTheMountain() {
  const auto model = sceneModel();
  const Vec3 behind{-5500.0, -5200.0, 300.0};
  QVERIFY(!model->isClear({-1000.0, -700.0, 700.0}, behind, 1.0));
  QVERIFY(model->isClear({-1000.0, -700.0, 6000.0}, behind, 1.0));
}

void TstTerrainModel::chooseTiles_coversTheViewOnce() {
  const auto model = sceneModel();
  const TileChoice choice = chooseTiles(*model, cameraOver(0.0, -2000.0, 3000.0), 1.0, {60, 4.0}, [](TileId) { return true; });
  QVERIFY(choice.wanted.empty());
  QVERIFY(choice.shown.size() > 8);
  // no tile lies inside another
  const std::set<TileId> shown(choice.shown.begin(), choice.shown.end());
  QCOMPARE(shown.size(), choice.shown.size());
  for (TileId tile : shown) {
    while (tile.level + 1 < model->levels()) {
      tile = {tile.level + 1, tile.column / 2, tile.row / 2};
      QVERIFY(!shown.contains(tile));
    }
  }
  // and what is in the middle of the picture is covered, more finely than the far end
  const auto levelAt = [&](double x, double y) {
    for (const TileId& tile : choice.shown) {
      const Bounds box = model->boundsOf(tile);
      if (x >= box.low.x && x <= box.high.x && y >= box.low.y && y <= box.high.y) {
        return tile.level;
      }
    }
    return -1;
  };
  QVERIFY(levelAt(0.0, -2000.0) >= 0);
  QVERIFY(levelAt(0.0, -3200.0) >= 0 && levelAt(0.0, -3200.0) <= levelAt(0.0, 1200.0));
}

void TstTerrainModel::chooseTiles_staysWithinItsBudget() {
  const auto model = sceneModel();
  for (const int budget : {1, 8, 20, 50}) {
    const TileChoice choice = chooseTiles(*model, cameraOver(0.0, -2000.0, 1500.0), 1.0, {budget, 0.5}, [](TileId) { return true; });
    QVERIFY(!choice.shown.empty());
    QVERIFY(choice.shown.size() <= static_cast<std::size_t>(budget));
  }
}

void TstTerrainModel::chooseTiles_neverShowsWhatIsNotThere() {
  const auto model = sceneModel();
  std::set<TileId> there{{model->levels() - 1, 0, 0}};
  std::size_t shown = 0;
  for (int round = 0; round < 200; ++round) {
    const TileChoice choice =
        chooseTiles(*model, cameraOver(0.0, -2000.0, 3000.0), 1.0, {60, 2.0}, [&](TileId tile) { return there.contains(tile); });
    for (const TileId& tile : choice.shown) {
      QVERIFY(there.contains(tile));
    }
    shown = choice.shown.size();
    if (choice.wanted.empty()) {
      QVERIFY(shown > 10);
      return;
    }
    there.insert(choice.wanted.front());
  }
  QVERIFY(shown > 1);
}

void TstTerrainModel::build_stopsWhenAsked() {
  std::stop_source source;
  source.request_stop();
  QVERIFY(TerrainModel::build(test::sceneTerrain(), source.get_token()) == nullptr);
}

}  // namespace vp::scene3d

QTEST_APPLESS_MAIN(vp::scene3d::TstTerrainModel)
#include "tst_terrain_model.moc"
