#include "ui/scene3d/scene_nodes.h"

#include "ui/scene3d/runway_shape.h"
#include "ui/style/chart_colors.h"

#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/LineWidth>
#include <osg/MatrixTransform>
#include <osg/Point>
#include <osg/PolygonOffset>
#include <osg/Texture1D>
#include <osgUtil/Tessellator>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vp::scene3d {
namespace {

// Order of drawing after relief, sky and base (bins 0 to 2).
constexpr int kRunwayBin = 3;
constexpr int kCurtainBin = 4;
constexpr int kHiddenBin = 5;
constexpr int kCasingBin = 6;
constexpr int kLineBin = 7;

constexpr float kHiddenAlpha = 0.28F;
constexpr float kCurtainAlpha = 0.42F;
constexpr double kBuried = 30.0;  // m that a curtain goes below the ground, for coarse tiles

osg::Vec4 vectorOf(const QColor& color, float alpha = 1.0F) {
  return {color.redF(), color.greenF(), color.blueF(), color.alphaF() * alpha};
}

osg::Vec3 vectorOf(const ScenePoint& p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
}

osg::ref_ptr<osg::Geometry> geometryOf(osg::Vec3Array* vertices, osg::PrimitiveSet* primitives) {
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setUseDisplayList(false);
  geometry->setUseVertexBufferObjects(true);
  geometry->setVertexArray(vertices);
  geometry->addPrimitiveSet(primitives);
  return geometry;
}

void setColor(osg::Geometry& geometry, const osg::Vec4& color) {
  osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(1);
  (*colors)[0] = color;
  geometry.setColorArray(colors, osg::Array::BIND_OVERALL);
}

/// A line without the points that lie on it within half a metre: each joint of a smoothed line leaves a faint mark.
std::vector<ScenePoint> simplified(const std::vector<ScenePoint>& points) {
  constexpr double kTolerance = 0.5;
  constexpr std::size_t kLongest = 64;  // points left out in a row, for colours by altitude
  std::vector<ScenePoint> kept{points.front()};
  std::size_t from = 0;
  for (std::size_t to = 2; to < points.size(); ++to) {
    const ScenePoint along = points[to] - points[from];
    const double whole = std::max(length(along), 1e-9);
    bool isStraight = to - from < kLongest;
    for (std::size_t k = from + 1; k < to && isStraight; ++k) {
      isStraight = length(cross(points[k] - points[from], along)) / whole < kTolerance;
    }
    if (!isStraight) {
      from = to - 1;
      kept.push_back(points[from]);
    }
  }
  kept.push_back(points.back());
  return kept;
}

/// Collects the lines of one look, so that hundreds of glides are one draw.
struct LineBatch {
  const SceneLine* look = nullptr;
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
  std::vector<std::pair<int, int>> strips;

  [[nodiscard]] bool takes(const SceneLine& line) const {
    return look->color == line.color && look->width == line.width && look->casing == line.casing && look->showHidden == line.showHidden;
  }
};

void setWidth(SceneNodes& nodes, osg::StateSet& state, double width) {
  const auto attribute = keep(new osg::LineWidth(static_cast<float>(width)));
  state.setAttributeAndModes(attribute.get());
  state.setDataVariance(osg::Object::DYNAMIC);
  nodes.lines.emplace_back(attribute, width);
}

void addPass(SceneNodes& nodes, const LineBatch& batch, double width, const QColor& color, float alpha, int bin, bool isHidden) {
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setUseDisplayList(false);
  geometry->setUseVertexBufferObjects(true);
  geometry->setVertexArray(batch.vertices);
  for (const auto& [first, count] : batch.strips) {
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_LINE_STRIP, first, count));
  }
  if (color.isValid()) {
    setColor(*geometry, vectorOf(color, alpha));
  } else if (alpha < 1.0F) {
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(*batch.colors);
    for (osg::Vec4& c : *colors) {
      c.a() *= alpha;
    }
    geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
  } else {
    geometry->setColorArray(batch.colors, osg::Array::BIND_PER_VERTEX);
  }
  osg::StateSet* state = geometry->getOrCreateStateSet();
  setWidth(nodes, *state, width);
  state->setAttributeAndModes(new osg::Depth(isHidden ? osg::Depth::GREATER : osg::Depth::LEQUAL, 0.0, 1.0, false));
  state->setRenderBinDetails(bin, "RenderBin");
  nodes.root->addChild(geometry);
}

