// Rules along C < R some D; the legend is in proof_search.hpp.
#include <algorithm>

#include "reasoning/explanation/proof_search.hpp"

namespace geminga::explanation {
namespace {

using owl::TermId;
using owl::TermKind;

bool is_some(TermKind kind) {
  return kind == TermKind::object_some_values_from || kind == TermKind::data_some_values_from;
}
bool is_all(TermKind kind) {
  return kind == TermKind::object_all_values_from || kind == TermKind::data_all_values_from;
}
bool is_at_least(TermKind kind) {
  return kind == TermKind::object_min_cardinality || kind == TermKind::data_min_cardinality;
}
bool is_at_most(TermKind kind) {
  return kind == TermKind::object_max_cardinality || kind == TermKind::data_max_cardinality;
}
bool is_of_objects(TermKind kind) { return owl::is_class_expression(kind); }

AxiomSet joined(AxiomSet one, const AxiomSet& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

}  // namespace

//  C < at least n R D   [n > 0]
//  ----------------------------
//  C < R some D
std::vector<ProofSearch::Link> ProofSearch::links(TermId context) {
  std::vector<Link> found;
  for (const std::uint32_t step : about(context)) {
    const TermId super = conclusions_[step].super;
    if (!is_some(kind(super)) && !is_at_least(kind(super))) continue;
    const std::vector<TermId> parts = arguments(super);
    found.push_back({step, parts[0], parts[1]});
    if (is_of_objects(kind(parts[1]))) open(parts[1]);
  }
  return found;
}

void ProofSearch::apply_links(TermId context) {
  const std::vector<Link> all = links(context);
  for (const Link& link : all) {
    apply_existentials(context, link);
    apply_ranges(context, link);
    apply_universals(context, link);
    if (is_of_objects(kind(link.filler))) apply_inverses(context, link);
  }
  apply_functional(context, all);
  apply_numbers(context, all);
}

//  C < R some D   D < E   [R <* S, S some E occurs]     C < R some D   D < F
//  ------------------------------------------------     --------------------
//  C < S some E                                         C < F
void ProofSearch::apply_existentials(TermId context, const Link& link) {
  if (const std::uint32_t* empty = find(link.filler, owl::nothing_term)) {
    add(context, owl::nothing_term, ProofRule::empty,
        link.filler == owl::nothing_term ? std::vector{link.step} : std::vector{link.step, *empty});
  }
  for (std::size_t at = 0; at < expressions_.size(); ++at) {
    const TermId wanted = expressions_[at];
    if (!is_some(kind(wanted))) continue;
    const std::vector<TermId> parts = arguments(wanted);
    const AxiomSet* by_roles = roles_.find(link.role, parts[0]);
    if (by_roles == nullptr) continue;
    if (parts[1] == link.filler) {
      add(context, wanted, ProofRule::existential, {link.step}, *by_roles);
    } else if (const std::uint32_t* above = find(link.filler, parts[1])) {
      add(context, wanted, ProofRule::existential, {link.step, *above}, *by_roles);
    }
  }
}

/// Adds to the filler of a link that the successor is in `more`, too.
void ProofSearch::refine(TermId context, const Link& link, TermId more, ProofRule rule,
                         std::vector<std::uint32_t> steps, AxiomSet axioms) {
  if (find(link.filler, more) != nullptr || !is_of_objects(kind(link.filler))) return;
  steps.insert(steps.begin(), link.step);
  add(context, terms_.some(link.role, terms_.conjunction({link.filler, more})), rule, std::move(steps),
      std::move(axioms));
}

//  C < R some D   [R <* S, E is the range of S]     C < R some D   [R <* S, E is the domain of S]
//  --------------------------------------------     ---------------------------------------------
//  C < R some (D and E)                             C < E
void ProofSearch::apply_ranges(TermId context, const Link& link) {
  for (std::size_t at = 0; at < data_domain_axioms_.size(); ++at) {
    const AxiomSet* by_roles = roles_.find(link.role, data_domains_[2 * at]);
    if (by_roles == nullptr) continue;
    add(context, data_domains_[2 * at + 1], ProofRule::domain, {link.step},
        joined(*by_roles, {data_domain_axioms_[at]}));
  }
  if (!is_of_objects(kind(link.filler))) return;
  const TermId back = terms_.inverse(link.role);
  for (const RoleFeature& range : roles_.ranges()) {
    if (const AxiomSet* by_roles = roles_.find(back, range.role)) {
      add(context, range.range, ProofRule::domain, {link.step}, joined(*by_roles, {range.axiom}));
    }
    if (const AxiomSet* by_roles = roles_.find(link.role, range.role)) {
      refine(context, link, range.range, ProofRule::range, {}, joined(*by_roles, {range.axiom}));
    }
  }
}

//  C < R some D   C < S only E   [R <* S]     C < R some D   D < S only E   [inverse R <* S]
//  --------------------------------------     ----------------------------------------------
//  C < R some (D and E)                       C < E
void ProofSearch::apply_universals(TermId context, const Link& link) {
  for (const std::uint32_t step : about(context)) {
    const TermId all = conclusions_[step].super;
    if (!is_all(kind(all))) continue;
    const AxiomSet* by_roles = roles_.find(link.role, arguments(all)[0]);
    if (by_roles != nullptr) refine(context, link, arguments(all)[1], ProofRule::universal, {step}, *by_roles);
  }
  if (!is_of_objects(kind(link.filler))) return;
  const TermId back = terms_.inverse(link.role);
  for (const std::uint32_t step : about(link.filler)) {
    const TermId all = conclusions_[step].super;
    if (kind(all) != TermKind::object_all_values_from) continue;
    if (const AxiomSet* by_roles = roles_.find(back, arguments(all)[0])) {
      add(context, arguments(all)[1], ProofRule::universal, {link.step, step}, *by_roles);
    }
  }
}

//  C < R some D   C < E   [inverse R <* S, S some E occurs]
//  --------------------------------------------------------
//  C < R some (D and S some E)
void ProofSearch::apply_inverses(TermId context, const Link& link) {
  const TermId back = terms_.inverse(link.role);
  for (std::size_t at = 0; at < expressions_.size(); ++at) {
    const TermId wanted = expressions_[at];
    if (kind(wanted) != TermKind::object_some_values_from) continue;
    const std::vector<TermId> parts = arguments(wanted);
    const AxiomSet* by_roles = roles_.find(back, parts[0]);
    const std::uint32_t* above = find(context, parts[1]);
    if (by_roles == nullptr || above == nullptr) continue;
    refine(context, link, wanted, ProofRule::inverse, {*above}, *by_roles);
  }
}

//  C < R some D   C < S some E   [R <* T, S <* T, T functional]
//  -----------------------------------------------------------
//  C < R some (D and E)
//
//  C < R some D   D < S some E   [inverse R <* T, S <* T, T functional]
//  --------------------------------------------------------------------
//  C < E
void ProofSearch::apply_functional(TermId context, const std::vector<Link>& all) {
  for (const RoleFeature& functional : roles_.functional()) {
    for (const Link& first : all) {
      const AxiomSet* of_first = roles_.find(first.role, functional.role);
      for (const Link& second : all) {
        const AxiomSet* of_second = roles_.find(second.role, functional.role);
        if (of_first == nullptr || of_second == nullptr || first.step == second.step) continue;
        refine(context, first, second.filler, ProofRule::functional, {second.step},
               joined(joined(*of_first, *of_second), {functional.axiom}));
      }
      if (!is_of_objects(kind(first.filler))) continue;
      const AxiomSet* of_back = roles_.find(terms_.inverse(first.role), functional.role);
      if (of_back == nullptr) continue;
      for (const Link& next : links(first.filler)) {
        const AxiomSet* of_next = roles_.find(next.role, functional.role);
        if (of_next == nullptr || !is_of_objects(kind(next.filler))) continue;
        add(context, next.filler, ProofRule::functional, {first.step, next.step},
            joined(joined(*of_back, *of_next), {functional.axiom}));
      }
    }
  }
}

//  C < at least m R D   C < at most n S E   D < E   [R <* S, m > n]
//  ----------------------------------------------------------------
//  C < F
//
//  C < R1 some D1   C < R2 some D2   C < at most 1 S E   D1 < E   D2 < E   [R1 <* S, R2 <* S]
//  ------------------------------------------------------------------------------------------
//  C < R1 some (D1 and D2)
void ProofSearch::apply_numbers(TermId context, const std::vector<Link>& all) {
  for (const std::uint32_t step : about(context)) {
    const TermId most = conclusions_[step].super;
    if (!is_at_most(kind(most))) continue;
    const std::uint32_t limit = source_.term(most).number;
    const std::vector<TermId> parts = arguments(most);
    struct Counted {
      Link link;
      std::vector<std::uint32_t> steps;
      AxiomSet axioms;
    };
    std::vector<Counted> counted;
    for (const Link& link : all) {
      const AxiomSet* by_roles = roles_.find(link.role, parts[0]);
      const std::uint32_t* above = find(link.filler, parts[1]);
      if (by_roles == nullptr || (above == nullptr && link.filler != parts[1])) continue;
      counted.push_back({link, {}, *by_roles});
      if (above != nullptr) counted.back().steps.push_back(*above);
      const TermId super = conclusions_[link.step].super;
      const std::uint32_t count = is_at_least(kind(super)) ? source_.term(super).number : 1;
      if (count <= limit) continue;
      std::vector<std::uint32_t> steps = counted.back().steps;
      steps.insert(steps.begin(), {link.step, step});
      add(context, owl::nothing_term, ProofRule::cardinality, steps, *by_roles);
    }
    for (const Counted& first : counted) {
      for (const Counted& second : counted) {
        if (limit != 1 || first.link.step == second.link.step) continue;
        std::vector<std::uint32_t> steps = {second.link.step, step};
        steps.insert(steps.end(), first.steps.begin(), first.steps.end());
        steps.insert(steps.end(), second.steps.begin(), second.steps.end());
        refine(context, first.link, second.link.filler, ProofRule::cardinality, steps,
               joined(first.axioms, second.axioms));
      }
    }
  }
}

//  C < R1 some D1   D1 < R2 some D2 ...   [R1 <* S1, R2 <* S2, ..., S1 o S2 o ... < T]
//  -----------------------------------------------------------------------------------
//  C < T some Dn
void ProofSearch::apply_chains(TermId context) {
  for (const RoleChain& chain : roles_.chains()) {
    std::vector<std::uint32_t> steps;
    AxiomSet axioms = {chain.axiom};
    follow_chain(chain, 0, context, context, steps, axioms);
  }
}

// Recursion is bounded by the length of the chain, which an axiom of the small set gives.
void ProofSearch::follow_chain(const RoleChain& chain, std::size_t at, TermId from, TermId to,
                               std::vector<std::uint32_t>& steps, AxiomSet& axioms) {
  if (at == chain.links.size()) {
    add(from, terms_.some(chain.super, to), ProofRule::chain, steps, axioms);
    return;
  }
  for (const Link& link : links(to)) {
    const AxiomSet* by_roles = roles_.find(link.role, chain.links[at]);
    if (by_roles == nullptr || !is_of_objects(kind(link.filler))) continue;
    const std::size_t known = axioms.size();
    steps.push_back(link.step);
    axioms.insert(axioms.end(), by_roles->begin(), by_roles->end());
    follow_chain(chain, at + 1, from, link.filler, steps, axioms);
    steps.pop_back();
    axioms.resize(known);
  }
}

}  // namespace geminga::explanation
