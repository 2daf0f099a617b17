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

constexpr double kBaseHatch = 20.0;  // hatch pictures along the longer side of the terrain
constexpr double kLidCells = 24.0;   // cells along a hatch picture over unknown regions, which are small

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

/// Without a colour of its own a geometry would take that of whatever was drawn before it.
void setWhite(osg::Geometry& geometry) {
  osg::ref_ptr<osg::Vec4Array> white = new osg::Vec4Array(1);
  (*white)[0] = osg::Vec4(1.0F, 1.0F, 1.0F, 1.0F);
  geometry.setColorArray(white, osg::Array::BIND_OVERALL);
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
  setWhite(*geometry);
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

/// @param strength  of the lines, 0 .. 1: over large areas they must not outdo the terrain
osg::ref_ptr<osg::Image> hatchImage(const TerrainPalette& palette, double strength) {
  constexpr int kSide = 64;  // four periods of the hatch
  osg::ref_ptr<osg::Image> image = new osg::Image;
  image->allocateImage(kSide, kSide, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      unsigned char* pixel = image->data(static_cast<unsigned int>(x), static_cast<unsigned int>(y));
      for (std::size_t c = 0; c < 3; ++c) {
        const double part = TerrainPalette::isHatchLine(x, y) ? strength : 0.0;
        pixel[c] = static_cast<unsigned char>(palette.hatchBase()[c] + part * (palette.hatch()[c] - palette.hatchBase()[c]));
      }
    }
  }
  return image;
}

osg::ref_ptr<osg::Texture2D> hatchTexture(const TerrainModel& model, style::Theme theme, double strength) {
  osg::ref_ptr<osg::Texture2D> hatch = new osg::Texture2D(hatchImage(TerrainPalette(theme, model.lowest(), model.highest(), 0.0), strength));
  hatch->setWrap(osg::Texture::WRAP_S, osg::Texture::REPEAT);
  hatch->setWrap(osg::Texture::WRAP_T, osg::Texture::REPEAT);
  hatch->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_NEAREST);
  return hatch;
}

/// Where the hatch lies on the ground.
osg::Vec2 hatchAt(const TerrainModel& model, double x, double y, double side) {
  return {static_cast<float>((x - model.extent().minX) / side), static_cast<float>((y - model.extent().minY) / side)};
}

osg::ref_ptr<osg::Geometry> lidsOf(const TileMesh& mesh, const TerrainModel& model) {
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec2Array> textureAt = new osg::Vec2Array;
  for (const auto& v : mesh.lidQuads) {
    vertices->push_back(osg::Vec3(v[0], v[1], v[2]));
    textureAt->push_back(hatchAt(model, static_cast<double>(v[0]), static_cast<double>(v[1]), kLidCells * model.terrain().grid->cellSize()));
  }
  osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
  geometry->setUseDisplayList(false);
  geometry->setUseVertexBufferObjects(true);
  geometry->setVertexArray(vertices);
  geometry->setTexCoordArray(0, textureAt, osg::Array::BIND_PER_VERTEX);
  setWhite(*geometry);
  geometry->addPrimitiveSet(new osg::DrawArrays(GL_QUADS, 0, static_cast<int>(vertices->size())));
  static_cast<void>(geometry->getBound());
  return geometry;
}

}  // namespace

TileNodes buildTileNodes(const TerrainModel& model, const TerrainPalette& palette, TileId tile, style::Theme theme) {
  const TileMesh mesh = buildTileMesh(model, tile);
  osg::ref_ptr<osg::Group> group = new osg::Group;
  if (mesh.isWhole || !mesh.triangles.empty()) {
    const osg::ref_ptr<osg::Geometry> surface = surfaceOf(mesh);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(imageOf(buildTileTexture(model, palette, tile)));
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_NEAREST);
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
  TileNodes nodes{keep<osg::Node>(group.get()), nullptr};
  if (!mesh.lidQuads.empty()) {
    nodes.lids = keep<osg::Node>(lidsOf(mesh, model).get());
  }
  return nodes;
}

NodePointer buildBaseNode(const TerrainModel& model, style::Theme theme) {
  const geo::Box extent = model.extent();
  const double side = std::max(extent.maxX - extent.minX, extent.maxY - extent.minY);
  const std::array<double, 4> xs{extent.minX - 1.1 * side, extent.minX - 0.12 * side, extent.maxX + 0.12 * side, extent.maxX + 1.1 * side};
  const std::array<double, 4> ys{extent.minY - 1.1 * side, extent.minY - 0.12 * side, extent.maxY + 0.12 * side, extent.maxY + 1.1 * side};
  osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
  osg::ref_ptr<osg::Vec2Array> textureAt = new osg::Vec2Array;
  osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array;
  for (std::size_t j = 0; j < 4; ++j) {
    for (std::size_t i = 0; i < 4; ++i) {
      const bool isInside = (i == 1 || i == 2) && (j == 1 || j == 2);
      vertices->push_back(osg::Vec3(static_cast<float>(xs[i]), static_cast<float>(ys[j]), static_cast<float>(model.base())));
      textureAt->push_back(hatchAt(model, xs[i], ys[j], side / kBaseHatch));
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
  osg::StateSet* state = geometry->getOrCreateStateSet();
  state->setTextureAttributeAndModes(0, hatchTexture(model, theme, 0.30));
  state->setAttributeAndModes(new osg::BlendFunc);
  state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
  state->setRenderBinDetails(2, "RenderBin");  // after the relief that hides most of it, and the sky that shows through its rim
  return keep<osg::Node>(geometry.get());
}

void setTerrainState(osg::Group& group) {
  osg::StateSet* state = group.getOrCreateStateSet();
  state->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
  state->setAttributeAndModes(new osg::CullFace(osg::CullFace::BACK));
  state->setRenderBinDetails(0, "RenderBin");
}

void setLidState(osg::Group& group, const TerrainModel& model, style::Theme theme) {
  group.getOrCreateStateSet()->setTextureAttributeAndModes(0, hatchTexture(model, theme, 0.7));
}

}  // namespace vp::scene3d
