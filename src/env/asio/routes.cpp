#include "env/asio/routes.hpp"

#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cerrno>
#include <cstring>
#include <optional>
#include <span>
#include <utility>

#include "base/address.hpp"
#include "env/asio/descriptor.hpp"

namespace geminga::env {
namespace {

namespace net = boost::asio;

/// An answer about one route is far shorter.
constexpr std::size_t max_route_bytes = 8192;
/// Reports that are read in one turn; the rest is read in the next.
constexpr int max_route_reports = 64;

/// The question for one address: RTM_GETROUTE, which of the routes fits (RTM_F_FIB_MATCH).
struct RouteQuestion {
  nlmsghdr header;
  rtmsg route;
  rtattr attribute;
  std::array<std::uint8_t, 16> address;
};

/// Whether the route names a router, by which the address lies beyond our own links.
bool has_router(std::span<const std::byte> attributes) {
  while (attributes.size() >= sizeof(rtattr)) {
    rtattr header{};
    std::memcpy(&header, attributes.data(), sizeof header);
    const int type = header.rta_type & NLA_TYPE_MASK;
    if (type == RTA_GATEWAY || type == RTA_VIA || type == RTA_MULTIPATH) return true;
    const std::size_t length = RTA_ALIGN(header.rta_len);
    if (header.rta_len < sizeof header || length >= attributes.size()) return false;
    attributes = attributes.subspan(length);
  }
  return false;
}

/// An error of the kernel's in the place of a route. EINVAL is that of a blackhole, and also of a kernel that does not
/// understand the question.
RouteKind of_error(int error) {
  switch (-error) {
    case ENETUNREACH:
    case EHOSTUNREACH:
    case EACCES:
      return RouteKind::none;
    case EINVAL:
      return find_route("127.0.0.1") == RouteKind::own ? RouteKind::none : RouteKind::unknown;
    default:
      return RouteKind::unknown;
  }
}

RouteKind of_answer(std::span<const std::byte> answer) {
  nlmsghdr header{};
  if (answer.size() < sizeof header) return RouteKind::unknown;
  std::memcpy(&header, answer.data(), sizeof header);
  if (header.nlmsg_len < sizeof header || header.nlmsg_len > answer.size()) return RouteKind::unknown;
  const auto content = answer.subspan(sizeof header, header.nlmsg_len - sizeof header);
  if (header.nlmsg_type == NLMSG_ERROR) {
    nlmsgerr error{};
    if (content.size() < sizeof error) return RouteKind::unknown;
    std::memcpy(&error, content.data(), sizeof error);
    return of_error(error.error);
  }
  rtmsg route{};
  if (header.nlmsg_type != RTM_NEWROUTE || content.size() < NLMSG_ALIGN(sizeof route)) return RouteKind::unknown;
  std::memcpy(&route, content.data(), sizeof route);
  switch (route.rtm_type) {
    case RTN_UNREACHABLE:
    case RTN_BLACKHOLE:
    case RTN_PROHIBIT:
    case RTN_THROW:
      return RouteKind::none;
    case RTN_LOCAL:
      return RouteKind::own;
    case RTN_UNICAST:
      break;
    default:
      return RouteKind::unknown;
  }
  if (route.rtm_dst_len == 0) return RouteKind::fallback;
  return has_router(content.subspan(NLMSG_ALIGN(sizeof route))) ? RouteKind::specific : RouteKind::own;
}

/// A socket that the kernel tells of changes of routes and of what they follow from, or -1. That an interface goes down
/// takes routes of IPv4 away without a report about them.
int open_route_reports() {
  Descriptor reports(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE));
  if (reports.get() < 0) return -1;
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  for (const auto group : {RTNLGRP_LINK, RTNLGRP_IPV4_IFADDR, RTNLGRP_IPV6_IFADDR, RTNLGRP_IPV4_ROUTE,
                           RTNLGRP_IPV6_ROUTE, RTNLGRP_IPV4_RULE, RTNLGRP_IPV6_RULE}) {
    address.nl_groups |= 1U << (static_cast<unsigned>(group) - 1);
  }
  if (::bind(reports.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) return -1;
  return reports.release();
}

}  // namespace

RouteKind find_route(std::string_view address) {
  const auto parsed = base::parse_address(address);
  if (!parsed) return RouteKind::unknown;
  const Descriptor socket(::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE));
  if (socket.get() < 0) return RouteKind::unknown;
  RouteQuestion question{};
  const std::size_t octets = parsed->octets.size();
  question.header.nlmsg_type = RTM_GETROUTE;
  question.header.nlmsg_flags = NLM_F_REQUEST;
  question.header.nlmsg_len =
      static_cast<std::uint32_t>(sizeof question.header + sizeof question.route + RTA_LENGTH(octets));
  question.route.rtm_family = parsed->is_ipv6() ? AF_INET6 : AF_INET;
  question.route.rtm_dst_len = static_cast<std::uint8_t>(octets * 8);
  question.route.rtm_flags = RTM_F_FIB_MATCH;
  question.attribute.rta_type = RTA_DST;
  question.attribute.rta_len = static_cast<std::uint16_t>(RTA_LENGTH(octets));
  std::ranges::copy(parsed->octets, question.address.begin());
  if (::send(socket.get(), &question, question.header.nlmsg_len, 0) < 0) return RouteKind::unknown;
  // The kernel answers within send().
  std::array<std::byte, max_route_bytes> answer;
  const ssize_t size = ::recv(socket.get(), answer.data(), answer.size(), 0);
  return size < 0 ? RouteKind::unknown : of_answer(std::span(answer).first(static_cast<std::size_t>(size)));
}

