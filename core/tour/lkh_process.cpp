#include "core/tour/lkh_process.h"

#include <fmt/core.h>

#include <cerrno>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <spawn.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vp::tour {

namespace {

/** The redirections of the started program. */
class FileActions {
public:
  explicit FileActions(const std::filesystem::path& log) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

private:
  posix_spawn_file_actions_t actions_{};
};

tl::unexpected<Error> cannotRun(const std::string& program) {
  return fail(Errc::Unsupported, "the external tour solver cannot be run; install LKH and give the path of its program, or use the built-in solver",
              program);
}

void killAndReap(pid_t child) {
  kill(child, SIGKILL);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
}

}  // namespace

Result<std::optional<int>> runProgram(const std::string& program, const std::vector<std::string>& arguments, const std::filesystem::path& log,
                                      std::optional<std::chrono::duration<double>> limit, const Job& job) {
  constexpr int kCannotExecute = 127;  // exit status of a spawned child whose program could not be started
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  const FileActions actions(log);
  pid_t child = 0;
  if (program.empty() || posix_spawnp(&child, program.c_str(), actions.get(), nullptr, argv.data(), environ) != 0) {
    return cannotRun(program);
  }
  const auto start = std::chrono::steady_clock::now();
  int status = 0;
  while (true) {
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child) {
      break;
    }
    if (ended < 0 && errno != EINTR) {
      return cannotRun(program);
    }
    const bool late = limit && std::chrono::steady_clock::now() - start > *limit;
    if (late || job.stopRequested()) {
      killAndReap(child);
      if (late) {
        return std::optional<int>();
      }
      return fail(Errc::Cancelled, "stopped while the external tour solver was running");
    }
    const timespec pause{0, 2'000'000};
    nanosleep(&pause, nullptr);
  }
  if (WIFEXITED(status) && WEXITSTATUS(status) == kCannotExecute) {
    return cannotRun(program);
  }
  return std::optional<int>(WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status));
}

}  // namespace vp::tour
