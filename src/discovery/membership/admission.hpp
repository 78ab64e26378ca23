// Who has one of the places for participants when there are more who want one.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_ADMISSION_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_ADMISSION_HPP

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
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/standing.hpp"

namespace geminga::membership {

/// Strangers that were heard while all places were taken: at most max_waiting. They lie in buckets of four; in a full
/// bucket the one of the lowest rank gives way. Uses no memory before the first.
class WaitingList {
 public:
  /// Random bits, so that nobody can aim at the place of another.
  void set_secret(std::uint64_t secret) { secret_ = secret; }
  /// Hears a stranger. Gives its standing from the second time on, nothing the first time.
  [[nodiscard]] std::optional<Standing> hear(const announcement::Announcement& announcement, base::Instant now);
  /// Puts in somebody who had to give its place away, so that it keeps its standing.
  void put(ParticipantId id, announcement::BootNonce boot, std::uint64_t sequence, const Standing& standing);

 private:
  struct Stranger {
    std::uint64_t key = 0;
    std::uint64_t sequence = 0;
    Standing standing;
  };
  [[nodiscard]] std::uint64_t key_of(ParticipantId id, announcement::BootNonce boot) const;
  /// The stranger with this key, or the place that it gets.
  [[nodiscard]] Stranger& place_of(std::uint64_t key);
  std::uint64_t secret_ = 0;
  std::vector<Stranger> strangers_;
};

/// Shares the places out among source addresses, and those of one address among its participants by their standing.
/// Costs of all calls are logarithmic; who was heard is put in its new order when somebody asks for that, and so costs
/// next to nothing while there are places enough. Deterministic for its secret and its calls.
class Admission {
 public:
  /// One that is taken.
  struct Place {
    ParticipantId id{};
    std::string source;
    Standing standing;
    Standing filed;  ///< the one by which it is in order
    bool is_seasoned = false;
    bool is_moved = false;    ///< it has another standing since then
    std::uint64_t added = 0;  ///< counts all that ever had a place
  };

  void set_secret(std::uint64_t secret) { waiting_.set_secret(secret); }

  /// The place stays where it is until it is removed.
  Place& add(ParticipantId id, const std::string& source, const Standing& standing);
  void update(Place& place, const Standing& standing);
  void remove(ParticipantId id);
  /// Remembers somebody who was removed for a newcomer, and may come back.
  void remember(ParticipantId id, announcement::BootNonce boot, std::uint64_t sequence, const Standing& standing) {
    waiting_.put(id, boot, sequence, standing);
  }
  /// Whether it was heard for seasoned_after and has one of its source's max_seasoned_per_source.
  [[nodiscard]] bool is_seasoned(ParticipantId id) const;
  /// How many there are of those.
  [[nodiscard]] std::size_t seasoned() const { return places_.size() - unseasoned_.size(); }

  /// Who gives its place to a newcomer that nobody knows yet, and what is known of the newcomer.
  struct Decision {
    std::optional<ParticipantId> gives_way;
    std::optional<Standing> standing;
  };
  [[nodiscard]] Decision decide(const announcement::Announcement& newcomer, const Arrival& arrival);
  /// The same for somebody of whom this standing is known.
  [[nodiscard]] std::optional<ParticipantId> decide(std::string_view source, const Standing& standing,
                                                    base::Instant now);
  /// The same for somebody who had a place until somebody else said that it was gone. If all else fails, whoever was
  /// added last gives way, since its place was free only because of a lie. Looks at every place.
  [[nodiscard]] std::optional<ParticipantId> decide_return(std::string_view source, Standing standing,
                                                           base::Instant now);

 private:
  using Ranked = std::set<std::pair<base::Instant, ParticipantId>>;
  struct Share {
    std::size_t count = 0;
    std::size_t seasoned = 0;
    Ranked unseasoned;  ///< by rank: the first gives way first
  };
  void insert(Place& place);
  void erase(const Place& place);
  /// Puts all in order who were heard.
  void refile();
  [[nodiscard]] const Share* greediest() const;
  [[nodiscard]] std::optional<ParticipantId> from_greedier(std::string_view source) const;

  std::map<ParticipantId, Place> places_;
  std::map<std::string, Share, std::less<>> shares_;
  std::set<std::pair<std::size_t, std::string>> by_count_;  ///< sources with somebody who may give way
  Ranked unseasoned_;                                       ///< those of all shares
  Ranked by_silence_;                                       ///< all, by when they were last heard
  std::vector<Place*> moved_;                               ///< which are not in order
  std::uint64_t added_ = 0;
  WaitingList waiting_;
};

}  // namespace geminga::membership

#endif
