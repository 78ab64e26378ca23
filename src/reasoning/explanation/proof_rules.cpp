// Rules about one class expression; the legend is in proof_search.hpp.
#include <algorithm>

#include "reasoning/explanation/proof_search.hpp"

namespace geminga::explanation {

using owl::TermId;
using owl::TermKind;

void ProofSearch::apply(TermId context) {
  apply_told(context);
  apply_parts(context);
  apply_clashes(context);
  apply_selfs(context);
  apply_links(context);
  apply_chains(context);
  apply_cases(context);
}

//  C < D   [D < E is an axiom]     C < D   D < E   [D is an individual]
//  ---------------------------     ------------------------------------
//  C < E                           C < E
void ProofSearch::apply_told(TermId context) {
  for (const std::uint32_t step : about(context)) {
    const TermId middle = conclusions_[step].super;
    for (const Told& told : told_) {
      if (told.sub == middle) add(context, told.super, ProofRule::subclass, {step}, {told.axiom});
    }
    if (middle == context || (kind(middle) != TermKind::object_one_of && middle != owl::thing_term)) continue;
    for (const std::uint32_t next : about(middle)) {
      if (conclusions_[next].rule == ProofRule::trivial) continue;
      add(context, conclusions_[next].super, ProofRule::subclass, {step, next});
    }
  }
}

//  C < D and E    C < D   C < E   [occurs]    C < D   [D or E occurs]
//  -----------    ------------------------    -----------------------
//  C < D          C < D and E                 C < D or E
void ProofSearch::apply_parts(TermId context) {
  for (const std::uint32_t step : about(context)) {
    const TermId whole = conclusions_[step].super;
    if (kind(whole) != TermKind::object_intersection_of) continue;
    for (const TermId part : arguments(whole)) add(context, part, ProofRule::conjunct, {step});
  }
  for (const TermId whole : expressions_) {
    if (kind(whole) == TermKind::object_intersection_of) {
      std::vector<std::uint32_t> steps;
      const std::vector<TermId> parts = arguments(whole);
      for (const TermId part : parts) {
        if (const std::uint32_t* step = find(context, part)) steps.push_back(*step);
      }
      if (steps.size() == parts.size()) add(context, whole, ProofRule::conjunction, steps);
    } else if (kind(whole) == TermKind::object_union_of) {
      for (const TermId part : arguments(whole)) {
        if (const std::uint32_t* step = find(context, part)) add(context, whole, ProofRule::alternative, {*step});
      }
    } else if (kind(whole) == TermKind::object_one_of) {
      for (const TermId individual : arguments(whole)) {
        const std::uint32_t* step = find(context, terms_.singleton(individual));
        if (step != nullptr) add(context, whole, ProofRule::alternative, {*step});
      }
    }
  }
}

//  C < D   C < E   [D and E disjoint]     C < D   C < not D     C and D < F   [not D occurs]
//  ----------------------------------     -----------------     ----------------------------
//  C < F                                  C < F                 C < not D
void ProofSearch::apply_clashes(TermId context) {
  for (const Told& pair : disjoint_) {
    const std::uint32_t* first = find(context, pair.sub);
    const std::uint32_t* second = find(context, pair.super);
    if (first != nullptr && second != nullptr) {
      add(context, owl::nothing_term, ProofRule::disjointness, {*first, *second}, {pair.axiom});
    }
  }
  for (const std::uint32_t step : about(context)) {
    const TermId negated = conclusions_[step].super;
    if (kind(negated) != TermKind::object_complement_of) continue;
    const std::uint32_t* positive = find(context, arguments(negated)[0]);
    if (positive != nullptr) add(context, owl::nothing_term, ProofRule::negation, {*positive, step});
  }
  for (std::size_t at = 0; at < expressions_.size(); ++at) {
    const TermId negated = expressions_[at];
    if (kind(negated) != TermKind::object_complement_of || find(context, negated) != nullptr) continue;
    const TermId both = terms_.conjunction({context, arguments(negated)[0]});
    if (both == context) continue;
    open(both);
    const std::uint32_t* empty = find(both, owl::nothing_term);
    if (empty != nullptr) add(context, negated, ProofRule::negation, {*empty});
  }
}

//  C < D or E   C and D < F   C and E < F
//  --------------------------------------
//  C < F
void ProofSearch::apply_cases(TermId context) {
  for (const std::uint32_t step : about(context)) {
    const TermId whole = conclusions_[step].super;
    std::vector<TermId> parts = arguments(whole);
    if (kind(whole) == TermKind::object_one_of && parts.size() > 1) {
      for (TermId& part : parts) part = terms_.singleton(part);
    } else if (kind(whole) != TermKind::object_union_of) {
      continue;
    }
    std::vector<TermId> cases;
    for (const TermId part : parts) cases.push_back(terms_.conjunction({context, part}));
    // Cases gain nothing if one of them is certain.
    if (std::ranges::find(cases, context) != cases.end()) continue;
    if (std::ranges::any_of(parts, [&](TermId part) { return find(context, part) != nullptr; })) continue;
    for (const TermId one : cases) open(one);
    // A conclusion must hold in the first possible case and in the others.
    const auto possible = std::ranges::find_if(cases, [&](TermId one) { return !find(one, owl::nothing_term); });
    const TermId first = possible == cases.end() ? cases.front() : *possible;
    for (const std::uint32_t of_first : about(first)) {
      const TermId wanted = conclusions_[of_first].super;
      if (wanted == first || find(context, wanted) != nullptr) continue;
      std::vector<std::uint32_t> steps = {step};
      for (const TermId one : cases) {
        const std::uint32_t* holds = find(one, wanted);
        if (holds == nullptr) holds = find(one, owl::nothing_term);
        if (holds != nullptr) steps.push_back(*holds);
      }
      if (steps.size() == cases.size() + 1) add(context, wanted, ProofRule::cases, steps);
    }
  }
}

//  C < R Self   [R <* S, S Self occurs]     C < R Self       C < R Self   [R <* S, E is the range of S]
//  ------------------------------------     ------------     ------------------------------------------
//  C < S Self                               C < R some C     C < E
void ProofSearch::apply_selfs(TermId context) {
  for (const std::uint32_t step : about(context)) {
    const TermId self = conclusions_[step].super;
    if (kind(self) != TermKind::object_has_self) continue;
    const TermId role = arguments(self)[0];
    for (const TermId other : expressions_) {
      if (kind(other) != TermKind::object_has_self) continue;
      if (const AxiomSet* axioms = roles_.find(role, arguments(other)[0])) {
        add(context, other, ProofRule::self, {step}, *axioms);
      }
    }
    add(context, terms_.some(role, context), ProofRule::self, {step});
    for (const RoleFeature& range : roles_.ranges()) {
      const AxiomSet* by_roles = roles_.find(role, range.role);
      if (by_roles == nullptr) continue;
      AxiomSet axioms = *by_roles;
      axioms.push_back(range.axiom);
      add(context, range.range, ProofRule::range, {step}, std::move(axioms));
    }
  }
}

}  // namespace geminga::explanation
