#pragma once

#include "ui/document/mission_document.h"

#include <QString>

namespace vp::gui {

/** The folder that is suggested for files of a mission: its own, or, while it has none, the user's documents; home if the desktop has made no such
 *  folder. */
QString suggestedFolder(const document::MissionDocument& mission);

/** The name, without ending, that is suggested for files made of a mission: that of its own file, else its title. */
QString suggestedName(const document::MissionDocument& mission);

}  // namespace vp::gui
