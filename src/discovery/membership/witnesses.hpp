// Who has heard whom: what we say of it, and what others say.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_WITNESSES_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/pending_words.hpp"

namespace geminga::membership {

/// Who says for so many of its intervals that it has not heard us is deaf to us: at 50 % loss one in thirty says so by
/// chance, at 30 % one in four hundred.
inline constexpr int deaf_intervals = 4;

/// Who is unknown to somebody else, of those whom we know and ourselves: what his fold differs by from ours tells if it
/// is one or two.
enum class Unknown : std::uint8_t {
  nobody,   ///< or he says so for long
  us,       ///< and perhaps another one
  others,   ///< who can tell by the same rule
  unclear,  ///< more than two, or he knows somebody whom we do not
};
/// Two are told apart among so many others at most: their 120 pairs are one of a fold's 65536 values by chance with
/// .002, and then something is said that nobody needed.
inline constexpr std::size_t max_told_apart = 15;

/// The words of witnesses name nobody: both sides must know the same participants, which a fold of them shows
/// (ANNOUNCEMENT.md, "Witnesses"). A word of thousands is copied, and touches nobody's record: what was said of
/// somebody is looked up when its deadline comes.
class Witnesses {
 public:
  void set_self(ParticipantId id, announcement::BootNonce boot);
  /// Somebody is known from now on; is not known any more.
  void add(ParticipantId id, announcement::BootNonce boot);
  void remove(ParticipantId id);
  /// When we last heard somebody known ourselves, and its interval.
  void update(ParticipantId id, base::Instant heard, base::Duration interval);

  /// What we have heard until then may have been said long before: we were not awake. We do not testify by it.
  void distrust_until(base::Instant until) { distrusted_until_ = until; }
  /// Whether we testify that we have heard somebody known within its interval.
  [[nodiscard]] bool has_heard(ParticipantId id, base::Instant now) const;
  /// How lately we have heard each of them.
  [[nodiscard]] announcement::Witness say(base::Instant now) const;
  /// Takes in of whom somebody known speaks, and says whom he does not know, where he or we have come to know others
  /// within two of his intervals. Some never hear each other, and need not be told again and again.
  Unknown compare(const announcement::Announcement& presence, base::Instant now);
  /// Whether the last word of somebody was of other ones than ours, and it is unclear of whom: one of us does not know
  /// all, and it may be ourselves.
  [[nodiscard]] bool is_unlike(base::Instant now) const { return now < unlike_until_ && unlike_fold_ != fold(); }
  /// Whether somebody known, who says this, has not heard us for one of our intervals, and has never said that it has
  /// heard us since `since`: so it may not know what we have changed then.
  [[nodiscard]] bool misses_us(const announcement::Announcement& presence, base::Instant since, base::Duration interval,
                               base::Instant now);
  /// Takes in what somebody known says of them; whether it speaks of the same ones.
  bool hear(const announcement::Announcement& presence, base::Instant now);
  /// Whether somebody known, whom we hear, has said for deaf_intervals of its own that it does not hear us.
  [[nodiscard]] bool is_deaf_to_us(ParticipantId id) const;
  /// The latest instant at or after which somebody else has heard it; the beginning of time: nobody said so.
  [[nodiscard]] base::Instant seen(ParticipantId id) const;
  /// How many words of others than itself were heard within `interval`, or within the one before it where that is more;
  /// at most enough_witnesses.
  [[nodiscard]] std::size_t words(ParticipantId id, base::Instant now, base::Duration interval) const;

 private:
  struct Member {
    announcement::BootNonce boot{};
    base::Duration interval{};
    base::Instant heard;           ///< by us
    base::Instant seen;            ///< by others
    std::uint16_t said_fold = 0;   ///< of those that it knows
    base::Instant fold_changed{};  ///< when it first said so
    base::Instant heard_us{};      ///< it has, then or later
    /// When it began to say that it has not heard us, and when it last said so; never: it does not.
    base::Instant deaf_since = base::never;
    base::Instant deaf_until = base::never;
  };
  struct Word {
    ParticipantId from{};
    base::Instant at;
  };
  [[nodiscard]] announcement::HeardWithin testimony(const Member& member, base::Instant now) const;
  /// Whether a word is about the same ones, so that each place has its meaning.
  [[nodiscard]] bool is_of_same(const announcement::Witness& witness) const;
  /// Its place among the others, or the one that it would get.
  [[nodiscard]] std::size_t place_of(ParticipantId id) const;
  [[nodiscard]] bool is_at(std::size_t place, ParticipantId id) const {
    return place < ids_.size() && ids_[place] == id;
  }
  /// Reads what is pending, since places or intervals change.
  void settle();
  /// The others are not the same ones any more.
  void begin_anew();
  [[nodiscard]] std::uint16_t fold() const;
  [[nodiscard]] Unknown explain(std::uint16_t difference) const;
  /// Takes in what somebody known says of us.
  void hear_of_us(const announcement::Announcement& presence, base::Instant now);

  ParticipantId self_{};
  std::uint64_t self_fold_ = 0;
  std::uint64_t others_fold_ = 0;
  std::vector<ParticipantId> ids_;  ///< of the others, ascending
  std::vector<Member> others_;      ///< in the same order
  std::size_t own_place_ = 0;       ///< among them
  PendingWords pending_;
  std::uint16_t said_fold_ = 0;  ///< ours, when somebody's was compared with it
  base::Instant fold_changed_{};
  std::uint16_t unlike_fold_ = 0;  ///< of whom nobody knows what differs
  base::Instant unlike_until_{};
  base::Instant distrusted_until_ = base::Instant::min();
  std::array<Word, 16> words_{};  ///< the last ones; those of one participant that speaks often leave room for others'
  std::size_t next_word_ = 0;
};

}  // namespace geminga::membership

#endif
