// All other participants that are heard: what they announce, on which ways, and until when it counts.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_TABLE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_TABLE_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/admission/admission.hpp"
#include "discovery/membership/claim/first_claims.hpp"
#include "discovery/membership/former_incarnations.hpp"
#include "discovery/membership/former_losses.hpp"
#include "discovery/membership/lacks_and_doubts.hpp"
#include "discovery/membership/namesakes.hpp"
#include "discovery/membership/neighbour/arrival.hpp"
#include "discovery/membership/neighbour/change.hpp"
#include "discovery/membership/neighbour/hearing.hpp"
#include "discovery/membership/neighbour/neighbour.hpp"
#include "discovery/membership/neighbour/neighbour_record.hpp"
#include "discovery/membership/neighbour/service_room.hpp"
#include "discovery/membership/neighbours.hpp"
#include "discovery/membership/records.hpp"
#include "discovery/membership/report.hpp"
#include "discovery/membership/timetable.hpp"
#include "discovery/membership/witnesses/witnesses.hpp"
#include "env/env.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// Participants that are given up in one call of expire().
inline constexpr std::size_t max_expired_at_once = 64;
/// For so long no further participants get a place once memory was short.
inline constexpr base::Duration memory_pause = std::chrono::seconds(60);

/// The table of one participant. Not thread-safe. Deterministic: it uses no clock, no randomness and no order of a hash
/// map. Services are kept by (participant, peer, number). A newer revision wins over an older one. A service that is in
/// no part of a completely heard revision is withdrawn; any datagram of the newest, complete revision keeps all
/// services alive. ANNOUNCEMENT.md tells which datagram is believed when one may be forged. The address of a path is
/// kept while the path is alive and no address of a better rank (address_rank()) turns up.
class NeighbourTable final : private ServiceRoom {
 public:
  explicit NeighbourTable(std::string group) : group_(std::move(group)) {}
  ~NeighbourTable() override = default;
  NeighbourTable(const NeighbourTable&) = delete;
  NeighbourTable& operator=(const NeighbourTable&) = delete;

  /// Sets our own identity. Call again after each draw of IdentifierClaim.
  void set_self(ParticipantId id, announcement::BootNonce boot);
  /// Sets the revision of our own state that our presence says.
  void set_revision(std::uint64_t revision) { witnesses_.set_revision(revision); }

  /// Random bits that nobody else knows, so that nobody can aim a flood at the places of others. Call before anything
  /// is heard.
  void set_secret(std::uint64_t secret) { admission_.set_secret(secret); }

  /// Shares the offers of neighbours with other tables of this process. Call before anything is heard.
  using ServiceRoom::set_offers;

  /// Has the addresses of participants that are heard from afar alone judged whenever something is heard of them. Call
  /// before anything is heard.
  void set_judge(JudgeReach judge) { judge_ = std::move(judge); }
  /// Judges all of them anew, since other answers are to be expected.
  void judge_reach();

  /// Takes in one decoded announcement. Cost: its entries times the logarithm of the sender's, and when something has
  /// changed (or a sixteenth of an interval has gone by) all entries of its sender. While the room for services is
  /// full, it also looks at every participant for each service that others make room for.
  [[nodiscard]] Hearing hear(const announcement::Announcement& announcement, const Arrival& arrival);
  /// Removes what has its deadline at or before `now`; of many participants the first max_expired_at_once, and
  /// next_deadline() is due then. Returns how many of the removed participants may come back into
  /// reach: those heard for sought_after whose next incarnation does not seem to have begun.
  std::size_t expire(base::Instant now);
  /// When expire() has something to do, or a little before; base::never: nothing. Its cost is constant.
  [[nodiscard]] base::Instant next_deadline() const { return timetable_.next(); }
  /// Moves every deadline before `until` to `until`. Call it when we were not awake, so that what came in meanwhile can
  /// be heard. It may have been said long ago, so we do not testify by what we hear until then.
  void postpone(base::Instant until);
  /// Removes the paths of an interface of ours, and chooses addresses anew. Participants stay until their deadline.
  void forget_interface(env::InterfaceIndex interface);

  /// The changes since the last call, in the order in which they must be done.
  [[nodiscard]] std::vector<Change> take_changes() { return std::exchange(changes_, {}); }

