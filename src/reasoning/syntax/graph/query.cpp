#include "reasoning/syntax/graph/query.hpp"

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <set>
#include <string_view>

#include "base/text.hpp"
#include "reasoning/syntax/graph/axiom_triples.hpp"
#include "reasoning/syntax/graph/store.hpp"
#include "reasoning/syntax/graph/triple_index.hpp"

namespace geminga::graph {
namespace {

struct Free {
  void operator()(rasqal_query* query) const { rasqal_free_query(query); }
  void operator()(librdf_query* query) const { librdf_free_query(query); }
  void operator()(librdf_query_results* results) const { librdf_free_query_results(results); }
  void operator()(librdf_storage* storage) const { librdf_free_storage(storage); }
  void operator()(librdf_model* model) const { librdf_free_model(model); }
  void operator()(librdf_stream* stream) const { librdf_free_stream(stream); }
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

/// How deep the braces of a query nest, without those in texts, comments and IRIs.
std::size_t levels_of(std::string_view query) {
  std::size_t deepest = 0;
  std::size_t level = 0;
  for (std::size_t at = 0; at < query.size();) {
    switch (query[at]) {
      case '"':
      case '\'':
        at = end_of_quoted(query, at);
        continue;
      case '#':
        at = std::min(query.find_first_of("\r\n", at), query.size());
        continue;
      case '<': {  // an IRI has none of these, and less-than has one of them behind it
        const std::size_t end = query.find_first_of("<>\"{}|^`\\ \t\r\n", at + 1);
        at = end != std::string_view::npos && query[end] == '>' ? end : at;
        break;
      }
      case '\\':
        ++at;
        break;
      case '{':
        deepest = std::max(deepest, ++level);
        break;
      case '}':
        level -= level == 0 ? 0 : 1;
        break;
      default:
        break;
    }
    ++at;
  }
  return deepest;
}

bool has_service(rasqal_graph_pattern* pattern) {
  if (pattern == nullptr) return false;
  if (rasqal_graph_pattern_get_operator(pattern) == RASQAL_GRAPH_PATTERN_OPERATOR_SERVICE) return true;
  for (int at = 0;; ++at) {
    rasqal_graph_pattern* below = rasqal_graph_pattern_get_sub_graph_pattern(pattern, at);
    if (below == nullptr) return false;
    if (has_service(below)) return true;
  }
}

/// The name of a blank node or of a variable that stands for one; empty for what is named.
std::string_view blank_name(const rasqal_literal* literal) {
  if (literal == nullptr) return {};
  if (literal->type == RASQAL_LITERAL_BLANK) return reinterpret_cast<const char*>(literal->string);
  if (literal->type != RASQAL_LITERAL_VARIABLE || literal->value.variable->type != RASQAL_VARIABLE_TYPE_ANONYMOUS)
    return {};
  return reinterpret_cast<const char*>(literal->value.variable->name);
}

bool is_one_of(const rasqal_literal* literal, std::initializer_list<std::string_view> names) {
  if (literal == nullptr || literal->type != RASQAL_LITERAL_URI) return false;
  const std::string_view uri = reinterpret_cast<const char*>(raptor_uri_as_string(literal->value.uri));
  return std::ranges::find(names, uri) != names.end();
}

/// Whether a query asks for the instances of a class expression: ?x a [ owl:onProperty ... ].
bool asks_for_instances(rasqal_query* query) {
  std::set<std::string_view> types;
  std::set<std::string_view> expressions;
  raptor_sequence* triples = rasqal_query_get_triple_sequence(query);
  for (int at = 0; triples != nullptr && at < raptor_sequence_size(triples); ++at) {
    const auto* triple = static_cast<const rasqal_triple*>(raptor_sequence_get_at(triples, at));
    if (is_one_of(triple->predicate, {rdf_type})) types.insert(blank_name(triple->object));
    if (is_one_of(triple->predicate,
                  {"http://www.w3.org/2002/07/owl#onProperty", "http://www.w3.org/2002/07/owl#unionOf",
                   "http://www.w3.org/2002/07/owl#intersectionOf", "http://www.w3.org/2002/07/owl#complementOf",
                   "http://www.w3.org/2002/07/owl#oneOf"}))
      expressions.insert(blank_name(triple->subject));
  }
  return std::ranges::any_of(types, [&](std::string_view of) { return !of.empty() && expressions.contains(of); });
}

/// Why a query is refused, or its variables. Rasqal reads the query and does nothing else with it.
std::optional<std::string> refusal_of(World& world, const std::string& query, Expressions expressions,
                                      std::vector<std::string>& variables) {
  const Owned<rasqal_query> read(rasqal_new_query(world.rasqal(), language, nullptr));
  if (read == nullptr) return "memory is short";
  if (rasqal_query_prepare(read.get(), octets(query), nullptr) != 0) {
    const std::string error = world.take_error();
    return "the query cannot be read: " + (error.empty() ? "check its syntax" : error);
  }
  const rasqal_query_verb verb = rasqal_query_get_verb(read.get());
  const bool is_known =
      verb == RASQAL_QUERY_VERB_SELECT || verb == RASQAL_QUERY_VERB_ASK || verb == RASQAL_QUERY_VERB_CONSTRUCT;
  if (!is_known)
    return std::string(rasqal_query_verb_as_string(verb)) + " is not answered here: write SELECT, ASK or CONSTRUCT";
  raptor_sequence* sources = rasqal_query_get_data_graph_sequence(read.get());
  if (sources != nullptr && raptor_sequence_size(sources) > 0)
    return "FROM would fetch a graph, and nothing is fetched: name the file before the query";
  if (has_service(rasqal_query_get_query_graph_pattern(read.get())))
    return "SERVICE would ask another host, and nothing is fetched";
  if (expressions == Expressions::are_refused && asks_for_instances(read.get()))
    return "the instances of a class expression are no triples: ask geminga-ontology instances, or --asserted only";
  raptor_sequence* named = rasqal_query_get_bound_variable_sequence(read.get());
  for (int at = 0; named != nullptr && at < raptor_sequence_size(named); ++at) {
    const auto* variable = static_cast<const rasqal_variable*>(raptor_sequence_get_at(named, at));
    if (variable->name != nullptr) variables.emplace_back(reinterpret_cast<const char*>(variable->name));
  }
  return std::nullopt;
}

/// The octets of a row, about.
std::size_t octets_of(const std::vector<std::optional<Node>>& row) {
  std::size_t octets = sizeof row + row.size() * sizeof row.front();
  for (const auto& node : row) octets += node ? node->text.size() + node->datatype.size() + node->language.size() : 0;
  return octets;
}

void read_rows(librdf_query_results* results, const GraphLimits& limits, Answer& answer) {
  const int count = librdf_query_results_get_bindings_count(results);
  // librdf does not know them for an answer without rows.
  if (count > 0) answer.variables.clear();
  for (int at = 0; at < count; ++at) answer.variables.emplace_back(librdf_query_results_get_binding_name(results, at));
  std::size_t octets = 0;
  for (; librdf_query_results_finished(results) == 0; librdf_query_results_next(results)) {
    if (answer.rows.size() >= limits.rows || octets > limits.query_octets) {
      answer.is_cut = true;
      return;
    }
    auto& row = answer.rows.emplace_back();
    for (int at = 0; at < count; ++at) {
      librdf_node* node = librdf_query_results_get_binding_value(results, at);
      row.push_back(node == nullptr ? std::nullopt : std::optional(node_of(*node)));
      if (node != nullptr) librdf_free_node(node);
    }
    octets += octets_of(row);
  }
}

std::optional<std::string> read_triples(World& world, librdf_query_results* results, const Prefixes& prefixes,
                                        Format format, const GraphLimits& limits, Answer& answer) {
  Statements made(world);
  std::size_t octets = 0;
  const Owned<librdf_stream> stream(librdf_query_results_as_stream(results));
  for (; stream != nullptr && librdf_stream_end(stream.get()) == 0; librdf_stream_next(stream.get())) {
    if (made.size() >= limits.rows || octets > limits.query_octets) {
      answer.is_cut = true;
      break;
    }
    const librdf_statement* triple = librdf_stream_get_object(stream.get());
    octets += triple_octets + graph::octets_of(*triple->subject) + graph::octets_of(*triple->predicate) +
              graph::octets_of(*triple->object);
    if (!made.add_copy(triple)) return "memory is short";
  }
  made.sort();
  auto text = write(world, made, format, prefixes);
  if (!text) return text.error();
  answer.text = std::move(*text);
  return std::nullopt;
}

}  // namespace

std::expected<Answer, AskError> ask(const Graph& graph, const std::string& query, const Prefixes& prefixes,
                                    Format format, const GraphLimits& limits, base::Budget* budget,
                                    Expressions expressions) {
  const auto refuse = [](std::string text) { return std::unexpected(AskError{std::move(text)}); };
  if (query.size() > limits.query_bytes)
    return refuse("the query has more than " + std::to_string(limits.query_bytes) + " bytes");
  if (levels_of(query) > limits.query_levels)
    return refuse("the query nests groups deeper than " + std::to_string(limits.query_levels) +
                  " levels, for which it would take too long: ask in several queries");
  if (!base::is_valid_utf8(query) || query.find('\0') != std::string::npos)
    return refuse("the query is no text in UTF-8");
  World& world = graph.store().world;
  const std::string text = with_prefixes(query, prefixes);
  Answer answer;
  if (auto refusal = refusal_of(world, text, expressions, answer.variables)) return refuse(std::move(*refusal));

  TripleIndex index(graph.store().statements.all(), limits, budget);
  const Owned<librdf_storage> storage(index.storage(world));
  const Owned<librdf_model> model(storage ? librdf_new_model(world.redland(), storage.get(), nullptr) : nullptr);
  if (!model) return refuse("Redland cannot hold the graph: memory is short");
  const Owned<librdf_query> asked(librdf_new_query(world.redland(), language, nullptr, octets(text), nullptr));
  const Owned<librdf_query_results> results(asked ? librdf_model_query_execute(model.get(), asked.get()) : nullptr);
  if (index.problem()) return std::unexpected(AskError{*index.problem(), true});
  if (!results) {
    const std::string error = world.take_error();
    return refuse("the query cannot be answered: " + (error.empty() ? "memory is short" : error));
  }
  std::optional<std::string> failed;
  if (librdf_query_results_is_boolean(results.get()) != 0) {
    answer.kind = Answer::Kind::truth;
    answer.is_true = librdf_query_results_get_boolean(results.get()) > 0;
  } else if (librdf_query_results_is_graph(results.get()) != 0) {
    answer.kind = Answer::Kind::triples;
    failed = read_triples(world, results.get(), prefixes, format, limits, answer);
  } else {
    read_rows(results.get(), limits, answer);
  }
  if (index.problem()) return std::unexpected(AskError{*index.problem(), true});
  if (failed) return refuse(std::move(*failed));
  if (const std::string error = world.take_error(); !error.empty())
    return refuse("the query cannot be answered: " + error);
  return answer;
}

}  // namespace geminga::graph
