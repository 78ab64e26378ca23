// The team beyond the links of a participant: words that relays bring, and, if it is a relay, those that it passes on.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_AIR_BEYOND_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_AIR_BEYOND_HPP

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/participant/air/announcer.hpp"
#include "discovery/participant/air/presence.hpp"
#include "discovery/relaying/keeping.hpp"
#include "discovery/relaying/recall.hpp"
#include "discovery/relaying/relay.hpp"
#include "discovery/relaying/voucher.hpp"
#include "discovery/sealing/seal.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// A relay that has passed on the first word of a participant says its presence so long after it, and once more: those
/// who have missed the word learn whom they lack. All that come within this time share these presences.
inline constexpr base::Duration first_testimony_delay = std::chrono::milliseconds(120);
inline constexpr base::Duration last_testimony_delay = std::chrono::milliseconds(360);

/// Joins the library of relaying to the air of one participant. Every participant believes relays; only one with
/// TeamSettings::relay is one.
class Beyond {
 public:
  /// The parts that it reads and changes. All are borrowed for its life.
  struct Means {
    const env::Env& env;
    const TeamSettings& settings;
    membership::NeighbourTable& table;
    sealing::Seal& seal;
    Announcer& announcer;
  };
  explicit Beyond(const Means& means);

  /// The word that a relay has wrapped, if it is to be heard; null otherwise. Valid until the next call. `is_believed`:
  /// a seal proves the relay, or the owner has named it.
  [[nodiscard]] const announcement::Announcement* unwrap(const announcement::Announcement& relayed, bool is_believed);
  /// The way on which that word came.
  [[nodiscard]] membership::Passage passage(const announcement::Announcement& relayed, const env::Interface& on) const;
  /// Takes in what a presence says of others: testimony of a relay, and for a relay doubts and lacks. `hearing` is the
  /// verdict of the table on it.
  void hear_presence(const announcement::Announcement& presence, const env::Interface& on, membership::Hearing hearing,
                     bool is_believed);

  /// The links on which a word that came in on `on` is to be passed on. Call before the neighbour table takes it in;
  /// the result is an argument of pass_on().
  using Links = std::vector<env::InterfaceIndex>;
  /// Of a word that was heard directly: `opened` is what the seal made of it.
  [[nodiscard]] Links links_for(const sealing::Opened& opened, const announcement::Announcement& said,
                                const env::Interface& on);
  /// Of a word that a relay has brought.
  [[nodiscard]] Links links_for(const announcement::Announcement& word, const env::Interface& on, bool is_sealed) const;
  /// Passes a word on that says `said`, and has bridges keep it, unless the table has refused it.
  void pass_on(const relaying::Word& word, const announcement::Announcement& said, const Links& links,
               membership::Hearing hearing);

  /// Takes in a frame of a bridge that the owner has named, on this interface.
  void hear_frame(std::span<const std::byte> datagram, const env::Interface& on);
  /// The kept words of those whom we do not know and for whom this presence testifies, to be heard as if its sender
  /// said them; `session` is the proved one that has said it.
  [[nodiscard]] std::vector<announcement::Announcement> recall(const announcement::Announcement& presence,
                                                               sealing::Session session, membership::Hearing hearing);
  /// Takes in that a participant is gone.
  void forget(ParticipantId participant) {
    if (keeping_) keeping_->look_at(participant);
  }

  /// The testimony of our presence on this interface about those who are not heard there.
  [[nodiscard]] std::vector<announcement::Behind> behind(const env::Interface& on) const;
  /// Says what is due, by the end of an event.
  void proceed();
  /// When proceed() has something to do, or base::never.
  [[nodiscard]] base::Instant due() const {
    return relay_ ? std::min({relay_->due(), keeping_->due(), testimony_due_}) : base::never;
  }

  [[nodiscard]] bool is_relay() const { return relay_.has_value(); }
  /// Each reason for which words were not believed or not passed on, and how many were not.
  [[nodiscard]] std::vector<std::pair<std::string_view, std::uint64_t>> refusals() const;
  /// Words that were passed on, counted once for each link.
  [[nodiscard]] std::uint64_t words() const { return relay_ ? relay_->words() : 0; }
  /// Words that were handed to bridges to be kept, and participants that we know by kept words.
  [[nodiscard]] std::uint64_t kept() const { return kept_; }
  [[nodiscard]] std::uint64_t recalled() const { return recalled_; }

 private:
  /// Whether a seal vouches for what we say. Without one only hosts that name us believe it.
  [[nodiscard]] bool seals() const { return means_.seal.policy().mode > sealing::Mode::prepared; }
  /// A way through these relays, the last of which speaks on that interface.
  [[nodiscard]] membership::Passage passage(std::vector<ParticipantId> through, const env::Interface& on) const;
  void hear_doubts(const std::vector<ParticipantId>& doubts, env::InterfaceIndex link);
  void say(env::InterfaceIndex link, const announcement::Announcement& relayed);
  /// Hands the words of one participant to the bridge on a link.
  void keep(const relaying::Keeping::Errand& errand);
  void keep_what_is_due();

  Means means_;
  relaying::Voucher voucher_;
  relaying::Recall recall_;
  std::optional<relaying::Relay> relay_;
  std::optional<relaying::Keeping> keeping_;  ///< of a relay
  std::uint64_t kept_ = 0;
  std::uint64_t recalled_ = 0;
  base::Instant testimony_due_ = base::never;  ///< of a presence that names those who are new behind us
  base::Instant last_testimony_{};             ///< when the last of these is due
};

}  // namespace geminga::participant

#endif
