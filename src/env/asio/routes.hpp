// The kernel's routes: the way to an address, and reports of their changes.
#ifndef GEMINGA_ENV_ASIO_ROUTES_HPP
#define GEMINGA_ENV_ASIO_ROUTES_HPP

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "env/route_kind.hpp"

namespace geminga::env {

/// The time between a report of a change and what is told of it: a router that learns routes reports many in a row.
inline constexpr std::chrono::milliseconds routes_pause{100};
/// Answers that are remembered; with one more all are forgotten and asked for anew.
inline constexpr std::size_t max_remembered_routes = 4096;

/// The route that rtnetlink(7) gives for a numeric address at this moment; `unknown` where it cannot be asked. A kernel
/// before 4.13 does not name the route that fits, and then nothing is `fallback`. Cost: a socket and two system calls.
[[nodiscard]] RouteKind find_route(std::string_view address);

/// Answers of the kernel, each asked for once until something changes. Listens to nothing before the first question, so
/// that a daemon that judges no address pays nothing.
class Routes {
 public:
  /// Tells that answers may differ.
  using Changed = std::function<void()>;
  Routes(boost::asio::io_context& context, Changed changed) : context_(context), changed_(std::move(changed)) {}
  ~Routes();
  Routes(const Routes&) = delete;
  Routes& operator=(const Routes&) = delete;

  [[nodiscard]] RouteKind find(std::string_view address);

 private:
  class Watcher;

  boost::asio::io_context& context_;
  Changed changed_;
  std::map<std::string, RouteKind, std::less<>> remembered_;
  /// Null: nothing was asked for yet. Its handlers share it, and may outlive this object for a turn.
  std::shared_ptr<Watcher> watcher_;
};

}  // namespace geminga::env

#endif
