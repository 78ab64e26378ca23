#include "reasoning/syntax/graph/query.hpp"

#include <algorithm>
#include <memory>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "reasoning/syntax/graph/existence.hpp"
#include "reasoning/syntax/graph/made_triples.hpp"
#include "reasoning/syntax/graph/patterns.hpp"
#include "reasoning/syntax/graph/query_text.hpp"
#include "reasoning/syntax/graph/selection.hpp"
#include "reasoning/syntax/graph/store.hpp"

namespace geminga::graph {
namespace {

/// The class expressions of a query and of those within it, which have blank nodes of their own.
class ClassExpressions {
 public:
  /// Finds their names, or says in one line why it cannot. Without a finder nothing is such an expression.
  std::optional<std::string> find(World& world, const ReadQuery& read, const FindNames& find_names) {
    if (auto refusal = take(world, read, find_names != nullptr)) return refusal;
    std::size_t count = 0;
    for (const auto& [query, expressions] : all_) count += expressions->size();
    if (count > max_expressions)
      return "the query asks for more than " + std::to_string(max_expressions) +
             " class expressions: ask in several queries";
    for (const auto& [query, expressions] : all_) {
      if (auto refusal = expressions->find(find_names)) return refusal;
    }
    return std::nullopt;
  }
  [[nodiscard]] bool has_asserted() const {
    return std::ranges::any_of(all_, [](const auto& entry) { return entry.second->has_asserted(); });
  }
  [[nodiscard]] const Expressions& of(const ReadQuery& read) const {
    return *std::ranges::find(all_, &read, [](const auto& entry) { return entry.first; })->second;
  }

 private:
  std::optional<std::string> take(World& world, const ReadQuery& read, bool reads) {
    const auto& expressions = all_.emplace_back(&read, std::make_unique<Expressions>(world)).second;
    if (reads) {
      if (auto refusal = expressions->read(read.triples())) return refusal;
    }
    for (const auto& inner : read.inner_queries()) {
      if (auto refusal = take(world, *inner, reads)) return refusal;
    }
    return std::nullopt;
  }

  std::vector<std::pair<const ReadQuery*, std::unique_ptr<Expressions>>> all_;
};

/// Finds the rows of a query and of those within it, over one graph.
class Asking {
 public:
  Asking(Terms& terms, TripleIndex& index, const ClassExpressions& expressions)
      : terms_(terms), index_(index), expressions_(expressions) {}

  /// The rows of a query, with all its variables.
  Rows rows(const ReadQuery& read, Variables& variables, std::size_t most) {
    Formulas formulas(terms_, variables);
    Patterns patterns(read, terms_, variables, formulas, index_, expressions_.of(read),
                      [&](const ReadQuery& inner) { return inner_rows(inner, variables); });
    Rows found = patterns.rows(rows_needed(read, most));
    if (read.last_values() != nullptr) found = patterns.joined(found, patterns.rows_of(*read.last_values()));
    return selected_rows(read, std::move(found), terms_, variables, formulas);
  }

 private:
  /// The rows of an inner query, with the numbers that its selected variables have in the outer one.
  Rows inner_rows(const ReadQuery& inner, Variables& outer) {
    Variables own;
    const Rows found = rows(inner, own, 0);
    std::vector<std::pair<std::size_t, std::size_t>> numbers;  // outside and within
    for (const rasqal_variable* variable : selected(inner))
      numbers.emplace_back(outer.number_of(*variable), own.number_of(*variable));
    Rows renamed;
    for (const Row& row : found) {
      Row& with = renamed.emplace_back();
      for (const auto& [outside, within] : numbers) set_in(with, outside, value_in(row, within));
    }
    return renamed;
  }

