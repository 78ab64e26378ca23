// Some axioms of a source, copied to a source of their own to which questions may be added.
#ifndef GEMINGA_REASONING_REASONER_EXCERPT_HPP
#define GEMINGA_REASONING_REASONER_EXCERPT_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// An axiom that is not in a source yet.
struct Statement {
  owl::AxiomKind kind = owl::AxiomKind::sub_class_of;
  std::vector<owl::TermId> arguments;
};

/// A copy of some axioms, in their order, and names that they do not use. Axioms may be added.
class Excerpt {
 public:
  /// No axiom is lost: a source has none whose terms nest too deep.
  Excerpt(const owl::Ontology& from, std::span<const std::uint32_t> axioms);

  owl::Ontology source;
  /// The number of axioms that were copied. Axioms that are added have this number or a greater one.
  std::size_t copied = 0;

  /// The copy of a term. Requires that it nests no deeper than axioms may.
  owl::TermId term(owl::TermId original);
  /// A new entity that neither source knows.
  owl::TermId fresh(owl::TermKind kind);
  void add(owl::AxiomKind kind, std::span<const owl::TermId> arguments);
  void add(const Statement& statement) { add(statement.kind, statement.arguments); }

 private:
  const owl::Ontology& from_;
  std::vector<std::uint32_t> numbers_;  ///< by original term; none: not copied yet
  std::uint32_t fresh_count_ = 0;
};

}  // namespace geminga::reasoner

#endif
