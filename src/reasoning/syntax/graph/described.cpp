// A walk from the resources along blank nodes, each visited once.
#include "reasoning/syntax/graph/described.hpp"

#include <set>
#include <vector>

#include "reasoning/syntax/graph/graph.hpp"
#include "reasoning/syntax/graph/literals.hpp"

namespace geminga::graph {
namespace {

/// The resources, each once, in the order in which they are met.
std::vector<TermNumber> resources_of(const ReadQuery& read, const Rows& rows, Terms& terms, Variables& variables) {
  std::vector<TermNumber> resources;
  std::vector<std::size_t> columns;
  raptor_sequence* named = rasqal_query_get_describe_sequence(read.query());
  const int count = named == nullptr ? 0 : raptor_sequence_size(named);
  for (int at = 0; at < count; ++at) {
    auto* literal = static_cast<rasqal_literal*>(raptor_sequence_get_at(named, at));
    if (const rasqal_variable* variable = rasqal_literal_as_variable(literal)) {
      columns.push_back(variables.number_of(*variable));
    } else if (const OwnedTerm term = term_of(terms.world(), literal)) {
      resources.push_back(terms.number_of(std::optional(node_of(*term))));
    }
  }
  std::set<TermNumber> seen(resources.begin(), resources.end());
  for (const Row& row : rows) {
    for (const std::size_t column : columns) {
      const TermNumber value = value_in(row, column);
      if (value != unbound && seen.insert(value).second) resources.push_back(value);
    }
  }
  return resources;
}

}  // namespace

std::expected<bool, std::string> describe(const ReadQuery& read, const Rows& rows, Terms& terms, Variables& variables,
                                          TripleIndex& index, const GraphLimits& limits, Statements& made) {
  std::vector<TermNumber> open = resources_of(read, rows, terms, variables);
  std::set<TermNumber> seen(open.begin(), open.end());
  std::size_t taken = 0;
  for (std::size_t at = 0; at < open.size(); ++at) {
    if (terms.node(open[at]).kind == Node::Kind::literal) continue;
    raptor_statement asked{};
    asked.subject = terms.term(open[at]);
    if (!index.step()) return true;
    for (const raptor_statement* candidate : index.candidates(asked)) {
      if (!index.step()) return true;
      if (!fits(*candidate, asked)) continue;
      taken += triple_octets + octets_of(*candidate->subject) + octets_of(*candidate->predicate) +
               octets_of(*candidate->object);
      if (made.size() >= limits.rows || taken > limits.query_octets) return false;
      if (!made.add_copy(candidate)) return std::unexpected("memory is short");
      if (candidate->object->type != RAPTOR_TERM_TYPE_BLANK) continue;
      const TermNumber object = terms.number_of(*candidate->object);
      if (seen.insert(object).second) open.push_back(object);
    }
  }
  return true;
}

}  // namespace geminga::graph
