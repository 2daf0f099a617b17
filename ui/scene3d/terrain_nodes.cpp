#include "ui/scene3d/terrain_nodes.h"

#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/Geometry>
#include <osg/Group>
#include <osg/Image>
#include <osg/Texture2D>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace vp::scene3d {
namespace {

osg::ref_ptr<osg::Image> imageOf(const TileTexture& texture) {
  auto* pixels = new unsigned char[texture.rgb.size()];
  std::memcpy(pixels, texture.rgb.data(), texture.rgb.size());
  osg::ref_ptr<osg::Image> image = new osg::Image;
  image->setImage(TileTexture::kSide, TileTexture::kSide, 1, GL_RGB, GL_RGB, GL_UNSIGNED_BYTE, pixels, osg::Image::USE_NEW_DELETE, 1);
  osg::Image::MipmapDataType offsets;
  unsigned int offset = 0;
  for (unsigned int size = TileTexture::kSide; size > 1; size /= 2) {
    offset += size * size * 3;
    offsets.push_back(offset);
  }
  image->setMipmapLevels(offsets);
  return image;
}

osg::ref_ptr<osg::Geometry> surfaceOf(const TileMesh& mesh) {
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  vertices->reserve(mesh.vertices.size());
  for (const auto& v : mesh.vertices) {
    vertices->push_back(osg::Vec3(v[0], v[1], v[2]));
  }
  osg::ref_ptr<osg::Vec2Array> textureAt = new osg::Vec2Array;
  textureAt->reserve(mesh.textureAt.size());
  for (const auto& t : mesh.textureAt) {
    textureAt->push_back(osg::Vec2(t[0], t[1]));
  }
  const std::vector<std::uint16_t>& triangles = mesh.isWhole ? wholeTileTriangles() : mesh.triangles;
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setUseDisplayList(false);
  geometry->setUseVertexBufferObjects(true);
  geometry->setVertexArray(vertices);
  geometry->setTexCoordArray(0, textureAt, osg::Array::BIND_PER_VERTEX);
  geometry->addPrimitiveSet(new osg::DrawElementsUShort(GL_TRIANGLES, triangles.begin(), triangles.end()));
  return geometry;
}

osg::Vec4 vectorOf(const QColor& color, double brightness = 1.0, double alpha = 1.0) {
  return {static_cast<float>(color.redF() * brightness), static_cast<float>(color.greenF() * brightness),
          static_cast<float>(color.blueF() * brightness), static_cast<float>(alpha)};
}

/// The cut sides of the relief model, lit from the north-west like the relief itself.
osg::ref_ptr<osg::Geometry> wallsOf(const TileMesh& mesh, style::Theme theme) {
  const QColor soil = style::ChartColors::of(theme).corridor;
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
  for (std::size_t i = 0; i + 3 < mesh.wallQuads.size(); i += 4) {
    const auto& a = mesh.wallQuads[i];
    const auto& b = mesh.wallQuads[i + 1];
    const auto dx = static_cast<double>(b[0] - a[0]);
    const auto dy = static_cast<double>(b[1] - a[1]);
    const double run = std::max(std::hypot(dx, dy), 1e-3);
    const double facing = (-dy - dx) / run / std::sqrt(2.0);  // outward normal (dy, -dx) against the light from (-1, 1)
    const double light = 0.80 + 0.16 * facing;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& v = mesh.wallQuads[i + k];
      vertices->push_back(osg::Vec3(v[0], v[1], v[2]));
      colors->push_back(vectorOf(soil, k < 2 ? light : 0.72 * light));
    }
  }
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setUseDisplayList(false);
  geometry->setUseVertexBufferObjects(true);
  geometry->setVertexArray(vertices);
  geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
  geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, static_cast<int>(vertices->size())));
  osg::StateSet* state = geometry->getOrCreateStateSet();
  state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
  state->setTextureMode(0, GL_TEXTURE_2D, osg::StateAttribute::OFF);
  return geometry;
}

osg::ref_ptr<osg::Image> hatchImage(const TerrainPalette& palette) {
  constexpr int kSide = 64;  // four periods of the hatch
  osg::ref_ptr<osg::Image> image = new osg::Image;
  image->allocateImage(kSide, kSide, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const TerrainPalette::Rgb rgb = TerrainPalette::isHatchLine(x, y) ? palette.hatch() : palette.hatchBase();
      std::copy(rgb.begin(), rgb.end(), image->data(static_cast<unsigned int>(x), static_cast<unsigned int>(y)));
    }
  }
  return image;
}

}  // namespace

