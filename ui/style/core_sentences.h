#pragma once

#include <span>

namespace vp::style {

/** Texts of the core of two words or more, as they stand in its sources: patterns of fmt, and pieces of sentences. */
std::span<const char* const> coreSentences();

}  // namespace vp::style
