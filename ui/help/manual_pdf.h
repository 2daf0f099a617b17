#pragma once

#include "ui/help/manual.h"

namespace vp::help {

/** Writes the whole manual as one PDF on A4: title, contents with page numbers, chapters from new pages on, a line with chapter and page
 *  number at the foot. References to other pages of the manual get their page numbers.
 *  @errors BadFile - a chapter or picture that cannot be read;  OutputFailed - the file cannot be written
 *  @threads needs a QGuiApplication (fonts); any platform, also "offscreen" */
Result<void> writeManualPdf(const Manual& manual, const QString& path, const QString& version);

}  // namespace vp::help
