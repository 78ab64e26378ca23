// The way out of all datagrams of a participant: sealed, remembered and counted.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_OUTLET_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_OUTLET_HPP

#include <cstddef>
#include <cstdint>
#include <span>

#include "discovery/participant/air/counters.hpp"
#include "discovery/participant/air/deaf_hosts.hpp"
#include "discovery/participant/air/sent_datagrams.hpp"
#include "discovery/sealing/seal.hpp"
#include "env/env.hpp"

namespace geminga::participant {

class Outlet {
 public:
  /// The parts that it changes. All are borrowed for its life.
  struct Means {
    env::Env& env;
    sealing::Seal& seal;
    DeafHosts& deaf_hosts;
    AirCounters& counters;
  };
  /// `key`: random bits for what is remembered of datagrams.
  Outlet(const Means& means, std::uint64_t key) : means_(means), sent_(key) {}

  /// Says one encoded announcement on an interface, and to hosts that are tried alone there.
  void send(env::InterfaceIndex interface, std::span<const std::byte> text);
  /// Hands a frame to the bridge on this link, as it is. A frame is no announcement, and nobody else hears it.
  void hand(env::InterfaceIndex link, std::span<const std::byte> frame);
  /// Whether this very datagram was sent of late.
  [[nodiscard]] bool has_sent(std::span<const std::byte> datagram) const { return sent_.contains(datagram); }

 private:
  Means means_;
  SentDatagrams sent_;
};

}  // namespace geminga::participant

#endif
