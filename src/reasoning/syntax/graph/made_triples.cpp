// Templates are filled for each row, and resources are followed along blank nodes, each visited once.
#include "reasoning/syntax/graph/made_triples.hpp"

#include <set>
#include <string_view>
#include <utility>

#include "reasoning/syntax/graph/store.hpp"
#include "reasoning/syntax/graph/terms/literals.hpp"

namespace geminga::graph {
namespace {

/// The triples that CONSTRUCT makes: those of its template, or of its pattern where it has none.
std::vector<const rasqal_triple*> made_triples(rasqal_query* query) {
  raptor_sequence* triples = rasqal_query_get_construct_triples_sequence(query);
  if (triples == nullptr) triples = rasqal_query_get_triple_sequence(query);
  std::vector<const rasqal_triple*> made;
  for (int at = 0; triples != nullptr && at < raptor_sequence_size(triples); ++at)
    made.push_back(static_cast<const rasqal_triple*>(raptor_sequence_get_at(triples, at)));
  return made;
}

/// The node that stands in a template for a row. A blank node is another one for each row.
std::optional<Node> made_node(rasqal_literal* literal, const Row& row, std::size_t number, Terms& terms,
                              Variables& variables) {
  const rasqal_variable* variable = rasqal_literal_as_variable(literal);
  const TermNumber value = variable == nullptr ? unbound : value_in(row, variables.number_of(*variable));
  if (value != unbound) return terms.node(value);
  if (const std::string_view label = blank_name(literal); !label.empty())
    return blank("c" + std::to_string(number) + "u" + label_of(label));
  if (variable != nullptr) return std::nullopt;
  const OwnedTerm term = term_of(terms.world(), literal);
  return term == nullptr ? std::nullopt : std::optional(node_of(*term));
}

}  // namespace

bool MadeTriples::take_room(std::size_t text_octets) {
  octets_ += triple_octets + text_octets;
  return statements_.size() < limits_.rows && octets_ <= limits_.query_octets;
}

std::expected<bool, std::string> MadeTriples::add(const Node& subject, const Node& predicate, const Node& object) {
  if (!take_room(subject.text.size() + predicate.text.size() + object.text.size())) return false;
  if (!statements_.add(subject, predicate, object)) return std::unexpected("memory is short");
  return true;
}

std::expected<bool, std::string> MadeTriples::add_copy(const raptor_statement& statement) {
  if (!take_room(octets_of(*statement.subject) + octets_of(*statement.predicate) + octets_of(*statement.object)))
    return false;
  if (!statements_.add_copy(&statement)) return std::unexpected("memory is short");
  return true;
}

std::expected<std::string, std::string> MadeTriples::sorted_text(Format format, const Prefixes& prefixes) {
  statements_.sort();
  return write(statements_, format, prefixes);
}

std::expected<bool, std::string> construct(const ReadQuery& read, const Rows& rows, Terms& terms, Variables& variables,
                                           MadeTriples& made) {
  const auto triples = made_triples(read.query());
  for (std::size_t at = 0; at < rows.size(); ++at) {
    for (const rasqal_triple* triple : triples) {
      const auto subject = made_node(triple->subject, rows[at], at, terms, variables);
      const auto predicate = made_node(triple->predicate, rows[at], at, terms, variables);
      const auto object = made_node(triple->object, rows[at], at, terms, variables);
      if (!subject || !predicate || !object) continue;  // section 16.2: what is no triple is left out
      if (subject->kind == Node::Kind::literal || predicate->kind != Node::Kind::iri) continue;
      if (auto has_room = made.add(*subject, *predicate, *object); !has_room || !*has_room) return has_room;
    }
  }
  return true;
}

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

std::expected<bool, std::string> describe(std::vector<TermNumber> resources, Terms& terms, TripleIndex& index,
                                          MadeTriples& made) {
  std::set<TermNumber> seen(resources.begin(), resources.end());
  for (std::size_t at = 0; at < resources.size(); ++at) {
    if (terms.node(resources[at]).kind == Node::Kind::literal) continue;
    raptor_statement asked{};
    asked.subject = terms.term(resources[at]);
    if (!index.step()) return true;
    for (const raptor_statement* candidate : index.candidates(asked)) {
      if (!index.step()) return true;
      if (!fits(*candidate, asked)) continue;
      if (auto has_room = made.add_copy(*candidate); !has_room || !*has_room) return has_room;
      if (candidate->object->type != RAPTOR_TERM_TYPE_BLANK) continue;
      const TermNumber object = terms.number_of(*candidate->object);
      if (seen.insert(object).second) resources.push_back(object);
    }
  }
  return true;
}

}  // namespace geminga::graph
