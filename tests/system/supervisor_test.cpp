// gemingad under a supervisor: a socket that plays systemd hears of its start, reloads, signs of life and end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <map>

#include "support/lab.hpp"
#include "system/folder.hpp"

namespace geminga::system {
namespace {

using testing::StartsWith;

/// Plays systemd: a socket that services tell of their state.
class Systemd {
 public:
  explicit Systemd(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0) << path;
  }
  ~Systemd() { ::close(socket_); }
  Systemd(const Systemd&) = delete;
  Systemd& operator=(const Systemd&) = delete;

  /// The next notice that is no sign of life; empty after the test's patience.
  [[nodiscard]] std::string next() const {
    while (true) {
      const std::string notice = receive();
      if (notice != "WATCHDOG=1\n") return notice;
    }
  }
  [[nodiscard]] std::string receive() const {
    pollfd input{socket_, POLLIN, 0};
    const auto wait = std::chrono::duration_cast<std::chrono::milliseconds>(patience);
    if (::poll(&input, 1, static_cast<int>(wait.count())) != 1) return "";
    std::array<char, 4096> room{};
    const auto size = ::recv(socket_, room.data(), room.size(), 0);
    return size <= 0 ? "" : std::string(room.data(), static_cast<std::size_t>(size));
  }

 private:
  int socket_;
};

/// A gemingad on the only host of a lab, started with these variables of a supervisor.
Process::Start supervised(const Lab& lab, const std::vector<std::string>& flags,
                          std::map<std::string, std::string> variables) {
  std::vector<std::string> words{program("gemingad"),
                                 "--interface",
                                 lab.interface_of(0),
                                 "--gcnp",
                                 "127.0.0.1:" + std::to_string(lab.gcnp_port(0)),
                                 "--port",
                                 std::to_string(lab.udp_port())};
  words.insert(words.end(), flags.begin(), flags.end());
  Process::Start start = lab.on(0, words);
  start.environment.merge(variables);
  return start;
}

const std::string reload_notice = "RELOADING=1\nMONOTONIC_USEC=";

/// CLOCK_MONOTONIC, by which systemd judges a reload.
std::int64_t monotonic_microseconds() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return std::int64_t{time.tv_sec} * 1'000'000 + time.tv_nsec / 1000;
}

/// The same with a socket as its only one that was given.
Process::Start activated(const Lab& lab, const std::vector<std::string>& flags, int socket) {
  Process::Start start = supervised(lab, flags, {{"LISTEN_FDS", "1"}});
  start.before = [socket, enter = start.before] {
    if (enter) enter();
    ::dup2(socket, 3);
    ::setenv("LISTEN_PID", std::to_string(::getpid()).c_str(), 1);
  };
  return start;
}

TEST(Supervised, SaysReadyReloadingReadyAndStopping) {
  const Lab lab(1);
  const Folder folder;
  Systemd systemd(folder.path("notify"));
  const std::string config = folder.write("gemingad.toml", "log-level = \"info\"\n");
  Process daemon(supervised(lab, {"--config", config}, {{"NOTIFY_SOCKET", folder.path("notify")}}));
  EXPECT_THAT(systemd.next(), StartsWith("READY=1\nSTATUS=ready: gcnp "));
  const std::int64_t before = monotonic_microseconds();
  daemon.signal(SIGHUP);
  const std::string reloading = systemd.next();
  ASSERT_THAT(reloading, StartsWith(reload_notice));
  const std::int64_t told = std::stoll(reloading.substr(reload_notice.size()));
  EXPECT_GE(told, before) << "the notice belongs to this reload and to no earlier one";
  EXPECT_LE(told, monotonic_microseconds());
  EXPECT_THAT(systemd.next(), StartsWith("READY=1\n"));
  std::ofstream(config) << "no such key = 1\n";
  daemon.signal(SIGHUP);
  EXPECT_THAT(systemd.next(), StartsWith("RELOADING=1\n"));
  EXPECT_THAT(systemd.next(), StartsWith("READY=1\n")) << "the configuration in force is kept, and served";
  daemon.signal(SIGTERM);
  EXPECT_THAT(systemd.next(), StartsWith("STOPPING=1\n"));
  EXPECT_EQ(daemon.wait(), 0);
}

TEST(Supervised, IsReadyAgainWhenAReloadedOntologyIsInForce) {
  const Lab lab(1);
  const Folder folder;
  Systemd systemd(folder.path("notify"));
  const std::string ontology = folder.write("team.ttl", "<http://a/#A> a <http://www.w3.org/2002/07/owl#Class> .\n");
  Process daemon(supervised(lab, {"--ontology", ontology}, {{"NOTIFY_SOCKET", folder.path("notify")}}));
  const std::string first = systemd.next();
  EXPECT_THAT(first, StartsWith("READY=1\n"));
  std::ofstream(ontology, std::ios::app) << "<http://a/#B> a <http://www.w3.org/2002/07/owl#Class> .\n";
  daemon.signal(SIGHUP);
  EXPECT_THAT(systemd.next(), StartsWith("RELOADING=1\n"));
  const std::string second = systemd.next();
  EXPECT_THAT(second, StartsWith("READY=1\n"));
  EXPECT_NE(first, second) << "the status names the digest of the ontology";
}

TEST(Supervised, GivesSignsOfLifeFromInsideItsCage) {
  const Lab lab(1);
  const Folder folder;
  Systemd systemd(folder.path("notify"));
  Process daemon(supervised(lab, {}, {{"NOTIFY_SOCKET", folder.path("notify")}, {"WATCHDOG_USEC", "20000"}}));
  EXPECT_THAT(systemd.next(), StartsWith("READY=1\n"));
  for (int sign = 0; sign < 3; ++sign) EXPECT_EQ(systemd.receive(), "WATCHDOG=1\n");
}

TEST(Supervised, ServesOnASocketThatItIsGivenAndLeavesIt) {
  const Lab lab(1);
  const Folder folder;
  const std::string path = folder.path("given");
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ASSERT_EQ(::listen(socket, 8), 0);
  // A client that comes before the daemon is served as soon as it is there.
  Talk early(path, 0);
  early.say("0 sys ping");
  Process daemon(activated(lab, {"--gcnp-socket", path}, socket));
  EXPECT_TRUE(early.line_with({"0 msg pong"})) << daemon.said();
  EXPECT_TRUE(daemon.wait_for("listening on a socket of the supervisor: " + path)) << daemon.said();
  daemon.signal(SIGTERM);
  EXPECT_EQ(daemon.wait(), 0);
  EXPECT_EQ(::access(path.c_str(), F_OK), 0) << "the supervisor listens on";
  ::close(socket);
}

TEST(Supervised, DoesNotStartWithASocketThatItCannotServe) {
  const Lab lab(1);
  const int socket = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  Process daemon(activated(lab, {}, socket));
  EXPECT_EQ(daemon.wait(), 2);
  EXPECT_THAT(daemon.said(), testing::HasSubstr("gemingad: socket 3 of the supervisor "));
  ::close(socket);
}

}  // namespace
}  // namespace geminga::system