  /// The part of our next presence that is about others. A doubted participant counts as asked by it. Looks at every
  /// participant.
  [[nodiscard]] Report report(base::Instant now);
  /// Whether report() would name anybody in `lacks` that is to be said at once.
  [[nodiscard]] bool lacks_anybody(base::Instant now) { return lacks_and_doubts_.lacks_anybody(now); }
  /// Whether report() would name anybody in `doubts`.
  [[nodiscard]] bool doubts_anybody() const { return lacks_and_doubts_.doubts_anybody(); }
  /// Takes in the doubts of another participant. Everybody hears the answers, so they count as asked by us, too.
  /// Returns whether all that we doubt are among them.
  bool hear_doubts(const std::vector<ParticipantId>& doubts, base::Instant now);
  /// Takes in the fold of a known participant's presence; see Witnesses::compare().
  /// States that it knows and we lack are asked for.
  Difference compare(const announcement::Announcement& presence, base::Instant now);
  /// Whether a known participant may have heard nothing of us since then; see Witnesses::misses_us().
  [[nodiscard]] bool misses_us(const announcement::Announcement& presence, base::Instant since, base::Duration interval,
                               base::Instant now) {
    return witnesses_.misses_us(presence, since, interval, now);
  }

  /// Makes room where memory is short: gives up a quarter of the participants that are not seasoned, at least one, the
  /// one that was added last first. For memory_pause no more participants than are left have a place. How many were
  /// given up; 0: all are seasoned.
  std::size_t shed(base::Instant now);
  /// Takes in what the presence of a relay says of participants that are not heard on its link. Its sender was known
  /// before, and is believed: by a seal, or since the owner has named it. `passage` is the way to the relay itself: its
  /// loss and interval.
  void hear_behind(const announcement::Announcement& presence, const Passage& passage, base::Instant now);
  /// Asks for the state of a known participant, since somebody who hears it through us lacks it.
  void suspect(ParticipantId id, base::Instant now);
  /// Asks for a sign of life of a known participant, since somebody who hears it through us doubts it.
  void doubt(ParticipantId id, base::Instant now);
  /// The participants that are known.
  [[nodiscard]] const Neighbours& neighbours() const { return neighbours_; }
  /// Testimony: the words of neighbours about each other and about us.
  [[nodiscard]] const Witnesses& witnesses() const { return witnesses_; }
  /// How many participants were heard for seasoned_after.
  [[nodiscard]] std::size_t seasoned() const { return admission_.seasoned(); }
  /// Services that were not taken because of max_services_per_participant or max_remote_services.
  [[nodiscard]] std::uint64_t refused_services() const { return refused(); }

 private:
  /// Takes in a presence or a change, which says something of a state that is known or is not.
  Hearing hear_short(const announcement::Announcement& announcement, const Arrival& arrival);
  Hearing hear_claim(const announcement::Announcement& announcement, const Arrival& arrival);
  Hearing hear_goodbye(const announcement::Announcement& announcement, const Arrival& arrival);
  /// Decides who owns an identifier: ANNOUNCEMENT.md, "Whose an identifier is".
  Hearing hear_state(const announcement::Announcement& announcement, const Arrival& arrival);
  Hearing hear_holder(Records::iterator holder, const announcement::Announcement& announcement, const Arrival& arrival);
  Hearing hear_newcomer(const announcement::Announcement& announcement, const Arrival& arrival, Turn since);
  /// Tells every participant that a newcomer may be its next incarnation: those of its name at its address, and those
  /// of its lasting identity.
  void succeed(const announcement::Announcement& newcomer, const Arrival& arrival);
  void add(std::unique_ptr<NeighbourRecord> one, const announcement::Announcement& announcement,
           const Arrival& arrival);
  void displace(ParticipantId id);
  std::unique_ptr<NeighbourRecord> remove(Records::iterator known, Departure reason);
  /// Brings everything that is derived from a record up to date, its next deadline included.
  void update(Records::value_type& known, base::Instant now);
  bool make_room(ParticipantId asks) override;
  /// How many participants have a place.
  [[nodiscard]] std::size_t room(base::Instant now) const {
    return now < room_until_ ? room_ : announcement::max_participants;
  }

  std::string group_;
  ParticipantId self_{};
  announcement::BootNonce self_boot_{};
  Admission admission_;
  Witnesses witnesses_;
  FormerIncarnations former_;
  FormerLosses former_losses_;
  FirstClaims claims_;
  LacksAndDoubts lacks_and_doubts_;
  Namesakes namesakes_;
  Turn turn_ = 0;
  Records records_;
  Neighbours neighbours_{records_};
  Timetable timetable_;                                ///< when expire() has something to do for which participant
  JudgeReach judge_;                                   ///< empty: all count as reachable
  std::size_t room_ = announcement::max_participants;  ///< until `room_until_`, since memory was short
  base::Instant room_until_{};
  std::vector<Change> changes_;
};

}  // namespace geminga::membership

#endif
