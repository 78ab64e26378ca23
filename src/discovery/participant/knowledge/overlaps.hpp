// Overlaps: which concepts can have instances in common with what is asked for. The reasoner decides; a few questions
// are asked at a time, and the answers remembered.
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

/// Answers that are remembered, each about one offered concept and one request. Beyond it all answers about the least
/// recently used request are forgotten, and decided anew when they are needed.
inline constexpr std::size_t max_remembered_overlaps = 32'768;
/// Answers about one request. Whether further concepts overlap with it is undecided.
inline constexpr std::size_t max_overlaps_of_request = 8'192;
/// Questions that are decided in one step, between which others have their turns. Questions over it wait, unmatched.
inline constexpr std::size_t max_overlaps_in_step = 4;
/// Questions because of requests of one other participant, and of all of them together, in one second. Questions over
/// it wait, unmatched, until something happens in a later second.
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
  /// Allows another max_overlaps_in_step questions.
  void begin_step() { left_ = max_overlaps_in_step; }
  /// Whether a question waits that may be asked again now.
  [[nodiscard]] bool take_waiting(base::Instant now);

  struct Counts {
    std::uint64_t decided = 0;    ///< questions that the reasoner was asked
    std::uint64_t undecided = 0;  ///< of these: it could not tell
    std::uint64_t postponed = 0;  ///< how often a question had to wait
  };
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  /// Answers about one request.
  struct Answers {
    std::map<vocabulary::ClassNumber, matching::OverlapAnswer> by_offer;
    std::uint64_t used = 0;
  };
  /// Answers by one ontology. While one takes the place of another, both are at work.
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
  std::optional<base::Instant> waiting_since_;  ///< since when a question from the air waits for a later second
  RemoteQuota quota_{max_overlaps_of_participant, max_overlaps_from_air};
  Counts counts_;
};

}  // namespace geminga::participant

#endif
