#include "reasoning/syntax/graph/query.hpp"

#include <algorithm>
#include <memory>
#include <string_view>

#include "base/text.hpp"
#include "reasoning/syntax/graph/literals.hpp"
#include "reasoning/syntax/graph/store.hpp"
#include "reasoning/syntax/graph/triple_index.hpp"
#include "reasoning/syntax/graph/triples_source.hpp"

namespace geminga::graph {
namespace {

struct Free {
  void operator()(rasqal_query* query) const { rasqal_free_query(query); }
  void operator()(rasqal_query_results* results) const { rasqal_free_query_results(results); }
};
template <typename T>
using Owned = std::unique_ptr<T, Free>;

constexpr const char* language = "sparql";

/// Whether the query itself declares the prefix.
bool declares(std::string_view query, std::string_view prefix) {
  const std::string word = std::string(prefix) + ':';
  for (std::size_t at = query.find(word); at != std::string_view::npos; at = query.find(word, at + 1)) {
    const bool is_word = at > 0 && std::string_view(" \t\r\n").find(query[at - 1]) != std::string_view::npos;
    const std::size_t behind = query.find_first_not_of(" \t\r\n", at + word.size());
    if (is_word && behind != std::string_view::npos && query[behind] == '<') return true;
  }
  return false;
}

/// The prefixes on one line, so that the lines in errors stay right.
std::string with_prefixes(const std::string& query, const Prefixes& prefixes) {
  std::string text;
  for (const auto& [prefix, name] : prefixes) {
    const bool is_plain = std::ranges::all_of(prefix, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    });
    const bool is_iri = name.find_first_of("<>\"{}|\\^` ") == std::string::npos;
    if (is_plain && is_iri && !declares(query, prefix))
      text.append("PREFIX ").append(prefix).append(": <").append(name).append("> ");
  }
  return text + query;
}

/// The end of a quoted text of SPARQL that begins here, or of the query where it has none.
std::size_t end_of_quoted(std::string_view query, std::size_t at) {
  const std::string quote(1, query[at]);
  const std::string end = query.substr(at, 3) == quote + quote + quote ? quote + quote + quote : quote;
  for (at += end.size(); at < query.size(); ++at) {
    if (query.substr(at, end.size()) == end) return at + end.size();
    if (query[at] == '\\') ++at;
  }
  return query.size();
}

/// The query with a blank instead of each text, comment and IRI.
std::string bare(std::string_view query) {
  std::string kept;
  for (std::size_t at = 0; at < query.size();) {
    std::size_t end = at + 1;
    switch (query[at]) {
      case '"':
      case '\'':
        end = end_of_quoted(query, at);
        break;
      case '#':
        end = std::min(query.find_first_of("\r\n", at), query.size());
        break;
      case '<': {  // an IRI has none of these, and less-than has one of them behind it
        const std::size_t behind = query.find_first_of("<>\"{}|^`\\ \t\r\n", at + 1);
        if (behind != std::string_view::npos && query[behind] == '>') end = behind + 1;
        break;
      }
      case '\\':
        end = std::min(at + 2, query.size());
        break;
      default:
        break;
    }
    kept += end == at + 1 ? query[at] : ' ';
    at = end;
  }
  return kept;
}

/// How deep the braces of a bare query nest.
std::size_t levels_of(std::string_view query) {
  std::size_t deepest = 0;
  std::size_t level = 0;
  for (const char c : query) {
    if (c == '{') deepest = std::max(deepest, ++level);
    if (c == '}' && level > 0) --level;
  }
  return deepest;
}

constexpr std::string_view instead_of_exists = "write OPTIONAL { ... } FILTER(!bound(?x)) for what is not there";

/// Names what rasqal does not know of SPARQL 1.1, where that may be why it cannot read this bare query. `error` is its
/// own word, which ends with what it did not expect.
std::string hint_for(const std::string& query, std::string_view error) {
  if (base::in_lower_case(query).find("exists") != std::string::npos)
    return std::string("; rasqal does not know EXISTS: ").append(instead_of_exists);
  for (const std::string_view operation : {"'+'", "'*'", "'/'", "'^'", "'|'", "'!'", "'?'"}) {
    if (error.ends_with(operation)) return "; rasqal does not know paths of properties: write a triple for each step";
  }
  return {};
}

bool has_pattern(rasqal_graph_pattern* pattern, rasqal_graph_pattern_operator kind) {
  if (pattern == nullptr) return false;
  if (rasqal_graph_pattern_get_operator(pattern) == kind) return true;
  for (int at = 0;; ++at) {
    rasqal_graph_pattern* below = rasqal_graph_pattern_get_sub_graph_pattern(pattern, at);
    if (below == nullptr) return false;
    if (has_pattern(below, kind)) return true;
  }
}

/// Why a query that rasqal has read is refused.
std::optional<std::string> refusal_of(rasqal_query* query) {
  const rasqal_query_verb verb = rasqal_query_get_verb(query);
  const bool is_known =
      verb == RASQAL_QUERY_VERB_SELECT || verb == RASQAL_QUERY_VERB_ASK || verb == RASQAL_QUERY_VERB_CONSTRUCT;
  if (!is_known)
    return std::string(rasqal_query_verb_as_string(verb)) + " is not answered here: write SELECT, ASK or CONSTRUCT";
  raptor_sequence* sources = rasqal_query_get_data_graph_sequence(query);
  if (sources != nullptr && raptor_sequence_size(sources) > 0)
    return "FROM would fetch a graph, and nothing is fetched: name the file before the query";
  rasqal_graph_pattern* pattern = rasqal_query_get_query_graph_pattern(query);
  if (has_pattern(pattern, RASQAL_GRAPH_PATTERN_OPERATOR_SERVICE))
    return "SERVICE would ask another host, and nothing is fetched";
  if (has_pattern(pattern, RASQAL_GRAPH_PATTERN_OPERATOR_MINUS))
    return std::string("rasqal does not compute MINUS: ").append(instead_of_exists);
  return std::nullopt;
}

std::vector<std::string> variables_of(rasqal_query* query) {
  std::vector<std::string> variables;
  raptor_sequence* named = rasqal_query_get_bound_variable_sequence(query);
  for (int at = 0; named != nullptr && at < raptor_sequence_size(named); ++at) {
    const auto* variable = static_cast<const rasqal_variable*>(raptor_sequence_get_at(named, at));
    if (variable->name != nullptr) variables.emplace_back(reinterpret_cast<const char*>(variable->name));
  }
  return variables;
}

/// The octets of a row, about.
std::size_t octets_of(const std::vector<std::optional<Node>>& row) {
  std::size_t octets = sizeof row + row.size() * sizeof row.front();
  for (const auto& node : row) octets += node ? node->text.size() + node->datatype.size() + node->language.size() : 0;
  return octets;
}

void read_rows(World& world, rasqal_query_results* results, const GraphLimits& limits, Answer& answer) {
  const int count = rasqal_query_results_get_bindings_count(results);
  // rasqal does not know them for an answer without rows.
  if (count > 0) answer.variables.clear();
  for (int at = 0; at < count; ++at)
    answer.variables.emplace_back(reinterpret_cast<const char*>(rasqal_query_results_get_binding_name(results, at)));
  std::size_t octets = 0;
  for (; rasqal_query_results_finished(results) == 0; rasqal_query_results_next(results)) {
    if (answer.rows.size() >= limits.rows || octets > limits.query_octets) {
      answer.is_cut = true;
      return;
    }
    auto& row = answer.rows.emplace_back();
    for (int at = 0; at < count; ++at) {
      const OwnedTerm term = term_of(world, rasqal_query_results_get_binding_value(results, at));
      row.push_back(term == nullptr ? std::nullopt : std::optional(node_of(*term)));
    }
    octets += octets_of(row);
  }
}

std::optional<std::string> read_triples(World& world, rasqal_query_results* results, const Prefixes& prefixes,
                                        Format format, const GraphLimits& limits, Answer& answer) {
  Statements made(world);
  std::size_t octets = 0;
  while (const raptor_statement* triple = rasqal_query_results_get_triple(results)) {
    if (made.size() >= limits.rows || octets > limits.query_octets) {
      answer.is_cut = true;
      break;
    }
    octets += triple_octets + graph::octets_of(*triple->subject) + graph::octets_of(*triple->predicate) +
              graph::octets_of(*triple->object);
    if (!made.add_copy(triple)) return "memory is short";
    if (rasqal_query_results_next_triple(results) != 0) break;
  }
  made.sort();
  auto text = write(made, format, prefixes);
  if (!text) return text.error();
  answer.text = std::move(*text);
  return std::nullopt;
}

/// Reads what a query returned. Returns why that failed.
std::optional<std::string> read_answer(World& world, rasqal_query_results* results, const Prefixes& prefixes,
                                       Format format, const GraphLimits& limits, Answer& answer) {
  if (rasqal_query_results_is_boolean(results) != 0) {
    answer.kind = Answer::Kind::truth;
    answer.is_true = rasqal_query_results_get_boolean(results) > 0;
  } else if (rasqal_query_results_is_graph(results) != 0) {
    answer.kind = Answer::Kind::triples;
    return read_triples(world, results, prefixes, format, limits, answer);
  } else {
    read_rows(world, results, limits, answer);
  }
  return std::nullopt;
}

}  // namespace

