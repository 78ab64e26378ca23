#include "env/asio/doors.hpp"

#include <algorithm>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <chrono>
#include <utility>

#include "env/asio/given_socket.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;
using net::ip::tcp;

/// The pause of accepting when the process has no descriptor left.
constexpr std::chrono::milliseconds accept_pause{100};

ListenError listen_error(const boost::system::error_code& error) {
  auto cause = ListenError::Cause::other;
  if (error == net::error::address_in_use) cause = ListenError::Cause::in_use;
  if (error == boost::system::errc::address_not_available || error == net::error::address_family_not_supported) {
    cause = ListenError::Cause::not_available;
  }
  return {cause, error.message()};
}

}  // namespace

std::expected<std::string, std::string> Doors::adopt(int descriptor) {
  const auto given = inspect_given_socket(descriptor);
  if (!given) return std::unexpected(given.error());
  Acceptor acceptor(context_);
  boost::system::error_code error;
  acceptor.assign({given->family, given->protocol}, descriptor, error);
  if (error) return std::unexpected(error.message());
  adopted_.push_back(given->place);
  doors_.push_back({std::move(acceptor), net::steady_timer(context_)});
  return given->place;
}

bool Doors::has_adopted(const std::string& place) const { return std::ranges::find(adopted_, place) != adopted_.end(); }

std::expected<void, ListenError> Doors::listen(const Endpoint& endpoint) {
  if (has_adopted(to_string(endpoint))) return {};
  Acceptor acceptor(context_);
  boost::system::error_code error;
  const auto address = net::ip::make_address(endpoint.address, error);
  if (!error) acceptor.open(address.is_v4() ? tcp::v4() : tcp::v6(), error);
  if (!error) acceptor.set_option(net::socket_base::reuse_address(true), error);
  if (!error && address.is_v6()) acceptor.set_option(net::ip::v6_only(true), error);
  if (!error) acceptor.bind(tcp::endpoint{address, endpoint.port}, error);
  if (!error) acceptor.listen(net::socket_base::max_listen_connections, error);
  if (error) return std::unexpected(listen_error(error));
  doors_.push_back({std::move(acceptor), net::steady_timer(context_)});
  return {};
}

std::expected<void, std::string> Doors::listen(const std::string& path) {
  if (has_adopted(path)) return {};
  auto file = SocketFile::make(path);
  if (!file) return std::unexpected(std::move(file.error()));
  Acceptor acceptor(context_, net::generic::stream_protocol(net::local::stream_protocol()), file->take_descriptor());
  files_.push_back(std::move(*file));
  doors_.push_back({std::move(acceptor), net::steady_timer(context_)});
  return {};
}

void Doors::serve(Take take) {
  take_ = std::move(take);
  for (std::size_t number = 0; number < doors_.size(); ++number) accept(number);
}

void Doors::close() {
  boost::system::error_code ignored;
  for (Door& door : doors_) {
    door.acceptor.close(ignored);
    door.retry.cancel();
  }
  files_.clear();
  take_ = nullptr;
}

void Doors::accept(std::size_t number) {
  doors_[number].acceptor.async_accept(
      [self = shared_from_this(), number](const boost::system::error_code& error, Socket socket) {
        if (!self->doors_[number].acceptor.is_open() || !self->take_) return;
        if (!error) Take(self->take_)(std::move(socket));  // a copy, since it may close the doors
        if (!self->doors_[number].acceptor.is_open()) return;
        if (error && error != net::error::connection_aborted) return self->accept_later(number);
        self->accept(number);
      });
}

/// No descriptor is left: trying again at once would only spin.
void Doors::accept_later(std::size_t number) {
  doors_[number].retry.expires_after(accept_pause);
  doors_[number].retry.async_wait([self = shared_from_this(), number](const boost::system::error_code& error) {
    if (!error && self->doors_[number].acceptor.is_open()) self->accept(number);
  });
}

}  // namespace geminga::env
