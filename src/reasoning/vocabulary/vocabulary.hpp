// The meanings of names: the only part of reasoning/ that discovery/ knows.
#ifndef GEMINGA_REASONING_VOCABULARY_VOCABULARY_HPP
#define GEMINGA_REASONING_VOCABULARY_VOCABULARY_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/error.hpp"
#include "reasoning/placement/expression.hpp"
#include "reasoning/taxonomy/class_number.hpp"
#include "reasoning/vocabulary/comparison.hpp"
#include "reasoning/vocabulary/near_miss.hpp"
#include "reasoning/vocabulary/overlap.hpp"
#include "reasoning/vocabulary/step_graph.hpp"
#include "reasoning/vocabulary/units.hpp"

namespace geminga::compiled {
class Ontology;
}
namespace geminga::explanation {
struct ExplainedAxiom;
}
namespace geminga::owl {
struct LeftOut;
struct LoadedFile;
}  // namespace geminga::owl

namespace geminga::vocabulary {

using taxonomy::ClassNumber;
/// Where a class expression stands among the classes of one vocabulary.
using Place = placement::ExpressionPlace;

class Conversions;
class Expression;
class ExpressionReader;
struct Explanation;

/// The team's ontology with its prefixes and, once it is prepared, with the tables that class expressions need. An
/// immutable value. Copies are cheap and share their content, which lives as long as one of them. Safe to read from
/// many threads.
///
/// A vocabulary without an ontology knows no class. Class numbers and places belong to one ontology, so that functions
/// that take one require the vocabulary that gave it.
class Vocabulary {
 public:
  /// Without an ontology.
  Vocabulary() = default;
  /// Null: without an ontology.
  explicit Vocabulary(std::shared_ptr<const compiled::Ontology> ontology);
  explicit Vocabulary(compiled::Ontology ontology);

  [[nodiscard]] bool is_loaded() const { return ontology_ != nullptr; }
  /// Whether both have the same ontology, read once: then numbers and places of one are valid in the other.
  [[nodiscard]] bool has_ontology_of(const Vocabulary& other) const { return ontology_ == other.ontology_; }

  // Names.

  /// The class of `prefix:Name`, `<IRI>`, a bare IRI, a label or a local name. The error is one line that says what is
  /// wrong and which classes may have been meant. Requires an ontology.
  [[nodiscard]] std::expected<ClassNumber, std::string> find(std::string_view name) const;
  [[nodiscard]] std::optional<ClassNumber> find_iri(std::string_view iri) const;
  /// The class of `prefix:Name`, `<IRI>` or a bare IRI, or nothing. Looks for no label and no likely meaning, so that
  /// it may be asked often.
  [[nodiscard]] std::optional<ClassNumber> find_term(std::string_view name) const;
  /// Whether a text looks like a class expression: more than one word, and not the name of a class. It may still be
  /// malformed.
  [[nodiscard]] bool is_expression(std::string_view name) const;
  [[nodiscard]] std::string_view iri(ClassNumber number) const;
  /// `prefix:Name` if a prefix fits, else `<IRI>`. The IRI need not be that of a class.
  [[nodiscard]] std::string short_name(ClassNumber number) const;
  [[nodiscard]] std::string short_name(std::string_view iri) const;
  /// The first classes whose short names begin with the text, at most so many, by prefix and IRI. Where prefixes share
  /// a beginning of their IRIs some may be missing, since no more than 16 times as many classes are looked at. The cost
  /// does not depend on the size of the ontology.
  [[nodiscard]] std::vector<std::string> short_names_with(std::string_view beginning, std::size_t most) const;
  /// A canonical expression with short names.
  [[nodiscard]] std::string short_expression(std::string_view canonical) const;

  // How classes relate. Matching asks these often; only those that return a vector allocate.

  [[nodiscard]] std::uint32_t class_count() const;
  /// owl:Thing, which is above every class. Requires an ontology.
  [[nodiscard]] ClassNumber thing() const;
  /// False if the class can have no instance.
  [[nodiscard]] bool is_satisfiable(ClassNumber number) const;
  /// Whether every instance of `sub` is one of `super`. Reflexive. O(1) to O(log n).
  [[nodiscard]] bool is_subsumed(ClassNumber sub, ClassNumber super) const;
  /// The number of edges of the shortest path up from `sub` to `super`: 0 for equivalent classes, nothing if `sub` is
  /// not subsumed.
  [[nodiscard]] std::optional<std::uint32_t> distance(ClassNumber sub, ClassNumber super) const;
  /// Every class that subsumes this one, including itself, ascending.
  [[nodiscard]] std::vector<ClassNumber> subsumers(ClassNumber number) const;
  /// The same for an expression by its place (placement/expression.hpp).
  [[nodiscard]] std::vector<ClassNumber> subsumers(const Place& place) const;
  /// The direct superclasses, ascending. An unsatisfiable class has none.
  [[nodiscard]] std::vector<ClassNumber> parents(ClassNumber number) const;
  /// The direct subclasses: one of each set of equivalent ones, ascending.
  [[nodiscard]] std::vector<ClassNumber> children(ClassNumber number) const;
  [[nodiscard]] bool is_above(const Place& place, ClassNumber sub) const;
  [[nodiscard]] std::optional<std::uint32_t> distance_up(const Place& place, ClassNumber super) const;
  [[nodiscard]] std::optional<std::uint32_t> distance_down(const Place& place, ClassNumber sub) const;

  /// The cheapest conversion of the representation `offered` into `requested`; null if there is none. Both must be
  /// satisfiable. Answers are remembered.
  [[nodiscard]] std::shared_ptr<const Chain> conversion(ClassNumber offered, ClassNumber requested) const;
  /// The declared conversions, at the places from 0 to their number. Requires an ontology.
  [[nodiscard]] const StepGraph& conversions() const;

