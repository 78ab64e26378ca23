// Writes a source in the functional-style syntax of OWL 2, which every other reasoner reads without a mapping between.
#ifndef GEMINGA_TESTS_COMPARE_FUNCTIONAL_SYNTAX_HPP
#define GEMINGA_TESTS_COMPARE_FUNCTIONAL_SYNTAX_HPP

#include <string>

#include "reasoning/owl/source.hpp"

namespace geminga::compare {

/// A whole document: every axiom of the source on a line of its own, with a declaration for every entity. Annotations
/// and what the reader left out are not in it.
[[nodiscard]] std::string functional_syntax(const owl::Ontology& source);

}  // namespace geminga::compare

#endif