  Terms& terms_;
  TripleIndex& index_;
  const ClassExpressions& expressions_;
};

/// The octets of a row, about.
std::size_t octets_of(const std::vector<std::optional<Node>>& row) {
  std::size_t octets = sizeof(std::vector<std::optional<Node>>) + row.size() * sizeof(std::optional<Node>);
  for (const auto& node : row) octets += node ? node->text.size() + node->datatype.size() + node->language.size() : 0;
  return octets;
}

/// Puts the values of the selected variables into the answer, up to the limits.
void write_rows(const ReadQuery& read, const Rows& rows, const Terms& terms, Variables& variables,
                const GraphLimits& limits, Answer& answer) {
  std::vector<std::size_t> numbers;
  for (const rasqal_variable* variable : selected(read)) {
    answer.variables.emplace_back(reinterpret_cast<const char*>(variable->name));
    numbers.push_back(variables.number_of(*variable));
  }
  std::size_t octets = 0;
  for (const Row& found : rows) {
    if (answer.rows.size() >= limits.rows || octets > limits.query_octets) {
      answer.is_cut = true;
      return;
    }
    auto& row = answer.rows.emplace_back();
    for (const std::size_t number : numbers) {
      const TermNumber value = value_in(found, number);
      row.push_back(value == unbound ? std::nullopt : std::optional(terms.node(value)));
    }
    octets += octets_of(row);
  }
}

/// Why a text is not even read as a query, in one line.
std::optional<std::string> refusal_of_text(const std::string& query, const GraphLimits& limits) {
  if (query.size() > limits.query_bytes)
    return "the query has more than " + std::to_string(limits.query_bytes) + " bytes";
  const std::string mask = masked(query);
  if (levels_of(mask, "([", ")]") > limits.query_brackets)
    return "the query nests brackets deeper than " + std::to_string(limits.query_brackets) + " levels";
  if (levels_of(mask) > limits.query_levels)
    return "the query nests groups deeper than " + std::to_string(limits.query_levels) +
           " levels, for which it would take too long: ask in several queries";
  if (!base::is_valid_utf8(query) || query.find('\0') != std::string::npos) return "the query is no text in UTF-8";
  if (describes_all(query)) return "DESCRIBE * is not answered here: name the variables";
  return std::nullopt;
}

std::unexpected<AskError> refused(std::string text) { return std::unexpected(AskError{std::move(text)}); }
std::unexpected<AskError> beyond_limit(const TripleIndex& index) {
  return std::unexpected(AskError{*index.problem(), true});
}

}  // namespace

std::expected<Answer, AskError> ask(const Graph& graph, const std::string& query, const AskOptions& options) {
  const GraphLimits& limits = options.limits;
  if (auto refusal = refusal_of_text(query, limits)) return refused(std::move(*refusal));
  World& world = graph.store().world;
  Terms terms(world);
  const std::string prepared = with_opaque_constants(with_spaced_signs(with_marked_existence(query)));
  const auto read = ReadQuery::read(terms, with_prefixes(prepared, options.prefixes) + '\n');
  if (!read) return refused(read.error());
  ClassExpressions expressions;
  if (auto refusal = expressions.find(world, **read, options.find_names)) return refused(std::move(*refusal));

  TripleIndex index(graph.store().statements.all(), limits, options.budget);
  Variables variables;
  const Rows rows = Asking(terms, index, expressions).rows(**read, variables, limits.rows + 1);
  if (index.problem()) return beyond_limit(index);
  Answer answer;
  answer.has_asserted_expressions = expressions.has_asserted();
  const rasqal_query_verb verb = rasqal_query_get_verb((*read)->query());
  if (verb == RASQAL_QUERY_VERB_ASK) {
    answer.kind = Answer::Kind::truth;
    answer.is_true = !rows.empty();
    return answer;
  }
  if (verb != RASQAL_QUERY_VERB_CONSTRUCT && verb != RASQAL_QUERY_VERB_DESCRIBE) {
    write_rows(**read, rows, terms, variables, limits, answer);
    return answer;
  }
  MadeTriples made(world, limits);
  const auto has_all = verb == RASQAL_QUERY_VERB_CONSTRUCT
                           ? construct(**read, rows, terms, variables, made)
                           : describe(resources_of(**read, rows, terms, variables), terms, index, made);
  if (!has_all) return refused(has_all.error());
  if (index.problem()) return beyond_limit(index);
  auto text = made.sorted_text(options.format, options.prefixes);
  if (!text) return refused(std::move(text.error()));
  answer.kind = Answer::Kind::triples;
  answer.is_cut = !*has_all;
  answer.text = std::move(*text);
  return answer;
}

}  // namespace geminga::graph