class Routes::Watcher : public std::enable_shared_from_this<Routes::Watcher> {
 public:
  Watcher(net::io_context& context, std::function<void()> changed)
      : changed_(std::move(changed)), timer_(context), reports_(context) {}

  void start() {
    if (const int fd = open_route_reports(); fd >= 0) {
      reports_.assign(fd);
      await_report();
    }
  }

  void stop() {
    is_stopped_ = true;
    timer_.cancel();
    boost::system::error_code ignored;
    reports_.close(ignored);
  }

  /// Whether changes are reported.
  [[nodiscard]] bool is_listening() const { return reports_.is_open(); }

 private:
  void await_report() {
    reports_.async_wait(net::posix::stream_descriptor::wait_read,
                        [self = shared_from_this()](const boost::system::error_code& error) {
                          if (error || self->is_stopped_) return;
                          self->drain();
                          self->tell_later();
                        });
  }

  /// Reads the waiting reports away. A full buffer (ENOBUFS) is a report, too.
  void drain() {
    std::array<char, max_route_bytes> report;
    for (int turn = 0; turn < max_route_reports; ++turn) {
      if (::recv(reports_.native_handle(), report.data(), report.size(), MSG_DONTWAIT) <= 0) return;
    }
  }

  void tell_later() {
    timer_.expires_after(routes_pause);
    timer_.async_wait([self = shared_from_this()](const boost::system::error_code& error) {
      if (error || self->is_stopped_) return;
      self->drain();
      self->changed_();
      if (!self->is_stopped_) self->await_report();
    });
  }

  std::function<void()> changed_;
  net::steady_timer timer_;
  net::posix::stream_descriptor reports_;
  bool is_stopped_ = false;
};

Routes::~Routes() {
  if (watcher_) watcher_->stop();
}

RouteKind Routes::find(std::string_view address) {
  if (!watcher_) {
    watcher_ = std::make_shared<Watcher>(context_, [this] {
      remembered_.clear();
      changed_();
    });
    watcher_->start();
  }
  if (const auto known = remembered_.find(address); known != remembered_.end()) return known->second;
  const RouteKind route = find_route(address);
  if (!watcher_->is_listening()) return route;
  if (remembered_.size() == max_remembered_routes) remembered_.clear();
  remembered_.emplace(address, route);
  return route;
}

}  // namespace geminga::env
