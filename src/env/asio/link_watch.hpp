// The times of looks at the network interfaces: when the kernel reports a change, and regularly in case it does not.
#ifndef GEMINGA_ENV_ASIO_LINK_WATCH_HPP
#define GEMINGA_ENV_ASIO_LINK_WATCH_HPP

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <functional>
#include <memory>

namespace geminga::env {

/// The time between two looks while something is wrong that a look may mend, or while the kernel reports nothing.
inline constexpr std::chrono::seconds link_scan_period{1};
/// The time between two looks without a reported change, if all is well. Shorter: an unreported change is seen sooner.
/// Longer: less processor time; a look each two seconds takes a tenth of an idle daemon's. Reports are reliable on
/// every kernel we know; this is a safeguard.
inline constexpr std::chrono::seconds link_rescan_period{30};
/// The time between two looks when many reports come: an interface that comes up causes half a dozen.
inline constexpr std::chrono::milliseconds link_scan_pause{20};

/// Listens to rtnetlink(7) and a timer. Its handlers share the watcher, which may outlive this object for a turn.
class LinkWatch {
 public:
  /// Looks at the interfaces. Returns whether all is well.
  using Look = std::function<bool()>;
  /// `is_well`: the result of the last look.
  LinkWatch(boost::asio::io_context& context, bool is_well, Look look);
  ~LinkWatch();
  LinkWatch(const LinkWatch&) = delete;
  LinkWatch& operator=(const LinkWatch&) = delete;

 private:
  class Watcher;
  std::shared_ptr<Watcher> watcher_;
};

}  // namespace geminga::env

#endif
