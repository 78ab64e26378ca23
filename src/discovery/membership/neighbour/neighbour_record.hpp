// Everything that is kept of one participant, and the rules for what is believed when somebody lies in its name.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_RECORD_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_NEIGHBOUR_RECORD_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/rare.hpp"
#include "base/time.hpp"
#include "discovery/membership/admission/standing.hpp"
#include "discovery/membership/neighbour/announced_interval.hpp"
#include "discovery/membership/neighbour/arrival.hpp"
#include "discovery/membership/neighbour/believed_header.hpp"
#include "discovery/membership/neighbour/change.hpp"
#include "discovery/membership/neighbour/contest.hpp"
#include "discovery/membership/neighbour/hearing.hpp"
#include "discovery/membership/neighbour/known_state.hpp"
#include "discovery/membership/neighbour/last_passage.hpp"
#include "discovery/membership/neighbour/life_signs.hpp"
#include "discovery/membership/neighbour/neighbour.hpp"
#include "discovery/membership/neighbour/neighbour_services.hpp"
#include "discovery/membership/neighbour/neighbour_ways.hpp"
#include "discovery/membership/neighbour/origin.hpp"
#include "discovery/membership/neighbour/reach.hpp"
#include "discovery/membership/neighbour/service_room.hpp"
#include "discovery/membership/schedule/search.hpp"
#include "discovery/membership/witnesses/witnesses.hpp"

namespace geminga::membership {

/// The time for which a goodbye is remembered, so that older datagrams that arrive after it do not bring the
/// participant back.
inline constexpr base::Duration goodbye_memory = std::chrono::seconds(10);

/// One incarnation of a participant: one boot nonce. Each call appends its changes to the list that it is given.
///
/// A sender numbers its datagrams in rising order, and its revision never falls. If two datagrams contradict each
/// other, one of them is forged, but it is not known which. From then on the participant is *contested*, until no
/// datagram has contradicted another for `hold_intervals`. Changes within that time are undone. What was believed stays
/// believed while it is repeated, new services are accepted, and a service that is not repeated lapses. So a forged
/// datagram has effect only until the participant sends its next one, and further forged ones change nothing that the
/// participant repeats.
class NeighbourRecord {
 public:
  /// `since`: when it came to own its identifier. Borrows the account of room for services and the witnesses; both must
  /// outlive it.
  NeighbourRecord(const announcement::Announcement& first, const Arrival& arrival, Turn since, ServiceRoom& room,
                  const Witnesses& witnesses);
  NeighbourRecord(const NeighbourRecord&) = delete;
  NeighbourRecord& operator=(const NeighbourRecord&) = delete;

  [[nodiscard]] const Origin& origin() const { return origin_; }
  [[nodiscard]] const Header& header() const { return header_.value(); }
  /// Whether the header has changed since the last call.
  [[nodiscard]] bool take_anew() { return header_.take_anew(); }
  /// When it was heard, and until when it is believed to live.
  [[nodiscard]] const LifeSigns& signs() const { return signs_; }
  [[nodiscard]] const NeighbourWays& ways() const { return ways_; }
  [[nodiscard]] const Standing& standing() const { return standing_; }
  void set_standing(const Standing& standing) { standing_ = standing; }

  /// Takes in a state, change or presence of this incarnation. Returns `known`, or why it was ignored (copied,
  /// elsewhere, leap) or doubted (contradiction).
  Hearing hear(const announcement::Announcement& announcement, const Arrival& arrival, std::vector<Change>& changes);
  /// Takes in a goodbye of this incarnation. Returns Hearing::goodbye if it ends the incarnation at once. A goodbye of
  /// a contested participant may be forged. It only shortens the deadline, so that a participant that goes on sending
  /// stays.
  [[nodiscard]] Hearing hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival);
  /// Remembers the number of a goodbye on its way. A datagram with a higher number was sent after it.
  void note_goodbye(const announcement::Announcement& announcement, const Arrival& arrival) {
    ways_.note_goodbye(announcement, arrival);
  }
  /// Whether a datagram is new and from the address that its way belongs to.
  [[nodiscard]] bool is_bound(const announcement::Announcement& announcement, const Arrival& arrival) const {
    const auto* way = ways_.find_bound(announcement, arrival);
    return way == nullptr ? ways_.all().empty() && arrival.source == origin_.source : !way->has(announcement.sequence);
  }
  /// The time for which it is remembered after it seemed to leave: long enough to hear it again if the goodbye was
  /// forged.
  [[nodiscard]] base::Duration memory(base::Instant now) const;
  /// Brings it back after a forged goodbye. Appends all that is known of it as changes.
  void come_back(base::Instant now, std::vector<Change>& changes);
  /// Takes in that another incarnation sends under this identifier. Returns whether this one gives way, because it has
  /// been silent for too long.
  [[nodiscard]] bool yields_to(const announcement::Announcement& rival, const Arrival& arrival);

