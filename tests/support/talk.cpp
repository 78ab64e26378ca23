#include "support/talk.hpp"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "support/process.hpp"

namespace geminga::system {

Talk::Talk(const std::string& address, std::uint16_t port) {
  sockaddr_storage storage{};
  socklen_t length = 0;
  if (address.starts_with('/')) {
    sockaddr_un path{};
    path.sun_family = AF_UNIX;
    address.copy(path.sun_path, sizeof path.sun_path - 1);
    length = sizeof path;
    std::memcpy(&storage, &path, sizeof path);
  } else if (address.find(':') == std::string::npos) {
    sockaddr_in v4{};
    v4.sin_family = AF_INET;
    v4.sin_port = htons(port);
    ::inet_pton(AF_INET, address.c_str(), &v4.sin_addr);
    length = sizeof v4;
    std::memcpy(&storage, &v4, sizeof v4);
  } else {
    sockaddr_in6 v6{};
    v6.sin6_family = AF_INET6;
    v6.sin6_port = htons(port);
    ::inet_pton(AF_INET6, address.c_str(), &v6.sin6_addr);
    length = sizeof v6;
    std::memcpy(&storage, &v6, sizeof v6);
  }
  socket_ = ::socket(storage.ss_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&storage), length) != 0) {
    ::close(socket_);
    throw std::runtime_error("nobody listens on " + address + " port " + std::to_string(port));
  }
}

Talk::~Talk() {
  if (socket_ >= 0) ::close(socket_);
}

Talk::Talk(Talk&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)),
      bytes_(std::move(other.bytes_)),
      last_query_(other.last_query_),
      has_ended_(other.has_ended_) {}

void Talk::say(std::string_view line) { send(std::string(line) + "\r\n"); }

bool Talk::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t size = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (size < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(size));
  }
  return true;
}

void Talk::half_close() { ::shutdown(socket_, SHUT_WR); }

bool Talk::read_more() {
  pollfd wait{socket_, POLLIN, 0};
  const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(patience).count();
  if (has_ended_ || ::poll(&wait, 1, static_cast<int>(milliseconds)) <= 0) return false;
  std::array<char, 65536> chunk;
  const ssize_t size = ::recv(socket_, chunk.data(), chunk.size(), 0);
  has_ended_ = size <= 0;
  if (!has_ended_) bytes_.append(chunk.data(), static_cast<std::size_t>(size));
  return !has_ended_;
}

std::optional<std::string> Talk::line() {
  for (;;) {
    if (const auto end = bytes_.find("\r\n"); end != std::string::npos) {
      std::string line = bytes_.substr(0, end);
      bytes_.erase(0, end + 2);
      return line;
    }
    if (!read_more()) return std::nullopt;
  }
}

std::optional<std::string> Talk::line_with(const std::vector<std::string>& texts) {
  while (auto next = line()) {
    if (std::ranges::all_of(texts, [&](const std::string& text) { return next->find(text) != std::string::npos; })) {
      return next;
    }
  }
  return std::nullopt;
}

std::vector<std::string> Talk::lines_until_pong() {
  say("0 sys ping");
  std::vector<std::string> lines;
  while (auto next = line()) {
    if (*next == "0 msg pong") return lines;
    lines.push_back(*next);
  }
  lines.emplace_back("no pong came");
  return lines;
}

std::vector<std::string> Talk::query(const std::string& words) {
  const std::string id = std::to_string(++last_query_);
  say(id + " query " + words);
  std::vector<std::string> lines;
  while (auto next = line()) {
    if (next->starts_with(id + " msg end")) return lines;
    if (next->starts_with(id + ' ')) lines.push_back(*next);
    if (next->starts_with(id + ' ') && !next->starts_with(id + " msg ")) return lines;  // an error
  }
  lines.emplace_back("no answer came");
  return lines;
}

bool Talk::wait_until(const std::string& words, const std::function<bool(const std::vector<std::string>&)>& holds) {
  constexpr int moment = 5;  // milliseconds; without it the daemon would answer 429
  const auto until = std::chrono::steady_clock::now() + patience;
  while (!holds(query(words))) {
    if (has_ended_ || std::chrono::steady_clock::now() > until) return false;
    pollfd news{socket_, POLLIN, 0};  // what the daemon says on its own account ends the moment
    ::poll(&news, 1, moment);
  }
  return true;
}

bool Talk::is_closed_by_daemon() {
  while (read_more()) {
  }
  return has_ended_;
}

std::string field(std::string_view line, std::string_view key) {
  const std::string wanted = ' ' + std::string(key) + '=';
  const auto begin = line.find(wanted);
  if (begin == std::string_view::npos) return "";
  line.remove_prefix(begin + wanted.size());
  return std::string(line.substr(0, line.find(' ')));
}

}  // namespace geminga::system
