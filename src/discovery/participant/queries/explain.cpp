// `query explain`: whether one class is subsumed by another, and the axioms that say so.
#include "base/text.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "discovery/participant/queries/queries.hpp"
#include "reasoning/vocabulary/explanation.hpp"

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

}  // namespace

std::expected<Answer, Error> answer_explain(const vocabulary::Vocabulary& vocabulary, const Resolver& resolver,
                                            const gcnp::QueryExplain& query) {
  if (!vocabulary.is_loaded()) return std::unexpected(resolver.no_ontology());
  const auto sub = find(vocabulary, "sub", query.sub);
  if (!sub) return std::unexpected(sub.error());
  const auto super = find(vocabulary, "super", query.super);
  if (!super) return std::unexpected(super.error());
  const auto explanation = vocabulary.explain(*sub, *super);
  if (!explanation) return std::unexpected(explanation.error());
  Answer answer{.kind = "explain", .lines = {}, .end = {}};
  answer.looked_through = explanation_work;
  for (const auto& axiom : explanation->axioms) {
    Line line;
    append(line, "axiom", axiom.text);
    append_stated(line, "file", base::printable(axiom.file, 4096));
    if (axiom.line != 0) append(line, "line", axiom.line);
    answer.lines.push_back(std::move(line));
  }
  append_flag(answer.end, "subsumed", explanation->is_subsumed);
  append(answer.end, "sub", vocabulary.short_name(*sub));
  append(answer.end, "super", vocabulary.short_name(*super));
  if (!explanation->is_subsumed) append_nearest(answer.end, vocabulary, *explanation);
  return answer;
}

}  // namespace geminga::participant
