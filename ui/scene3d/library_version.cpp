#include "ui/scene3d/library_version.h"

#include <osg/Version>

namespace vp::scene3d {

QString openSceneGraphVersion() {
  return QString::fromLatin1(osgGetVersion());
}

}  // namespace vp::scene3d
