// What Redland's Turtle writer gets wrong: it writes numbers and truth values bare, as they stand there.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TURTLE_NUMBERS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TURTLE_NUMBERS_HPP

#include <optional>
#include <string_view>

#include "reasoning/syntax/graph/node.hpp"

namespace geminga::graph {

/// Behind the IRI of a datatype: Redland does not know it, and so writes the literal in quotation marks. To be taken
/// out of what it has written.
inline constexpr std::string_view in_quotes = "-geminga-in-quotes";

/// A literal to write in place of this one; nothing where Redland writes it right. It has a lexical form of the same
/// value that is read as this datatype where it stands bare: `1` would be an integer and is `1.0` for a decimal. Where
/// there is none, as for `INF` and for what is not of its datatype, the datatype is marked.
[[nodiscard]] std::optional<Node> turtle_number(const Node& literal);

}  // namespace geminga::graph

#endif
