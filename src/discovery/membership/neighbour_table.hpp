// All other participants that are heard: what they announce, on which ways, and until when it counts.
#ifndef GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_TABLE_HPP
#define GEMINGA_DISCOVERY_MEMBERSHIP_NEIGHBOUR_TABLE_HPP

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/time.hpp"
#include "discovery/announcement/announcement.hpp"
#include "discovery/membership/hearing.hpp"
#include "discovery/membership/witnesses.hpp"
#include "env/env.hpp"
#include "geminga/service.hpp"

namespace geminga::membership {

/// Why something remote is gone. The words of matching::Reason.
enum class Departure : std::uint8_t {
  withdrawn,  ///< its participant does not announce it any more
  expired,    ///< not heard of before the deadline
  left,       ///< its participant said goodbye
};

/// A remote publication is there, has changed, or was said again (then only `heard` differs); that a presence affirms
/// it is told by NeighbourTable::affirmed(). The address is never empty unless nothing is known of the sender; an IPv6
/// link-local one carries our interface as zone.
struct PutPublication {
  ServiceKey key;
  Publication publication;
  std::string peer_name;
  std::string participant_name;
  base::Instant heard;  ///< registry::PublicationEntry::updated
  friend bool operator==(const PutPublication&, const PutPublication&) = default;
};
struct PutSubscription {
  ServiceKey key;
  Subscription subscription;
  std::string peer_name;
  std::string participant_name;
  base::Instant heard;
  friend bool operator==(const PutSubscription&, const PutSubscription&) = default;
};
struct RemovePublication {
  ServiceKey key;
  Departure reason = Departure::withdrawn;
  friend bool operator==(const RemovePublication&, const RemovePublication&) = default;
};
struct RemoveSubscription {
  ServiceKey key;
  Departure reason = Departure::withdrawn;
  friend bool operator==(const RemoveSubscription&, const RemoveSubscription&) = default;
};
/// A participant and everything of it is gone; its services are not removed one by one.
struct RemoveParticipant {
  ParticipantId participant{};
  Departure reason = Departure::expired;
  friend bool operator==(const RemoveParticipant&, const RemoveParticipant&) = default;
};
/// What the caller does to its registry, in this order.
using Change = std::variant<PutPublication, PutSubscription, RemovePublication, RemoveSubscription, RemoveParticipant>;

/// How a datagram came in.
struct Arrival {
  env::InterfaceIndex interface{};
  std::string_view interface_name;  ///< becomes the zone of IPv6 link-local addresses
  /// The sender's numeric address, which its ways belong to; also used for a sender that announces no address of its
  /// own. May be empty.
  std::string_view source;
  base::Instant now;
};

/// One way on which a participant is heard: our interface and its interface.
struct Path {
  env::InterfaceIndex interface{};
  std::string interface_name;
  std::uint32_t link = 0;
  std::vector<std::string> addresses;  ///< the sender's there; IPv6 link-local ones with our zone
  base::Instant heard;
  double loss = 0;  ///< the share of its last 64 datagrams on this way that were not heard
};

/// What is known of one participant.
struct Neighbour {
  ParticipantId id{};
  announcement::BootNonce boot{};
  std::string name;  ///< the identifier where it says none
  std::uint64_t ontology_digest = 0;
  base::Duration interval{};
  base::Instant heard;
  base::Instant deadline;
  std::string address;  ///< what its services without address are given; may be empty
  std::vector<Path> paths;
  double loss = 0;  ///< of the best path
  std::size_t publications = 0;
  std::size_t subscriptions = 0;
  bool is_deaf = false;      ///< it says that it has not heard us for long, though we hear it
  bool is_complete = false;  ///< all parts of its newest revision were heard
};

/// What is said of others in a presence (announcement::Announcement has the fields of these names).
struct Report {
  announcement::Witness witness;
  std::vector<ParticipantId> lacks;
  std::vector<ParticipantId> doubts;
};

/// Goodbyes are remembered so long, so that datagrams which they overtook bring nobody back; at most max_participants.
inline constexpr base::Duration goodbye_memory = std::chrono::seconds(10);

/// The table of one participant. Not thread-safe. Deterministic: no clock, no chance, no order of a hash map. What a
/// participant announces is kept by (participant, peer, number); a newer revision wins over an older one; what is in no
/// part of a completely heard revision is withdrawn; a datagram of the newest, complete revision keeps all alive. Who
/// is believed when a datagram may be forged is told in ANNOUNCEMENT.md. The address of a path is kept as long as the
/// path is alive and none of a better rank (address_rank()) turns up.
class NeighbourTable {
 public:
  /// Whether what is heard again is told as a change of `heard`, or only by affirmed().
  enum class Affirmed : std::uint8_t { told, known };
  explicit NeighbourTable(std::string group, Affirmed affirmed = Affirmed::told);
  ~NeighbourTable();
  NeighbourTable(const NeighbourTable&) = delete;
  NeighbourTable& operator=(const NeighbourTable&) = delete;

