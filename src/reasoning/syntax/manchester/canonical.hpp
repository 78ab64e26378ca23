// The canonical text of class expressions: what goes on the air and into identities.
#ifndef GEMINGA_REASONING_SYNTAX_MANCHESTER_CANONICAL_HPP
#define GEMINGA_REASONING_SYNTAX_MANCHESTER_CANONICAL_HPP

#include <string>

#include "reasoning/owl/source.hpp"

namespace geminga::manchester {

/// The canonical form (MANCHESTER.md): full IRIs, the members of `and`, `or` and braces sorted and each once. Equal for
/// expressions that differ in nothing else. parse() reads it again. The term is a class expression; its depth is that
/// of terms.
[[nodiscard]] std::string canonical(const owl::Ontology& source, owl::TermId term);

}  // namespace geminga::manchester

#endif
