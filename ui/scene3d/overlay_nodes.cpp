#include "ui/scene3d/overlay_nodes.h"

#include <osg/BlendFunc>
#include <osg/Camera>
#include <osg/Depth>
#include <osg/Geometry>
#include <osg/Texture2D>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace vp::scene3d {
namespace {

constexpr int kSkyBin = 1;      // behind the relief, which hides most of it; before the base plane, which is seen through at its rim
constexpr int kLabelBin = 100;  // over everything

/// A camera that draws in pixels of the picture, y downwards.
osg::ref_ptr<osg::Camera> pixelCamera(int bin, osg::Depth* depth) {
  osg::ref_ptr<osg::Camera> camera = new osg::Camera;
  camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
  camera->setRenderOrder(osg::Camera::NESTED_RENDER);
  camera->setClearMask(0);
  camera->setAllowEventFocus(false);
  camera->setCullingActive(false);
  camera->setComputeNearFarMode(osg::Camera::DO_NOT_COMPUTE_NEAR_FAR);
  osg::StateSet* state = camera->getOrCreateStateSet();
  state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
  state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
  state->setAttributeAndModes(depth);
  state->setRenderBinDetails(bin, "RenderBin");
  return camera;
}

void setPixels(osg::Camera& camera, const CameraState& view) {
  camera.setProjectionMatrixAsOrtho(0.0, view.width, view.height, 0.0, -1.0, 1.0);
  camera.setViewMatrix(osg::Matrix::identity());
}

osg::ref_ptr<osg::Geometry> dynamicQuads() {
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setDataVariance(osg::Object::DYNAMIC);
  geometry->setUseDisplayList(false);
  geometry->setUseVertexBufferObjects(false);  // few and new in each frame
  geometry->setVertexArray(new osg::Vec3Array);
  geometry->setColorArray(new osg::Vec4Array, osg::Array::BIND_PER_VERTEX);
  geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, 0));
  geometry->setCullingActive(false);
  return geometry;
}

QColor mixed(const QColor& a, const QColor& b, double part) {
  const auto mix = [part](int x, int y) { return static_cast<int>(std::lround(x + part * (y - x))); };
  return {mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue())};
}

osg::Vec4 vectorOf(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF(), 1.0F};
}

}  // namespace

QColor hazeColor(style::Theme theme) {
  return style::ChartColors::of(theme).sky;
}

QColor zenithColor(style::Theme theme) {
  return theme == style::Theme::Light ? mixed(hazeColor(theme), QColor(0x5E, 0x9A, 0xD0), 0.80)
                                      : mixed(hazeColor(theme), QColor(0x05, 0x07, 0x0C), 0.85);
}

class SkyNode::Private {
public:
  Private() : camera(pixelCamera(kSkyBin, new osg::Depth(osg::Depth::LEQUAL, 1.0, 1.0, false))), quads(dynamicQuads()) { camera->addChild(quads); }
  osg::ref_ptr<osg::Camera> camera;
  osg::ref_ptr<osg::Geometry> quads;
};

SkyNode::SkyNode() : d_(std::make_unique<Private>()) {}
SkyNode::~SkyNode() = default;

osg::Node& SkyNode::node() {
  return *d_->camera;
}

void SkyNode::update(const CameraState& camera, style::Theme theme) {
  setPixels(*d_->camera, camera);
  auto& vertices = static_cast<osg::Vec3Array&>(*d_->quads->getVertexArray());
  auto& colors = static_cast<osg::Vec4Array&>(*d_->quads->getColorArray());
  vertices.clear();
  colors.clear();
  // Bands of elevation above the horizon; the camera never rolls, so each is a level strip of the picture.
  const double pitch = std::asin(std::clamp(camera.forward.z, -1.0, 1.0));
  const double perTangent = 0.5 * camera.height / std::tan(0.5 * camera.fieldOfView);
  const auto rowOf = [&](double elevation) {
    const double angle = std::clamp(elevation - pitch, -1.45, 1.45);
    return 0.5 * camera.height - perTangent * std::tan(angle);
  };
  constexpr std::array kElevations{-1.4, 0.0, 0.05, 0.16, 0.40, 1.2};
  constexpr std::array kParts{0.0, 0.0, 0.22, 0.52, 0.85, 1.0};
  for (std::size_t i = 0; i + 1 < kElevations.size(); ++i) {
    const auto low = static_cast<float>(rowOf(kElevations[i]));
    const auto high = static_cast<float>(rowOf(kElevations[i + 1]));
    const auto right = static_cast<float>(camera.width);
    const osg::Vec4 lower = vectorOf(mixed(hazeColor(theme), zenithColor(theme), kParts[i]));
    const osg::Vec4 upper = vectorOf(mixed(hazeColor(theme), zenithColor(theme), kParts[i + 1]));
    vertices.push_back(osg::Vec3(0.0F, low, 0.0F));
    vertices.push_back(osg::Vec3(right, low, 0.0F));
    vertices.push_back(osg::Vec3(right, high, 0.0F));
    vertices.push_back(osg::Vec3(0.0F, high, 0.0F));
    for (const osg::Vec4& color : {lower, lower, upper, upper}) {
      colors.push_back(color);
    }
  }
  static_cast<osg::DrawArrays&>(*d_->quads->getPrimitiveSet(0)).setCount(static_cast<int>(vertices.size()));
  vertices.dirty();
  colors.dirty();
  d_->quads->dirtyBound();
}

