// Says when to look at the network interfaces again: when the kernel reports a change, and regularly in case it does
// not.
#ifndef GEMINGA_ENV_ASIO_LINK_WATCH_HPP
#define GEMINGA_ENV_ASIO_LINK_WATCH_HPP

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <functional>
#include <memory>

namespace geminga::env {

/// Between two looks while something is amiss that a look may mend, or the kernel reports nothing.
inline constexpr std::chrono::seconds link_scan_period{2};
/// Between two looks without a reported change where all is well. Shorter: a change that the kernel did not report is
/// seen sooner. Longer: less processor time, of which a look each two seconds takes a tenth. Reports are reliable on
/// every kernel we know; this is a safeguard.
inline constexpr std::chrono::seconds link_rescan_period{30};
/// Between two looks when many reports come: an interface that comes up causes half a dozen.
inline constexpr std::chrono::milliseconds link_scan_pause{20};

/// Listens to rtnetlink(7) and a timer.
class LinkWatch {
 public:
  /// Looks, and says whether all is well.
  using Look = std::function<bool()>;
  /// `is_well`: as it was looked at last.
  LinkWatch(boost::asio::io_context& context, bool is_well, Look look);
  ~LinkWatch();
  LinkWatch(const LinkWatch&) = delete;
  LinkWatch& operator=(const LinkWatch&) = delete;

 private:
  class State;
  std::shared_ptr<State> state_;
};

}  // namespace geminga::env

#endif
