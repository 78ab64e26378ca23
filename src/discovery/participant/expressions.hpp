// The class expressions that are asked for, by own peers and on the air, each with its place in the loaded ontology.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_EXPRESSIONS_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_EXPRESSIONS_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "base/time.hpp"
#include "discovery/participant/prepared_ontology.hpp"
#include "geminga/error.hpp"
#include "geminga/service.hpp"

namespace geminga::participant {

/// Places that are remembered; beyond it the one that was not asked for longest is classified anew when it comes again.
inline constexpr std::size_t max_remembered_expressions = 1024;
/// New expressions of one other participant, and of all of them together, that are classified in one second. What is
/// over it waits, unmatched, until something is heard in a later second.
inline constexpr std::size_t max_expressions_of_participant = 8;
inline constexpr std::size_t max_expressions_from_air = 32;
/// A peer's expression that had to be classified counts as so many statements (Limits::statements_per_second).
inline constexpr std::size_t statements_per_expression = 100;

/// Classifies expressions over one ontology and remembers where they stand. What it needs of the ontology is made
/// elsewhere, and asked for when the first expression comes. Not thread-safe.
class Expressions {
 public:
  using Place = std::shared_ptr<const placement::ExpressionPlace>;

  explicit Expressions(const compiled::Ontology* ontology) : ontology_(ontology) {}
  /// Forgets everything. The ontology must outlive this, or be replaced before it goes. `prepared` may be null; of
  /// another ontology it is dropped.
  void set_ontology(const compiled::Ontology* ontology, std::unique_ptr<const PreparedOntology> prepared);
  /// The ontology that is to be prepared, because an expression has come: null where none is, or it was given.
  [[nodiscard]] const compiled::Ontology* wanted() const { return is_wanted_ && !prepared_ ? ontology_ : nullptr; }
  /// Whether an expression has come since the ontology is in force.
  [[nodiscard]] bool is_used() const { return is_wanted_; }
  /// Takes what was wanted. False where it is of another ontology, or there already; then it is dropped.
  bool give(std::unique_ptr<const PreparedOntology> prepared);

  /// What a peer's expression is asked for as: the full IRI of the class that it is equivalent to, or its canonical
  /// text. 422 where it cannot be read or can have no instance, or the ontology is too large; 413 over a limit; 503
  /// while the ontology is wanted().
  [[nodiscard]] std::expected<std::string, Error> resolve(std::string_view text);
  /// Where a canonical text stands; null where it is unknown here, can have no instance, or must wait. `from` is null
  /// for our own; its text is one that resolve() gave.
  [[nodiscard]] Place place(const std::string& canonical, std::optional<ParticipantId> from, base::Instant now);
  /// Whether something from the air waits and a new second has begun; it is to be asked for again then.
  [[nodiscard]] bool take_waiting(base::Instant now);

  struct Counts {
    std::uint64_t classified = 0;  ///< places found, each time that it was work
    std::uint64_t unknown = 0;     ///< from the air: not to be read here, or without instances
    std::uint64_t postponed = 0;   ///< from the air: over the limits of a second
  };
  [[nodiscard]] const Counts& counts() const { return counts_; }

 private:
  static constexpr base::Duration second = std::chrono::seconds(1);
  struct Remembered {
    Place place;
    std::uint64_t used = 0;
  };
  struct Window {
    base::Instant begin{};
    std::size_t seen = 0;
  };

  /// What expressions need of the ontology, or why it is not there; 503: not yet.
  [[nodiscard]] std::expected<const PreparedOntology::Parts*, Error> parts();
  [[nodiscard]] bool take_turn(ParticipantId from, base::Instant now);
  Place remember(const std::string& canonical, Place place);

  const compiled::Ontology* ontology_;
  std::unique_ptr<const PreparedOntology> prepared_;
  bool is_wanted_ = false;
  std::map<std::string, Remembered, std::less<>> remembered_;
  std::uint64_t uses_ = 0;
  std::map<ParticipantId, Window> windows_;
  Window air_;
  std::optional<base::Instant> waiting_since_;
  Counts counts_;
};

}  // namespace geminga::participant

#endif
