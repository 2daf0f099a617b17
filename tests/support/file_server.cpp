#include "tests/support/file_server.h"

#include <algorithm>
#include <arpa/inet.h>
#include <cstring>
#include <netinet/in.h>
#include <poll.h>
#include <stdexcept>
#include <sys/socket.h>
#include <unistd.h>

namespace vp::test {
namespace {

std::string headerIn(const std::string& head, const std::string& name) {
  std::size_t at = head.find("\r\n" + name + ": ");
  if (at == std::string::npos) {
    return {};
  }
  at += name.size() + 4;
  return head.substr(at, head.find("\r\n", at) - at);
}

}  // namespace

FileServer::FileServer() {
  listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof place;
  if (::bind(listener_, reinterpret_cast<sockaddr*>(&place), length) != 0 || ::listen(listener_, 64) != 0 ||
      ::getsockname(listener_, reinterpret_cast<sockaddr*>(&place), &length) != 0) {
    throw std::runtime_error("no port could be opened on 127.0.0.1");
  }
  port_ = ntohs(place.sin_port);
  door_ = std::thread([this] { accept(); });
}

FileServer::~FileServer() {
  stop();
}

std::string FileServer::address() const {
  return "http://127.0.0.1:" + std::to_string(port_);
}

void FileServer::put(const std::string& path, std::string bytes) {
  const std::lock_guard lock(mutex_);
  files_[path] = std::move(bytes);
}

void FileServer::remove(const std::string& path) {
  const std::lock_guard lock(mutex_);
  files_.erase(path);
}

void FileServer::behave(const std::function<void(Manners&)>& change) {
  const std::lock_guard lock(mutex_);
  change(manners_);
}

std::vector<FileServer::Request> FileServer::requests() const {
  const std::lock_guard lock(mutex_);
  return requests_;
}

void FileServer::waitUntilHolding() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return isHolding_ || isEnding_; });
}

void FileServer::release() {
  const std::lock_guard lock(mutex_);
  manners_.holdAfter.reset();
  isHolding_ = false;
  changed_.notify_all();
}

void FileServer::stop() {
  {
    const std::lock_guard lock(mutex_);
    if (isEnding_) {
      return;
    }
    isEnding_ = true;
    changed_.notify_all();
  }
  door_.join();
  ::close(listener_);
  for (std::thread& thread : threads_) {
    thread.join();
  }
}

void FileServer::accept() {
  for (;;) {
    pollfd door{listener_, POLLIN, 0};
    const int ready = ::poll(&door, 1, 20);
    const std::lock_guard lock(mutex_);
    if (isEnding_) {
      return;
    }
    if (ready > 0) {
      const int connection = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      if (connection >= 0) {
        threads_.emplace_back([this, connection] { serve(connection); });
      }
    }
  }
}

void FileServer::serve(int connection) {
  std::string head;
  char block[4096];
  while (head.find("\r\n\r\n") == std::string::npos) {
    const ssize_t got = ::recv(connection, block, sizeof block, 0);
    if (got <= 0) {
      ::close(connection);
      return;
    }
    head.append(block, static_cast<std::size_t>(got));
  }
  const std::size_t first = head.find(' ') + 1;
  Request request{head.substr(first, head.find(' ', first) - first), headerIn(head, "Range"), head};
  {
    const std::lock_guard lock(mutex_);
    requests_.push_back(request);
  }
  answer(connection, request);
  ::shutdown(connection, SHUT_RDWR);
  ::close(connection);
}

bool FileServer::send(int connection, const std::string& bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t sent = ::send(connection, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (sent <= 0) {
      return false;
    }
    done += static_cast<std::size_t>(sent);
    sent_ += static_cast<std::uint64_t>(sent);
  }
  return true;
}

void FileServer::answer(int connection, const Request& request) {
  Manners manners;
  std::string file;
  bool exists = false;
  {
    const std::lock_guard lock(mutex_);
    manners = manners_;
    std::string path = request.path;
    if (path.starts_with("http://")) {  // as a proxy is asked
      path = path.substr(path.find('/', 7));
    }
    const auto found = files_.find(path);
    exists = found != files_.end();
    file = exists ? found->second : "";
  }
  if (manners.status || !exists) {
    const std::string words = "<html>no</html>";
    send(connection, "HTTP/1.1 " + std::to_string(manners.status.value_or(404)) + " No\r\nContent-Length: " + std::to_string(words.size()) +
                         "\r\nConnection: close\r\n\r\n" + words);
    return;
  }
  std::size_t from = 0;
  std::size_t to = file.size();
  const bool isPart = manners.ranges && request.range.starts_with("bytes=");
  if (isPart) {
    from = std::stoull(request.range.substr(6));
    to = std::min(file.size(), static_cast<std::size_t>(std::stoull(request.range.substr(request.range.find('-') + 1))) + 1);
  }
  if (manners.wrongPart) {
    to -= std::min(from, to);
    from = 0;
  }
  if (isPart && from >= file.size()) {
    send(connection, "HTTP/1.1 416 Range Not Satisfiable\r\nContent-Length: 0\r\nConnection: close\r\n\r\n");
    return;
  }
  std::string head = isPart ? "HTTP/1.1 206 Partial Content\r\nContent-Range: bytes " + std::to_string(from) + "-" + std::to_string(to - 1) + "/" +
                                  std::to_string(file.size()) + "\r\n"
                            : "HTTP/1.1 200 OK\r\n";
  if (manners.etags) {
    head += "ETag: \"" + (manners.etagOf ? manners.etagOf(request.path) : std::to_string(std::hash<std::string>{}(file))) + "\"\r\n";
  }
  std::string body = file.substr(from, to - from);
  if (!send(connection, head + "Content-Length: " + std::to_string(body.size()) + "\r\nConnection: close\r\n\r\n")) {
    return;
  }
  if (manners.cutAfter && *manners.cutAfter < body.size()) {
    send(connection, body.substr(0, *manners.cutAfter));
    return;
  }
  if (manners.holdAfter && *manners.holdAfter < body.size()) {
    if (!send(connection, body.substr(0, *manners.holdAfter))) {
      return;
    }
    body.erase(0, *manners.holdAfter);
    std::unique_lock lock(mutex_);
    isHolding_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return !isHolding_ || isEnding_; });
    if (isEnding_) {
      return;
    }
  }
  send(connection, body);
}

}  // namespace vp::test
