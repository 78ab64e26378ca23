// The rules of one service, for both directions: the answer to a local peer, and the word for a datagram's counter.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_FAULT_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_FAULT_HPP

#include <optional>

#include "discovery/announcement/codec.hpp"
#include "geminga/error.hpp"
#include "geminga/service.hpp"

namespace geminga::announcement {

/// One violated rule: the word for a counter, and the GCNP error for a peer that stated it.
struct Fault {
  DecodeError word = DecodeError::bad_identity;
  Error error;
};

/// The first rule that a service violates, its total size apart; nothing: everything in it may be announced.
[[nodiscard]] std::optional<Fault> find_fault(const Publication& publication);
[[nodiscard]] std::optional<Fault> find_fault(const Subscription& subscription);

}  // namespace geminga::announcement

#endif
