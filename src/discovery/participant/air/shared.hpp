// The things that participants of one process share.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_SHARED_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_SHARED_HPP

#include <cstddef>
#include <memory>

#include "discovery/announcement/reader.hpp"
#include "discovery/membership/neighbour/offer.hpp"

namespace geminga::participant {

/// A thousand simulated participants hear the same datagrams and know the same services: each datagram is decoded once,
/// and each service kept once. Nothing that a participant does depends on it. Not thread-safe.
struct Shared {
  /// More than are on the air at one time.
  static constexpr std::size_t remembered_datagrams = 512;

  announcement::Reader reader{remembered_datagrams};
  std::shared_ptr<membership::Offers> offers = std::make_shared<membership::Offers>();
};

}  // namespace geminga::participant

#endif
