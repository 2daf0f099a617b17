#pragma once

#include "ui/map/map_camera.h"
#include "ui/map/map_scene.h"

#include <QImage>
#include <QSize>

namespace vp::map {

/** A picture of the map without any window, with the same drawing code.
 *  @param size  device-independent pixels; the picture has size * devicePixelRatio pixels
 *  @pre a QGuiApplication exists (for fonts)   @cost some 0.2 s per million pixels, in this thread */
QImage renderMap(const MapScene& scene, const MapCamera& camera, double devicePixelRatio);

/** The same, fitted to tour and targets, else to the terrain. */
QImage renderMap(const MapScene& scene, QSize size, double devicePixelRatio);

/** The camera that fits a situation: what Ctrl+Home shows. */
MapCamera homeCamera(const document::Situation& situation, QSizeF size);

}  // namespace vp::map
