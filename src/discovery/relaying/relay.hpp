// A relay's decisions: which words go to which links, and for whom it testifies there. ANNOUNCEMENT.md, "Relays".
#ifndef GEMINGA_DISCOVERY_RELAYING_RELAY_HPP
#define GEMINGA_DISCOVERY_RELAYING_RELAY_HPP

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbours.hpp"
#include "discovery/membership/schedule/token_bucket.hpp"
#include "discovery/relaying/speakers.hpp"
#include "env/env.hpp"

namespace geminga::relaying {

/// Words that are passed on at once, and the time in which one more may follow: a team of a thousand that starts, and
/// 100 a second. A flood of a holder of the key costs the other links no more.
inline constexpr std::size_t words_capacity = 4096;
inline constexpr base::Duration word_refill_time = std::chrono::milliseconds(10);
/// Where so many datagrams are lost a word is said a second time, so long after the first.
inline constexpr double repeats_from_loss = 0.05;
inline constexpr base::Duration repeat_delay = std::chrono::milliseconds(6);

/// One number for both sides of a dual-stack interface: they are one link.
[[nodiscard]] constexpr env::InterfaceIndex link_of(const env::Interface& interface) {
  return interface.ipv6_side_of.value_or(interface.index);
}

/// The relay of one participant. It says nothing itself: its owner wraps and sends what it decides (Voucher). It keeps
/// no tree and no route: what it decides follows from the table of neighbours and from what other relays have said of
/// late.
class Relay {
 public:
  /// Borrows both for its life.
  Relay(const env::Env& env, const membership::Neighbours& neighbours) : env_(env), neighbours_(neighbours) {}

  /// The links on which a word of this participant is to be said that came in on `from`: all others on which it is not
  /// heard anyway, and for which no better relay speaks. `is_sealed`: without a seal only links to named peers count.
  /// To be asked before the table takes the word in.
  [[nodiscard]] std::vector<env::InterfaceIndex> links_for(ParticipantId participant, env::InterfaceIndex from,
                                                           ParticipantId self, bool is_sealed) const;

  /// Whether we speak for a participant on a link.
  [[nodiscard]] bool speaks_for(const membership::Reach& reach, env::InterfaceIndex link, ParticipantId self) const;

  /// Takes one word of the budget; false: it is used up.
  [[nodiscard]] bool may_pass();

  /// The testimony of our presence on this link about those who are not heard there, in ascending order. Cost: all
  /// participants.
  [[nodiscard]] std::vector<announcement::Behind> behind(env::InterfaceIndex link, ParticipantId self) const;

  /// Takes in that another relay has spoken for a participant on a link, `hops` of them away from those there.
  void hear_speaker(env::InterfaceIndex link, ParticipantId participant, const Distance& speaker,
                    base::Duration interval) {
    speakers_.hear({link, participant}, speaker, interval, env_.now());
  }
  /// Takes in the testimony of another relay on a link.
  void hear_behind(env::InterfaceIndex link, const announcement::Announcement& presence, base::Duration interval);
  /// Takes in whom somebody on a link doubts: we answer for those that we hear, whoever speaks for them otherwise.
  void hear_doubts(env::InterfaceIndex link, const std::vector<ParticipantId>& doubts);
  /// Those of the participants whom somebody on this link lacks or doubts that are heard only elsewhere: we ask for
  /// them.
  [[nodiscard]] std::vector<ParticipantId> elsewhere(env::InterfaceIndex link,
                                                     const std::vector<ParticipantId>& named) const;

  /// A word that is to be said once more.
  struct Repeat {
    base::Instant at;
    env::InterfaceIndex link{};
    announcement::Announcement relayed;
  };
  /// Plans the second copy of a word where the air is bad.
  void repeat(env::InterfaceIndex link, const announcement::Announcement& relayed);
  [[nodiscard]] std::optional<Repeat> take_repeat();
  /// Whether another relay has fallen silent, so that our testimony is due at once.
  [[nodiscard]] bool takes_over() { return speakers_.take_silent(env_.now()); }
  /// When take_repeat() or takes_over() has something to do.
  [[nodiscard]] base::Instant due() const;

  [[nodiscard]] std::uint64_t words() const { return words_; }
  /// Counts a word that was passed on, on one link.
  void count() { ++words_; }

 private:
  /// Whether a participant is heard on this link: itself, or through another relay there.
  [[nodiscard]] bool is_heard_on(const membership::Reach& reach, env::InterfaceIndex link) const;
  [[nodiscard]] env::InterfaceIndex link_of(env::InterfaceIndex interface) const;

  const env::Env& env_;
  const membership::Neighbours& neighbours_;
  Speakers speakers_;
  std::deque<Repeat> repeats_;  ///< by time
  membership::TokenBucket budget_{words_capacity, word_refill_time};
  std::uint64_t words_ = 0;
};

}  // namespace geminga::relaying

#endif
