#include "compare/opinions.hpp"

#include <cstdint>

#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/dl/consequence/closure.hpp"
#include "reasoning/dl/hypertableau/tableau.hpp"
#include "reasoning/el/classify.hpp"
#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::compare {
namespace {

using owl::TermId;

std::string name_of(const owl::Ontology& source, TermId id) {
  if (id == owl::thing_term) return "Thing";
  if (id == owl::nothing_term) return "Nothing";
  return std::string(source.name_of(id));
}

/// owl:Thing and every other named class of the source, in the order of their terms.
std::vector<TermId> named_classes(const owl::Ontology& source) {
  std::vector<TermId> classes;
  for (std::uint32_t id = 0; id < source.term_count(); ++id) {
    if (source.kind(TermId{id}) == owl::TermKind::named_class && TermId{id} != owl::nothing_term)
      classes.push_back(TermId{id});
  }
  return classes;
}

owl::Ontology copy_of(const owl::Ontology& source) {
  owl::Ontology copy;
  const owl::FileId file = copy.add_file("copy");
  std::vector<TermId> terms;
  const auto mapped = [&](std::span<const TermId> from) {
    std::vector<TermId> to;
    for (const TermId id : from) to.push_back(terms[static_cast<std::size_t>(id)]);
    return to;
  };
  for (std::uint32_t id = 0; id < source.term_count(); ++id) {
    const owl::Term term = source.term(TermId{id});
    terms.push_back(copy.copy(term.kind, source.name(term.name), term.number, mapped(term.arguments)));
  }
  for (std::size_t at = 0; at < source.axiom_count(); ++at)
    copy.add(source.axiom(at).kind, mapped(source.axiom(at).arguments), file, source.axiom(at).line);
  return copy;
}

}  // namespace

namespace {

Opinion of_the_reasoner(const owl::Ontology& source, const reasoner::Options& options) {
  const auto classification = reasoner::classify(source, options);
  if (!classification) return {{}, false, {classification.error().text}};
  return {cases::closure_of(source, *classification, false),
          classification->unused.empty() && classification->gaps.empty(),
          {}};
}

}  // namespace

Opinion of_the_reasoner(const owl::Ontology& source) { return of_the_reasoner(source, {}); }

Opinion of_models(const owl::Ontology& source) { return of_the_reasoner(source, {.alternatives = 0}); }

Opinion of_el(const owl::Ontology& source) {
  const auto classification = el::classify(source);
  if (!classification) return {{}, false, {classification.error().text}};
  return {cases::closure_of(source, *classification, false), classification->unused.empty(), {}};
}

Opinion of_consequence(const owl::Ontology& source) {
  const auto set = clauses::clausify(source, {}, {});
  if (!set) return {{}, false, {set.error().text}};
  std::vector<clauses::ConceptId> wanted;
  for (std::uint32_t id = 0; id < set->concepts.size(); ++id) {
    if (set->concepts[id].kind == clauses::ConceptKind::named && clauses::ConceptId{id} != clauses::nothing)
      wanted.push_back(clauses::ConceptId{id});
  }
  const consequence::Closure found = consequence::saturate(source, *set, wanted);
  Opinion opinion{{}, found.gaps.empty() && set->unused.empty(), found.gaps};
  if (!found.is_consistent) {
    opinion.closure = {"inconsistent"};
    return opinion;
  }
  const auto name = [&](clauses::ConceptId id) { return name_of(source, set->concepts[clauses::number(id)].term); };
  std::vector<std::pair<std::string, std::string>> pairs;
  // A class of which no clause speaks is below what everything is below.
  for (const TermId id : named_classes(source)) pairs.emplace_back(name_of(source, id), "Thing");
  for (std::size_t at = 0; at < wanted.size(); ++at) {
    for (const clauses::ConceptId super : found.subsumers[at]) {
      if (set->concepts[clauses::number(super)].kind == clauses::ConceptKind::named)
        pairs.emplace_back(name(wanted[at]), name(super));
    }
  }
  opinion.closure = cases::closure_of_pairs(pairs);
  return opinion;
}

namespace {

/// Most questions without counting have an answer within these steps, and the others are not worth the time.
constexpr std::size_t few_steps = 5'000;
/// With counting, hardly a question that takes more steps has an answer at all.
constexpr std::size_t enough_steps = 5'000'000;

Opinion of_the_tableau(const owl::Ontology& original, const hypertableau::QuestionLimits& limits) {
  owl::Ontology source = copy_of(original);
  const std::vector<TermId> classes = named_classes(original);
  std::vector<std::pair<TermId, TermId>> asked;
  std::vector<TermId> queries;
  for (const TermId sub : classes) {
    asked.emplace_back(sub, owl::nothing_term);
    queries.push_back(sub);
    for (const TermId super : classes) {
      if (super == sub || super == owl::thing_term) continue;
      asked.emplace_back(sub, super);
      queries.push_back(source.term(owl::TermKind::object_intersection_of,
                                    {sub, source.term(owl::TermKind::object_complement_of, {super})}));
    }
  }
  const auto set = clauses::clausify(source, {}, queries);
  if (!set) return {{}, false, {set.error().text}};
  Opinion opinion{{}, set->unused.empty(), {}};
  hypertableau::Tableau tableau(source, *set, limits);
  const hypertableau::Answer is_consistent = tableau.is_consistent();
  if (is_consistent.verdict == hypertableau::Verdict::no) return {{"inconsistent"}, true, {}};
  std::vector<std::pair<std::string, std::string>> pairs;
  for (std::size_t at = 0; at < queries.size(); ++at) {
    const std::pair<std::string, std::string> pair{name_of(original, asked[at].first),
                                                   name_of(original, asked[at].second)};
    const hypertableau::Answer answer = tableau.is_satisfiable({set->queries[at]});
    if (answer.verdict == hypertableau::Verdict::no) pairs.push_back(pair);
    if (answer.verdict == hypertableau::Verdict::unknown) opinion.unknown.push_back(pair.first + " < " + pair.second);
  }
  opinion.is_complete = opinion.is_complete && opinion.unknown.empty();
  opinion.closure = cases::closure_of_pairs(pairs);
  return opinion;
}

}  // namespace

Opinion of_the_tableau(const owl::Ontology& source) { return of_the_tableau(source, {.steps = enough_steps}); }

Opinion of_the_tableau_without_counting(const owl::Ontology& source) {
  return of_the_tableau(source, {.steps = few_steps, .counts = false});
}

std::vector<std::string> contradictions(const Opinion& first, const Opinion& second) {
  std::vector<std::string> found;
  if (second.is_complete) {
    for (const std::string& line : cases::unsound(first.closure, second.closure))
      found.push_back("only the first: " + line);
  }
  if (first.is_complete) {
    for (const std::string& line : cases::unsound(second.closure, first.closure))
      found.push_back("only the second: " + line);
  }
  return found;
}

}  // namespace geminga::compare