  /// The declared units of measurement; none without an ontology.
  [[nodiscard]] const Units& units() const { return units_; }

  // Class expressions. They need the saturated ontology and tables of its names, which take seconds to build for a
  // large ontology.

  /// The same ontology, prepared for expressions. May run on any thread, while others read this. If it is impossible,
  /// because the ontology is over a limit or memory runs out, check_expressions() of the result says so. Requires an
  /// ontology.
  [[nodiscard]] Vocabulary with_expressions() const;
  [[nodiscard]] bool is_prepared() const { return reader_ != nullptr; }
  /// Whether expressions can be read: 503 until the vocabulary is prepared, 422 if they are impossible in it.
  [[nodiscard]] std::expected<void, Error> check_expressions() const;
  /// Reads a text: 413 if it is over a limit, 422 if it cannot be read. Requires that check_expressions() has no error,
  /// and so does place().
  [[nodiscard]] std::expected<Expression, Error> read(std::string_view text, std::size_t max_bytes) const;
  /// The cost depends on what the expression leads to and what is below it.
  [[nodiscard]] Place place(const Expression& expression) const;
  /// How two satisfiable expressions relate, as far as their places decide it: nothing where the expressions themselves
  /// have to be compared. Needs no preparation.
  [[nodiscard]] std::optional<Comparison> compare(const Place& one, const Place& other) const;
  /// The same by the expressions. Costs as much as placing both where their places do not decide it.
  [[nodiscard]] Comparison compare(const Expression& one, const Place& place, const Expression& other,
                                   const Place& place_of_other) const;

  // Explanations. These read the axioms and search, which takes milliseconds. 422 if the axioms are damaged.

  [[nodiscard]] std::expected<Explanation, Error> explain(ClassNumber sub, ClassNumber super) const;
  /// Whether something can be an instance of both.
  [[nodiscard]] Overlap overlap(ClassNumber one, ClassNumber other) const;
  /// The same for an expression and its place.
  [[nodiscard]] Overlap overlap(ClassNumber one, const Expression& other, const Place& place) const;
  /// The same for two expressions and their places. The vocabulary must be able to read expressions.
  [[nodiscard]] Overlap overlap(const Expression& one, const Place& place, const Expression& other,
                                const Place& place_of_other) const;
  /// A minimal set of axioms by which nothing is an instance of both, one line each, in the order of the argument.
  /// Empty if something can be one, or if no engine finds the axioms within its limits.
  [[nodiscard]] std::vector<std::string> exclusion(ClassNumber one, ClassNumber other) const;
  [[nodiscard]] std::vector<std::string> exclusion(ClassNumber one, const Expression& other) const;
  [[nodiscard]] std::vector<std::string> exclusion(const Expression& one, const Expression& other) const;
  /// A minimal set of axioms by which every instance of one expression is one of another, in the same order. Empty if
  /// that does not follow, or if no engine finds the axioms within its limits.
  [[nodiscard]] std::vector<explanation::ExplainedAxiom> proof(const Expression& sub, const Expression& super) const;
  /// The reason why a class is not below another, in one short line: the nearest class, and what is missing.
  [[nodiscard]] std::expected<std::string, Error> why_not(ClassNumber sub, ClassNumber super) const;

  /// The ways to make a candidate match: what it lacks, and what of the request contradicts it, the smallest first.
  /// Asks the reasoner at most `questions` times, each of which takes up to milliseconds. The vocabulary must be able
  /// to read expressions.
  [[nodiscard]] NearMisses near_misses(const Expression& request, const Expression& candidate,
                                       std::size_t questions) const;

  // The ontology itself. Without one the answers are empty, and the digest is 0.

  /// Equal on every host that loaded the same ontologies.
  [[nodiscard]] std::uint64_t digest() const;
  /// False: it contradicts itself, and every class is empty. True also where that is not decided.
  [[nodiscard]] bool is_consistent() const;
  [[nodiscard]] std::vector<owl::LoadedFile> files() const;
  [[nodiscard]] std::vector<owl::LeftOut> left_out() const;
  /// Why something may be missing although its axioms were used, one line each.
  [[nodiscard]] std::vector<std::string> gaps() const;
  /// The gap that says which classes are undecided, without the words that it begins with.
  [[nodiscard]] std::optional<std::string> undecided() const;

 private:
  friend class OntologyMark;

  /// Whether every instance of one expression is one of another; `gaps` says why a no may be wrong.
  struct Subsumed {
    bool holds = false;
    std::vector<std::string> gaps{};
  };
  [[nodiscard]] Subsumed is_subsumed(const Expression& sub, const Expression& super) const;
  /// The conjunction of two expressions.
  [[nodiscard]] std::expected<Expression, Error> both(const Expression& one, const Expression& other) const;

  std::shared_ptr<const compiled::Ontology> ontology_;
  std::shared_ptr<const Conversions> conversions_;  ///< null: without an ontology
  Units units_;
  std::shared_ptr<const ExpressionReader> reader_;  ///< borrows the ontology; null: not prepared
};

/// Recognises the ontology of a vocabulary later, without keeping it alive.
class OntologyMark {
 public:
  OntologyMark() = default;
  explicit OntologyMark(const Vocabulary& vocabulary) : ontology_(vocabulary.ontology_) {}
  [[nodiscard]] bool is_of(const Vocabulary& vocabulary) const {
    return !ontology_.owner_before(vocabulary.ontology_) && !vocabulary.ontology_.owner_before(ontology_);
  }

 private:
  std::weak_ptr<const compiled::Ontology> ontology_;
};

}  // namespace geminga::vocabulary

#endif
