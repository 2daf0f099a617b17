// The rules of layout that a compiler does not check: who may include whom, third-party headers, size of files.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace vp::architecture {

/** Text of every source file by its path from the repository's root, "core/geo/pose.h". */
using SourceTree = std::map<std::string, std::string>;

struct Violation {
  std::string path;
  int line = 0;  ///< 0 where the whole file is meant
  std::string what;
};

/** The rules that one file can break by itself: table of folders, third-party headers, `#pragma once`, length. */
std::vector<Violation> checkFile(const std::string& path, const std::string& text);

/** What the checker reaches through any number of headers: nothing of the planner. */
std::vector<Violation> checkIndependenceOfSafety(const SourceTree& tree);

/** Nothing that a file of core/audit includes, directly or through others, holds a formula of planner or checker: values alone. */
std::vector<Violation> checkIndependenceOfAudit(const SourceTree& tree);

}  // namespace vp::architecture
