#include "web/server/connection.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/associated_executor.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <exception>
#include <utility>

#include "answers/differences.hpp"
#include "web/site/event_stream.hpp"

namespace geminga::web {
namespace {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using boost::system::error_code;

constexpr unsigned http_1_0 = 10;
constexpr unsigned http_1_1 = 11;
/// Octets that are read at once.
constexpr std::size_t read_octets = 4096;

std::string text_of(beast::string_view text) { return {text.data(), text.size()}; }

Request request_of(const http::request<http::empty_body>& head) {
  Request request{.method = text_of(head.method_string()), .target = text_of(head.target())};
  for (const auto& field : head) {
    const std::string value = text_of(field.value());
    if (field.name() == http::field::host) request.hosts.push_back(value);
    if (field.name() == http::field::authorization) request.authorizations.push_back(value);
    if (field.name() == http::field::accept) request.accept += (request.accept.empty() ? "" : ",") + value;
  }
  return request;
}

http::response<http::string_body> head_of(const Response& response, unsigned version) {
  http::response<http::string_body> head;
  head.version(version);
  head.result(response.status);
  for (const auto& [name, value] : common_fields()) head.set(name, value);
  for (const auto& [name, value] : response.fields) head.set(name, value);
  head.set(http::field::content_type, response.type);
  return head;
}

/// The response to a request that could not be read; a status of 0: none, the reader is gone.
Response refusal_of(const error_code& error) {
  if (error == http::error::header_limit) return failure(431, "the head of the request is too long");
  if (error == http::error::body_limit) return failure(413, "a request has no body here");
  if (error == http::error::bad_version) return failure(505, "speak HTTP/1.1");
  if (error == beast::error::timeout) return failure(408, "the request did not come in time");
  if (error.category() == make_error_code(http::error::bad_method).category() && error != http::error::end_of_stream &&
      error != http::error::partial_message) {
    return failure(400, "the request cannot be read: " + error.message());
  }
  return {.status = 0, .type = "", .body = ""};
}

// GCC 12 destroys some temporaries of an expression with co_await twice (GCC bug 99576 and its kin), so that functions
// and responses have names here before they are awaited.

/// Completes with what `begin` gives to the function that it is handed.
template <typename Value, typename Begin>
net::awaitable<Value> result_of(Begin begin) {
  return net::async_initiate<const net::use_awaitable_t<>, void(Value)>(
      [](auto handler, Begin given) {
        // Shared, since std::function copies; it is called once, and from the loop, so that nothing grows on the stack.
        const auto shared = std::make_shared<decltype(handler)>(std::move(handler));
        given([shared](Value value) {
          net::post(net::get_associated_executor(*shared),
                    [shared, value = std::move(value)]() mutable { std::move (*shared)(std::move(value)); });
        });
      },
      net::use_awaitable, std::move(begin));
}

}  // namespace

Connection::Connection(Socket socket, Site& site, const Limits& limits, Owner owner)
    : stream_(std::move(socket)),
      pause_(stream_.get_executor()),
      site_(site),
      limits_(limits),
      owner_(std::move(owner)) {}

void Connection::start() {
  net::co_spawn(
      stream_.get_executor(), [self = shared_from_this()] { return self->serve(); },
      [self = shared_from_this()](const std::exception_ptr&) {
        // Nothing but the lack of memory throws, and costs this connection alone.
        self->close();
        self->owner_.ended();
      });
}

void Connection::close() {
  error_code ignored;
  stream_.socket().close(ignored);
  pause_.cancel();
}

Connection::Awaitable<void> Connection::serve() {
  for (std::size_t count = 1; count <= limits_.requests; ++count) {
    is_waiting_ = true;
    since_ = Clock::now();
    const bool is_open = co_await serve_one(count == limits_.requests);
    if (!is_open) break;
  }
  error_code ignored;
  stream_.socket().shutdown(net::socket_base::shutdown_send, ignored);
}

/// Beast's own limit of a head is not kept where lines come in time to be taken one by one.
Connection::Awaitable<error_code> Connection::read_head(Parser& parser) {
  std::size_t taken = 0;
  while (true) {
    error_code error;
    if (buffer_.size() > 0) {
      const std::size_t count = parser.put(buffer_.data(), error);
      buffer_.consume(count);
      taken += count;
      if (error && error != http::error::need_more) co_return error;
      if (parser.is_header_done()) co_return error_code();
    }
    const std::size_t room = limits_.head_octets - std::min(limits_.head_octets, taken + buffer_.size());
    if (room == 0) co_return http::error::header_limit;
    const auto space = buffer_.prepare(std::min(room, read_octets));
    const std::size_t count = co_await stream_.async_read_some(space, net::redirect_error(net::use_awaitable, error));
    if (error) co_return error;
    buffer_.commit(count);
  }
}

Connection::Awaitable<error_code> Connection::read(Parser& parser) {
  parser.body_limit(0);
  stream_.expires_after(limits_.request_patience);
  error_code error = co_await read_head(parser);
  is_waiting_ = false;
  if (!error && !parser.is_done()) error = http::error::body_limit;
  if (!error && parser.get().version() != http_1_0 && parser.get().version() != http_1_1) {
    error = http::error::bad_version;
  }
  co_return error;
}

Connection::Awaitable<bool> Connection::serve_one(bool is_last) {
  Parser parser;
  const error_code error = co_await read(parser);
  if (error) {
    const Response refusal = refusal_of(error);
    const bool is_silent = error == beast::error::timeout && !parser.got_some() && buffer_.size() == 0;
    if (refusal.status != 0 && !is_silent) co_await refuse(refusal);
    co_return false;
  }
  const http::request<http::empty_body>& head = parser.get();
  const bool has_body = head.method() != http::verb::head;
  const bool is_kept = head.keep_alive() && !is_last;
  const auto ask = [this, request = request_of(head)](const Site::Then& then) { site_.answer(request, then); };
  const Response response = co_await result_of<Response>(ask);
  if (!response.stream) {
    const bool is_written = co_await write(response, head.version(), is_kept, has_body);
    co_return is_written&& is_kept;
  }
  if (owner_.takes_stream()) {
    co_await tell(response, head.version(), has_body);
    owner_.stream_ended();
  } else {
    site_.count(503);
    const Response refusal = failure(503, "there are as many streams as may be: try again later");
    co_await write(refusal, head.version(), false, has_body);
  }
  co_return false;
}

Connection::Awaitable<bool> Connection::write(const Response& response, unsigned version, bool is_kept, bool has_body) {
  auto message = head_of(response, version);
  message.keep_alive(is_kept);
  message.content_length(response.body.size());
  if (has_body) message.body() = response.body;
  error_code error;
  stream_.expires_after(limits_.response_patience);
  http::response_serializer<http::string_body> serializer(message);
  co_await http::async_write(stream_, serializer, net::redirect_error(net::use_awaitable, error));
  co_return !error;
}

Connection::Awaitable<void> Connection::refuse(const Response& response) {
  site_.count(response.status);
  const bool is_written = co_await write(response, http_1_1, false, true);
  if (is_written) co_await linger();
}

Connection::Awaitable<void> Connection::linger() {
  error_code error;
  stream_.socket().shutdown(net::socket_base::shutdown_send, error);
  stream_.expires_after(limits_.linger);
  std::array<char, 4096> thrown_away{};
  std::size_t octets = 0;
  while (!error && octets < limits_.linger_octets) {
    const std::size_t count =
        co_await stream_.async_read_some(net::buffer(thrown_away), net::redirect_error(net::use_awaitable, error));
    octets += count;
  }
}

Connection::Awaitable<bool> Connection::write_text(const std::string& text) {
  error_code error;
  stream_.expires_after(limits_.response_patience);
  co_await net::async_write(stream_, net::buffer(text), net::redirect_error(net::use_awaitable, error));
  stream_.expires_never();
  co_return !error;
}

Connection::Awaitable<void> Connection::tell(const Response& response, unsigned version, bool has_body) {
  auto message = head_of(response, version);
  message.keep_alive(false);
  error_code error;
  stream_.expires_after(limits_.response_patience);
  http::response_serializer<http::string_body> serializer(message);
  co_await http::async_write_header(stream_, serializer, net::redirect_error(net::use_awaitable, error));
  if (error || !has_body) co_return;
  const auto ask = [stream = response.stream](const EventStream::Then& then) { stream->next(then); };
  auto said = Clock::now();
  while (!has_gone()) {
    std::string events = co_await result_of<std::string>(ask);
    if (events.empty() && Clock::now() - said >= limits_.heartbeat) events = ":\n\n";
    if (!events.empty()) {
      const bool is_written = co_await write_text(events);
      if (!is_written) co_return;
      said = Clock::now();
    }
    pause_.expires_after(answers::watch_pause);
    co_await pause_.async_wait(net::redirect_error(net::use_awaitable, error));
  }
}

bool Connection::has_gone() {
  if (!stream_.socket().is_open()) return true;
  char octet = 0;
  const auto count = ::recv(stream_.socket().native_handle(), &octet, 1, MSG_PEEK | MSG_DONTWAIT);
  return count == 0 || (count < 0 && errno != EAGAIN && errno != EWOULDBLOCK);
}

}  // namespace geminga::web
