#include "tools/web/reader.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstring>
#include <utility>

#include "support/process.hpp"

namespace geminga::web {
namespace {

std::size_t length_of(const Reply& reply) {
  const auto found = reply.fields.find("content-length");
  std::size_t length = 0;
  if (found != reply.fields.end())
    std::from_chars(found->second.data(), found->second.data() + found->second.size(), length);
  return length;
}

Reply head_of(std::string_view head) {
  Reply reply;
  std::from_chars(head.data() + std::min<std::size_t>(9, head.size()), head.data() + head.size(), reply.status);
  while (true) {
    const auto end = head.find("\r\n");
    if (end == std::string_view::npos) return reply;
    head.remove_prefix(end + 2);
    const auto colon = head.find(": ");
    if (colon == std::string_view::npos) return reply;
    std::string name(head.substr(0, colon));
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    reply.fields[name] = head.substr(colon + 2, head.find("\r\n") - colon - 2);
  }
}

}  // namespace

Reader::Reader(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0) << port;
}

Reader::Reader(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_un to{};
  to.sun_family = AF_UNIX;
  std::memcpy(to.sun_path, path.data(), std::min(path.size(), sizeof to.sun_path - 1));
  EXPECT_EQ(::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0) << path;
}

Reader::~Reader() {
  if (socket_ >= 0) ::close(socket_);
}

Reader::Reader(Reader&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), octets_(std::move(other.octets_)) {}

bool Reader::send(std::string_view octets) {
  while (!octets.empty()) {
    const auto count = ::send(socket_, octets.data(), octets.size(), MSG_NOSIGNAL);
    if (count <= 0) return false;
    octets.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void Reader::half_close() { ::shutdown(socket_, SHUT_WR); }

bool Reader::read_more() {
  pollfd ready{.fd = socket_, .events = POLLIN, .revents = 0};
  const int patience = static_cast<int>(std::chrono::milliseconds(system::patience).count());
  if (::poll(&ready, 1, patience) != 1) {
    ADD_FAILURE() << "nothing came";
    return false;
  }
  std::array<char, 65'536> chunk{};
  const auto count = ::recv(socket_, chunk.data(), chunk.size(), 0);
  if (count <= 0) return false;
  octets_.append(chunk.data(), static_cast<std::size_t>(count));
  return true;
}

std::optional<Reply> Reader::reply(bool has_body) {
  std::size_t end = 0;
  while ((end = octets_.find("\r\n\r\n")) == std::string::npos) {
    if (!read_more()) return std::nullopt;
  }
  Reply reply = head_of(std::string_view(octets_).substr(0, end + 2));
  octets_.erase(0, end + 4);
  const std::size_t length = has_body ? length_of(reply) : 0;
  while (octets_.size() < length) {
    if (!read_more()) return std::nullopt;
  }
  reply.body = octets_.substr(0, length);
  octets_.erase(0, length);
  return reply;
}

bool Reader::wait_for(std::string_view text) {
  std::size_t at = 0;
  while ((at = octets_.find(text)) == std::string::npos) {
    if (!read_more()) return false;
  }
  octets_.erase(0, at + text.size());
  return true;
}

bool Reader::is_closed() {
  const std::size_t failures = static_cast<std::size_t>(testing::Test::HasFailure());
  while (read_more()) octets_.clear();
  return static_cast<std::size_t>(testing::Test::HasFailure()) == failures;
}

bool Reader::is_quiet() const {
  char octet = 0;
  return octets_.empty() && ::recv(socket_, &octet, 1, MSG_PEEK | MSG_DONTWAIT) < 0;
}

std::string get_request(std::string_view target, std::string_view fields) {
  return "GET " + std::string(target) + " HTTP/1.1\r\nHost: localhost\r\n" + std::string(fields) + "\r\n";
}

Reply get(std::uint16_t port, std::string_view target, std::string_view fields) {
  Reader reader(port);
  EXPECT_TRUE(reader.send(get_request(target, fields)));
  return reader.reply().value_or(Reply{});
}

}  // namespace geminga::web
