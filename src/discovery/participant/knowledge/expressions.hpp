// The class expressions that own peers and participants on the air ask for and offer, each with its place in the
// vocabularies at work.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_EXPRESSIONS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_KNOWLEDGE_EXPRESSIONS_HPP

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/time.hpp"
#include "discovery/participant/knowledge/remote_quota.hpp"
#include "geminga/error.hpp"
#include "geminga/service.hpp"
#include "reasoning/vocabulary/vocabulary.hpp"

namespace geminga::participant {

/// Places that are remembered. Beyond it the least recently used is forgotten, and classified anew when it comes again.
inline constexpr std::size_t max_remembered_expressions = 1024;
/// New expressions of one other participant, and of all of them together, that are classified in one second.
/// Expressions over it wait, unmatched, until something is heard in a later second.
inline constexpr std::size_t max_expressions_of_participant = 8;
inline constexpr std::size_t max_expressions_from_air = 32;
/// A peer's expression that had to be classified counts as so many statements (Limits::statements_per_second).
inline constexpr std::size_t statements_per_expression = 100;

/// Has expressions placed by the vocabulary that it is given, and remembers their places while its ontology is at work.
/// While one ontology takes the place of another, there are two of them. A vocabulary is prepared for that elsewhere,
/// when the first expression comes. Not thread-safe.
class Expressions {
 public:
  using Place = std::shared_ptr<const vocabulary::Place>;
  using Vocabulary = vocabulary::Vocabulary;

  /// Whether an expression has come while this ontology is in force.
  [[nodiscard]] bool is_used(const Vocabulary& vocabulary) const;
  /// Whether one has come, and the vocabulary is not prepared for it yet.
  [[nodiscard]] bool is_waiting(const Vocabulary& vocabulary) const {
    return is_used(vocabulary) && !vocabulary.is_prepared();
  }

  /// The concept that a peer's expression stands for: the full IRI of the class that it is equivalent to, or its
  /// canonical text. 422 where it cannot be read or can have no instance, or the ontology is too large; 413 over a
  /// limit; 503 while is_waiting(). Requires an ontology.
  [[nodiscard]] std::expected<std::string, Error> resolve(const Vocabulary& vocabulary, std::string_view text);
  /// Has the vocabulary prepared for expressions, as the first of them does: 503 while it is not, 422 where they are
  /// impossible.
  [[nodiscard]] std::expected<void, Error> require(const Vocabulary& vocabulary);
  /// The place of a canonical text; null where it is unknown here, can have no instance, or must wait. `from` is null
  /// for one of our own, whose text resolve() gave. What was placed by the other ontology at work need not wait, so
  /// that nothing is lost when one takes the place of the other.
  [[nodiscard]] Place place(const Vocabulary& vocabulary, const std::string& canonical,
                            std::optional<ParticipantId> from, base::Instant now);
  /// The place of a canonical text where it is remembered; null otherwise. Classifies nothing.
  [[nodiscard]] Place known_place(const Vocabulary& vocabulary, const std::string& canonical) const;
  /// Why a canonical text has no place here, in words for a user; empty where it has one.
  [[nodiscard]] std::string problem(const Vocabulary& vocabulary, const std::string& canonical) const;
  /// Whether an expression from the air waits and a new second has begun. Then it is to be asked for again.
  [[nodiscard]] bool take_waiting(const Vocabulary& vocabulary, base::Instant now);

  struct Counts {
    std::uint64_t classified = 0;  ///< places found, each time that it was work
    std::uint64_t unknown = 0;     ///< from the air: not to be read here, or without instances
    std::uint64_t postponed = 0;   ///< from the air: over the limits of a second
  };
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  struct Remembered {
    Place place;
    std::string problem;  ///< why there is none; empty where there is
    std::uint64_t used = 0;
  };
  /// Places by one ontology.
  struct Memory {
    vocabulary::OntologyMark ontology;
    bool is_used = false;
    std::map<std::string, Remembered, std::less<>> remembered{};
  };

  /// The memory of an ontology, which takes the place of the one that was used less lately.
  [[nodiscard]] Memory& memory_of(const Vocabulary& vocabulary);
  [[nodiscard]] const Memory* find_memory(const Vocabulary& vocabulary) const;
  [[nodiscard]] bool is_known_elsewhere(const Memory& memory, const std::string& canonical) const;
  [[nodiscard]] bool take_quota(ParticipantId from, base::Instant now);
  Place remember(Memory& memory, const std::string& canonical, Place place, std::string problem = {});

  std::array<Memory, 2> memories_;
  std::size_t last_ = 0;  ///< the memory that was asked last
  std::uint64_t uses_ = 0;
  RemoteQuota quota_{max_expressions_of_participant, max_expressions_from_air};
  std::optional<base::Instant> waiting_since_;
  Counts counts_;
};

}  // namespace geminga::participant

#endif
