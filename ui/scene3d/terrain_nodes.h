#pragma once

#include "ui/scene3d/osg_pointer.h"
#include "ui/scene3d/terrain_tile.h"

namespace vp::scene3d {

/** A tile as nodes. */
struct TileNodes {
  NodePointer ground;  ///< surface with its picture, and walls
  NodePointer lids;    ///< null: none; textured by the group they are put into
};

/** Built off the thread that renders; shares nothing with other tiles. */
TileNodes buildTileNodes(const TerrainModel& model, const TerrainPalette& palette, TileId tile, style::Theme theme);

/** The hatched plane of the unknown, on which the relief stands; fades out far around the terrain. */
NodePointer buildBaseNode(const TerrainModel& model, style::Theme theme);

/** State of all that belongs to the ground. */
void setTerrainState(osg::Group& group);
/** State of the lids over unknown regions. */
void setLidState(osg::Group& group, const TerrainModel& model, style::Theme theme);

}  // namespace vp::scene3d