  /// Takes in the testimony of a relay: this participant sent something `passage.age` ago, and its state has this
  /// revision (0: not stated). Has no effect while it is heard directly or is contested.
  void hear_of(const Passage& passage, std::uint64_t revision, base::Instant now);
  /// Whether this host itself has heard it within hold_intervals.
  [[nodiscard]] bool is_heard_directly(base::Instant now) const {
    return passage_.is_direct(announcement::hold_intervals * lasting_interval(now), now);
  }
  /// Its ways, for a relay.
  [[nodiscard]] Reach reach() const;

  /// Checks whether its address can be reached from here, if it is heard only through relays or by unicast.
  void judge_reach(const JudgeReach& judge, std::vector<Change>& changes);

  /// Looks up what others have testified about it.
  void ask_witnesses(base::Instant now);
  /// Takes in that a participant of its name claims an identifier or is new, at the address of one of its ways:
  /// probably its next incarnation. This one is doubted, with a near deadline, until it gives a sign of life. Has an
  /// effect once in contest_intervals.
  void succeed(std::uint32_t lasting, const Arrival& arrival);
  /// Takes in that this host's presence has asked it for a sign of life.
  void ask(base::Instant now) { signs_.ask(now, answer_time(known_loss())); }
  /// Takes over the losses on one way before the same incarnation was given up (FormerLosses).
  void go_on_from(env::InterfaceIndex interface, std::uint32_t link, const LossWindow& former) {
    ways_.go_on_from(interface, link, former);
  }
  void set_succeeded(std::optional<base::Instant> succeeded) { signs_.set_succeeded(succeeded); }
  /// Whether it is looked for after its deadline, since it may only be out of reach.
  [[nodiscard]] bool is_sought(base::Instant now) const {
    const auto succeeded = signs_.succeeded();
    const bool has_next_incarnation = succeeded && now - *succeeded < announcement::contest_intervals * interval();
    return standing_.span() >= sought_after && !has_next_incarnation;
  }
  /// When a datagram last proved that a complete revision still holds.
  [[nodiscard]] base::Instant affirmed() const { return known_.affirmed(); }
  /// The time between two of its announcements, as far as it is believed: no single datagram makes deadlines shorter or
  /// longer.
  [[nodiscard]] base::Duration lasting_interval(base::Instant now) const;
  /// Takes in that somebody else seems to have a newer state of it: it is asked for until the participant speaks.
  void suspect() { known_.set_suspected(known_.is_complete() && !contest_.is_open()); }
  /// The last revision that is known in whole, or is believed while it is contested; 0: none.
  [[nodiscard]] std::uint64_t held_revision() const { return contest_.is_open() ? known_.revision() : known_.held(); }
  /// Whether its newest state is unknown or uncertain, or is unknown for one of its ways, or had no room.
  [[nodiscard]] bool is_lacking() const { return is_state_lacking() || services_.is_short(); }
  /// Whether its newest state is to be asked for at once. While forged datagrams go on, the next presence is early
  /// enough.
  [[nodiscard]] bool is_missed(base::Instant now) const {
    return is_state_lacking() && (!contest_.is_open() || now - contest_.since() < urgent_time);
  }
  /// Asks for a sign of life at once.
  void doubt() { signs_.doubt(); }
  /// Moves every deadline before `until` to `until`.
  void postpone(base::Instant until);

