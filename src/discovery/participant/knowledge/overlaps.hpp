// Which concepts have instances in common with what is asked for, as the reasoner says; asked a little at a time, and
// remembered.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_OVERLAPS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_OVERLAPS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "base/time.hpp"
#include "discovery/matching/degrees/overlap.hpp"
#include "discovery/participant/knowledge/remote_quota.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

/// Answers that are remembered, each about one concept that is offered and what is asked for. Beyond it all those about
/// the one that was not asked for longest are forgotten, and decided anew when they are needed.
inline constexpr std::size_t max_remembered_overlaps = 32'768;
/// Of these, those about one request. Whether further concepts overlap with it is undecided.
inline constexpr std::size_t max_overlaps_of_request = 8'192;
/// Questions that are decided in one step, between which others have their turns. What is over it waits, unmatched.
inline constexpr std::size_t max_overlaps_in_step = 4;
/// Questions because of requests of one other participant, and of all of them together, in one second. What is over it
/// waits, unmatched, until something happens in a later second.
inline constexpr std::size_t max_overlaps_of_participant = 16;
inline constexpr std::size_t max_overlaps_from_air = 64;
/// A question that a peer's statement asks counts as so many statements (Limits::statements_per_second).
inline constexpr std::size_t statements_per_overlap = 10;

/// Not thread-safe.
class Overlaps {
 public:
  using Vocabulary = vocabulary::Vocabulary;

  /// As matching::Overlapping. `from` is null for our own.
  [[nodiscard]] matching::OverlapAnswer answer(const Vocabulary& vocabulary, vocabulary::ClassNumber offered,
                                               const SemanticIdentity& requested, const matching::Classes& classes,
                                               std::optional<ParticipantId> from, base::Instant now);
  /// Another max_overlaps_in_step may be decided.
  void begin_step() { left_ = max_overlaps_in_step; }
  /// Whether something waits that may be asked for again now.
  [[nodiscard]] bool take_waiting(base::Instant now);

  struct Counts {
    std::uint64_t decided = 0;    ///< questions that the reasoner was asked
    std::uint64_t undecided = 0;  ///< of these: it could not tell
    std::uint64_t postponed = 0;  ///< how often no answer was given, for it was to wait
  };
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  /// About one thing that is asked for.
  struct Answers {
    std::map<vocabulary::ClassNumber, matching::OverlapAnswer> by_offer;
    std::uint64_t used = 0;
  };
  /// By one ontology. While one takes the place of another, both are at work.
  struct Memory {
    vocabulary::OntologyMark ontology;
    std::map<std::string, Answers, std::less<>> by_request;
    std::size_t size = 0;
  };

  [[nodiscard]] Memory& memory_of(const Vocabulary& vocabulary);
  [[nodiscard]] bool take_quota(std::optional<ParticipantId> from, base::Instant now);
  void remember(Memory& memory, const std::string& requested, vocabulary::ClassNumber offered,
                matching::OverlapAnswer answer);

  std::array<Memory, 2> memories_;
  std::size_t last_ = 0;  ///< the memory that was asked last
  std::uint64_t uses_ = 0;
  std::size_t left_ = max_overlaps_in_step;
  bool is_waiting_ = false;
  std::optional<base::Instant> waiting_since_;  ///< something from the air, for a later second
  RemoteQuota quota_{max_overlaps_of_participant, max_overlaps_from_air};
  Counts counts_;
};

}  // namespace geminga::participant

#endif
