#pragma once

#include <QString>

#include <string>

namespace vp::style {

/** A text of the core in the language of the window: names of export formats, what they lose, terms of landings, steps of long work. The core
 *  knows no translations; what is not in the list in core_text.cpp, such as sentences with numbers in them, stays as it is, in English. */
QString coreText(const std::string& text);

}  // namespace vp::style
