// What our own peers state, on its way into the registry and out of it.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_OWN_SERVICES_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_OWN_SERVICES_HPP

#include <cstdint>

#include "discovery/participant/core.hpp"

namespace geminga::participant {

/// The address of a service that states none, as it is told to peers on the same host.
inline constexpr const char* local_address = "127.0.0.1";

/// Enters a statement that is in force, or its change, into the registry; it is announced at the end of the event.
void enter(Core& core, const Session& session, std::uint32_t number, const StatedPublication& stated);
void enter(Core& core, const Session& session, std::uint32_t number, const StatedSubscription& stated,
           matching::Matcher::Telling telling = matching::Matcher::Telling::all);
void withdraw_publication(Core& core, const Session& session, std::uint32_t number, matching::Reason reason);
void withdraw_subscription(Core& core, const Session& session, std::uint32_t number, matching::Reason reason);
/// Puts a statement out of force until the ontology is there. The peer is told that everything it was told of is gone,
/// and keeps its request.
void suspend(Core& core, Session& session, std::uint32_t number, const StatedPublication& stated);
void suspend(Core& core, Session& session, std::uint32_t number, const StatedSubscription& stated);
/// Withdraws one, and all that is known of it here.
void forget_publication(Core& core, Session& session, std::uint32_t number);
void forget_subscription(Core& core, Session& session, std::uint32_t number);

/// Pairs of services on one host that may change in one event: a change of one service never makes more events for
/// local peers than the host has services.
inline constexpr std::size_t max_pairs_at_once = 1024;
/// Whether all services of the peer may change at once.
[[nodiscard]] bool is_small(const Core& core, const Session& session);
/// Withdraws all services of a peer at once, so that none that is about to go is chosen in place of one that has gone.
void withdraw_all(Core& core, Session& session);
/// Withdraws one service of a peer that is not small; there must be one.
void withdraw_one(Core& core, Session& session);
/// Enters the next service of a peer under its new name; there must be one.
void rename_one(Core& core, Session& session);
/// Another identifier takes the place of the one that was held: all that our peers have stated leaves under the former
/// and returns under this one, request by request, in turns (neighbour_feed.hpp).
void change_identifier(Core& core, ParticipantId held);
/// Enters one request again: its peer is told that all it was told of for this request is gone, and then what there is.
void return_one(Core& core, Session& session, std::uint32_t number);
/// Resolves the names of one statement by the ontology in force. What it does not know is withdrawn and told to its
/// peer; what an earlier one did not know comes back.
void restate(Core& core, Session& session, std::uint32_t number);

}  // namespace geminga::participant

#endif
