// A supervisor, and a journal, that a test plays.
#ifndef GEMINGA_TESTS_DAEMON_SUPERVISING_HPP
#define GEMINGA_TESTS_DAEMON_SUPERVISING_HPP

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "daemon/supervisor/supervisor.hpp"

namespace geminga::daemon {

/// A socket of datagrams at a path, as systemd and its journal have.
class Listener {
 public:
  Listener() {
    char folder[] = "/tmp/geminga-supervisor-XXXXXX";
    folder_ = ::mkdtemp(folder);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path().copy(address.sun_path, sizeof address.sun_path - 1);
    socket_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ~Listener() {
    ::close(socket_);
    std::filesystem::remove_all(folder_);
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  [[nodiscard]] std::string path() const { return folder_ + "/socket"; }
  /// The next datagram; empty where none is there.
  [[nodiscard]] std::string next() const {
    std::array<char, 4096> room{};
    const auto size = ::recv(socket_, room.data(), room.size(), MSG_DONTWAIT);
    return size <= 0 ? "" : std::string(room.data(), static_cast<std::size_t>(size));
  }

 private:
  std::string folder_;
  int socket_ = -1;
};

/// A supervisor of the process in which these variables are set.
inline Supervisor supervised_by(const std::vector<std::string>& variables) {
  std::vector<const char*> environment;
  for (const std::string& variable : variables) environment.push_back(variable.c_str());
  environment.push_back(nullptr);
  return Supervisor(environment.data());
}

}  // namespace geminga::daemon

#endif
