#pragma once

#include <QFont>
#include <QSizeF>
#include <QStringList>

namespace vp::style {

/** Size of lines of text under each other [device-independent px]: as wide as the widest, as high as all. */
QSizeF textSize(const QStringList& lines, const QFont& font);

}  // namespace vp::style
