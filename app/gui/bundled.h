#pragma once

#include <QString>

namespace vp::gui {

/** The mission that the first start opens, planned: maps/alpine-n10.vpm, found beside the program or in the source tree.
 *  Empty if it is not there. */
QString bundledExample();

/** Whether a mission is one of those that come with the program, which many may look at. @param path  absolute */
bool isBundled(const QString& path);

}  // namespace vp::gui
