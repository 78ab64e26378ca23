// The axioms are read, then rounds of rules are applied until the goal is reached.
#include "reasoning/explanation/proof_search.hpp"

#include <algorithm>

#include "base/sorted.hpp"

namespace geminga::explanation {

using owl::Axiom;
using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

namespace {

// A proof for people has tens of steps. These bounds are far beyond, and end the generation of ever new terms.
constexpr std::size_t max_contexts = 120;
constexpr std::size_t max_conclusions = 4'000;
constexpr std::uint32_t max_depth = 24;  ///< of expressions that rules make

}  // namespace

std::string_view to_string(ProofRule rule) {
  switch (rule) {
    case ProofRule::trivial:
      return "in every ontology";
    case ProofRule::subclass:
      return "a chain of subclasses";
    case ProofRule::conjunct:
      return "taking a conjunction apart";
    case ProofRule::conjunction:
      return "putting a conjunction together";
    case ProofRule::alternative:
      return "an alternative of a union";
    case ProofRule::existential:
      return "the existential rule";
    case ProofRule::empty:
      return "a successor that cannot exist";
    case ProofRule::domain:
      return "the domain";
    case ProofRule::range:
      return "the range";
    case ProofRule::universal:
      return "the universal restriction";
    case ProofRule::chain:
      return "the property chain";
    case ProofRule::inverse:
      return "the inverse property";
    case ProofRule::functional:
      return "the functional property";
    case ProofRule::cardinality:
      return "counting";
    case ProofRule::self:
      return "the self restriction";
    case ProofRule::disjointness:
      return "disjointness";
    case ProofRule::negation:
      return "negation";
    case ProofRule::cases:
      return "cases";
    case ProofRule::contradiction:
      return "contradiction";
    case ProofRule::together:
      return "all of them together, as an engine finds that shows no steps";
  }
  return {};
}

ProofSearch::ProofSearch(owl::Ontology& source, const AxiomSet& axioms, TermId sub, TermId super)
    : source_(source),
      terms_(source),
      roles_(source, terms_, axioms),
      sub_(terms_.normal(sub)),
      super_(terms_.normal(super)) {
  look_into(sub_);
  look_into(super_);
  for (const std::uint32_t axiom : axioms) use(axiom);
  open(sub_);
  open(owl::thing_term);
}

void ProofSearch::tell(TermId sub, TermId super, std::uint32_t axiom) {
  const Told told{terms_.normal(sub), terms_.normal(super), axiom};
  look_into(told.sub);
  look_into(told.super);
  told_.push_back(told);
}

/// Notes an expression and its parts. Recursion is bounded by the nesting of terms.
void ProofSearch::look_into(TermId expression) {
  if (std::ranges::find(expressions_, expression) != expressions_.end()) return;
  if (!owl::is_class_expression(kind(expression))) return;
  expressions_.push_back(expression);
  for (const TermId argument : arguments(expression)) look_into(argument);
}

void ProofSearch::tell_all(const std::vector<TermId>& equal, std::uint32_t axiom) {
  for (const TermId from : equal) {
    for (const TermId to : equal) {
      if (from != to) tell(from, to, axiom);
    }
  }
}

void ProofSearch::tell_disjoint(const std::vector<TermId>& members, std::uint32_t axiom) {
  for (std::size_t first = 0; first < members.size(); ++first) {
    for (std::size_t second = first + 1; second < members.size(); ++second) {
      disjoint_.push_back({terms_.normal(members[first]), terms_.normal(members[second]), axiom});
      look_into(disjoint_.back().sub);
      look_into(disjoint_.back().super);
    }
  }
}

void ProofSearch::use(std::uint32_t number) {
  const Axiom axiom = source_.axiom(number);
  // Terms that are added may move the axiom's own arguments.
  const std::vector<TermId> given(axiom.arguments.begin(), axiom.arguments.end());
  switch (axiom.kind) {
    case AxiomKind::sub_class_of:
      return tell(given[0], given[1], number);
    case AxiomKind::equivalent_classes:
      return tell_all(given, number);
    case AxiomKind::disjoint_classes:
      return tell_disjoint(given, number);
    case AxiomKind::disjoint_union: {
      const std::vector<TermId> parts(given.begin() + 1, given.end());
      for (const TermId part : parts) tell(part, given[0], number);
      if (parts.size() > 1) tell(given[0], source_.term(TermKind::object_union_of, parts), number);
      if (parts.size() == 1) tell(given[0], parts.front(), number);
      return tell_disjoint(parts, number);
    }
    case AxiomKind::data_property_domain:
      data_domains_.insert(data_domains_.end(), {given[0], terms_.normal(given[1])});
      data_domain_axioms_.push_back(number);
      return;
    case AxiomKind::reflexive_object_property:
      return tell(owl::thing_term, source_.term(TermKind::object_has_self, {given[0]}), number);
    case AxiomKind::irreflexive_object_property:
      return tell(source_.term(TermKind::object_has_self, {given[0]}), owl::nothing_term, number);
    default:
      return use_fact(axiom.kind, given, number);
  }
}

/// A fact is an axiom about classes that hold one individual each.
void ProofSearch::use_fact(AxiomKind kind, const std::vector<TermId>& given, std::uint32_t number) {
  const auto one = [&](TermId individual) {
    const TermId alone = terms_.singleton(individual);
    if (source_.kind(individual) != TermKind::literal) open(alone);
    return alone;
  };
  const auto all = [&] {
    std::vector<TermId> members;
    for (const TermId individual : given) members.push_back(one(individual));
    return members;
  };
  switch (kind) {
    case AxiomKind::class_assertion:
      return tell(one(given[1]), given[0], number);
    case AxiomKind::object_property_assertion:
      tell(one(given[1]), terms_.some(given[0], one(given[2])), number);
      return tell(one(given[2]), terms_.some(terms_.inverse(given[0]), one(given[1])), number);
    case AxiomKind::data_property_assertion:
      return tell(one(given[1]), terms_.some(given[0], one(given[2])), number);
    case AxiomKind::negative_object_property_assertion:
    case AxiomKind::negative_data_property_assertion: {
      const TermId some = terms_.some(given[0], one(given[2]));
      look_into(some);
      disjoint_.push_back({one(given[1]), some, number});
      return;
    }
    case AxiomKind::same_individual:
      return tell_all(all(), number);
    case AxiomKind::different_individuals:
      return tell_disjoint(all(), number);
    default:
      return;  // proof_roles.cpp reads axioms of properties; keys and datatypes have no rule here
  }
}

void ProofSearch::open(TermId context) {
  if (is_open(context) || contexts_.size() >= max_contexts) return;
  contexts_.push_back(context);
  about_.try_emplace(context);
  add(context, context, ProofRule::trivial, {});
  add(context, owl::thing_term, ProofRule::trivial, {});
}

void ProofSearch::add(TermId sub, TermId super, ProofRule rule, std::vector<std::uint32_t> steps, AxiomSet axioms) {
  if (find(sub, super) != nullptr || conclusions_.size() >= max_conclusions) return;
  if (source_.depth(super) > max_depth) return;
  const auto number = static_cast<std::uint32_t>(conclusions_.size());
  base::sort_unique(axioms);
  conclusions_.push_back({sub, super, rule, std::move(steps), std::move(axioms)});
  known_.emplace(std::pair(sub, super), number);
  about_[sub].push_back(number);
}

void ProofSearch::assume(TermId sub, TermId super, AxiomSet axioms) {
  open(sub);
  add(sub, super, ProofRule::together, {}, std::move(axioms));
}

const std::uint32_t* ProofSearch::find(TermId sub, TermId super) const {
  const auto found = known_.find({sub, super});
  return found == known_.end() ? nullptr : &found->second;
}

std::vector<std::uint32_t> ProofSearch::about(TermId context) const {
  const auto found = about_.find(context);
  return found == about_.end() ? std::vector<std::uint32_t>{} : found->second;
}

std::vector<TermId> ProofSearch::arguments(TermId term) const {
  const auto view = source_.term(term).arguments;
  return {view.begin(), view.end()};
}

//  C < F    a is in F    owl:Thing < F
//  -----    ---------    -------------
//  C < D      C < D          C < D
void ProofSearch::conclude_goal() {
  if (const std::uint32_t* reached = find(sub_, super_)) {
    goal_ = *reached;
    return;
  }
  for (const TermId context : contexts_) {
    const bool must_exist = context == owl::thing_term || kind(context) == TermKind::object_one_of;
    const std::uint32_t* empty = find(context, owl::nothing_term);
    if (empty == nullptr || (context != sub_ && !must_exist)) continue;
    add(sub_, super_, ProofRule::contradiction, {*empty});
    if (const std::uint32_t* reached = find(sub_, super_)) goal_ = *reached;
    return;
  }
}

std::optional<std::uint32_t> ProofSearch::run() {
  conclude_goal();
  for (std::size_t before = 0; !goal_ && before != conclusions_.size();) {
    before = conclusions_.size();
    for (std::size_t at = 0; at < contexts_.size() && !goal_; ++at) {
      apply(contexts_[at]);
      conclude_goal();
    }
  }
  return goal_;
}

}  // namespace geminga::explanation
