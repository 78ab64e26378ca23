// Everything the neighbour table keeps of one participant, and which word counts when somebody lies in its name.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_RECORD_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_RECORD_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/time.hpp"
#include "discovery/membership/announced_interval.hpp"
#include "discovery/membership/life_signs.hpp"
#include "discovery/membership/neighbour_services.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/membership/neighbour_ways.hpp"
#include "discovery/membership/passed.hpp"
#include "discovery/membership/search.hpp"
#include "discovery/membership/service_room.hpp"
#include "discovery/membership/settled.hpp"
#include "discovery/membership/standing.hpp"
#include "discovery/membership/witnesses.hpp"

namespace geminga::membership {

/// One known participant: one life of it, that is one boot nonce. Appends what changes to the list it is given.
///
/// A sender numbers its datagrams in rising order and its revision never falls. Datagrams that do not fit together
/// prove that one of them is forged, and nothing tells which. From then on the participant is *contested* until all has
/// fitted for `hold_intervals`: what was changed within that time is undone, and what is believed stays believed as
/// long as it is repeated. New services are taken in; one that nobody speaks of any more lapses. So a lie in the name
/// of a participant lasts until it speaks, and the next lie does nothing to what it keeps saying.
class NeighbourRecord {
 public:
  /// `since`: when its identifier became its own. Borrows the room that its services take, and what others say of it.
  NeighbourRecord(const announcement::Announcement& first, const Arrival& arrival, Turn since, ServiceRoom& room,
                  const Witnesses& witnesses);
  NeighbourRecord(const NeighbourRecord&) = delete;
  NeighbourRecord& operator=(const NeighbourRecord&) = delete;

  [[nodiscard]] announcement::BootNonce boot() const { return boot_; }
  /// The source address that it was first heard from. Its place is counted against the share of that address.
  [[nodiscard]] const std::string& source() const { return source_; }
  /// When it was first heard under its identifier; a claim counts, too. Of several lives under one identifier the one
  /// that was heard first owns it.
  [[nodiscard]] Turn since() const { return since_; }
  [[nodiscard]] const Standing& standing() const { return standing_; }
  void set_standing(const Standing& standing) { standing_ = standing; }

  /// Takes in a state or the presence of this life. Says `known`, or why it was ignored (copied, elsewhere, leap) or
  /// doubted (contradiction).
  Hearing hear(const announcement::Announcement& announcement, const Arrival& arrival, std::vector<Change>& changes);
  /// Whether a goodbye of this life ends it at once. One of a contested participant only shortens its deadline, so that
  /// it stays if it goes on speaking.
  [[nodiscard]] Hearing hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival);
  /// A goodbye was heard on this way. A datagram with a higher number was sent after it.
  void note_goodbye(const announcement::Announcement& announcement, const Arrival& arrival);
  /// What a state proves of somebody who seemed to leave at `left`.
  enum class Proof : std::uint8_t {
    none,   ///< it is from elsewhere, or may be from before that
    echo,   ///< its number was heard before: it may be a copy
    alive,  ///< it was sent after that
  };
  [[nodiscard]] Proof proof(const announcement::Announcement& announcement, const Arrival& arrival, base::Instant left);
  /// Whether a datagram is a new one from the address that its way belongs to.
  [[nodiscard]] bool is_bound(const announcement::Announcement& announcement, const Arrival& arrival) const {
    const auto* way = ways_.find_bound(announcement, arrival);
    return way == nullptr ? ways_.all().empty() && arrival.source == source_ : !way->has(announcement.sequence);
  }
  /// For how long it is remembered when it seems to leave: long enough to hear it again if somebody has only lied about
  /// it.
  [[nodiscard]] base::Duration memory(base::Instant now) const;
  /// It is back: somebody has lied in its name, and all that is known of it is to be told again.
  void come_back(base::Instant now, std::vector<Change>& changes);
  /// Another life speaks under this identifier. Whether this one gives way, because it has been silent for too long.
  [[nodiscard]] bool yields_to(const announcement::Announcement& rival, const Arrival& arrival);

  /// Looks up what others have said of it.
  void ask_witnesses(base::Instant now);
  /// Somebody of its name claims an identifier, or is new, at the address of one of its ways: its own next life, if it
  /// does not show that it lives. Until then it is doubted, and its deadline is near. Once in contest_intervals at
  /// most.
  void succeed(std::uint32_t lasting, const Arrival& arrival);
  /// We say in a presence that we doubt it.
  void ask(base::Instant now) { life_.ask(now, answer_time(known_loss())); }
  [[nodiscard]] std::optional<base::Instant> succeeded() const { return life_.succeeded(); }
  void set_succeeded(std::optional<base::Instant> succeeded) { life_.set_succeeded(succeeded); }
  /// Its deadline has passed: whether it is looked for, since it may be out of reach only.
  [[nodiscard]] bool is_sought(base::Instant now) const {
    const auto succeeded = life_.succeeded();
    const bool has_next_life = succeeded && now - *succeeded < announcement::contest_intervals * interval();
    return standing_.span() >= sought_after && !has_next_life;
  }
  /// When we last heard it ourselves.
  [[nodiscard]] base::Instant heard() const { return life_.heard(); }
  [[nodiscard]] const std::string& name() const { return header_.value().name; }
  /// Whether what it says of itself has changed since the last call.
  [[nodiscard]] bool take_anew() { return std::exchange(is_anew_, false); }
  /// When a datagram last proved that a complete revision is as it was.
  [[nodiscard]] base::Instant affirmed() const { return affirmed_; }
  /// Of all its lives; 0: it has none that lasts.
  [[nodiscard]] std::uint32_t lasting() const { return header_.value().lasting; }
  /// The time between two of its announcements, as it says.
  [[nodiscard]] base::Duration interval() const { return interval_.value(); }
  /// Whether its newest state is not known, or not certain, or not what it says of one of its ways, or had no room.
  [[nodiscard]] bool is_lacking() const { return is_state_lacking() || services_.is_short(); }
  /// Whether that is to be said at once. While somebody goes on to lie in its name, it is said when we speak anyway.
  [[nodiscard]] bool is_missed(base::Instant now) const {
    return is_state_lacking() && (!is_contested_ || now - contested_since_ < urgent_time);
  }
  /// Whether it gives no sign of life, and its deadline is near.
  [[nodiscard]] bool is_doubted() const { return life_.is_doubted(); }
  /// No deadline is before `until`.
  void postpone(base::Instant until);
  [[nodiscard]] const std::vector<NeighbourWay>& ways() const { return ways_.all(); }

