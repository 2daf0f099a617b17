#pragma once

#include <QCoreApplication>

namespace vp::map {

/** Translation context of the words on the map that belong to no QObject. */
struct Words {
  Q_DECLARE_TR_FUNCTIONS(vp::map::Words)
};

}  // namespace vp::map
