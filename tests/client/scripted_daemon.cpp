#include "client/scripted_daemon.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <utility>

namespace geminga::client {
namespace {

int listen_on_loopback(std::uint16_t& port) {
  const int listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  EXPECT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), size), 0);
  EXPECT_EQ(::listen(listener, 1), 0);
  EXPECT_EQ(::getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size), 0);
  port = ntohs(address.sin_port);
  return listener;
}

}  // namespace

std::string Conversation::hear() {
  while (true) {
    if (const auto end = heard_.find("\r\n"); end != std::string::npos) {
      std::string line = heard_.substr(0, end);
      heard_.erase(0, end + 2);
      return line;
    }
    std::array<char, 4096> buffer{};
    const auto count = ::recv(socket_, buffer.data(), buffer.size(), 0);
    if (count <= 0) return "";
    heard_.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

void Conversation::expect(std::string_view line) { EXPECT_EQ(hear(), line); }

void Conversation::say(std::string_view line) { send(std::string(line) + "\r\n"); }

void Conversation::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const auto count = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count <= 0) return;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
}

void Conversation::welcome() {
  EXPECT_TRUE(hear().starts_with("0 sys hello"));
  say("0 msg hello version=1 participant=1a2b3c4d peer=3 name=test ontology=0123456789abcdef participant_name=robot2");
}

void Conversation::wait_for_end() {
  while (!hear().empty()) {
  }
}

ScriptedDaemon::ScriptedDaemon(std::vector<Script> scripts) : listener_(listen_on_loopback(port_)) {
  thread_ = std::thread([listener = listener_, scripts = std::move(scripts)] {
    for (const Script& script : scripts) {
      const int socket = ::accept(listener, nullptr, nullptr);
      if (socket < 0) return;
      Conversation conversation(socket);
      script(conversation);
      ::close(socket);
    }
  });
}

ScriptedDaemon::~ScriptedDaemon() {
  ::shutdown(listener_, SHUT_RDWR);  // wakes an accept() that nobody came to
  thread_.join();
  ::close(listener_);
}

std::string field(const std::string& line, const std::string& key) {
  const auto begin = line.find(' ' + key + '=');
  if (begin == std::string::npos) return "";
  const auto value = begin + key.size() + 2;
  return line.substr(value, line.find(' ', value) - value);
}

std::uint16_t free_port() {
  std::uint16_t port = 0;
  ::close(listen_on_loopback(port));
  return port;
}

}  // namespace geminga::client
