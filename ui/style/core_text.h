#pragma once

#include "core/base/result.h"

#include <QString>

#include <string>
#include <vector>

namespace vp::style {

/** A text of the core in the language of the window: errors, findings of the checker, notes, names of export formats, steps of long work. The core
 *  knows no translations and writes English by patterns of fmt; these stand in core_sentences.h and are translated with the rest of the window. A
 *  sentence is taken apart by them (sentence_patterns.h), and what was filled in, if it is words of the core itself, is translated too. What was made
 *  by no pattern stays as it is: names, numbers, and texts of libraries. May be called by any thread. */
QString coreText(const std::string& text);

/** The same for the place and the sentence of an error, as Error::message() joins them. */
QString coreText(const Error& error);

/** All patterns, in UTF-8: those of core_sentences.h and single words. */
const std::vector<const char*>& corePatterns();

}  // namespace vp::style
