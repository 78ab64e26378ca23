#include "reasoning/syntax/graph/reading.hpp"

#include <functional>
#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/graph/existence.hpp"
#include "reasoning/syntax/graph/formulas/formulas.hpp"
#include "reasoning/syntax/graph/query_text.hpp"
#include "reasoning/syntax/graph/selection.hpp"

namespace geminga::graph {
namespace {

constexpr const char* sparql = "sparql";

/// Names what rasqal does not know of SPARQL 1.1, where that may be why it cannot read this query. `error` is its own
/// word, which ends with what it did not expect.
std::string hint_for(const std::string& query, std::string_view error) {
  if (base::in_lower_case(masked(query)).find("exists") != std::string::npos)
    return "; rasqal does not know EXISTS: write it as a filter of its own, FILTER EXISTS { ... } or FILTER NOT EXISTS "
           "{ ... }, beside the triples of its group";
  for (const std::string_view operation : {"'+'", "'*'", "'/'", "'^'", "'|'", "'!'", "'?'"}) {
    if (error.ends_with(operation))
      return "; rasqal does not know paths of properties: write a triple for each step, and rdfs:subClassOf for "
             "rdfs:subClassOf*, since what follows is there, too";
  }
  return {};
}

std::expected<OwnedQuery, std::string> prepared(World& world, const std::string& text) {
  OwnedQuery query(rasqal_new_query(world.rasqal(), sparql, nullptr));
  if (query == nullptr) return std::unexpected("memory is short");
  if (rasqal_query_prepare(query.get(), octets(text), nullptr) == 0) return query;
  const std::string error = world.take_error();
  return std::unexpected("the query cannot be read: " + (error.empty() ? "check its syntax" : error) +
                         hint_for(text, error));
}

/// Calls `use` for a pattern and those below, in the order of the text, but not for those of inner queries.
void for_each_pattern(rasqal_graph_pattern* pattern, const std::function<void(rasqal_graph_pattern*)>& use) {
  if (pattern == nullptr) return;
  use(pattern);
  if (rasqal_graph_pattern_get_operator(pattern) == RASQAL_GRAPH_PATTERN_OPERATOR_SELECT) return;
  for (rasqal_graph_pattern* below : parts_of(pattern)) for_each_pattern(below, use);
}

template <typename T>
std::vector<T*> items_of(raptor_sequence* sequence) {
  std::vector<T*> items;
  for (int at = 0; sequence != nullptr && at < raptor_sequence_size(sequence); ++at)
    items.push_back(static_cast<T*>(raptor_sequence_get_at(sequence, at)));
  return items;
}

/// Why a group of EXISTS is refused: what SPARQL 1.1 leaves open, and readers decide in several ways.
std::optional<std::string> refusal_in_existence(rasqal_graph_pattern* existence) {
  std::optional<std::string> refusal;
  for_each_pattern(existence, [&](rasqal_graph_pattern* below) {
    const auto kind = rasqal_graph_pattern_get_operator(below);
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_MINUS)
      refusal = "MINUS within EXISTS: write FILTER NOT EXISTS instead of MINUS there";
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_SELECT) refusal = "SELECT within EXISTS: write its pattern alone";
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_LET) refusal = "BIND within EXISTS: write it before the filter";
  });
  return refusal;
}

/// Why a pattern is refused.
std::optional<std::string> refusal_of_pattern(rasqal_graph_pattern* pattern) {
  switch (rasqal_graph_pattern_get_operator(pattern)) {
    case RASQAL_GRAPH_PATTERN_OPERATOR_SERVICE:
      return "SERVICE would ask another host, and nothing is fetched";
    case RASQAL_GRAPH_PATTERN_OPERATOR_FILTER: {
      const rasqal_expression* filter = rasqal_graph_pattern_get_filter_expression(pattern);
      // rasqal writes this for a filter whose variables the group does not bind, whatever the filter says.
      if (filter != nullptr && filter->op == RASQAL_EXPR_LITERAL && filter->literal != nullptr &&
          filter->literal->type == RASQAL_LITERAL_BOOLEAN)
        return "a FILTER is of variables that its group { ... } does not bind, or of none: write it into the group "
               "that binds them";
      return refusal_of(filter);
    }
    case RASQAL_GRAPH_PATTERN_OPERATOR_OPTIONAL:
      return existence_of(pattern) ? refusal_in_existence(pattern) : std::nullopt;
    case RASQAL_GRAPH_PATTERN_OPERATOR_LET:
      return refusal_of(rasqal_graph_pattern_get_filter_expression(pattern));
    default:
      return std::nullopt;
  }
}

