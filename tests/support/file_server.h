#pragma once
// A small HTTP server on 127.0.0.1 that misbehaves on request.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace vp::test {

/** Serves files from memory, each connection on a thread of its own. What it shall do wrong may be changed while it runs. */
class FileServer {
public:
  struct Manners {
    bool ranges = true;                      ///< else whole files, whatever is asked for
    bool etags = true;                       ///< else no version is told
    bool wrongPart = false;                  ///< always the first bytes, whatever part is asked for
    std::optional<std::uint64_t> cutAfter;   ///< bytes of every body, then the connection closes
    std::optional<std::uint64_t> holdAfter;  ///< bytes of a body longer than that, then nothing until release() or the end
    std::optional<int> status;               ///< this instead of an answer
    std::function<std::string(const std::string& path)> etagOf;
  };
  struct Request {
    std::string path;
    std::string range;  ///< of the header, "bytes=0-99"
    std::string head;   ///< all of it
  };

  FileServer();
  ~FileServer();
  FileServer(const FileServer&) = delete;
  FileServer& operator=(const FileServer&) = delete;

  /** "http://127.0.0.1:40123" */
  [[nodiscard]] std::string address() const;
  void put(const std::string& path, std::string bytes);
  void remove(const std::string& path);
  void behave(const std::function<void(Manners&)>& change);
  [[nodiscard]] std::vector<Request> requests() const;
  [[nodiscard]] std::uint64_t bytesSent() const { return sent_; }
  /** Waits until an answer is held back. */
  void waitUntilHolding();
  void release();
  /** Closes the door: nobody answers any more. */
  void stop();

private:
  void accept();
  void serve(int connection);
  void answer(int connection, const Request& request);
  bool send(int connection, const std::string& bytes);

  int listener_ = -1;
  int port_ = 0;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, std::string> files_;
  Manners manners_;
  std::vector<Request> requests_;
  std::vector<std::thread> threads_;
  std::thread door_;
  std::atomic<std::uint64_t> sent_{0};
  bool isHolding_ = false;
  bool isEnding_ = false;
};

}  // namespace vp::test
