// Numbers and truth values, which Redland's Turtle writer writes without quotation marks, whatever their lexical form
// is.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TURTLE_NUMBERS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TURTLE_NUMBERS_HPP

#include <optional>
#include <string_view>

#include "reasoning/syntax/graph/axioms/node.hpp"

namespace geminga::graph {

/// Appended to the IRI of a datatype. Redland does not know the result, and so writes the literal in quotation marks.
/// The mark must be removed from the text afterwards.
inline constexpr std::string_view in_quotes = "-geminga-in-quotes";

/// The literal to write in place of this one. Nothing if Redland writes it correctly. It has another lexical form of
/// the same value that is read as this datatype without quotation marks: `1` would be an integer, and is `1.0` for a
/// decimal. If there is none, as for `INF` and for ill-typed literals, the datatype is marked.
[[nodiscard]] std::optional<Node> turtle_number(const Node& literal);

}  // namespace geminga::graph

#endif