class LabelNode::Private {
public:
  struct Sheet {
    const LabelAtlas* atlas = nullptr;
    qint64 key = 0;
    osg::ref_ptr<osg::Geometry> quads;
  };
  Private() : camera(pixelCamera(kLabelBin, new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false))) {
    osg::StateSet* state = camera->getOrCreateStateSet();
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA));
  }

  /// One sheet for each atlas, its picture uploaded once.
  Sheet& sheetOf(std::size_t index, const LabelAtlas& atlas) {
    while (sheets.size() <= index) {
      sheets.emplace_back();
    }
    Sheet& sheet = sheets[index];
    if (sheet.quads && sheet.key == atlas.image.cacheKey()) {
      return sheet;
    }
    if (sheet.quads) {
      camera->removeChild(sheet.quads);
    }
    sheet.key = atlas.image.cacheKey();
    sheet.quads = dynamicQuads();
    sheet.quads->setTexCoordArray(0, new osg::Vec2Array, osg::Array::BIND_PER_VERTEX);
    if (!atlas.image.isNull()) {
      auto* pixels = new unsigned char[static_cast<std::size_t>(atlas.image.sizeInBytes())];
      std::memcpy(pixels, atlas.image.constBits(), static_cast<std::size_t>(atlas.image.sizeInBytes()));
      osg::ref_ptr<osg::Image> image = new osg::Image;
      image->setImage(atlas.image.width(), atlas.image.height(), 1, GL_RGBA, GL_RGBA, GL_UNSIGNED_BYTE, pixels, osg::Image::USE_NEW_DELETE, 1);
      osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
      texture->setResizeNonPowerOfTwoHint(false);
      texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
      texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
      sheet.quads->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    }
    camera->addChild(sheet.quads);
    return sheet;
  }

  osg::ref_ptr<osg::Camera> camera;
  std::vector<Sheet> sheets;
};

LabelNode::LabelNode() : d_(std::make_unique<Private>()) {}
LabelNode::~LabelNode() = default;

osg::Node& LabelNode::node() {
  return *d_->camera;
}

void LabelNode::update(const CameraState& camera, const std::vector<const LabelAtlas*>& atlases, const std::vector<PlacedLabel>& labels) {
  setPixels(*d_->camera, camera);
  for (std::size_t a = 0; a < atlases.size(); ++a) {
    const Private::Sheet& sheet = d_->sheetOf(a, *atlases[a]);
    auto& vertices = static_cast<osg::Vec3Array&>(*sheet.quads->getVertexArray());
    auto& colors = static_cast<osg::Vec4Array&>(*sheet.quads->getColorArray());
    auto& textureAt = static_cast<osg::Vec2Array&>(*sheet.quads->getTexCoordArray(0));
    vertices.clear();
    colors.clear();
    textureAt.clear();
    // lowest priority first, so that the most important stands on top
    for (std::size_t next = labels.size(); next-- > 0;) {
      const PlacedLabel& label = labels[next];
      if (label.atlas != static_cast<int>(a)) {
        continue;
      }
      const QRectF& t = label.piece->texture;
      const std::array<QPointF, 4> corners{t.topLeft(), t.topRight(), t.bottomRight(), t.bottomLeft()};
      const auto opacity = static_cast<float>(label.opacity);
      for (std::size_t k = 0; k < 4; ++k) {
        vertices.push_back(osg::Vec3(static_cast<float>(label.corners[k][0]), static_cast<float>(label.corners[k][1]), 0.0F));
        textureAt.push_back(osg::Vec2(static_cast<float>(corners[k].x()), static_cast<float>(corners[k].y())));
        colors.push_back(osg::Vec4(opacity, opacity, opacity, opacity));
      }
    }
    static_cast<osg::DrawArrays&>(*sheet.quads->getPrimitiveSet(0)).setCount(static_cast<int>(vertices.size()));
    vertices.dirty();
    colors.dirty();
    textureAt.dirty();
    sheet.quads->dirtyBound();
  }
}

}  // namespace vp::scene3d
