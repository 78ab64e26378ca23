// FILTER EXISTS and FILTER NOT EXISTS (SPARQL 1.1 Query Language, section 8.1), which rasqal cannot read.
//
// `FILTER NOT EXISTS { ... }` is given to it as an OPTIONAL with a triple that no file has. OPTIONAL is what it leaves
// as it stands, and what may have a filter of variables of the group around it.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_EXISTENCE_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_EXISTENCE_HPP

#include <optional>
#include <string>

#include "reasoning/syntax/graph/terms/terms.hpp"

namespace geminga::graph {

/// The query with such an OPTIONAL for each filter that is EXISTS or NOT EXISTS and nothing else. Lines stay lines.
[[nodiscard]] std::string with_marked_existence(const std::string& query);

/// Whether this is the triple that marks such an OPTIONAL.
[[nodiscard]] bool is_mark(const rasqal_triple& triple);
/// The filter that an OPTIONAL stands for: true for EXISTS, false for NOT EXISTS; nothing for an OPTIONAL.
[[nodiscard]] std::optional<bool> existence_of(rasqal_graph_pattern* optional);

}  // namespace geminga::graph

#endif
