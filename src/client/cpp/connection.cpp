#include "client/cpp/connection.hpp"

#include <sys/un.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/system/error_code.hpp>
#include <optional>

namespace geminga::client {
namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

class Connection::Socket {
 public:
  std::expected<void, Failure> connect(const Endpoint& endpoint, Clock::time_point deadline) {
    error_code error;
    const auto at = generic(endpoint, error);
    if (error) return fail(Failure::bad_address, error);
    std::optional<error_code> result;
    socket_.async_connect(at, [&](error_code code) { result = code; });
    if (!run_until(deadline, result)) return fail(Failure::timed_out, asio::error::timed_out);
    if (*result) return fail(Failure::unreachable, *result);
    socket_.non_blocking(true, error);
    if (!error && endpoint.path.empty()) socket_.set_option(tcp::no_delay(true), error);
    if (error) return fail(Failure::unreachable, error);
    return {};
  }

  std::expected<void, Failure> write(std::string_view bytes, Clock::time_point deadline) {
    while (!bytes.empty()) {
      error_code error;
      const std::size_t count = socket_.write_some(asio::buffer(bytes.data(), bytes.size()), error);
      bytes.remove_prefix(count);
      if (error == asio::error::would_block || error == asio::error::try_again) {
        if (auto ready = wait(Protocol::socket::wait_write, deadline); !ready) return ready;
      } else if (error && error != asio::error::interrupted) {
        return fail(Failure::closed, error);
      }
    }
    return {};
  }

  std::expected<std::string_view, Failure> read(Clock::time_point deadline) {
    while (true) {
      error_code error;
      const std::size_t count = socket_.read_some(asio::buffer(buffer_), error);
      if (!error) return std::string_view(buffer_.data(), count);
      if (error == asio::error::would_block || error == asio::error::try_again) {
        if (auto ready = wait(Protocol::socket::wait_read, deadline); !ready) return std::unexpected(ready.error());
      } else if (error != asio::error::interrupted) {
        fail(Failure::closed, error);
        return std::unexpected(Failure::closed);
      }
    }
  }

  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] int file_descriptor() { return socket_.native_handle(); }

 private:
  using Protocol = asio::generic::stream_protocol;

  static Protocol::endpoint generic(const Endpoint& endpoint, error_code& error) {
    if (!endpoint.path.empty()) {
      constexpr std::size_t longest = sizeof(sockaddr_un::sun_path) - 1;
      if (endpoint.path.size() <= longest) return asio::local::stream_protocol::endpoint(endpoint.path);
      error = asio::error::name_too_long;
      return {};
    }
    return tcp::endpoint{asio::ip::make_address(endpoint.address, error), endpoint.port};
  }

  std::expected<void, Failure> wait(Protocol::socket::wait_type type, Clock::time_point deadline) {
    if (deadline <= Clock::now()) return fail(Failure::timed_out, asio::error::timed_out);
    std::optional<error_code> result;
    socket_.async_wait(type, [&](error_code code) { result = code; });
    if (!run_until(deadline, result)) return fail(Failure::timed_out, asio::error::timed_out);
    if (*result) return fail(Failure::closed, *result);
    return {};
  }

  /// Runs until the one operation under way has its result, or cancels it at the deadline; then false.
  bool run_until(Clock::time_point deadline, const std::optional<error_code>& result) {
    context_.restart();
    context_.run_until(deadline);
    if (result) return true;
    error_code ignored;
    socket_.cancel(ignored);
    context_.restart();
    context_.run();
    return false;
  }

  std::unexpected<Failure> fail(Failure failure, const error_code& error) {
    reason_ = error.message();
    return std::unexpected(failure);
  }

  asio::io_context context_{1};
  Protocol::socket socket_{context_};
  std::array<char, 16 * 1024> buffer_{};
  std::string reason_;
};

Connection::Connection() : socket_(std::make_unique<Socket>()) {}
Connection::~Connection() = default;

std::expected<void, Connection::Failure> Connection::connect(const Endpoint& endpoint, Clock::time_point deadline) {
  return socket_->connect(endpoint, deadline);
}

std::expected<void, Connection::Failure> Connection::write(std::string_view bytes, Clock::time_point deadline) {
  return socket_->write(bytes, deadline);
}

std::expected<std::string_view, Connection::Failure> Connection::read(Clock::time_point deadline) {
  return socket_->read(deadline);
}

const std::string& Connection::reason() const { return socket_->reason(); }
int Connection::file_descriptor() const { return socket_->file_descriptor(); }

}  // namespace geminga::client