std::expected<Answer, AskError> ask(const Graph& graph, const std::string& query, const Prefixes& prefixes,
                                    Format format, const GraphLimits& limits, base::Budget* budget,
                                    const FindInstances& find_instances) {
  const auto refuse = [](std::string text) { return std::unexpected(AskError{std::move(text)}); };
  if (query.size() > limits.query_bytes)
    return refuse("the query has more than " + std::to_string(limits.query_bytes) + " bytes");
  const std::string bare_query = bare(query);
  if (levels_of(bare_query) > limits.query_levels)
    return refuse("the query nests groups deeper than " + std::to_string(limits.query_levels) +
                  " levels, for which it would take too long: ask in several queries");
  if (!base::is_valid_utf8(query) || query.find('\0') != std::string::npos)
    return refuse("the query is no text in UTF-8");
  World& world = graph.store().world;
  const std::string text = with_prefixes(query, prefixes);
  const Owned<rasqal_query> asked(rasqal_new_query(world.rasqal(), language, nullptr));
  if (asked == nullptr) return refuse("memory is short");
  if (rasqal_query_prepare(asked.get(), octets(text), nullptr) != 0) {
    const std::string error = world.take_error();
    return refuse("the query cannot be read: " + (error.empty() ? "check its syntax" : error) +
                  hint_for(bare_query, error));
  }
  if (auto refusal = refusal_of(asked.get())) return refuse(std::move(*refusal));
  Expressions expressions(world);
  if (find_instances) {
    auto refusal = expressions.read(asked.get());
    if (!refusal) refusal = expressions.find(find_instances);
    if (refusal) return refuse(std::move(*refusal));
  }

  Answer answer;
  answer.variables = variables_of(asked.get());
  TripleIndex index(graph.store().statements.all(), limits, budget);
  TriplesSource source(world, index, expressions);
  if (!source.serve(asked.get())) return refuse("memory is short");
  const Owned<rasqal_query_results> results(rasqal_query_execute(asked.get()));
  if (index.problem()) return std::unexpected(AskError{*index.problem(), true});
  if (!results) {
    const std::string error = world.take_error();
    return refuse("the query cannot be answered: " +
                  (error.empty() ? "rasqal cannot compute an operation of it" : error));
  }
  auto failed = read_answer(world, results.get(), prefixes, format, limits, answer);
  if (index.problem()) return std::unexpected(AskError{*index.problem(), true});
  if (failed) return refuse(std::move(*failed));
  if (const std::string error = world.take_error(); !error.empty())
    return refuse("the query cannot be answered: " + error);
  return answer;
}

}  // namespace geminga::graph
