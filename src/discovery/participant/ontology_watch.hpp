// Watches which participants on the air have another ontology than ours, and writes that into the log.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_ONTOLOGY_WATCH_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_ONTOLOGY_WATCH_HPP

#include <cstddef>
#include <cstdint>
#include <map>

#include "base/time.hpp"
#include "discovery/membership/neighbours.hpp"
#include "env/env.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// The interval between two looks, and so between two lines. Longer: a team that reloads one by one causes fewer lines.
/// Shorter: a difference is in the log sooner.
inline constexpr base::Duration ontology_look_interval = std::chrono::seconds(5);
/// The number of participants that one line names; `query ontology` has them all.
inline constexpr std::size_t max_named_others = 8;

/// Writes one line a change; queries show what still differs.
class OntologyWatch {
 public:
  /// To be called at the end of any event, with the digest of our own ontology; does nothing before its interval has
  /// gone by, or while nobody comes, goes or says anything else. O(participants).
  void look(const membership::Neighbours& neighbours, std::uint64_t own_digest, env::Env& env);

 private:
  using Others = std::map<ParticipantId, std::uint64_t>;  ///< the digest of each that differs

  base::Instant next_look_{};
  std::uint64_t roster_ = 0;  ///< of the table of neighbours, when it was looked at last
  std::uint64_t own_ = 0;     ///< our digest when it was looked at last
  Others others_;
};

}  // namespace geminga::participant

#endif
