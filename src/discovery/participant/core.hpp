// What the parts of one participant share: the world, the registry with its matcher and the vocabulary, and the peers.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CORE_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CORE_HPP

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "discovery/matching/matcher.hpp"
#include "discovery/membership/neighbour_table.hpp"
#include "discovery/participant/contest.hpp"
#include "discovery/participant/counters.hpp"
#include "discovery/participant/expressions.hpp"
#include "discovery/participant/neighbour_queue.hpp"
#include "discovery/participant/ontology_change.hpp"
#include "discovery/participant/ontology_state.hpp"
#include "discovery/participant/ontology_watch.hpp"
#include "discovery/participant/overlaps.hpp"
#include "discovery/participant/session.hpp"
#include "discovery/participant/settings.hpp"
#include "discovery/participant/twins.hpp"
#include "discovery/participant/work.hpp"
#include "discovery/sealing/seal.hpp"
#include "env/env.hpp"

namespace geminga::participant {

/// Where a participant is in its life.
enum class Phase : std::uint8_t {
  created,   ///< start() has not been called
  claiming,  ///< no identifier has been held: statements wait
  ready,     ///< peers are served; after a clash under the old identifier, until another is claimed
  stopping,  ///< goodbyes are being said
  stopped,   ///< may be destroyed
  failed,    ///< no identifier could be claimed: may be destroyed
};
[[nodiscard]] std::string_view to_string(Phase phase);

struct Core {
  Core(env::Env& the_env, Settings the_settings, vocabulary::Vocabulary the_vocabulary);
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  env::Env& env;
  const Settings settings;
  OntologyChange ontology_change;
  OntologyState ontology_state;
  OntologyWatch ontology_watch;
  Expressions expressions;
  Overlaps overlaps;
  matching::Matcher matcher;
  membership::NeighbourTable neighbours;
  announcement::Announcement heard;  ///< the last one; its memory is used again
  NeighbourQueue neighbour_queue;
  Counters counters;
  Contest contest;
  /// Everything that goes out or comes in on the air passes it.
  sealing::Seal seal;
  Twins twins;
  Phase phase = Phase::created;
  /// What our peers know us by; 0 until an identifier is held. After a clash it stays until another one is held.
  ParticipantId id{};
  base::Instant started{};
  std::map<env::StreamId, std::unique_ptr<Session>> sessions;
  std::uint32_t next_peer = 1;
  /// Our own requests that are to be entered under the identifier that is held now; the next one last.
  std::vector<std::pair<env::StreamId, std::uint32_t>> returning;
  /// Something that is announced is not what was announced last.
  bool is_changed = false;
  std::function<std::vector<gcnp::Parameter>()> status_source;

  /// In force: what every name means.
  [[nodiscard]] const vocabulary::Vocabulary& vocabulary() const { return matcher.vocabulary(); }
  /// What the team calls us.
  [[nodiscard]] std::string name() const;
  [[nodiscard]] std::uint64_t digest() const;
  [[nodiscard]] Session* find(PeerId peer);
  /// In ascending order of peer.
  [[nodiscard]] std::vector<const Session*> peers() const;
  [[nodiscard]] const env::Interface* find(env::InterfaceIndex index) const;
  /// Whether all that we say is said on this interface, too: not on a twin where nobody speaks IPv6 alone.
  [[nodiscard]] bool speaks_on(const env::Interface& interface);
  /// Peers whose connection is not over.
  [[nodiscard]] std::size_t peer_count() const;
  /// Publications and subscriptions of all peers; those of them that are announced; places of room that are promised.
  [[nodiscard]] std::size_t service_count() const;
  [[nodiscard]] std::size_t shared_count() const;
  [[nodiscard]] std::size_t promised_room() const;

  /// All the work that was done for clients since the start, whoever caused it.
  [[nodiscard]] Work work() const;
  /// Work that nothing else counts: statements, and lines of answers.
  Work worked = 0;

  /// Writes an error to a peer, and counts it.
  void refuse(Session& session, std::uint32_t id, const Error& error);
  /// Octets that wait for a peer, here and in Env.
  [[nodiscard]] std::size_t backlog(const Session& session) const;
  void log(base::LogLevel level, const std::string& line) { env.log().write(level, line); }
};

}  // namespace geminga::participant

#endif