/// Rounds the joints of a wide line, which would gape on the outside of each bend.
void addJoints(SceneNodes& nodes, const LineBatch& batch, double width, const QColor& color, int bin) {
  const osg::ref_ptr<osg::Geometry> geometry =
      geometryOf(batch.vertices, new osg::DrawArrays(GL_POINTS, 0, static_cast<int>(batch.vertices->size())));
  if (color.isValid()) {
    setColor(*geometry, vectorOf(color));
  } else {
    geometry->setColorArray(batch.colors, osg::Array::BIND_PER_VERTEX);
  }
  const auto point = keep(new osg::Point(static_cast<float>(width)));
  osg::StateSet* state = geometry->getOrCreateStateSet();
  state->setAttributeAndModes(point.get());
  state->setMode(GL_POINT_SMOOTH, osg::StateAttribute::ON);
  state->setDataVariance(osg::Object::DYNAMIC);
  state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
  state->setRenderBinDetails(bin, "RenderBin");
  nodes.joints.emplace_back(point, width);
  nodes.root->addChild(geometry);
}

void addLines(SceneNodes& nodes, const SceneData& scene) {
  std::vector<LineBatch> batches;
  for (const SceneLine& line : scene.lines) {
    if (line.points.size() < 2) {
      continue;
    }
    auto batch = std::find_if(batches.begin(), batches.end(), [&](const LineBatch& b) { return b.takes(line); });
    if (batch == batches.end()) {
      batch = batches.emplace(batches.end());
      batch->look = &line;
    }
    const std::vector<ScenePoint> points = simplified(line.points);
    batch->strips.emplace_back(static_cast<int>(batch->vertices->size()), static_cast<int>(points.size()));
    for (const ScenePoint& p : points) {
      batch->vertices->push_back(vectorOf(p));
      batch->colors->push_back(vectorOf(line.color.isValid() ? line.color : style::ChartColors::altitudeScale(scene.altitudes.fraction(p.z))));
    }
  }
  for (const LineBatch& batch : batches) {
    const SceneLine& look = *batch.look;
    const double width = look.width;
    if (look.showHidden) {
      addPass(nodes, batch, width, look.color, kHiddenAlpha, kHiddenBin, true);
    }
    const bool isWide = width >= 3.0;
    if (look.casing.isValid()) {
      addPass(nodes, batch, width + 2.6, look.casing, 1.0F, kCasingBin, false);
      if (isWide) {
        addJoints(nodes, batch, width + 2.6, look.casing, kCasingBin);
      }
    }
    addPass(nodes, batch, width, look.color, 1.0F, kLineBin, false);
    if (isWide) {
      addJoints(nodes, batch, width, look.color, kLineBin);
    }
  }
}

/// The colour scale of altitudes as a texture, so that each height of a curtain has its own colour whatever its triangles.
osg::ref_ptr<osg::Texture1D> altitudeTexture() {
  constexpr int kSide = 256;
  osg::ref_ptr<osg::Image> image = new osg::Image;
  image->allocateImage(kSide, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, 1);
  for (int i = 0; i < kSide; ++i) {
    const QColor color = style::ChartColors::altitudeScale(static_cast<double>(i) / (kSide - 1));
    unsigned char* pixel = image->data(static_cast<unsigned int>(i));
    pixel[0] = static_cast<unsigned char>(color.red());
    pixel[1] = static_cast<unsigned char>(color.green());
    pixel[2] = static_cast<unsigned char>(color.blue());
    pixel[3] = 255;
  }
  osg::ref_ptr<osg::Texture1D> texture = new osg::Texture1D(image);
  texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
  texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
  texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
  return texture;
}

