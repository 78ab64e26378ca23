// Lemmas about few axioms are tried first.
#include "reasoning/explanation/proof_lemmas.hpp"

#include <string>

namespace geminga::explanation {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

// The most questions to engines for one proof. Each is about a few axioms.
constexpr std::size_t max_questions = 400;

}  // namespace

TermId ProofLemmas::fresh() {
  std::string iri;
  do {
    iri = "urn:geminga:lemma:" + std::to_string(fresh_count_++);
  } while (module_.source().find_name(iri));
  return module_.source().named_class(iri);
}

/// A class N with N < C and no other axiom: N < D follows exactly if C < D does.
ProofLemmas::Named ProofLemmas::name_below(TermId expression) {
  if (module_.source().kind(expression) == TermKind::named_class) return {expression, std::nullopt};
  Named& named = below_[expression];
  if (!named.axiom) {
    named = {fresh(), static_cast<std::uint32_t>(module_.source().axiom_count())};
    module_.source().add(AxiomKind::sub_class_of, {named.name, expression}, owl::FileId{0}, 0);
  }
  return named;
}

/// A class N with C < N and no other axiom: D < N follows exactly if D < C does.
ProofLemmas::Named ProofLemmas::name_above(TermId expression) {
  if (module_.source().kind(expression) == TermKind::named_class) return {expression, std::nullopt};
  Named& named = above_[expression];
  if (!named.axiom) {
    named = {fresh(), static_cast<std::uint32_t>(module_.source().axiom_count())};
    module_.source().add(AxiomKind::sub_class_of, {expression, named.name}, owl::FileId{0}, 0);
  }
  return named;
}

ProofLemmas::Asked ProofLemmas::asked(const AxiomSet& axioms, TermId sub, TermId super) {
  const Named below = name_below(sub);
  const Named above = name_above(super);
  Asked question{axioms, below.name, above.name};
  if (below.axiom) question.axioms.push_back(*below.axiom);
  if (above.axiom) question.axioms.push_back(*above.axiom);
  return question;
}

bool ProofLemmas::holds(const AxiomSet& axioms, TermId sub, TermId super) {
  const Asked question = asked(axioms, sub, super);
  return oracle_.holds(question.axioms, question.below, question.above);
}

Oracle::Decision ProofLemmas::decide(const AxiomSet& axioms, TermId sub, TermId super) {
  const Asked question = asked(axioms, sub, super);
  return oracle_.decide(question.axioms, question.below, question.above);
}

std::optional<AxiomSet> ProofLemmas::find(const AxiomSet& axioms, TermId sub, TermId super) {
  const auto entails = [&](std::span<const std::uint32_t> some) {
    return holds(AxiomSet(some.begin(), some.end()), sub, super);
  };
  if (!entails(axioms)) return std::nullopt;
  return find_minimal(*find_sufficient_prefix(axioms, entails), entails);
}

std::uint32_t ProofLemmas::bridge(ProofSearch& search, const AxiomSet& axioms, TermId sub, TermId super) {
  std::size_t questions = 0;
  // Lemmas add contexts and expressions, which are asked about, too.
  for (std::size_t at = 0; at < search.contexts().size() && questions < max_questions; ++at) {
    for (std::size_t of = 0; of < search.expressions().size() && questions < max_questions; ++of) {
      const TermId context = search.contexts()[at];
      const TermId wanted = search.expressions()[of];
      if (context == sub && wanted == super) continue;
      if (search.is_known(context, wanted)) continue;
      ++questions;
      const auto lemma = find(axioms, context, wanted);
      // A lemma that needs all axioms is no easier to follow than the goal.
      if (!lemma || lemma->size() == axioms.size()) continue;
      search.assume(context, wanted, *lemma);
      if (const auto goal = search.run()) return *goal;
    }
  }
  search.assume(sub, super, axioms);
  return *search.run();
}

}  // namespace geminga::explanation
