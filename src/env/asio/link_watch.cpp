#include "env/asio/link_watch.hpp"

#include <linux/netlink.h>
#include <linux/rtnetlink.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>

namespace geminga::env {
namespace {

namespace net = boost::asio;

/// Reports read in one turn; the rest is read in the next.
constexpr int max_reports_per_turn = 64;

/// A socket that the kernel tells of changes of links and addresses, or -1.
int open_reports() {
  const int fd = ::socket(AF_NETLINK, SOCK_RAW | SOCK_CLOEXEC | SOCK_NONBLOCK, NETLINK_ROUTE);
  if (fd < 0) return -1;
  sockaddr_nl address{};
  address.nl_family = AF_NETLINK;
  address.nl_groups = RTMGRP_LINK | RTMGRP_IPV4_IFADDR | RTMGRP_IPV6_IFADDR;
  if (::bind(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) return fd;
  ::close(fd);
  return -1;
}

}  // namespace

class LinkWatch::Watcher : public std::enable_shared_from_this<LinkWatch::Watcher> {
 public:
  Watcher(net::io_context& context, bool is_well, Look look)
      : look_(std::move(look)), timer_(context), reports_(context), is_well_(is_well) {}

  void start() {
    if (const int fd = open_reports(); fd >= 0) {
      reports_.assign(fd);
      await_report();
    }
    look_at(std::chrono::steady_clock::now() + period());
  }

  void stop() {
    is_stopped_ = true;
    timer_.cancel();
    boost::system::error_code ignored;
    reports_.close(ignored);
  }

 private:
  [[nodiscard]] std::chrono::seconds period() const {
    return is_well_ && reports_.is_open() ? link_rescan_period : link_scan_period;
  }

  void await_report() {
    reports_.async_wait(net::posix::stream_descriptor::wait_read,
                        [self = shared_from_this()](const boost::system::error_code& error) {
                          if (error || self->is_stopped_) return;
                          self->drain();
                          self->look_at(std::max(std::chrono::steady_clock::now(), self->last_look_ + link_scan_pause));
                          self->await_report();
                        });
  }

  /// Reads the waiting reports away: the look will see what changed. A full buffer (ENOBUFS) is a report, too.
  void drain() {
    std::array<char, 8192> report;
    for (int turn = 0; turn < max_reports_per_turn; ++turn) {
      if (::recv(reports_.native_handle(), report.data(), report.size(), MSG_DONTWAIT) <= 0) return;
    }
  }

  void look_at(std::chrono::steady_clock::time_point instant) {
    timer_.expires_at(instant);
    timer_.async_wait([self = shared_from_this()](const boost::system::error_code& error) {
      if (error || self->is_stopped_) return;
      self->last_look_ = std::chrono::steady_clock::now();
      self->is_well_ = self->look_();
      if (self->is_stopped_) return;
      self->look_at(self->last_look_ + self->period());
    });
  }

  Look look_;
  net::steady_timer timer_;
  net::posix::stream_descriptor reports_;
  std::chrono::steady_clock::time_point last_look_;
  bool is_well_;
  bool is_stopped_ = false;
};

LinkWatch::LinkWatch(net::io_context& context, bool is_well, Look look)
    : watcher_(std::make_shared<Watcher>(context, is_well, std::move(look))) {
  watcher_->start();
}
LinkWatch::~LinkWatch() { watcher_->stop(); }

}  // namespace geminga::env
