// The constants of rasqal as the terms of raptor.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TERMS_LITERALS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TERMS_LITERALS_HPP

#include <memory>
#include <string_view>

#include "reasoning/syntax/graph/terms/world.hpp"

namespace geminga::graph {

struct FreeTerm {
  void operator()(raptor_term* term) const { raptor_free_term(term); }
};
using OwnedTerm = std::unique_ptr<raptor_term, FreeTerm>;

/// The term of a constant: an IRI, a blank node, or a literal with its lexical form. Null for a variable, for null, and
/// if memory is short.
[[nodiscard]] OwnedTerm term_of(World& world, rasqal_literal* literal);

/// The name of a blank node or of a variable that stands for one; empty for what is named, and for null.
[[nodiscard]] std::string_view blank_name(const rasqal_literal* literal);

/// The IRI of a constant that is one; empty otherwise.
[[nodiscard]] std::string_view iri_of(const rasqal_literal* literal);

}  // namespace geminga::graph

#endif
