// Asks whether the conjunction of both is below owl:Nothing: the rules of EL first, then for a model.
#include "reasoning/explanation/overlap.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "reasoning/explanation/proof_lemmas.hpp"
#include "reasoning/modules/module.hpp"
#include "reasoning/owl/left_out.hpp"

namespace geminga::explanation {
namespace {

using owl::TermId;
using owl::TermKind;
using taxonomy::ClassNumber;

/// The names that a question is about.
struct Signature {
  std::vector<ClassNumber> classes;
  std::vector<std::uint32_t> terms;  ///< other entities, as terms of the compiled form
};

/// The terms of these entities. A pass over the kinds of all terms, if there is any.
std::vector<std::uint32_t> find_terms(const taxonomy::ClassifiedView& view,
                                      const std::set<std::pair<TermKind, std::string_view>>& entities) {
  std::vector<std::uint32_t> terms;
  if (entities.empty()) return terms;
  for (std::uint32_t term = 0; term < view.term_count(); ++term) {
    const TermKind kind = view.kind_of_term(term);
    const auto known = entities.lower_bound({kind, {}});
    if (known == entities.end() || known->first != kind) continue;
    if (entities.contains({kind, view.name_of_term(term)})) terms.push_back(term);
  }
  return terms;
}

Signature signature_of(const compiled::Ontology& ontology, ClassNumber one, const Class& other) {
  Signature signature{.classes = {one}, .terms = {}};
  if (const auto* number = std::get_if<ClassNumber>(&other)) {
    signature.classes.push_back(*number);
    return signature;
  }
  const auto& [source, root] = std::get<WrittenClass>(other);
  std::set<std::pair<TermKind, std::string_view>> entities;
  for (const TermId id : owl::terms_in(source, std::span(&root, 1))) {
    const owl::Term term = source.term(id);
    if (!term.arguments.empty()) continue;
    if (term.kind == TermKind::named_class) {
      if (const auto number = ontology.find_iri(source.name_of(id))) signature.classes.push_back(*number);
    } else if (term.kind == TermKind::object_property || term.kind == TermKind::data_property ||
               term.kind == TermKind::individual || term.kind == TermKind::datatype) {
      entities.emplace(term.kind, source.name_of(id));
    }
  }
  signature.terms = find_terms(ontology.axioms(), entities);
  return signature;
}

/// The axioms that can matter, and the conjunction.
struct Question {
  Question(const compiled::Ontology& ontology, ClassNumber first, const Class& other)
      : Question(ontology, first, other, signature_of(ontology, first, other)) {}

  Module module;
  TermId one;
  TermId both;

 private:
  Question(const compiled::Ontology& ontology, ClassNumber first, const Class& other, const Signature& signature)
      : module(ontology, signature.classes, signature.terms), one(module.term(first)), both(one) {
    const auto* number = std::get_if<ClassNumber>(&other);
    const auto* written = std::get_if<WrittenClass>(&other);
    const TermId second =
        number != nullptr ? module.term(*number) : module.source().copy(written->source, written->term);
    if (second != one) both = module.source().term(TermKind::object_intersection_of, {one, second});
  }
};

/// What was left out when the ontology was read, and is in no module: more than the axioms that a classification did
/// not use.
std::optional<std::string> unread(const compiled::Ontology& ontology) {
  const auto groups = ontology.axioms().unused_group;
  const auto left_out = ontology.left_out();
  for (std::size_t group = 0; group < left_out.size(); ++group) {
    // What is said of conversions has no consequence.
    if (left_out[group].construct.starts_with("geminga:conver")) continue;
    const auto unused = std::ranges::count(groups, static_cast<std::uint32_t>(group));
    if (left_out[group].count > static_cast<std::size_t>(unused)) return left_out[group].construct;
  }
  return std::nullopt;
}

Overlap undecided(std::string reason) { return {Common::undecided, std::move(reason)}; }

}  // namespace

Overlap find_overlap(const compiled::Ontology& ontology, ClassNumber one, const Class& other, Patience patience) {
  if (const auto axioms = ontology.check_axioms(); !axioms) return undecided(axioms.error().text);
  Question question(ontology, one, other);
  const AxiomSet axioms = question.module.all();
  if (axioms.size() > max_overlap_axioms)
    return undecided("more than " + std::to_string(max_overlap_axioms) + " axioms may matter");
  Oracle oracle(question.module.source(), patience);
  const Oracle::Decision decision =
      ProofLemmas(question.module, oracle).decide(axioms, question.both, owl::nothing_term);
  if (decision.verdict == hypertableau::Verdict::yes) return {Common::impossible};
  if (decision.verdict == hypertableau::Verdict::unknown) return undecided(decision.reason);
  if (const auto construct = unread(ontology))
    return undecided("axioms were left out when the ontology was read: " + *construct);
  return {Common::possible};
}

std::vector<ExplainedAxiom> explain_exclusion(const compiled::Ontology& ontology, ClassNumber one, const Class& other,
                                              Patience patience) {
  std::vector<ExplainedAxiom> list;
  if (!ontology.check_axioms()) return list;
  Question question(ontology, one, other);
  Oracle oracle(question.module.source(), patience);
  ProofLemmas engines(question.module, oracle);
  const auto axioms = engines.find(question.module.all(), question.both, owl::nothing_term);
  if (!axioms) return list;
  for (const std::uint32_t axiom : question.module.in_order_of_argument(*axioms, question.one)) {
    list.push_back(question.module.explained(axiom));
  }
  return list;
}

}  // namespace geminga::explanation
