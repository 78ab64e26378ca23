// A known participant as the rest of the program sees it.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_HPP

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour/loss_window.hpp"
#include "env/env.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// One way on which a participant is heard: our interface and its interface.
struct Path {
  env::InterfaceIndex interface{};
  std::string interface_name;
  std::uint32_t link = 0;
  std::vector<std::string> addresses;  ///< the sender's there; IPv6 link-local ones with our zone
  base::Instant heard;
  double loss = 0;        ///< the share of its last 64 datagrams on this way that were not heard
  LossSample lately{};    ///< of which that is; empty on a way through a relay, which says the share alone
  LossSample for_long{};  ///< its last 256 datagrams on this way
};

/// A participant and everything that queries show of it.
struct Neighbour {
  ParticipantId id{};
  announcement::BootNonce boot{};
  std::string name;  ///< its identifier if it announces no name
  std::uint64_t ontology_digest = 0;
  base::Duration interval{};
  base::Instant heard;
  base::Instant deadline;
  std::string address;  ///< given to its services that have none; may be empty
  std::vector<Path> paths;
  double loss = 0;  ///< of the best path
  std::size_t publications = 0;
  std::size_t subscriptions = 0;
  bool is_deaf = false;  ///< it has said for long, and not by chance, that it does not hear us
  /// The relays on the way to it, as far as they are known, the one next to it first; empty: it is heard directly.
  std::vector<ParticipantId> through;
  bool is_complete = false;  ///< all parts of its newest revision were heard
};

}  // namespace geminga::membership

#endif
