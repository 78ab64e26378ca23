// Bottom and top locality of the axioms of a source: whether an axiom says nothing about a signature.
//
// An axiom is local with respect to a signature S if it is a tautology as soon as every class and property outside S is
// empty (bottom), or is everything (top): Cuenca Grau, Horrocks, Kazakov, Sattler: Modular Reuse of Ontologies, 2008.
// The test is syntactic. It may call an axiom not local that is, and never the other way round.
#ifndef GEMINGA_REASONING_MODULES_SOURCE_LOCALITY_HPP
#define GEMINGA_REASONING_MODULES_SOURCE_LOCALITY_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::modules {

/// The meaning of the names outside a signature.
enum class Outside : std::uint8_t { is_empty, is_everything };

/// Tests axioms of one source against a signature that the caller keeps and may let grow. Both must outlive it.
class SourceLocality {
 public:
  /// `is_in_signature` has an entry for each term.
  SourceLocality(const owl::Ontology& source, const std::vector<bool>& is_in_signature, Outside outside)
      : source_(source), is_in_signature_(is_in_signature), outside_(outside) {}

  /// Declarations are local. An axiom of more than max_terms_looked_at terms is not.
  [[nodiscard]] bool is_local(const owl::Axiom& axiom);

 private:
  /// The extension of a class, a property or a data range, as far as it is known.
  enum class Extension : std::uint8_t { empty, everything, unknown };
  using Terms = std::span<const owl::TermId>;

  [[nodiscard]] Extension of(owl::TermId id);
  [[nodiscard]] Extension named(owl::TermId id) const;
  [[nodiscard]] Extension of_boolean(const owl::Term& term, bool is_intersection);
  [[nodiscard]] Extension of_restriction(const owl::Term& term);
  [[nodiscard]] Extension at_least(std::uint32_t number, Extension role, Extension filler) const;
  /// The filler of a quantified restriction; everything where there is none.
  [[nodiscard]] Extension filler(const owl::Term& term);

  [[nodiscard]] bool is_empty(owl::TermId id) { return of(id) == Extension::empty; }
  [[nodiscard]] bool is_everything(owl::TermId id) { return of(id) == Extension::everything; }
  [[nodiscard]] bool all_are(Terms terms, Extension extension);
  [[nodiscard]] bool is_one_extension(Terms terms) {
    return all_are(terms, Extension::empty) || all_are(terms, Extension::everything);
  }
  [[nodiscard]] bool at_most_one_is_not_empty(Terms terms);
  [[nodiscard]] bool is_trivial_union(Terms arguments);
  [[nodiscard]] bool is_trivial_rule(Terms arguments);
  [[nodiscard]] bool is_local_property_axiom(const owl::Axiom& axiom);

  const owl::Ontology& source_;
  const std::vector<bool>& is_in_signature_;
  Outside outside_;
  std::uint32_t looked_at_ = 0;
};

}  // namespace geminga::modules

#endif
