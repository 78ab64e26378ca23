// A server that says to each who connects what a test wants, and nothing that the protocol wants.
#ifndef GEMINGA_TESTS_TOOLS_BRIDGE_LYING_SERVER_HPP
#define GEMINGA_TESTS_TOOLS_BRIDGE_LYING_SERVER_HPP

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "client/channels/socket.hpp"

namespace geminga::system {

/// Listens on 127.0.0.1 until its end. It says `greeting` to each, and `answer` each time that `question` has come.
/// Where there is a `flood`, it says that again and again behind the first answer, as fast as the guest reads.
class LyingServer {
 public:
  LyingServer(std::string greeting, std::string question, std::string answer, std::string flood = "")
      : greeting_(std::move(greeting)),
        question_(std::move(question)),
        answer_(std::move(answer)),
        flood_(std::move(flood)),
        door_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(place);
    auto* const address = reinterpret_cast<sockaddr*>(&place);
    if (::bind(door_.get(), address, size) == 0 && ::listen(door_.get(), 4) == 0 &&
        ::getsockname(door_.get(), address, &size) == 0) {
      port_ = ntohs(place.sin_port);
    }
    thread_ = std::jthread([this](const std::stop_token& stop) { serve(stop); });
  }

  /// "127.0.0.1:PORT".
  [[nodiscard]] std::string where() const { return "127.0.0.1:" + std::to_string(port_); }

 private:
  /// Whether there is something to read within a tenth of a second.
  static bool is_ready(int descriptor) {
    pollfd ready{descriptor, POLLIN, 0};
    return ::poll(&ready, 1, 100) > 0;
  }

  void serve(const std::stop_token& stop) const {
    while (!stop.stop_requested()) {
      if (!is_ready(door_.get())) continue;
      const client::Socket guest(::accept4(door_.get(), nullptr, nullptr, SOCK_CLOEXEC));
      if (guest.is_open()) talk(guest.get(), stop);
    }
  }

  void talk(int guest, const std::stop_token& stop) const {
    say(guest, greeting_);
    std::string heard;
    std::array<char, 4096> room{};
    while (!stop.stop_requested() && !question_.empty()) {
      if (!is_ready(guest)) continue;
      const ssize_t size = ::recv(guest, room.data(), room.size(), 0);
      if (size <= 0) return;
      heard.append(room.data(), static_cast<std::size_t>(size));
      if (const auto found = heard.find(question_); found != std::string::npos) {
        heard.erase(0, found + question_.size());
        say(guest, answer_);
        while (!flood_.empty() && !stop.stop_requested() && say(guest, flood_)) {
        }
      }
    }
  }

  /// False where the guest has left.
  static bool say(int guest, std::string_view octets) {
    while (!octets.empty()) {
      const ssize_t sent = ::send(guest, octets.data(), octets.size(), MSG_NOSIGNAL);
      if (sent <= 0) return false;
      octets.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
  }

  std::string greeting_, question_, answer_, flood_;
  client::Socket door_;
  std::uint16_t port_ = 0;
  std::jthread thread_;
};

}  // namespace geminga::system

#endif
