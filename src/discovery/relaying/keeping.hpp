// The words that a relay hands to bridges that keep them on a server: SEALING.md, "Kept words".
#ifndef GEMINGA_DISCOVERY_RELAYING_KEEPING_HPP
#define GEMINGA_DISCOVERY_RELAYING_KEEPING_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbours.hpp"
#include "discovery/relaying/relay.hpp"
#include "discovery/relaying/voucher.hpp"
#include "discovery/relaying/word_chain.hpp"
#include "env/env.hpp"

namespace geminga::relaying {

/// A bridge says each second that it keeps words. One that was not heard for so long keeps none.
inline constexpr base::Duration keeper_time = std::chrono::milliseconds(3500);
/// A kept word is said again after this time, a third of the time after which a server forgets it.
inline constexpr base::Duration keep_again = std::chrono::seconds(20);
/// Participants that are handed over at once, and the pause behind them: a thousand take a third of a second.
inline constexpr int kept_at_once = 16;
inline constexpr base::Duration keeping_pause = std::chrono::milliseconds(5);
/// Participants that we do not speak for, and those whose state we have only in part, are looked at again after these
/// times.
inline constexpr base::Duration silent_again = std::chrono::seconds(5);
inline constexpr base::Duration partial_again = std::chrono::seconds(2);

/// Decides what is kept, and when; its owner seals and sends it. Of each participant the words that lead to its newest
/// state, as they were passed on.
class Keeping {
 public:
  /// Borrows all for its life.
  Keeping(const env::Env& env, const membership::Neighbours& neighbours, const Relay& relay)
      : env_(env), neighbours_(neighbours), relay_(relay) {}

  /// Takes in a sealed word that the table has taken in.
  void take(const announcement::Announcement& said, const Word& word);
  /// Takes in that the bridge on this link keeps words. In another life it is given everything.
  void hear_keeper(env::InterfaceIndex link, std::uint64_t life);
  /// Takes in that a participant is gone, or that we may speak for it from now on: it is looked at at once.
  void look_at(ParticipantId participant);
  void look_at_all();

  /// The thing to do about one participant on one link.
  struct Errand {
    enum class What : std::uint8_t {
      keep,  ///< hand its chain over
      drop,  ///< have it forgotten
      ask,   ///< ask it for its state, of which we have only a part
    };
    What what{};
    env::InterfaceIndex link{};
    ParticipantId participant{};
    const WordChain* chain = nullptr;  ///< with keep; valid until the next call
  };
  /// The next errand that is due. `self` is our identifier.
  [[nodiscard]] std::optional<Errand> next(ParticipantId self);
  /// When next() has something to do, or base::never.
  [[nodiscard]] base::Instant due() const;

 private:
  struct Turn {
    base::Instant at{};
    bool is_kept = false;
    bool was_partial = false;
  };
  struct Keeper {
    std::uint64_t life = 0;
    base::Instant until{};
    std::map<ParticipantId, Turn> turns;
    std::set<std::pair<base::Instant, ParticipantId>> agenda;  ///< the turns by time
  };
  static void set_turn(Keeper& keeper, ParticipantId participant, base::Instant at);
  /// The errand of the participant whose turn it is, if there is one.
  [[nodiscard]] std::optional<Errand> attend(env::InterfaceIndex link, Keeper& keeper, ParticipantId participant,
                                             ParticipantId self);

  const env::Env& env_;
  const membership::Neighbours& neighbours_;
  const Relay& relay_;
  std::map<ParticipantId, WordChain> chains_;
  std::map<env::InterfaceIndex, Keeper> keepers_;
  base::Instant paused_until_{};
  int left_ = kept_at_once;  ///< until the next pause
};

}  // namespace geminga::relaying

#endif
