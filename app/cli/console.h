#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <string>

namespace vp::cli {

/** Exit statuses of volplane-cli (DESIGN section 4). */
enum ExitStatus { kDone = 0, kNoSolution = 1, kBadInput = 2, kVerificationFailed = 3, kStopped = 130 };

/** The exit status that belongs to an error. */
int statusOf(const Error& error);

/** Prints "volplane-cli: SENTENCE" on stderr, with --json an object on stdout as well, and gives the exit status. */
int report(const Error& error, bool json);

/** What every command shares. */
struct Common {
  bool json = false;
  bool quiet = false;
};

/** Turns Ctrl-C and SIGTERM into a stop request and shows progress on a terminal. One per process, made before any
 *  other thread: the signals are blocked in all of them and taken by a thread of its own. */
class Console {
public:
  explicit Console(bool showProgress);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /** A job that stops on Ctrl-C and shows its progress on stderr where that is a terminal. */
  [[nodiscard]] Job job();
  /** Ends the progress line. */
  void finishProgress();

private:
  struct Impl;
  Impl* impl_;
};

/** Folder of a file, "." for a bare name. */
std::string folderOf(const std::string& path);

}  // namespace vp::cli