  /// Drops ways and services that have their deadline at or before `now`. The table drops the participant itself.
  void expire(base::Instant now, std::vector<Change>& changes);
  void forget_interface(env::InterfaceIndex interface, std::vector<Change>& changes);

  /// When expire() has something to do, or a little before. Its cost is constant.
  [[nodiscard]] base::Instant next_deadline() const;
  [[nodiscard]] Neighbour snapshot() const;
  [[nodiscard]] NeighbourServices& services() { return services_; }
  [[nodiscard]] const NeighbourServices& services() const { return services_; }

 private:
  /// The time after the first lie in which its state is asked for at once.
  static constexpr base::Duration urgent_time = std::chrono::milliseconds(500);

  /// Another incarnation that wants this identifier.
  struct Rival {
    announcement::BootNonce boot{};
    std::string source;
    std::uint64_t sequence = 0;
  };

  [[nodiscard]] bool is_state_lacking() const {
    return !known_.is_complete() || known_.is_suspected() || !std::ranges::all_of(ways_.all(), &NeighbourWay::is_said);
  }
  /// The time between two of its announcements, as it announces it.
  [[nodiscard]] base::Duration interval() const { return interval_.value(); }
  /// The relays on the way to it; null: it was last heard directly.
  [[nodiscard]] const Passage* passage() const { return passage_.relayed(); }
  [[nodiscard]] NeighbourWay::Order order(const NeighbourWay& way, const announcement::Announcement& announcement,
                                          const Arrival& arrival) const;
  void take_in(NeighbourWay& way, const announcement::Announcement& announcement, const Arrival& arrival,
               std::vector<Change>& changes);
  /// Takes in what a state says of the participant and the way.
  void take_state(NeighbourWay& way, const announcement::Announcement& announcement, const Arrival& arrival);
  /// Takes in a change; beyond the services that it names it says what a presence says.
  void take_change(NeighbourWay& way, const announcement::Announcement& announcement, base::Instant now,
                   std::vector<Change>& changes);
  void take_interval(const announcement::Announcement& announcement, base::Instant now);
  void take_revision(NeighbourWay& way, const announcement::Announcement& announcement, base::Instant now,
                     std::vector<Change>& changes);
  /// Begins or prolongs the contest after a contradiction.
  void contest(base::Instant now, std::vector<Change>& changes);
  void end_contest(base::Instant now);
  /// Takes in that a way has an address that it did not have.
  void meet(NeighbourWay& way, const Arrival& arrival);
  /// Whether a state shows that its source is an address of its sender, because the sender moves there: from now on its
  /// services have that address. So a forger cannot keep the services of another participant alive at their old
  /// address.
  [[nodiscard]] bool introduces(const announcement::Announcement& state, const Arrival& arrival) const;
  void set_deadlines(NeighbourWay& way, bool is_sign, base::Instant now);
  /// Chooses the address for services without one.
  void choose_address();

  /// The time for which a statement counts as a contradiction of another one. An interval counts up to the time for
  /// which the participant is known.
  [[nodiscard]] base::Duration hold(base::Instant now) const;
  [[nodiscard]] Moment moment(base::Instant now) const;
  /// The moment at which it was heard.
  [[nodiscard]] Moment moment_of_hearing(base::Instant now) const;
  [[nodiscard]] Reception reception(base::Instant now) const;
  /// The loss of its best way, or a bad one if too few datagrams were heard to tell.
  [[nodiscard]] double known_loss() const;

  const Origin origin_;
  bool has_spoken_ = false;
  Standing standing_;
  BelievedHeader header_;
  AnnouncedInterval interval_;  ///< the interval that it keeps: that of the header, stretched
  LifeSigns signs_;
  KnownState known_;
  Contest contest_;
  base::Instant next_service_deadline_ = base::never;  ///< while not complete: no service has an earlier deadline
  base::Rare<Rival> rival_;
  LastPassage passage_;
  Reachability reachability_ = Reachability::reachable;
  NeighbourWays ways_;
  NeighbourServices services_;
  const Witnesses& witnesses_;
};

}  // namespace geminga::membership

#endif
