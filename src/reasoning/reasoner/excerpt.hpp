// Some axioms of a source as a source of their own, to which questions may be added.
#ifndef GEMINGA_REASONING_REASONER_EXCERPT_HPP
#define GEMINGA_REASONING_REASONER_EXCERPT_HPP

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// An axiom that is not in a source yet.
struct Statement {
  el::AxiomKind kind = el::AxiomKind::sub_class_of;
  std::vector<el::TermId> arguments;
};

/// A copy of some axioms, in their order, and names that they do not use. Its source may be added to.
class Excerpt {
 public:
  /// Axioms whose terms nest deeper than a source allows are no axioms of any source, so none is lost.
  Excerpt(const el::OntologySource& from, std::span<const std::uint32_t> axioms);

  el::OntologySource source;
  /// How many axioms were copied: what is added has this number or a greater one.
  std::size_t copied = 0;

  /// The same term in the excerpt. Requires that it nests no deeper than axioms do.
  el::TermId term(el::TermId original);
  /// An entity that neither source knows.
  el::TermId fresh(el::TermKind kind);
  void add(el::AxiomKind kind, std::span<const el::TermId> arguments);
  void add(const Statement& statement) { add(statement.kind, statement.arguments); }

 private:
  const el::OntologySource& from_;
  std::vector<std::uint32_t> numbers_;  ///< by original term; none: not copied yet
  std::uint32_t fresh_count_ = 0;
};

}  // namespace geminga::reasoner

#endif
