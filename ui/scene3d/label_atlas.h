#pragma once

#include "ui/scene3d/scene_data.h"

#include <QImage>
#include <QRectF>
#include <QSizeF>

#include <vector>

namespace vp::scene3d {

/** One piece of the atlas: where it lies in it (texture coordinates, from the upper left) and how large it is shown. */
struct AtlasPiece {
  QRectF texture;  ///< 0 .. 1
  QSizeF size;     ///< px at 96 dpi
};

/** A label or symbol ready to be put on the picture. */
struct AtlasItem {
  enum class Shape { Text, TargetHead, Aircraft };
  Shape shape = Shape::Text;
  ScenePoint anchor;
  double priority = 0.0;
  double showWithin = 1e12;
  double heading = 0.0;              ///< Aircraft
  double lift = 0.0;                 ///< px between anchor and the lower side of a text
  bool isFaintBehindGround = false;  ///< else left out there
  AtlasPiece full;
  AtlasPiece brief;  ///< without the second line; empty size: there is none
};

/** All labels and symbols of a scene in one picture, drawn with the application's font at the resolution of the screen.
 *  Premultiplied RGBA. @threads pure */
struct LabelAtlas {
  QImage image;
  std::vector<AtlasItem> items;
};

LabelAtlas buildLabelAtlas(const SceneData& scene, double pixelRatio);

}  // namespace vp::scene3d
