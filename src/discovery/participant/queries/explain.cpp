// `query explain`: whether one class is subsumed by another, and the axioms that say so.
#include <string>
#include <utility>
#include <vector>

#include "base/text.hpp"
#include "discovery/participant/knowledge/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "reasoning/vocabulary/comparison.hpp"
#include "reasoning/vocabulary/explanation.hpp"
#include "reasoning/vocabulary/expression.hpp"

namespace geminga::participant {
namespace {

/// The search for a minimal explanation, in entries: it takes milliseconds where a look-up takes microseconds.
constexpr std::size_t explanation_work = 2000;
/// The longest `text`; a line of GCNP holds more.
constexpr std::size_t max_reason_bytes = 16'384;

std::expected<vocabulary::ClassNumber, Error> find(const vocabulary::Vocabulary& vocabulary, std::string_view key,
                                                   const std::string& name) {
  auto found = vocabulary.find(name);
  if (found) return *found;
  return std::unexpected(
      Error{ErrorCode::impossible, std::string(key) + "=" + base::printable(name) + ": " + found.error()});
}

/// Appends the nearest common classes, and what is missing.
void append_nearest(Line& line, const vocabulary::Vocabulary& vocabulary, const vocabulary::Explanation& explanation) {
  std::vector<std::string> common;
  for (const auto number : explanation.common) common.push_back(vocabulary.short_name(number));
  append(line, "common", base::joined(common, ","));
  std::string text;
  for (const std::string& one : explanation.missing) {
    if (text.size() + one.size() > max_reason_bytes) break;
    text += (text.empty() ? "" : "\n") + base::printable(one, max_reason_bytes);
  }
  append(line, "text", std::move(text));
}

Answer answer_of(const std::vector<explanation::ExplainedAxiom>& axioms) {
  Answer answer{.kind = "explain", .lines = {}, .end = {}};
  answer.looked_through = explanation_work;
  for (const auto& axiom : axioms) {
    Line line;
    append(line, "axiom", axiom.text);
    append_stated(line, "file", base::printable(axiom.file, 4096));
    if (axiom.line != 0) append(line, "line", axiom.line);
    answer.lines.push_back(std::move(line));
  }
  return answer;
}

/// A side of the question where one of them is an expression.
struct Side {
  std::string shown;  ///< with short names
  vocabulary::Expression expression;
  vocabulary::Place place;
};

std::expected<Side, Error> side_of(const vocabulary::Vocabulary& vocabulary, Resolver& resolver, std::string_view key,
                                   const std::string& name) {
  const auto refuse = [&](const Error& error) {
    return std::unexpected(Error{error.code, std::string(key) + ": " + error.text});
  };
  const auto identity = resolver.resolve(ConceptNames{name, {}});
  if (!identity) return refuse(identity.error());
  const auto& semantic = std::get<SemanticIdentity>(*identity);
  const std::string text = has_expression(semantic) ? semantic.concept_iri : '<' + semantic.concept_iri + '>';
  auto expression = vocabulary.read(text, vocabulary::max_expression_bytes);
  if (!expression) return refuse(expression.error());
  vocabulary::Place place = vocabulary.place(*expression);
  return Side{std::get<ConceptNames>(named(vocabulary, *identity)).concept_name, std::move(*expression),
              std::move(place)};
}

/// The answer where at least one of the two is an expression.
std::expected<Answer, Error> explain_expressions(const vocabulary::Vocabulary& vocabulary, Resolver& resolver,
                                                 const gcnp::QueryExplain& query) {
  const auto sub = side_of(vocabulary, resolver, "sub", query.sub);
  if (!sub) return std::unexpected(sub.error());
  const auto super = side_of(vocabulary, resolver, "super", query.super);
  if (!super) return std::unexpected(super.error());
  const auto compared = vocabulary.compare(sub->expression, sub->place, super->expression, super->place);
  using Relation = vocabulary::Comparison::Relation;
  const bool is_subsumed = compared.relation == Relation::equivalent || compared.relation == Relation::narrower;
  using Axioms = std::vector<explanation::ExplainedAxiom>;
  Answer answer = answer_of(is_subsumed ? vocabulary.proof(sub->expression, super->expression) : Axioms());
  append_flag(answer.end, "subsumed", is_subsumed);
  append(answer.end, "sub", sub->shown);
  append(answer.end, "super", super->shown);
  if (is_subsumed) return answer;
  append(answer.end, "text",
         compared.gaps.empty() ? "it does not follow from the ontology"
                               : "it is not known to follow: " + base::joined(compared.gaps, ", "));
  return answer;
}

}  // namespace

std::expected<Answer, Error> answer_explain(const vocabulary::Vocabulary& vocabulary, Resolver& resolver,
                                            const gcnp::QueryExplain& query) {
  if (!vocabulary.is_loaded()) return std::unexpected(resolver.no_ontology());
  if (vocabulary.is_expression(query.sub) || vocabulary.is_expression(query.super)) {
    return explain_expressions(vocabulary, resolver, query);
  }
  const auto sub = find(vocabulary, "sub", query.sub);
  if (!sub) return std::unexpected(sub.error());
  const auto super = find(vocabulary, "super", query.super);
  if (!super) return std::unexpected(super.error());
  const auto explanation = vocabulary.explain(*sub, *super);
  if (!explanation) return std::unexpected(explanation.error());
  Answer answer = answer_of(explanation->axioms);
  append_flag(answer.end, "subsumed", explanation->is_subsumed);
  append(answer.end, "sub", vocabulary.short_name(*sub));
  append(answer.end, "super", vocabulary.short_name(*super));
  if (!explanation->is_subsumed) append_nearest(answer.end, vocabulary, *explanation);
  return answer;
}

}  // namespace geminga::participant
