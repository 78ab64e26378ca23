// What a heard announcement was taken for.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_HEARING_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_HEARING_HPP

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace geminga::membership {

/// How the table has taken an announcement.
enum class Hearing : std::uint8_t {
  own,          ///< our own datagram, come back
  clash,        ///< our identifier from another boot nonce: feed IdentifierClaim::conflict() with its kind
  claim,        ///< somebody claims an identifier: it is new here, so Schedule::newcomer()
  newcomer,     ///< a participant that was not known, or has restarted: Schedule::newcomer()
  known,        ///< a known participant's; changes may follow
  goodbye,      ///< a known participant has left
  other_group,  ///< not for us
  stale,        ///< from before its sender's goodbye or the loss of its identifier, or the goodbye of somebody unknown
  full,         ///< an unknown participant, while all places are taken by somebody with a better right to them
  copied,       ///< a datagram that was heard, sent again from another source address: ignored
  elsewhere,    ///< in the name of a known participant from another source address: ignored until it is repeated
  rival,        ///< a known identifier from another boot nonce, while its owner is there: ignored
  leap,         ///< a revision too far from the one before it: ignored until it is repeated
  contradiction,  ///< does not fit to what was heard: somebody lies in the name of this participant
  returned,       ///< a participant goes on after a goodbye in its name, or has its identifier back: it is known again
  stranger,       ///< the presence of somebody whose state is not known: it is named in Report::lacks for a while
};
inline constexpr std::size_t hearing_count = 16;
/// "own", "clash", ... Static storage.
[[nodiscard]] std::string_view to_string(Hearing hearing);

}  // namespace geminga::membership

#endif
