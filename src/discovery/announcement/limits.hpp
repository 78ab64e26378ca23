// The limits of an announcement, beside those of env/env.hpp (a datagram) and identity/service_limits.hpp (a service).
// src/discovery/announcement/ANNOUNCEMENT.md names the same numbers.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_LIMITS_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_LIMITS_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/time.hpp"
#include "env/env.hpp"
#include "identity/service_limits.hpp"

namespace geminga::announcement {

/// One announcement without its envelope.
inline constexpr std::size_t max_datagram_bytes = env::max_datagram_bytes - env::max_envelope_bytes;

/// The octets of a datagram that one publication or subscription may take, its share of the tables included. The rest
/// is kept for the largest possible header, so whether a service fits depends on nothing but the service.
inline constexpr std::size_t max_entry_bytes = 720;

/// A concept or representation IRI, in octets.
inline constexpr std::size_t max_iri_bytes = 255;
/// A class expression that is asked for instead of a concept, in octets of its canonical form.
inline constexpr std::size_t max_expression_bytes = 400;
/// The class expression of a description, which has no other large part. The rest of max_entry_bytes is for attributes.
inline constexpr std::size_t max_described_bytes = 640;
/// Services of a choice that are written one by one. For more than these each participant is written once
/// (wire_choice.hpp).
inline constexpr std::size_t max_listed_choice = 16;
/// Addresses of one interface; further ones are not announced.
inline constexpr std::size_t max_addresses = 8;

/// Publications and subscriptions of one participant together. The daemon refuses one more by 429.
inline constexpr std::size_t max_services_per_participant = 1024;
/// Parts of one state: enough for the most services, each alone in its part.
inline constexpr std::size_t max_parts = max_services_per_participant;
/// Participants that are known at once. One more takes the place of a less proved one (admission.hpp), or gets none.
inline constexpr std::size_t max_participants = 1024;
/// Participants of one source address that never give way to a stranger, however many the address has. A host has one
/// daemon.
inline constexpr std::size_t max_seasoned_per_source = 32;
/// Strangers that are remembered while all places are taken, so that they can prove themselves by a second datagram. At
/// ten thousand forged strangers a second each is remembered for 0.8 s on average, which outlasts the first copies of a
/// newcomer.
inline constexpr std::size_t max_waiting = 8192;
/// Services for which every known participant has room, whatever others take: twice the sixteen services of a robot.
inline constexpr std::size_t reserved_services = 32;
/// Publications and subscriptions of all remote participants together beyond the reserve of each.
inline constexpr std::size_t max_remote_services = 8192;
/// Services of all participants that are remembered for a short while after they were withdrawn, in case that was a
/// lie.
inline constexpr std::size_t max_withdrawn_services = 4096;
/// Ways on which one participant is heard (our interface and its interface); further ones are not used.
inline constexpr std::size_t max_paths = 4;

/// Addresses of one participant whose words are signs of life; the oldest gives way to a further one.
inline constexpr std::size_t max_vouched = max_paths * max_addresses;

/// Participants that one announcement says it lacks, and as many that it doubts.
inline constexpr std::size_t max_named = 16;
/// Participants that one presence introduces.
inline constexpr std::size_t max_introductions = 8;
/// Octets of the testimony about so many participants (Witness).
constexpr std::size_t witness_bytes(std::size_t members) { return 2 + (members + 3) / 4; }
/// Lines of a diagnosis, and octets of each. A whole inquiry has max_datagram_bytes, so no diagnosis is longer.
inline constexpr std::size_t max_diagnosis_lines = 64;
inline constexpr std::size_t max_diagnosis_line_bytes = 200;
/// Relays that a word passes at most. Each adds an interval to the time in which a death is told.
inline constexpr std::size_t max_hops = 4;
/// A word that a relay passes on, its envelope included: what is left of an announcement by the largest header of the
/// relay (59 octets).
inline constexpr std::size_t max_word_bytes = 1136;
/// A state is split into datagrams of at most so many octets, so that each of them can be passed on. A service that is
/// too large for that has a datagram of its own, which is not.
inline constexpr std::size_t max_said_bytes = max_word_bytes - env::max_envelope_bytes;
/// Participants that one datagram of a relay testifies about; for more of them it says several.
inline constexpr std::size_t max_behind = 160;
/// The greatest age that a relay says: longer than any deadline behind max_hops relays.
inline constexpr base::Duration max_relayed_age = std::chrono::minutes(10);
/// The group that a presence means when it names none.
inline constexpr std::string_view default_group = "default";

/// The announced interval. A shorter one would be a flood; a longer one would keep dead participants for minutes.
inline constexpr base::Duration min_interval = std::chrono::milliseconds(50);
inline constexpr base::Duration max_interval = std::chrono::seconds(60);
/// The most doublings of the interval where many share the air.
inline constexpr unsigned max_doublings = 8;

/// The longest interval that counts for a stranger until it is heard again: the usual one.
inline constexpr base::Duration stranger_interval = std::chrono::seconds(2);
/// A participant that was heard for so long never gives way to a stranger.
inline constexpr base::Duration seasoned_after = std::chrono::seconds(60);
/// The intervals before the first contradiction in a sender's name whose changes are undone: somebody lies in that
/// name, and older statements are believed.
inline constexpr int hold_intervals = 2;
/// The intervals without a contradiction that end a contest: what it takes to believe that somebody is gone.
inline constexpr int contest_intervals = 5;
/// The longest time for which a datagram may be overtaken by later ones.
inline constexpr base::Duration overtaken_time = std::chrono::milliseconds(200);
/// The largest step from one revision to the next that is taken at once: a change each 10 us for all of ten seconds.
inline constexpr std::uint64_t max_revision_step = std::uint64_t{1} << 20;

}  // namespace geminga::announcement

#endif
