// `query explain`: whether one class is subsumed by another, and the axioms that say so.
#include "reasoning/explanation/explain.hpp"

#include "base/text.hpp"
#include "discovery/participant/identities.hpp"
#include "discovery/participant/naming.hpp"
#include "discovery/participant/queries/lines.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/why_not.hpp"

namespace geminga::participant {
namespace {

/// A minimal explanation is searched for, which takes milliseconds where a look-up takes microseconds.
constexpr std::size_t explanation_work = 2000;
/// Of `text`; a line of GCNP holds more.
constexpr std::size_t max_reason_bytes = 16'384;

std::expected<taxonomy::ClassNumber, Error> find(const compiled::Ontology& ontology, std::string_view key,
                                                 const std::string& name) {
  const auto found = ontology.find(name);
  if (found) return *found;
  return std::unexpected(Error{ErrorCode::impossible, std::string(key) + "=" + base::printable(name) + ": " +
                                                          describe(ontology, name, found.error())});
}

/// What is nearest, and what is missing.
void append_reason(Line& line, const compiled::Ontology& ontology, taxonomy::ClassNumber sub,
                   taxonomy::ClassNumber super) {
  const explanation::WhyNot why_not = explanation::why_not(ontology, sub, super, explanation::Patience::of_a_daemon);
  std::vector<std::string> common;
  for (const taxonomy::ClassNumber number : why_not.common) common.push_back(ontology.short_name(number));
  append(line, "common", joined(common));
  std::string text;
  for (const std::string& one : explanation::describe(ontology, sub, super, why_not)) {
    if (text.size() + one.size() > max_reason_bytes) break;
    text += (text.empty() ? "" : "\n") + base::printable(one, max_reason_bytes);
  }
  append(line, "text", std::move(text));
}

}  // namespace

Answered answer(Core& core, const gcnp::QueryExplain& query) {
  if (core.ontology == nullptr) return std::unexpected(no_ontology(core));
  const compiled::Ontology& ontology = *core.ontology;
  const auto sub = find(ontology, "sub", query.sub);
  if (!sub) return std::unexpected(sub.error());
  const auto super = find(ontology, "super", query.super);
  if (!super) return std::unexpected(super.error());
  // Matching goes on without axioms; what they would explain is not made up.
  if (const auto axioms = ontology.check_axioms(); !axioms) {
    return std::unexpected(Error{ErrorCode::impossible, axioms.error().text});
  }
  Answer answer{.kind = "explain", .lines = {}, .end = {}};
  answer.looked_through = explanation_work;
  if (const auto axioms = explanation::explain(ontology, *sub, *super, explanation::Patience::of_a_daemon)) {
    for (const explanation::ExplainedAxiom& axiom : *axioms) {
      Line line;
      append(line, "axiom", axiom.text);
      append_known(line, "file", base::printable(axiom.file, 4096));
      if (axiom.line != 0) append(line, "line", axiom.line);
      answer.lines.push_back(std::move(line));
    }
  }
  const bool is_subsumed = ontology.is_subsumed(*sub, *super);
  append_flag(answer.end, "subsumed", is_subsumed);
  append(answer.end, "sub", ontology.short_name(*sub));
  append(answer.end, "super", ontology.short_name(*super));
  if (!is_subsumed) append_reason(answer.end, ontology, *sub, *super);
  return answer;
}

}  // namespace geminga::participant
