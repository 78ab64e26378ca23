// One connection: requests in, responses out, one after the other.
#ifndef GEMINGA_WEB_SERVER_CONNECTION_HPP
#define GEMINGA_WEB_SERVER_CONNECTION_HPP

#include <boost/asio/awaitable.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/basic_stream.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "web/server/limits.hpp"
#include "web/site/site.hpp"

namespace geminga::web {

/// Ends by itself: where the reader ends it, where a time or a limit is reached, or after what is no HTTP. Neither
/// copies nor moves.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  using Socket = boost::asio::generic::stream_protocol::socket;
  using Clock = std::chrono::steady_clock;

  /// Functions of its owner.
  struct Owner {
    std::function<bool()> takes_stream;  ///< whether there is room for one more stream, which begins then
    std::function<void()> stream_ended;  ///< of one that was taken
    std::function<void()> ended;         ///< nothing is called after this
  };

  /// Borrows site and limits.
  Connection(Socket socket, Site& site, const Limits& limits, Owner owner);

  void start();
  /// Whether it waits for a request, and since when.
  [[nodiscard]] bool is_waiting() const { return is_waiting_; }
  [[nodiscard]] Clock::time_point since() const { return since_; }
  /// Ends it at once.
  void close();

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::empty_body>;
  template <typename Value>
  using Awaitable = boost::asio::awaitable<Value>;

  Awaitable<void> serve();
  /// Reads a request and answers it. Whether another one may follow.
  Awaitable<bool> serve_one(bool is_last);
  /// Reads a head, and judges it by its limits.
  Awaitable<boost::system::error_code> read(Parser& parser);
  Awaitable<boost::system::error_code> read_head(Parser& parser);
  /// Whether it was written.
  Awaitable<bool> write(const Response& response, unsigned version, bool is_kept, bool has_body);
  /// Answers what could not be read, and ends.
  Awaitable<void> refuse(const Response& response);
  /// Tells events until the reader goes.
  Awaitable<void> tell(const Response& response, unsigned version, bool has_body);
  Awaitable<bool> write_text(const std::string& text);
  Awaitable<void> linger();
  [[nodiscard]] bool has_gone();

  boost::beast::basic_stream<boost::asio::generic::stream_protocol> stream_;
  boost::beast::flat_buffer buffer_;  ///< octets that have come and are not taken: at most those of a head
  boost::asio::steady_timer pause_;
  Site& site_;
  const Limits& limits_;
  Owner owner_;
  bool is_waiting_ = true;
  Clock::time_point since_ = Clock::now();
};

}  // namespace geminga::web

#endif