void addCurtain(osg::Group& root, const SceneCurtain& curtain, const AltitudeRange& altitudes) {
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  osg::ref_ptr<osg::FloatArray> textureAt = new osg::FloatArray;
  for (std::size_t i = 0; i < curtain.top.size(); ++i) {
    const ScenePoint& top = curtain.top[i];
    const ScenePoint bottom{top.x, top.y, curtain.bottom[i] - kBuried};
    vertices->push_back(vectorOf(top));
    vertices->push_back(vectorOf(bottom));
    textureAt->push_back(static_cast<float>(altitudes.fraction(top.z)));
    textureAt->push_back(static_cast<float>(altitudes.fraction(bottom.z)));
  }
  const osg::ref_ptr<osg::Geometry> geometry = geometryOf(vertices, new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<int>(vertices->size())));
  geometry->setTexCoordArray(0, textureAt, osg::Array::BIND_PER_VERTEX);
  setColor(*geometry, osg::Vec4(1.0F, 1.0F, 1.0F, kCurtainAlpha));
  osg::StateSet* state = geometry->getOrCreateStateSet();
  state->setTextureAttributeAndModes(0, altitudeTexture());
  state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
  state->setRenderBinDetails(kCurtainBin, "RenderBin");
  root.addChild(geometry);
}

void addTranslucent(osg::Group& root, osg::Geometry& geometry, const QColor& color, double opacity) {
  setColor(geometry, vectorOf(color, static_cast<float>(opacity)));
  osg::StateSet* state = geometry.getOrCreateStateSet();
  state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
  state->setRenderBinDetails(kCurtainBin, "RenderBin");
  root.addChild(&geometry);
}

/// Sides, floor and ceiling; the flat ones weaker, or nothing below them could be read from above.
void addVolume(osg::Group& root, const SceneVolume& volume) {
  constexpr double kFlat = 0.5;
  const std::size_t count = volume.top.size();
  osg::ref_ptr<osg::Vec3Array> sides = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec3Array> ceiling = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec3Array> floor = new osg::Vec3Array;
  for (std::size_t i = 0; i <= count; ++i) {
    const ScenePoint& top = volume.top[i % count];
    const ScenePoint bottom{top.x, top.y, volume.bottom[i % count]};
    sides->push_back(vectorOf(top));
    sides->push_back(vectorOf(bottom));
    if (i < count) {
      ceiling->push_back(vectorOf(top));
      floor->push_back(vectorOf(bottom));
    }
  }
  addTranslucent(root, *geometryOf(sides, new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, static_cast<int>(sides->size()))), volume.color, volume.opacity);
  for (osg::Vec3Array* flat : {ceiling.get(), floor.get()}) {
    const osg::ref_ptr<osg::Geometry> geometry = geometryOf(flat, new osg::DrawArrays(GL_POLYGON, 0, static_cast<int>(flat->size())));
    const osg::ref_ptr<osgUtil::Tessellator> tessellator = new osgUtil::Tessellator;
    tessellator->setWindingType(osgUtil::Tessellator::TESS_WINDING_ODD);
    tessellator->retessellatePolygons(*geometry);
    addTranslucent(root, *geometry, volume.color, kFlat * volume.opacity);
  }
}

void addPoles(SceneNodes& nodes, const SceneData& scene) {
  const style::ChartColors& colors = style::ChartColors::of(scene.style.theme);
  for (const auto& [extra, bin] : {std::pair{2.4, kCasingBin}, std::pair{0.0, kLineBin}}) {
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4Array> tints = new osg::Vec4Array;
    for (const ScenePole& pole : scene.poles) {
      for (const ScenePoint& p : {pole.foot, pole.head}) {
        vertices->push_back(vectorOf(p));
        tints->push_back(vectorOf(bin == kCasingBin ? colors.textHalo : pole.color));
      }
    }
    if (vertices->empty()) {
      return;
    }
    const osg::ref_ptr<osg::Geometry> geometry = geometryOf(vertices, new osg::DrawArrays(GL_LINES, 0, static_cast<int>(vertices->size())));
    geometry->setColorArray(tints, osg::Array::BIND_PER_VERTEX);
    osg::StateSet* state = geometry->getOrCreateStateSet();
    setWidth(nodes, *state, 2.0 + extra);
    state->setRenderBinDetails(bin, "RenderBin");
    nodes.root->addChild(geometry);
  }
}

