// A reader of HTTP that sends what a test tells it to, well-formed or not.
#ifndef GEMINGA_TESTS_TOOLS_WEB_READER_HPP
#define GEMINGA_TESTS_TOOLS_WEB_READER_HPP

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::web {

/// One response. Names of fields are in lower case.
struct Reply {
  int status = 0;
  std::map<std::string, std::string> fields;
  std::string body;
};

/// One connection on this host. Every wait ends with the test's patience.
class Reader {
 public:
  explicit Reader(std::uint16_t port);
  /// At the path of a Unix socket.
  explicit Reader(const std::string& path);
  ~Reader();
  Reader(Reader&& other) noexcept;
  Reader& operator=(Reader&&) = delete;

  /// Sends these octets. False: the other side has closed.
  bool send(std::string_view octets);
  void half_close();
  /// The next response, its body by Content-Length; nothing where the connection ended before. Without a body for HEAD.
  [[nodiscard]] std::optional<Reply> reply(bool has_body = true);
  /// Waits until what has come and is not taken contains this, and takes it with all before it.
  [[nodiscard]] bool wait_for(std::string_view text);
  /// Whether the other side closes, whatever it says before.
  [[nodiscard]] bool is_closed();
  /// Whether the connection stands and nothing waits to be read.
  [[nodiscard]] bool is_quiet() const;

 private:
  bool read_more();

  int socket_ = -1;
  std::string octets_;
};

/// A request for GET with a Host, and these fields, each with its line end.
[[nodiscard]] std::string get_request(std::string_view target, std::string_view fields = "");

/// The response to one request on a connection of its own.
[[nodiscard]] Reply get(std::uint16_t port, std::string_view target, std::string_view fields = "");

}  // namespace geminga::web

#endif
