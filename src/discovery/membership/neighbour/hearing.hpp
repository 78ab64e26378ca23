// The verdict on an announcement that was heard.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_HEARING_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_HEARING_HPP

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geminga::membership {

/// The verdict of the table on an announcement.
enum class Hearing : std::uint8_t {
  own,          ///< our own datagram came back
  clash,        ///< our identifier from another boot nonce: feed IdentifierClaim::conflict() with its kind
  claim,        ///< a claim of an identifier by an unknown participant: Schedule::newcomer()
  newcomer,     ///< an unknown participant, or one that has restarted: Schedule::newcomer()
  known,        ///< from a known participant; changes may follow
  goodbye,      ///< a known participant has left
  other_group,  ///< from another group
  stale,      ///< older than its sender's goodbye or the loss of its identifier, or a goodbye of an unknown participant
  full,       ///< from an unknown participant, while others have a better right to all places
  copied,     ///< a copy of a known datagram from another source address: ignored
  elsewhere,  ///< in the name of a known participant from another source address: ignored until it is repeated
  rival,      ///< a known identifier with another boot nonce, while its owner is there: ignored
  leap,       ///< a revision too far from the last one: ignored until it is repeated
  contradiction,  ///< does not fit to earlier datagrams: somebody lies in the name of this participant
  returned,       ///< a participant goes on after a goodbye in its name, or has its identifier back: known again
  stranger,       ///< the presence of a participant whose state is not known: named in Report::lacks for a while
};
inline constexpr std::size_t hearing_count = 16;
/// "own", "clash", ... Static storage.
[[nodiscard]] std::string_view to_string(Hearing hearing);

}  // namespace geminga::membership

#endif
