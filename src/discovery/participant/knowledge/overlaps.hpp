// Overlaps: which concepts can have instances in common with what is asked for, and how two expressions relate. The
// reasoner decides; a few questions are asked at a time, and the answers remembered.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_OVERLAPS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_OVERLAPS_HPP

#include <cstddef>
#include <cstdint>
#include <optional>

#include "base/time.hpp"
#include "discovery/matching/degrees/comparison.hpp"
#include "discovery/matching/degrees/overlap.hpp"
#include "discovery/participant/knowledge/remembered_answers.hpp"
#include "discovery/participant/knowledge/remote_quota.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

/// Answers that are remembered, each about one offered concept and one request. Beyond it all answers about the least
/// recently used request are forgotten, and decided anew when they are needed.
inline constexpr std::size_t max_remembered_overlaps = 32'768;
/// Answers about one request. Whether further concepts overlap with it is undecided.
inline constexpr std::size_t max_overlaps_of_request = 8'192;
/// Comparisons of an offered expression and a requested one that are remembered, like max_remembered_overlaps. Those
/// that the places of both decide are not among them.
inline constexpr std::size_t max_remembered_comparisons = 32'768;
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
  [[nodiscard]] matching::OverlapAnswer answer(const Vocabulary& vocabulary, const matching::Meaning& offered,
                                               const matching::Meaning& requested, std::optional<ParticipantId> from,
                                               base::Instant now);
  /// As matching::Comparing. `from` is null for our own.
  [[nodiscard]] matching::ComparisonAnswer compare(const Vocabulary& vocabulary, const matching::Meaning& offered,
                                                   const matching::Meaning& requested,
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
  [[nodiscard]] bool take_quota(std::optional<ParticipantId> from, base::Instant now);

  RememberedAnswers<vocabulary::Overlap, max_remembered_overlaps> overlaps_;
  RememberedAnswers<vocabulary::Comparison, max_remembered_comparisons> comparisons_;
  std::size_t left_ = max_overlaps_in_step;
  bool is_waiting_ = false;
  std::optional<base::Instant> waiting_since_;  ///< since when a question from the air waits for a later second
  RemoteQuota quota_{max_overlaps_of_participant, max_overlaps_from_air};
  Counts counts_;
};

}  // namespace geminga::participant

#endif
