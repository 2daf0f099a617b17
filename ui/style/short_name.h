#pragma once

#include <QString>

namespace vp::style {

/// Names longer than this are shortened in drawings, where they would hide what is drawn. [letters]
inline constexpr int kLongestName = 26;

/** A name as drawings write it: blanks simplified, and with "…" in its middle if it is longer than kLongestName, because
 *  numbered names differ at one of their ends. Lists, tables and printed tables have the whole name.   @threads pure */
QString shortName(const QString& name);

}  // namespace vp::style