/// Why the part of a query behind its pattern is refused.
std::optional<std::string> refusal_of_selection(rasqal_query* query) {
  for (const rasqal_variable* variable : items_of<rasqal_variable>(rasqal_query_get_bound_variable_sequence(query))) {
    if (auto refusal = refusal_of(variable->expression)) return refusal;
  }
  for (raptor_sequence* conditions :
       {rasqal_query_get_group_conditions_sequence(query), rasqal_query_get_having_conditions_sequence(query),
        rasqal_query_get_order_conditions_sequence(query)}) {
    for (const rasqal_expression* formula : items_of<rasqal_expression>(conditions)) {
      if (auto refusal = refusal_of(formula)) return refusal;
    }
  }
  return std::nullopt;
}

/// Why a query that rasqal has read is refused.
std::optional<std::string> refusal_of_query(rasqal_query* query, bool is_inner) {
  const rasqal_query_verb verb = rasqal_query_get_verb(query);
  const bool is_known = verb == RASQAL_QUERY_VERB_SELECT || verb == RASQAL_QUERY_VERB_ASK ||
                        verb == RASQAL_QUERY_VERB_CONSTRUCT || verb == RASQAL_QUERY_VERB_DESCRIBE;
  if (!is_known)
    return std::string(rasqal_query_verb_as_string(verb)) +
           " is not answered here: write SELECT, ASK, CONSTRUCT or DESCRIBE";
  if (is_inner && verb != RASQAL_QUERY_VERB_SELECT) return "a query within a query must be SELECT";
  raptor_sequence* sources = rasqal_query_get_data_graph_sequence(query);
  if (sources != nullptr && raptor_sequence_size(sources) > 0)
    return "FROM would fetch a graph, and nothing is fetched: name the file before the query";
  std::optional<std::string> refusal = refusal_of_selection(query);
  for_each_pattern(rasqal_query_get_query_graph_pattern(query), [&](rasqal_graph_pattern* pattern) {
    if (!refusal) refusal = refusal_of_pattern(pattern);
  });
  return refusal;
}

/// The terms of values, which are read as the objects of triples.
std::expected<GivenValues, std::string> given_values(Terms& terms, const std::string& prologue,
                                                     const WrittenValues& written) {
  GivenValues values{written.variables, {}};
  std::string triples;
  for (const auto& row : written.rows) {
    for (const auto& value : row) {
      if (value) triples.append("?s ?p ").append(*value).append(" . ");
    }
  }
  const auto query = prepared(terms.world(), prologue + "ASK { " + triples + "}");
  if (!query) return std::unexpected(query.error());
  const auto read = items_of<rasqal_triple>(rasqal_query_get_triple_sequence(query->get()));
  std::size_t next = 0;
  for (const auto& row : written.rows) {
    Row& given = values.rows.emplace_back();
    for (const auto& value : row) {
      const OwnedTerm term =
          value && next < read.size() ? term_of(terms.world(), read[next++]->object) : OwnedTerm(nullptr);
      if (value && term == nullptr) return std::unexpected("a value of VALUES is no IRI and no literal");
      given.push_back(term == nullptr ? unbound : terms.number_of(std::optional(node_of(*term))));
    }
  }
  return values;
}

}  // namespace

std::vector<rasqal_graph_pattern*> parts_of(rasqal_graph_pattern* pattern) {
  return items_of<rasqal_graph_pattern>(rasqal_graph_pattern_get_sub_graph_pattern_sequence(pattern));
}

std::vector<const rasqal_variable*> selected(const ReadQuery& read) {
  const auto variables = items_of<rasqal_variable>(rasqal_query_get_bound_variable_sequence(read.query()));
  std::vector<const rasqal_variable*> named(variables.begin(), variables.end());
  if (rasqal_query_get_wildcard(read.query()) == 0) return named;
  const auto visible = read.visible();
  std::erase_if(named, [&](const rasqal_variable* variable) {
    return !visible.contains(reinterpret_cast<const char*>(variable->name));
  });
  return named;
}

