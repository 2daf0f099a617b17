#pragma once

#include <tl/expected.hpp>

#include <string>
#include <utility>

namespace vp {

/** What kind of expected failure happened; decides the exit status of a program (see app/cli). */
enum class Errc {
  BadFile,         ///< a file cannot be opened, is truncated, or is not what it should be
  BadFormat,       ///< a file's text or structure is wrong at a place that can be named
  OutOfRange,      ///< a value is outside what it may be
  NewerVersion,    ///< the file was written by a newer version of this program
  MissingTerrain,  ///< something needed lies outside the terrain, or where it has no data
  NoLandingSite,   ///< no usable landing site inside the terrain
  NoSolution,      ///< the mission has no safe tour; what() says which target, constraint and height is missing
  OutputFailed,    ///< a file cannot be written
  Cancelled,       ///< the caller asked to stop; nothing was written
  Unsupported,     ///< a feature that this build or machine does not have
  Internal,        ///< a defect of this program; nothing was changed
};

/** An expected failure at a border: one sentence that names the cause and the remedy, and where it happened. */
struct Error {
  Errc code = Errc::BadFile;
  std::string what;   ///< one sentence in English, without the place
  std::string where;  ///< file, and line/column or member path where known; may be empty

  /** The place and the sentence, as shown to a person. */
  [[nodiscard]] std::string message() const { return where.empty() ? what : where + ": " + what; }
};

template <typename T>
using Result = tl::expected<T, Error>;

/** Makes the error branch of a Result. */
inline tl::unexpected<Error> fail(Errc code, std::string what, std::string where = {}) {
  return tl::unexpected<Error>(Error{code, std::move(what), std::move(where)});
}

/** Passes the error of one Result on as the error of another. */
template <typename T>
tl::unexpected<Error> forward(const Result<T>& failed) {
  return tl::unexpected<Error>(failed.error());
}

}  // namespace vp
