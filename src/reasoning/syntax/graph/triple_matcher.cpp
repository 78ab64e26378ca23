#include "reasoning/syntax/graph/triple_matcher.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "reasoning/syntax/graph/existence.hpp"

namespace geminga::graph {
namespace {

using Part = raptor_term* raptor_statement::*;
constexpr std::array<Part, 3> all_parts{&raptor_statement::subject, &raptor_statement::predicate,
                                        &raptor_statement::object};

std::array<rasqal_literal*, 3> literals_in(const rasqal_triple& triple) {
  return {triple.subject, triple.predicate, triple.object};
}

}  // namespace

TripleMatcher::Triples TripleMatcher::triples_of(rasqal_graph_pattern* basic) {
  Triples triples;
  for (int at = 0;; ++at) {
    const rasqal_triple* triple = rasqal_graph_pattern_get_triple(basic, at);
    if (triple == nullptr) return triples;
    if (!is_mark(*triple)) triples.push_back(triple);
  }
}

TermNumber TripleMatcher::known(rasqal_literal* literal, const Row& row, bool is_of_expression) {
  const std::string_view label = blank_name(literal);
  const rasqal_variable* variable = rasqal_literal_as_variable(literal);
  const bool is_node = is_of_expression && expressions_.has_node(label);
  if (variable != nullptr && !is_node) return value_in(row, variables_.number_of(*variable));
  const auto [place, is_new] = constants_.try_emplace(literal, unbound);
  if (is_new) {
    const OwnedTerm term = is_node ? nullptr : term_of(terms_.world(), literal);
    place->second = terms_.number_of(is_node           ? std::optional(blank(std::string(label)))
                                     : term == nullptr ? std::nullopt
                                                       : std::optional(node_of(*term)));
  }
  return place->second;
}

std::size_t TripleMatcher::place_of_next(const Triples& triples, const Row& row) {
  std::size_t best = 0;
  int most = -1;
  for (std::size_t at = 0; at < triples.size(); ++at) {
    const bool is_of_expression = expressions_.answers(*triples[at]);
    const auto literals = literals_in(*triples[at]);
    int score = 0;
    for (std::size_t part = 0; part < literals.size(); ++part) {
      // A subject or object tells more than a predicate, which many triples have.
      if (known(literals[part], row, is_of_expression) != unbound) score += part == 1 ? 1 : 3;
    }
    if (score > most) {
      most = score;
      best = at;
    }
  }
  return best;
}

void TripleMatcher::match(Triples triples, Row row, std::size_t most, Rows& found) {
  if (most > 0 && found.size() >= most) return;
  if (triples.empty()) {
    found.push_back(std::move(row));
    return;
  }
  const std::size_t next = place_of_next(triples, row);
  const rasqal_triple& triple = *triples[next];
  triples.erase(triples.begin() + static_cast<std::ptrdiff_t>(next));
  const bool is_of_expression = expressions_.answers(triple);
  const auto literals = literals_in(triple);
  raptor_statement asked{};
  std::array<std::optional<std::size_t>, 3> open;
  for (std::size_t at = 0; at < literals.size(); ++at) {
    const TermNumber value = known(literals[at], row, is_of_expression);
    asked.*all_parts[at] = terms_.term(value);
    if (value == unbound) open[at] = variables_.number_of(*rasqal_literal_as_variable(literals[at]));
  }
  const auto candidates =
      is_of_expression ? TripleIndex::candidates(expressions_.triples().all(), asked) : index_.candidates(asked);
  if (!index_.step()) return;
  for (const raptor_statement* candidate : candidates) {
    if (!index_.step()) return;
    if (!fits(*candidate, asked)) continue;
    Row with = row;
    bool agrees = true;
    for (std::size_t at = 0; at < open.size() && agrees; ++at) {
      if (!open[at]) continue;
      const TermNumber value = terms_.number_of(*(candidate->*all_parts[at]));
      const TermNumber before = value_in(with, *open[at]);
      agrees = before == unbound || before == value;
      set_in(with, *open[at], value);
    }
    if (agrees) match(triples, std::move(with), most, found);
    if (most > 0 && found.size() >= most) return;
  }
}

void TripleMatcher::add_variables(const Triples& triples, std::set<std::size_t>& variables) const {
  for (const rasqal_triple* triple : triples) {
    for (rasqal_literal* literal : literals_in(*triple)) {
      const rasqal_variable* variable = rasqal_literal_as_variable(literal);
      if (variable != nullptr && !expressions_.has_node(blank_name(literal)))
        variables.insert(variables_.number_of(*variable));
    }
  }
}

}  // namespace geminga::graph
