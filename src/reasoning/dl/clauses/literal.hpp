// Class expressions and their complements, one level of negation normal form at a time.
//
// No term can be added to a source while it is read, so a complement is a term and a sign. What the sign does to the
// term is worked out where it is needed: not (R some C) is R only (not C).
#ifndef GEMINGA_REASONING_DL_CLAUSES_LITERAL_HPP
#define GEMINGA_REASONING_DL_CLAUSES_LITERAL_HPP

#include <cstdint>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::clauses {

/// ObjectExactCardinality stands for two expressions, which have no terms of their own.
enum class Part : std::uint8_t { whole, minimum, maximum };

/// A class expression or its complement. An individual stands for its nominal.
struct Literal {
  owl::TermId term = owl::thing_term;
  bool is_negated = false;
  Part part = Part::whole;
};
[[nodiscard]] constexpr Literal complement(Literal literal) {
  literal.is_negated = !literal.is_negated;
  return literal;
}
inline constexpr Literal top{};
inline constexpr Literal bottom{owl::thing_term, true, Part::whole};

enum class ShapeKind : std::uint8_t {
  truth,
  falsity,
  atom,          ///< a named class or nominal, `term`
  negated_atom,  ///< its complement
  all_of,        ///< operands
  any_of,        ///< operands
  some,          ///< property some filler
  every,         ///< property only filler
  self,          ///< property Self
  not_self,      ///< not (property Self)
  at_least,      ///< property min count filler, count >= 2
  at_most,       ///< property max count filler, count >= 1
  data_some,     ///< the same with a data property and range
  data_every,
  data_at_least,
  data_at_most,
};

/// The shape of a literal whose sign is pushed one level down.
struct Shape {
  ShapeKind kind = ShapeKind::truth;
  owl::TermId term{};
  std::vector<Literal> operands;
  owl::TermId property{};  ///< an object property expression or data property
  std::uint32_t count = 1;
  Literal filler;
  DataRange range{no_term, false};
};

/// `literal` must be of a well-formed class expression or an individual.
[[nodiscard]] Shape shape_of(const owl::Ontology& source, Literal literal);

/// The range of a data range expression or literal, without its complements. rdfs:Literal is no_term.
[[nodiscard]] DataRange range_of(const owl::Ontology& source, owl::TermId term, bool is_complement);

}  // namespace geminga::clauses

#endif
