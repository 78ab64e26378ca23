// What Redland's Turtle writer gets wrong: it writes numbers and truth values bare, as they stand there.
#ifndef GEMINGA_GRAPH_TURTLE_NUMBERS_HPP
#define GEMINGA_GRAPH_TURTLE_NUMBERS_HPP

#include <expected>
#include <optional>
#include <string>

#include "graph/node.hpp"

namespace geminga::graph {

/// A lexical form of the same value that is read as this datatype where it stands bare: `1` would be an integer and is
/// `1.0` for a decimal; nothing where the one that it has will do. An error, in one line, where there is none.
[[nodiscard]] std::expected<std::optional<std::string>, std::string> turtle_number(const Node& literal);

}  // namespace geminga::graph

#endif