NodePointer buildTileNode(const TerrainModel& model, const TerrainPalette& palette, TileId tile, style::Theme theme) {
  const TileMesh mesh = buildTileMesh(model, tile);
  osg::ref_ptr<osg::Group> group = new osg::Group;
  if (mesh.isWhole || !mesh.triangles.empty()) {
    const osg::ref_ptr<osg::Geometry> surface = surfaceOf(mesh);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(imageOf(buildTileTexture(model, palette, tile)));
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setUseHardwareMipMapGeneration(false);
    surface->getOrCreateStateSet()->setTextureAttributeAndModes(0, texture);
    group->addChild(surface);
  }
  if (!mesh.wallQuads.empty()) {
    group->addChild(wallsOf(mesh, theme));
  }
  static_cast<void>(group->getBound());  // here rather than while a frame is drawn
  return keep<osg::Node>(group.get());
}

NodePointer buildBaseNode(const TerrainModel& model, style::Theme theme) {
  const geo::Box extent = model.extent();
  const double side = std::max(extent.maxX - extent.minX, extent.maxY - extent.minY);
  const std::array<double, 4> xs{extent.minX - 2.0 * side, extent.minX - 0.4 * side, extent.maxX + 0.4 * side, extent.maxX + 2.0 * side};
  const std::array<double, 4> ys{extent.minY - 2.0 * side, extent.minY - 0.4 * side, extent.maxY + 0.4 * side, extent.maxY + 2.0 * side};
  const double texture = side / 14.0;
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec2Array> textureAt = new osg::Vec2Array;
  osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const bool isInside = (i == 1 || i == 2) && (j == 1 || j == 2);
      vertices->push_back(osg::Vec3(static_cast<float>(xs[i]), static_cast<float>(ys[j]), static_cast<float>(model.base())));
      textureAt->push_back(osg::Vec2(static_cast<float>((xs[i] - extent.minX) / texture), static_cast<float>((ys[j] - extent.minY) / texture)));
      colors->push_back(osg::Vec4(1.0F, 1.0F, 1.0F, isInside ? 1.0F : 0.0F));
    }
  }
  osg::ref_ptr<osg::DrawElementsUShort> triangles = new osg::DrawElementsUShort(GL_TRIANGLES);
  for (unsigned int j = 0; j < 3; ++j) {
    for (unsigned int i = 0; i < 3; ++i) {
      const unsigned int a = j * 4 + i;
      // corner fields are cut along the diagonal that points outwards, so that they fade round
      const bool isFalling = (i == 0) == (j == 0);
      const std::array<unsigned int, 6> corners = isFalling ? std::array<unsigned int, 6>{a, a + 1, a + 4, a + 1, a + 5, a + 4}
                                                            : std::array<unsigned int, 6>{a, a + 1, a + 5, a, a + 5, a + 4};
      for (const unsigned int corner : corners) {
        triangles->push_back(static_cast<GLushort>(corner));
      }
    }
  }
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setUseDisplayList(false);
  geometry->setUseVertexBufferObjects(true);
  geometry->setVertexArray(vertices);
  geometry->setTexCoordArray(0, textureAt, osg::Array::BIND_PER_VERTEX);
  geometry->setColorArray(colors, osg::Array::BIND_PER_VERTEX);
  geometry->addPrimitiveSet(triangles);
  osg::ref_ptr<osg::Texture2D> hatch = new osg::Texture2D(hatchImage(TerrainPalette(theme, model.lowest(), model.highest())));
  hatch->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
  hatch->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
  hatch->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
  osg::StateSet* state = geometry->getOrCreateStateSet();
  state->setTextureAttributeAndModes(0, hatch);
  state->setAttributeAndModes(new osg::BlendFunc);
  state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
  state->setRenderBinDetails(1, "RenderBin");  // after the relief that hides most of it
  return keep<osg::Node>(geometry.get());
}

void setTerrainState(osg::Group& group) {
  osg::StateSet* state = group.getOrCreateStateSet();
  state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
  state->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
  state->setRenderBinDetails(0, "RenderBin");
}

}  // namespace vp::scene3d