void addRunway(SceneNodes& nodes, const SceneRunway& runway, const SceneData& scene) {
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
  const RunwayShape shape = runwayShape(runway, scene.terrain.get(), style::ChartColors::of(scene.style.theme));
  for (const RunwayShape::Corner& corner : shape.triangles) {
    vertices->push_back(vectorOf(corner.place));
    colors->push_back(vectorOf(corner.color));
  }
  const osg::ref_ptr<osg::Geometry> geometry = geometryOf(vertices, new osg::DrawArrays(GL_TRIANGLES, 0, static_cast<int>(vertices->size())));
  geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
  const auto transform = keep(new osg::MatrixTransform);
  transform->addChild(geometry);
  nodes.root->addChild(transform.get());
  nodes.runways.push_back({transform, shape.centre, runway.threshold.heading, runway.length, shape.width});
}

/// What lies on the ground: no depth written, moved forward so that coarse tiles do not hide it.
osg::ref_ptr<osg::StateSet> runwayState() {
  osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
  state->setAttributeAndModes(new osg::PolygonOffset(-2.0F, -600.0F));
  state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, false));
  state->setRenderBinDetails(kRunwayBin, "RenderBin");
  return state;
}

}  // namespace

std::shared_ptr<const SceneNodes> buildSceneNodes(const SceneData& scene, double labelRatio) {
  auto nodes = std::make_shared<SceneNodes>();
  nodes->root = keep(new osg::Group);
  osg::StateSet* state = nodes->root->getOrCreateStateSet();
  state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
  state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
  state->setMode(GL_LINE_SMOOTH, osg::StateAttribute::ON);
  state->setAttributeAndModes(new osg::BlendFunc);
  for (const SceneCurtain& curtain : scene.curtains) {
    addCurtain(*nodes->root, curtain, scene.altitudes);
  }
  for (const SceneVolume& volume : scene.volumes) {
    addVolume(*nodes->root, volume);
  }
  addLines(*nodes, scene);
  addPoles(*nodes, scene);
  const osg::ref_ptr<osg::StateSet> onGround = runwayState();
  for (const SceneRunway& runway : scene.runways) {
    addRunway(*nodes, runway, scene);
    nodes->runways.back().transform->setStateSet(onGround);
  }
  nodes->labels = buildLabelAtlas(scene, labelRatio);
  static_cast<void>(nodes->root->getBound());
  return nodes;
}

void fitToPicture(const SceneNodes& nodes, const CameraState& camera, double exaggeration, double pixelRatio) {
  for (const auto& [line, width] : nodes.lines) {
    line->setWidth(static_cast<float>(width * pixelRatio));
  }
  for (const auto& [point, width] : nodes.joints) {
    point->setSize(static_cast<float>(width * pixelRatio));
  }
  for (const RunwayNode& runway : nodes.runways) {
    const Vec3 offset = Vec3{runway.centre.x, runway.centre.y, runway.centre.z * exaggeration} - camera.eye;
    const double pixels = camera.pixelsPerMetre(std::max(dot(offset, camera.forward), camera.nearPlane));
    const double along = std::max(1.0, kRunwayPixels / (pixels * std::max(runway.length, 1.0)));
    const double across = std::max(along, kRunwayWidePixels / (pixels * std::max(runway.width, 1.0)));
    const osg::Vec3d centre(runway.centre.x, runway.centre.y, runway.centre.z);
    runway.transform->setMatrix(osg::Matrix::translate(-centre) * osg::Matrix::rotate(-runway.heading, osg::Vec3d(0.0, 0.0, 1.0)) *
                                osg::Matrix::scale(along, across, 1.0) * osg::Matrix::rotate(runway.heading, osg::Vec3d(0.0, 0.0, 1.0)) *
                                osg::Matrix::translate(centre));
  }
}

}  // namespace vp::scene3d
