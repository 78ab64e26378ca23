// Testimony about who heard whom: what we say of it, and what others say.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_WITNESSES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_WITNESSES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/witnesses/difference.hpp"
#include "discovery/membership/witnesses/pending_testimony.hpp"

namespace geminga::membership {

/// A participant that says for so many of its intervals that it has not heard us is deaf to us. At 50 % loss one in
/// thirty says so by chance, at 30 % one in four hundred.
inline constexpr int deaf_intervals = 4;
/// Before people are told of it, it has to say so for so many: at 30 % loss one in twenty thousand does by chance.
inline constexpr int surely_deaf_intervals = 12;

/// A testimony with the names of those that it is about.
struct NamedTestimony {
  base::Instant said{};
  std::vector<std::pair<ParticipantId, announcement::HeardWithin>> heard;  ///< ascending, without the witness itself
};

/// Testimony names nobody: its bits have a meaning only if both sides know the same participants, which a fold of them
/// and of the revisions of their states shows (ANNOUNCEMENT.md, "Witnesses"). A testimony about thousands is copied and
/// touches no record; what was said of a participant is looked up at its deadline.
class Witnesses {
 public:
  void set_self(ParticipantId id, announcement::BootNonce boot);
  /// Adds or removes a known participant.
  void add(ParticipantId id, announcement::BootNonce boot);
  void remove(ParticipantId id);
  /// Tells when we last heard a known participant ourselves, its interval, and the last revision of its state that we
  /// have in whole; 0: none.
  void update(ParticipantId id, base::Instant heard, base::Duration interval, std::uint64_t revision = 0);
  /// Tells the revision of our own state.
  void set_revision(std::uint64_t revision);

  /// Does not testify by what we hear until then: we were not awake, and it may have been said long before.
  void distrust_until(base::Instant until) { distrusted_until_ = until; }
  /// Whether we testify that we have heard a known participant within its interval.
  [[nodiscard]] bool has_heard(ParticipantId id, base::Instant now) const;
  /// Our testimony: how lately we have heard each known participant.
  [[nodiscard]] announcement::Witness say(base::Instant now) const;
  /// Takes in which participants and revisions a known one knows, and returns what explains that it knows others than
  /// we do. Only differences that arose within two of its intervals count: participants that never hear each other need
  /// not be told of it again and again.
  Difference compare(const announcement::Announcement& presence, base::Instant now);
  /// Whether the last fold that we heard differs from ours in an unclear way: one side does not know all, and the
  /// unknown one may be ourselves.
  [[nodiscard]] bool is_unlike(base::Instant now) const { return now < unlike_until_ && unlike_fold_ != fold(); }
  /// Whether a known participant, which says this, has not heard us for one of our intervals, and has never said that
  /// it heard us since `since`. Then it may not know what we changed at that time.
  [[nodiscard]] bool misses_us(const announcement::Announcement& presence, base::Instant since, base::Duration interval,
                               base::Instant now);
  /// Takes in the testimony of a known participant; whether it is about the same participants as ours.
  bool hear(const announcement::Announcement& presence, base::Instant now);
  /// Whether a known participant, which we hear, has said for deaf_intervals of its own that it does not hear us.
  [[nodiscard]] bool is_deaf_to_us(ParticipantId id) const { return says_for(id, deaf_intervals); }
  /// The same for surely_deaf_intervals.
  [[nodiscard]] bool is_surely_deaf_to_us(ParticipantId id) const { return says_for(id, surely_deaf_intervals); }
  /// Whether a known participant, which hears us, has said for deaf_intervals of its own that it knows other
  /// participants than we do.
  [[nodiscard]] bool knows_others(ParticipantId id) const;
  /// Whether any does. Looks at every participant.
  [[nodiscard]] bool anybody_knows_others() const;
  /// The latest instant at or after which somebody else has heard it; the beginning of time if nobody said so.
  [[nodiscard]] base::Instant seen(ParticipantId id) const;
  /// The last testimony of a participant, where it is about the participants that are known at present. O(these).
  [[nodiscard]] std::optional<NamedTestimony> last_word(ParticipantId witness) const;
  /// How many testimonies of participants other than itself were heard within `interval`, or within the interval before
  /// it if those are more; at most enough_witnesses.
  [[nodiscard]] std::size_t words(ParticipantId id, base::Instant now, base::Duration interval) const;

 private:
  /// A thing that a participant says in all its presences: when it began to, and when it last did; never: it does not.
  struct Saying {
    base::Instant since = base::never;
    base::Instant until = base::never;
    void note(bool is_said, base::Instant now);
    [[nodiscard]] bool lasts(base::Duration time) const { return since != base::never && until - since >= time; }
  };
  struct Member {
    announcement::BootNonce boot{};
    std::uint64_t revision = 0;
    base::Duration interval{};
    base::Instant heard;           ///< by us
    base::Instant seen;            ///< by others
    std::uint16_t said_fold = 0;   ///< of the participants that it knows
    base::Instant fold_changed{};  ///< when it first said so
    base::Instant heard_us{};      ///< it heard us then or later
    Saying is_deaf{};              ///< that it has not heard us
    Saying knows_others{};         ///< that it knows other participants than we do
    announcement::HeardList said;  ///< its last testimony
    base::Instant said_at{};
    std::uint64_t said_places = 0;  ///< the places that it is about; 0: it has said nothing
  };
  struct Word {
    ParticipantId from{};
    base::Instant at;
  };
  [[nodiscard]] Folded folded(std::size_t place) const {
    return {.id = ids_[place], .boot = others_[place].boot, .revision = others_[place].revision};
  }
  [[nodiscard]] bool says_for(ParticipantId id, int intervals) const;
  [[nodiscard]] announcement::HeardWithin testimony(const Member& member, base::Instant now) const;
  /// Whether a testimony is about the same participants, so that each place has its meaning.
  [[nodiscard]] bool is_of_same(const announcement::Announcement& presence) const;
  /// Its place among the others, or the place that it would get.
  [[nodiscard]] std::size_t place_of(ParticipantId id) const;
  [[nodiscard]] bool is_at(std::size_t place, ParticipantId id) const {
    return place < ids_.size() && ids_[place] == id;
  }
  /// Reads what is pending, before places or intervals change.
  void settle();
  /// Adapts the places to the participants that are known.
  void begin_anew();
  [[nodiscard]] std::uint16_t fold() const;
  /// The fold of a known participant less ours, as if we knew the revision that it says of itself.
  [[nodiscard]] std::uint16_t difference(const announcement::Announcement& presence) const;
  [[nodiscard]] Difference explain(const announcement::Announcement& presence) const;
  /// Takes in what a known participant says of us.
  void hear_of_us(const announcement::Announcement& presence, base::Instant now);

  Folded self_;
  std::uint16_t others_fold_ = 0;
  std::vector<ParticipantId> ids_;  ///< of the others, ascending
  std::vector<Member> others_;      ///< in the same order
  std::size_t own_place_ = 0;       ///< among them
  std::uint64_t places_ = 0;        ///< counts the changes of places
  PendingTestimony pending_;
  std::uint16_t said_fold_ = 0;  ///< ours, when another one was last compared with it
  base::Instant fold_changed_{};
  std::uint16_t unlike_fold_ = 0;  ///< the last fold that differed in an unclear way
  base::Instant unlike_until_{};
  base::Instant distrusted_until_ = base::Instant::min();
  std::array<Word, 16>
      words_{};  ///< the last ones: enough that one participant that speaks often leaves room for others
  std::size_t next_word_ = 0;
};

}  // namespace geminga::membership

#endif
