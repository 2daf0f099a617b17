#pragma once

#include <QString>

namespace vp::scene3d {

/** Version of the OpenSceneGraph library in use, for example "3.6.5". */
QString openSceneGraphVersion();

}  // namespace vp::scene3d