std::set<std::string, std::less<>> ReadQuery::visible() const {
  std::set<std::string, std::less<>> names;
  const auto take = [&](const rasqal_variable* variable) {
    if (variable != nullptr) names.emplace(reinterpret_cast<const char*>(variable->name));
  };
  const std::function<void(rasqal_graph_pattern*)> walk = [&](rasqal_graph_pattern* pattern) {
    const auto kind = rasqal_graph_pattern_get_operator(pattern);
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_MINUS || existence_of(pattern)) return;
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_SELECT) {
      for (const rasqal_variable* variable : selected(inner(pattern))) take(variable);
      return;
    }
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_LET) take(rasqal_graph_pattern_get_variable(pattern));
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_VALUES) {
      const auto& given = values(pattern).variables;
      names.insert(given.begin(), given.end());
    }
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_BASIC) {
      for (int at = 0; const rasqal_triple* triple = rasqal_graph_pattern_get_triple(pattern, at); ++at) {
        for (rasqal_literal* literal : {triple->subject, triple->predicate, triple->object}) {
          if (blank_name(literal).empty()) take(rasqal_literal_as_variable(literal));
        }
      }
    }
    for (rasqal_graph_pattern* below : parts_of(pattern)) walk(below);
  };
  if (pattern() != nullptr) walk(pattern());
  if (last_) names.insert(last_->variables.begin(), last_->variables.end());
  return names;
}

const rasqal_expression* ReadQuery::formula_of(const rasqal_variable& variable) const {
  const std::string_view name = reinterpret_cast<const char*>(variable.name);
  for (const auto& inner : inner_) {
    for (const rasqal_variable* other : selected(*inner)) {
      if (name == reinterpret_cast<const char*>(other->name)) return nullptr;
    }
  }
  return variable.expression;
}

std::vector<rasqal_triple*> ReadQuery::triples() const {
  std::vector<rasqal_triple*> triples;
  for_each_pattern(pattern(), [&](rasqal_graph_pattern* below) {
    if (rasqal_graph_pattern_get_operator(below) != RASQAL_GRAPH_PATTERN_OPERATOR_BASIC) return;
    for (int at = 0; rasqal_triple* triple = rasqal_graph_pattern_get_triple(below, at); ++at)
      triples.push_back(triple);
  });
  return triples;
}

std::expected<std::unique_ptr<ReadQuery>, std::string> ReadQuery::read(Terms& terms, const std::string& text,
                                                                       bool is_inner) {
  auto query = prepared(terms.world(), text);
  if (!query) return std::unexpected(query.error());
  if (auto refusal = refusal_of_query(query->get(), is_inner)) return std::unexpected(std::move(*refusal));
  std::unique_ptr<ReadQuery> read(new ReadQuery);
  read->query_ = std::move(*query);
  if (auto refusal = read->read_inner(terms, text)) return std::unexpected(std::move(*refusal));
  if (auto refusal = refusal_of_selected(*read)) return std::unexpected(std::move(*refusal));
  (void)terms.world().take_error();  // rasqal's remarks on variables that are not used
  return read;
}

std::optional<std::string> ReadQuery::read_inner(Terms& terms, const std::string& text) {
  std::vector<const rasqal_graph_pattern*> queries;
  std::vector<const rasqal_graph_pattern*> blocks;
  for_each_pattern(pattern(), [&](rasqal_graph_pattern* below) {
    const auto kind = rasqal_graph_pattern_get_operator(below);
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_SELECT) queries.push_back(below);
    if (kind == RASQAL_GRAPH_PATTERN_OPERATOR_VALUES) blocks.push_back(below);
  });
  const auto inner = inner_texts(text);
  if (!inner || inner->queries.size() != queries.size() || inner->values.size() != blocks.size())
    return "the queries or VALUES within it cannot be told apart: write them apart";
  const std::string prologue = prologue_of(text);
  for (std::size_t at = 0; at < queries.size(); ++at) {
    auto read = ReadQuery::read(terms, prologue + inner->queries[at], true);
    if (!read) return read.error();
    place_of_inner_.emplace(queries[at], inner_.size());
    inner_.push_back(std::move(*read));
  }
  for (std::size_t at = 0; at < blocks.size(); ++at) {
    auto values = given_values(terms, prologue, inner->values[at]);
    if (!values) return values.error();
    values_.emplace(blocks[at], std::move(*values));
  }
  if (inner->last) {
    auto values = given_values(terms, prologue, *inner->last);
    if (!values) return values.error();
    last_ = std::move(*values);
  }
  return std::nullopt;
}

}  // namespace geminga::graph
