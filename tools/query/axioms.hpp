// The axioms of an explanation, for a terminal.
#ifndef GEMINGA_QUERY_AXIOMS_HPP
#define GEMINGA_QUERY_AXIOMS_HPP

#include "geminga/client.hpp"
#include "query/command.hpp"

namespace geminga::query {

/// Prints the axioms of an answer to `query explain`, each on a line with its file and line.
void print_axioms(const Context& context, const Answer& answer);

}  // namespace geminga::query

#endif
