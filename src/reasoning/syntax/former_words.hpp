// Words of OWL's predecessors and drafts, and what OWL 2 calls them.
#ifndef GEMINGA_REASONING_SYNTAX_FORMER_WORDS_HPP
#define GEMINGA_REASONING_SYNTAX_FORMER_WORDS_HPP

#include <optional>
#include <string>
#include <string_view>

namespace geminga::syntax {

/// Last cell of a list in files that mistype rdf:nil.
inline constexpr std::string_view mistyped_nil = "http://www.w3.org/1999/02/22-rdf-syntax-ns#nill";

/// The IRI of OWL 2 for a word of DAML+OIL (2000 and 2001), of the working drafts of OWL (2002), OWL 1.1 (2006) and
/// OWL 2 (2008); nothing for any other IRI. A word of DAML+OIL or of OWL 1.1's own namespace that has no counterpart is
/// taken into OWL's namespace, so that it is named as what OWL does not have, and never taken for an annotation.
[[nodiscard]] std::optional<std::string> word_of_owl2(std::string_view iri);

}  // namespace geminga::syntax

#endif
