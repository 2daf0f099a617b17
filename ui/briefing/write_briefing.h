#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "ui/briefing/briefing_content.h"
#include "ui/briefing/page.h"

#include <QByteArray>

#include <memory>
#include <vector>

namespace vp::briefing {

class Pictures;

/** The pages of a briefing, laid out and not yet painted. Pages refer to `pictures`, which they need to be painted. */
std::vector<Page> layOutBriefing(const BriefingContent& content, const Pictures& pictures, const BriefingOptions& options);

/** A briefing as a PDF file: fonts embedded, title set, created at noon of the options' date. A plan that is not verified says so
 *  on every page.
 *  @errors Cancelled; OutputFailed - the PDF could not be made
 *  @pre a QGuiApplication exists   @threads any one thread at a time   @cost some 0.2 s per picture */
Result<QByteArray> writeBriefing(const BriefingSource& source, const BriefingOptions& options, const Job& job);

/** Pages of a PDF that writeBriefing() made. */
int pageCount(const QByteArray& pdf);

}  // namespace vp::briefing
