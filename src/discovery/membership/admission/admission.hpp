// The places for participants: who gets one when more participants are heard than there are places.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_ADMISSION_ADMISSION_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_ADMISSION_ADMISSION_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/admission/standing.hpp"
#include "discovery/membership/admission/waiting_list.hpp"

namespace geminga::membership {

/// Shares the places out among source addresses, and those of one address among its participants by their standing.
/// While there are places enough, members are not ordered, and a member costs its entry alone. The first query of the
/// order sorts all members; from then on each call costs logarithmic time, and a participant that was heard gets its
/// new position at the next query. Deterministic for its secret and its calls.
class Admission {
 public:
  /// A participant that has a place.
  struct Member {
    ParticipantId id{};
    std::string source;
    Standing standing;
    Standing filed;  ///< the standing by which it is in order
    bool is_seasoned = false;
    bool is_moved = false;    ///< `standing` is newer than `filed`
    std::uint64_t added = 0;  ///< its number among all that ever had a place
  };

  void set_secret(std::uint64_t secret) { waiting_.set_secret(secret); }

  /// The reference stays valid until the member is removed.
  Member& add(ParticipantId id, const std::string& source, const Standing& standing);
  void update(Member& member, const Standing& standing);
  void remove(ParticipantId id);
  /// Remembers a participant that was removed for a newcomer and may come back.
  void remember(ParticipantId id, announcement::BootNonce boot, std::uint64_t sequence, const Standing& standing) {
    waiting_.put(id, boot, sequence, standing);
  }
  /// Whether it was heard for seasoned_after and is one of the max_seasoned_per_source of its source.
  [[nodiscard]] bool is_seasoned(ParticipantId id) const;
  /// The members that are not seasoned, at most so many: those that were added last, the last one first. Looks at every
  /// member.
  [[nodiscard]] std::vector<ParticipantId> newest_unseasoned(std::size_t most) const;
  /// How many members are seasoned.
  [[nodiscard]] std::size_t seasoned() const { return seasoned_; }

  /// Which member gives its place to an unknown newcomer, and the standing of the newcomer as far as it is known.
  struct Decision {
    std::optional<ParticipantId> gives_way;
    std::optional<Standing> standing;
  };
  [[nodiscard]] Decision decide(const announcement::Announcement& newcomer, std::string_view source, base::Instant now);
  /// Which member gives its place to a newcomer of known standing.
  [[nodiscard]] std::optional<ParticipantId> decide(std::string_view source, const Standing& standing,
                                                    base::Instant now);
  /// Which member gives its place back to a participant that lost its own by a false goodbye. If nobody else does, the
  /// member that was added last gives way, since only the lie made its place free. Looks at every member.
  [[nodiscard]] std::optional<ParticipantId> decide_return(std::string_view source, Standing standing,
                                                           base::Instant now);

 private:
  using Ranked = std::set<std::pair<base::Instant, ParticipantId>>;
  struct Share {
    std::size_t count = 0;
    Ranked unseasoned;  ///< by rank: the first gives way first
  };
  void insert(Member& member);
  void erase(const Member& member);
  /// Puts all members in order, if they are not yet.
  void order();
  /// Puts every member that was heard into its new order.
  void refile();
  [[nodiscard]] const Share* greediest() const;
  [[nodiscard]] std::optional<ParticipantId> from_greedier(std::string_view source) const;

  std::map<ParticipantId, Member> members_;
  std::map<std::string, Share, std::less<>> shares_;
  std::set<std::pair<std::size_t, std::string>> by_count_;  ///< sources with a member that may give way
  Ranked unseasoned_;                                       ///< those of all shares
  Ranked by_silence_;                                       ///< all, by the time of the last datagram
  std::vector<Member*> moved_;                              ///< those that are not in order
  bool is_ordered_ = false;  ///< whether shares_ and the sets have the members; without, they are empty
  std::map<std::string, std::size_t, std::less<>> seasoned_of_;  ///< by source
  std::size_t seasoned_ = 0;
  std::uint64_t added_ = 0;
  WaitingList waiting_;
};

}  // namespace geminga::membership

#endif
