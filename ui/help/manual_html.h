#pragma once

#include "ui/help/manual.h"

namespace vp::help {

/** Writes the manual as web pages that need no network: one for each chapter, index.html, style.css and the pictures
 *  that the chapters show.
 *  @param folder  is made if it is missing; files in it are replaced    @param version  of the program, for the foot of each page
 *  @errors BadFile - a chapter or picture that cannot be read;  OutputFailed - the folder or a file cannot be written */
Result<void> writeManualHtml(const Manual& manual, const QString& folder, const QString& version);

/** Paths of the pictures that a page shows, as they stand in it. */
QStringList picturesOf(const Page& page);

}  // namespace vp::help
