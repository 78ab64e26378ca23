// The canonical text of class expressions, as it is announced and as identities contain it.
#ifndef GEMINGA_REASONING_SYNTAX_MANCHESTER_CANONICAL_HPP
#define GEMINGA_REASONING_SYNTAX_MANCHESTER_CANONICAL_HPP

#include <string>

#include "reasoning/owl/source.hpp"

namespace geminga::manchester {

/// The canonical form (MANCHESTER.md): full IRIs; the members of `and`, `or` and braces sorted, each once. Equal for
/// expressions that differ only in these. parse() can read it. The term is a class expression; the nesting of terms
/// bounds the recursion.
[[nodiscard]] std::string canonical(const owl::Ontology& source, owl::TermId term);

}  // namespace geminga::manchester

#endif
