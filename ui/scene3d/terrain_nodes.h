#pragma once

#include "ui/scene3d/osg_pointer.h"
#include "ui/scene3d/terrain_tile.h"

namespace vp::scene3d {

/** A tile with its picture and walls. Built off the thread that renders; draws nothing in common with other tiles. */
NodePointer buildTileNode(const TerrainModel& model, const TerrainPalette& palette, TileId tile, style::Theme theme);

/** The hatched plane of the unknown, on which the relief stands; fades out far around the terrain. */
NodePointer buildBaseNode(const TerrainModel& model, style::Theme theme);

/** State of all that belongs to the ground. */
void setTerrainState(osg::Group& group);

}  // namespace vp::scene3d