  /// Drops ways and services that have their deadline at or before `now`; the participant itself is the table's.
  void expire(base::Instant now, std::vector<Change>& changes);
  void forget_interface(env::InterfaceIndex interface, std::vector<Change>& changes);

  [[nodiscard]] base::Instant deadline() const { return life_.deadline(); }
  /// When expire() has something to do, or a little before. Its cost is constant.
  [[nodiscard]] base::Instant next_deadline() const;
  [[nodiscard]] Neighbour snapshot() const;
  /// The highest sequence number that was heard of it; of its first way.
  [[nodiscard]] std::uint64_t newest() const { return ways().empty() ? 0 : ways().front().newest(); }
  [[nodiscard]] NeighbourServices& services() { return services_; }
  [[nodiscard]] const NeighbourServices& services() const { return services_; }

 private:
  /// For so long after the first lie its state is missed at once.
  static constexpr base::Duration urgent_time = std::chrono::milliseconds(500);

  /// What a state says of the participant itself.
  struct Header {
    std::string name;
    std::uint64_t ontology_digest = 0;
    base::Duration interval{};
    std::uint32_t lasting = 0;
    friend bool operator==(const Header&, const Header&) = default;
  };
  /// Who wants this identifier in another life.
  struct Rival {
    announcement::BootNonce boot{};
    std::string source;
    std::uint64_t sequence = 0;
  };

  [[nodiscard]] bool is_state_lacking() const {
    return !is_complete_ || !std::ranges::all_of(ways(), &NeighbourWay::is_said);
  }
  static Header header_of(const announcement::Announcement& announcement);
  [[nodiscard]] NeighbourWay::Order order(const NeighbourWay& way, const announcement::Announcement& announcement,
                                          const Arrival& arrival) const;
  void take_in(NeighbourWay& way, const announcement::Announcement& announcement, const Arrival& arrival,
               std::vector<Change>& changes);
  /// What the state of a revision says of it; of an unchanged one it is what is known already.
  void take_state(NeighbourWay& way, const announcement::Announcement& announcement, const Arrival& arrival);
  /// Only what is said in it; the rest as in a presence.
  void take_change(NeighbourWay& way, const announcement::Announcement& announcement, base::Instant now,
                   std::vector<Change>& changes);
  void take_interval(const announcement::Announcement& announcement, base::Instant now);
  void take_revision(NeighbourWay& way, const announcement::Announcement& announcement, base::Instant now,
                     std::vector<Change>& changes);
  /// Somebody has lied in its name.
  void contest(base::Instant now, std::vector<Change>& changes);
  void end_contest(base::Instant now);
  void set_deadlines(NeighbourWay& way, base::Instant now);
  /// Picks the address for services without one.
  void choose_address();

  /// How long a word counts against another one. An interval counts up to the time for which the participant is known.
  [[nodiscard]] base::Duration hold(base::Instant now) const;
  /// The interval that deadlines are made of: no single word makes them shorter or longer.
  [[nodiscard]] base::Duration lasting_interval(base::Instant now) const;
  [[nodiscard]] Moment moment(base::Instant now, bool is_heard) const;
  [[nodiscard]] Reception reception(base::Instant now) const;
  /// Of its best way, and a bad one where too few numbers were heard to tell.
  [[nodiscard]] double known_loss() const;

  ParticipantId id_;
  announcement::BootNonce boot_;
  std::string source_;
  Turn since_;
  bool has_spoken_ = false;
  Standing standing_;
  Settled<Header> header_;
  bool is_anew_ = false;        ///< it is not the same since take_anew()
  AnnouncedInterval interval_;  ///< what it keeps: that of the header, stretched
  LifeSigns life_;
  std::uint64_t revision_;       ///< the one that is believed
  std::uint64_t said_revision_;  ///< the last one of which a state was heard
  Passed raised_;                ///< when it and those before it were first heard
  bool is_complete_ = false;
  std::vector<ServiceNumber> complete_;  ///< the services of a complete revision
  base::Instant affirmed_;               ///< when a datagram last proved that a complete revision is as it was
  bool is_contested_ = false;
  base::Instant contested_since_;
  base::Instant contested_until_;
  base::Instant next_lapse_ = base::never;             ///< while contested: when a service may not be held any more
  base::Instant next_service_deadline_ = base::never;  ///< while not complete: no service has an earlier one
  std::optional<Rival> rival_;
  NeighbourWays ways_;
  NeighbourServices services_;
  const Witnesses& witnesses_;
};

}  // namespace geminga::membership

#endif