  /// Who we are, to be told from others; again after each draw of IdentifierClaim.
  void set_self(ParticipantId id, announcement::BootNonce boot);

  /// Random bits that nobody else knows, so that nobody can aim a flood at the places of others. Before anything is
  /// heard.
  void set_secret(std::uint64_t secret);

  /// Takes in one decoded announcement. Cost: its entries times the logarithm of the sender's, and when something has
  /// changed (or a sixteenth of an interval has gone by) all entries of its sender; while all room for services is
  /// taken also a look at every participant for each service that others make room for.
  [[nodiscard]] Hearing hear(const announcement::Announcement& announcement, const Arrival& arrival);
  /// Removes what has its deadline at or before `now`. How many participants of them may come back into reach: who was
  /// heard for sought_after, and whose next life does not seem to have begun.
  std::size_t expire(base::Instant now);
  /// When expire() has something to do, or a little before; base::never: nothing. Its cost is constant.
  [[nodiscard]] base::Instant next_deadline() const;
  /// We were not awake when something was due: nobody's deadline is before `until`, so that what has come in meanwhile
  /// can be heard. It may have been said long ago, so we do not testify by what we hear until then.
  void postpone(base::Instant until);
  /// An interface of ours is gone: its paths are, and addresses are chosen anew. Participants stay until their
  /// deadline.
  void forget_interface(env::InterfaceIndex interface);

  /// The changes since the last call, in the order in which they must be done.
  [[nodiscard]] std::vector<Change> take_changes();

  /// What we have heard of others, for our next presence. Who is doubted counts as asked with it. Costs a look at every
  /// participant.
  [[nodiscard]] Report report(base::Instant now);
  /// Whether report() would name anybody in `lacks` that is to be said at once; or in `doubts`.
  [[nodiscard]] bool lacks_anybody(base::Instant now);
  [[nodiscard]] bool doubts_anybody() const;
  /// Somebody else says that it doubts these, whom all can hear answer: that counts as asked by us, too. Whether all
  /// whom we doubt are among them.
  bool hear_doubts(const std::vector<ParticipantId>& doubts, base::Instant now);
  /// Whom somebody known, who says this, does not know (Witnesses::compare()).
  Unknown compare(const announcement::Announcement& presence, base::Instant now);
  /// Whether the last of these could not be told (Witnesses::is_unlike()).
  [[nodiscard]] bool is_unlike(base::Instant now) const;
  /// Whether somebody known, who says this, may have heard nothing of us since then (Witnesses::misses_us()).
  [[nodiscard]] bool misses_us(const announcement::Announcement& presence, base::Instant since, base::Duration interval,
                               base::Instant now);
  /// Whether we testify that we have heard it ourselves within one of its intervals.
  [[nodiscard]] bool is_heard_lately(ParticipantId id, base::Instant now) const;
  /// The share of all participants' last datagrams that was lost, in [0, 1); nothing: too few were heard.
  [[nodiscard]] std::optional<double> loss() const;

  [[nodiscard]] bool is_known(ParticipantId id) const;
  [[nodiscard]] std::optional<Neighbour> find(ParticipantId id) const;
  /// When a datagram last proved that all is there which somebody known was last heard to offer and to ask for.
  [[nodiscard]] std::optional<base::Instant> affirmed(ParticipantId id) const;
  /// Counts how often somebody came or went, or said something else of itself: the same number, the same participants
  /// with the same names and ontologies.
  [[nodiscard]] std::uint64_t roster() const;
  /// In ascending order of identifier.
  void for_each(const std::function<void(const Neighbour&)>& visit) const;
  [[nodiscard]] std::size_t size() const;
  /// Those of them that were heard for seasoned_after.
  [[nodiscard]] std::size_t seasoned() const;
  /// Services that were not taken because of max_services_per_participant or max_remote_services.
  [[nodiscard]] std::uint64_t refused_services() const;

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace geminga::membership

#endif
