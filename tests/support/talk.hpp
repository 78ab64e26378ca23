// A raw GCNP client that reads line by line, like a TCP client with a patient reader.
#ifndef GEMINGA_TESTS_SUPPORT_TALK_HPP
#define GEMINGA_TESTS_SUPPORT_TALK_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace geminga::system {

/// One connection to a daemon. Lines are read in their order; each is given out once.
class Talk {
 public:
  /// Connects to a loopback address, or to a Unix socket by its path. Throws std::runtime_error if nobody listens.
  Talk(const std::string& address, std::uint16_t port);
  ~Talk();
  Talk(Talk&& other) noexcept;
  Talk& operator=(Talk&&) = delete;

  /// Sends a line, CR LF added.
  void say(std::string_view line);
  /// Sends these bytes. False: the daemon has closed.
  bool send(std::string_view bytes);
  /// Shuts our side down, as `nc -N` does.
  void half_close();
  /// The next line without its end; nothing: the daemon closed, or patience ended.
  [[nodiscard]] std::optional<std::string> line();
  /// Skips to the next line that contains all these texts.
  [[nodiscard]] std::optional<std::string> line_with(const std::vector<std::string>& texts);
  /// Sends `sys ping` and returns every line before its answer: everything that the daemon had to say until now.
  [[nodiscard]] std::vector<std::string> lines_until_pong();
  /// Asks `ID query WORDS` and returns the lines of the answer without the end.
  [[nodiscard]] std::vector<std::string> query(const std::string& words);
  /// Asks until the lines of the answer satisfy `holds`, for facts that no event tells. Asks again at the daemon's next
  /// line, or after a moment without one. False: the daemon closed, or patience ended first.
  [[nodiscard]] bool wait_until(const std::string& words,
                                const std::function<bool(const std::vector<std::string>&)>& holds);
  /// Whether the daemon closes the connection, whatever it says before.
  [[nodiscard]] bool is_closed_by_daemon();

 private:
  bool read_more();

  int socket_ = -1;
  std::string bytes_;
  std::uint32_t last_query_ = 900'000;
  bool has_ended_ = false;
};

/// The value of `key=` in a GCNP line without quotes, or an empty text.
[[nodiscard]] std::string field(std::string_view line, std::string_view key);

}  // namespace geminga::system

#endif
