// Counts of what came from outside and could not be taken, told now and then.
#ifndef GEMINGA_BRIDGE_TEAM_TALLY_HPP
#define GEMINGA_BRIDGE_TEAM_TALLY_HPP

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "client/channels/reactor.hpp"

namespace geminga::bridge {

/// Tells all counts in one line when one has grown, at most once in tally_pause. Neither copies nor moves; the reactor
/// must outlive it.
class Tally {
 public:
  using Tell = std::function<void(const std::string& line)>;

  Tally(client::Reactor& reactor, Tell tell);

  /// Counts one more for a reason, which is a constant of the program, e.g. "names that are no UTF-8".
  void count(std::string_view reason);
  [[nodiscard]] std::uint64_t of(std::string_view reason) const;

 private:
  void tell();

  client::Reactor& reactor_;
  Tell tell_;
  std::map<std::string, std::uint64_t, std::less<>> counts_;
  base::Instant told_at_{};
  client::Reactor::Timer timer_;
};

}  // namespace geminga::bridge

#endif
