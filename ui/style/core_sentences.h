#pragma once

#include <span>

namespace vp::style {

/** Texts of the core of two words or more, as they stand in its sources: patterns of fmt, and pieces of sentences. */
std::span<const char* const> sentencesOfFormats();  ///< core/formats
std::span<const char* const> sentencesOfSafety();   ///< core/safety
std::span<const char* const> sentencesOfOthers();   ///< all other rooms

}  // namespace vp::style
