// A daemon of a few lines that says what a test tells it to, on a free port of this host.
#ifndef GEMINGA_TESTS_CLIENT_SCRIPTED_DAEMON_HPP
#define GEMINGA_TESTS_CLIENT_SCRIPTED_DAEMON_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace geminga::client {

/// One accepted connection, used on the daemon's thread.
class Conversation {
 public:
  explicit Conversation(int socket) : socket_(socket) {}

  /// The next line without its end; empty at the end of the stream.
  std::string hear();
  /// Fails the test unless the next line is this one.
  void expect(std::string_view line);
  /// Sends a line and CR LF.
  void say(std::string_view line);
  /// Sends bytes as they are.
  void send(std::string_view bytes);
  /// Answers the hello with participant 1a2b3c4d, peer 3.
  void welcome();
  /// Waits until the client has closed.
  void wait_for_end();

 private:
  int socket_;
  std::string heard_;
};

/// Accepts one connection for each script, one after the other, and runs it there in a thread, which the destructor
/// joins. A script that returns closes its connection.
class ScriptedDaemon {
 public:
  using Script = std::function<void(Conversation&)>;

  explicit ScriptedDaemon(Script script) : ScriptedDaemon(std::vector{std::move(script)}) {}
  explicit ScriptedDaemon(std::vector<Script> scripts);
  ~ScriptedDaemon();
  ScriptedDaemon(const ScriptedDaemon&) = delete;
  ScriptedDaemon& operator=(const ScriptedDaemon&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  /// `127.0.0.1:PORT`
  [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(port_); }

 private:
  std::uint16_t port_ = 0;
  int listener_ = -1;  ///< behind port_, which its making fills
  std::thread thread_;
};

/// The value of `key=` in a line; empty if there is none.
[[nodiscard]] std::string field(const std::string& line, const std::string& key);

/// A port of this host on which nobody listens.
[[nodiscard]] std::uint16_t free_port();

}  // namespace geminga::client

#endif
