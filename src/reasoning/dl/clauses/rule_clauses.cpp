// One function a form of atom, and what is bound by which.
#include "reasoning/dl/clauses/rule_clauses.hpp"

#include <algorithm>
#include <utility>

#include "reasoning/dl/clauses/built_in.hpp"

namespace geminga::clauses {

using owl::TermId;
using owl::TermKind;

std::string_view RuleClauses::add(const OrderedAxiom& axiom) {
  const owl::Ontology& source = vocabulary_.source();
  const owl::Term body = source.term(axiom.arguments[0]);
  const owl::Term head = source.term(axiom.arguments[1]);
  std::size_t arguments = 0;
  for (const owl::Term& atoms : {body, head}) {
    for (const TermId id : atoms.arguments) arguments += source.term(id).arguments.size();
  }
  if (body.arguments.size() + head.arguments.size() > max_rule_atoms || arguments > max_rule_arguments)
    return "a swrl:Imp of more than 256 atoms or 1024 arguments";
  rule_ = {};
  rule_.axiom = axiom.axiom;
  variables_.clear();
  is_mixed_ = false;
  for (const TermId id : vocabulary_.hashes().sorted(body.arguments, 0)) add_to_body(id);
  const std::size_t bound = variables_.size();
  for (const TermId id : vocabulary_.hashes().sorted(head.arguments, 0)) add_to_head(id);
  if (is_mixed_) return "a swrl:Variable for an individual and for a value";
  // No value or individual follows for a variable of the head alone.
  for (RuleAtom& atom : rule_.heads) {
    const bool is_free = std::ranges::any_of(
        atom.terms, [&](const RuleTerm& term) { return term.kind == RuleTermKind::variable && term.number >= bound; });
    if (!is_free) continue;
    atom.kind = RuleAtomKind::unknown;
    rule_.problem = "a swrl:Variable of a head that the body does not bind";
  }
  check_bound();
  // An empty head is false, and one of which nothing is left is true.
  if (rule_.heads.empty() && !head.arguments.empty()) return {};
  if (!rule_.problem.empty()) set_.open_rules.push_back({axiom.axiom, rule_.problem});
  set_.rules.push_back(rule_);
  return {};
}

RuleTerm RuleClauses::term(TermId id, bool is_value) {
  switch (vocabulary_.source().kind(id)) {
    case TermKind::literal:
      return {RuleTermKind::literal, static_cast<std::uint32_t>(id)};
    case TermKind::variable: {
      const auto [found, is_new] = variables_.try_emplace(id, static_cast<std::uint32_t>(variables_.size()));
      if (is_new) rule_.is_value.push_back(is_value);
      is_mixed_ = is_mixed_ || rule_.is_value[found->second] != is_value;
      return {RuleTermKind::variable, found->second};
    }
    default:
      return {RuleTermKind::individual, number(vocabulary_.individual(id))};
  }
}

RuleAtom RuleClauses::unknown(std::string_view problem, const owl::Term& atom) {
  rule_.problem = problem;
  RuleAtom result;
  for (const TermId id : atom.arguments) {
    const TermKind kind = vocabulary_.source().kind(id);
    if (kind == TermKind::variable || owl::is_individual(kind)) {
      // The kind of the atom tells whether the variable stands for an individual or a value.
      const bool is_value =
          atom.kind == TermKind::built_in_atom || atom.kind == TermKind::data_range_atom ||
          (atom.kind == TermKind::data_property_atom && id == atom.arguments[2] && id != atom.arguments[1]);
      result.terms.push_back(term(id, is_value));
    }
  }
  return result;
}

void RuleClauses::add_to_body(TermId id) {
  const owl::Term atom = vocabulary_.source().term(id);
  switch (atom.kind) {
    case TermKind::class_atom:
      rule_.body.push_back(class_atom(atom, false));
      return;
    case TermKind::object_property_atom:
      rule_.body.push_back(property_atom(atom, false));
      return;
    case TermKind::data_property_atom:
      rule_.body.push_back(data_atom(atom, false));
      return;
    case TermKind::data_range_atom:
      rule_.body.push_back({RuleAtomKind::data_range,
                            number(vocabulary_.data_range(range_of(vocabulary_.source(), atom.arguments[0], false))),
                            {term(atom.arguments[1], true)}});
      return;
    case TermKind::same_individual_atom:
      rule_.body.push_back({RuleAtomKind::equal, 0, {term(atom.arguments[0], false), term(atom.arguments[1], false)}});
      return;
    case TermKind::different_individuals_atom:
      for (const TermId argument : atom.arguments)
        rule_.body.push_back({RuleAtomKind::named, 0, {term(argument, false)}});
      rule_.alternatives.push_back(
          {RuleAtomKind::equal, 0, {term(atom.arguments[0], false), term(atom.arguments[1], false)}});
      return;
    default:
      rule_.body.push_back(built_in(atom));
  }
}

void RuleClauses::add_to_head(TermId id) {
  const owl::Term atom = vocabulary_.source().term(id);
  switch (atom.kind) {
    case TermKind::class_atom:
      rule_.heads.push_back(class_atom(atom, true));
      return;
    case TermKind::object_property_atom:
      if (vocabulary_.source().name_of(atom.arguments[0]) == owl::owl_top_object_property) {
        term(atom.arguments[1], false);
        term(atom.arguments[2], false);
        return;
      }
      rule_.heads.push_back(property_atom(atom, true));
      return;
    case TermKind::data_property_atom:
      rule_.heads.push_back(data_atom(atom, true));
      return;
    case TermKind::data_range_atom:
      rule_.heads.push_back({RuleAtomKind::data_range,
                             number(vocabulary_.data_range(range_of(vocabulary_.source(), atom.arguments[0], false))),
                             {term(atom.arguments[1], true)}});
      return;
    case TermKind::same_individual_atom:
    case TermKind::different_individuals_atom:
      rule_.heads.push_back({atom.kind == TermKind::same_individual_atom ? RuleAtomKind::equal : RuleAtomKind::unequal,
                             0,
                             {term(atom.arguments[0], false), term(atom.arguments[1], false)}});
      return;
    default:
      rule_.heads.push_back(built_in(atom));
  }
}

RuleAtom RuleClauses::class_atom(const owl::Term& atom, bool is_head) {
  const Literal literal = positive(atom.arguments[0]);
  const std::string_view problem = allowed_.problem(is_head ? literal : complement(literal));
  if (!problem.empty()) return unknown(problem, atom);
  const ConceptId id = is_head ? translator_.below(literal) : translator_.above(literal);
  const RuleAtomKind kind = id == thing ? RuleAtomKind::named : RuleAtomKind::concept_of;
  return {kind, number(id), {term(atom.arguments[1], false)}};
}

RuleAtom RuleClauses::property_atom(const owl::Term& atom, bool is_head) {
  RuleAtom result{RuleAtomKind::role, 0, {term(atom.arguments[1], false), term(atom.arguments[2], false)}};
  if (!is_head && vocabulary_.source().name_of(atom.arguments[0]) == owl::owl_top_object_property) {
    rule_.body.push_back({RuleAtomKind::named, 0, {result.terms[0]}});
    return {RuleAtomKind::named, 0, {result.terms[1]}};
  }
  const Role role = translator_.role(atom.arguments[0]);
  if (!is_head && !roles_.is_simple(role)) {
    result.kind = RuleAtomKind::path;
    result.predicate = path(role);
    return result;
  }
  result.predicate = number(role.property);
  if (role.is_inverse) std::swap(result.terms[0], result.terms[1]);
  return result;
}

std::uint32_t RuleClauses::path(Role role) {
  const auto [found, is_new] = paths_.try_emplace(role, static_cast<std::uint32_t>(set_.paths.size()));
  if (is_new) set_.paths.push_back(roles_.automaton(role));
  return found->second;
}

/// A concept above "property value literal".
ConceptId RuleClauses::has_value(TermId property, TermId literal) {
  const auto [found, is_new] = has_values_.try_emplace({property, literal}, thing);
  if (!is_new) return found->second;
  found->second = vocabulary_.auxiliary(literal);
  const DataRangeId others = vocabulary_.data_range({literal, true});
  translator_.add_clause({{{AtomKind::data_role, centre, 1, number(vocabulary_.data_property(property))}},
                          {{AtomKind::concept_of, centre, centre, number(found->second)},
                           {AtomKind::data_range, 1, centre, number(others)}}});
  return found->second;
}

RuleAtom RuleClauses::data_atom(const owl::Term& atom, bool is_head) {
  if (allowed_.is_top_data(atom.arguments[0])) return unknown("owl:topDataProperty", atom);
  const RuleTerm object = term(atom.arguments[1], false);
  const bool is_constant = vocabulary_.source().kind(atom.arguments[2]) == TermKind::literal;
  if (is_constant && !is_head)
    return {RuleAtomKind::concept_of, number(has_value(atom.arguments[0], atom.arguments[2])), {object}};
  return {RuleAtomKind::data_role,
          number(vocabulary_.data_property(atom.arguments[0])),
          {object, term(atom.arguments[2], true)}};
}

RuleAtom RuleClauses::built_in(const owl::Term& atom) {
  const auto form = find_built_in(vocabulary_.source().name(atom.name));
  if (!form) return unknown("a built-in of a swrl:Imp that is not known", atom);
  const std::size_t count = atom.arguments.size();
  if (count < form->least || (count > form->most && form->most != many_arguments))
    return unknown("a built-in of a swrl:Imp with a wrong number of arguments", atom);
  RuleAtom result{RuleAtomKind::built_in, static_cast<std::uint32_t>(form->built_in), {}};
  for (const TermId argument : atom.arguments) result.terms.push_back(term(argument, true));
  return result;
}

void RuleClauses::check_bound() {
  std::vector<bool> is_bound(rule_.is_value.size(), false);
  const auto is_known = [&](const RuleTerm& term) {
    return term.kind != RuleTermKind::variable || !rule_.is_value[term.number] || is_bound[term.number];
  };
  const auto bind = [&](const RuleTerm& term, bool& changed) {
    if (is_known(term)) return;
    is_bound[term.number] = true;
    changed = true;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (const RuleAtom& atom : rule_.body) {
      // An unknown atom binds nothing.
      if (atom.kind == RuleAtomKind::data_role) bind(atom.terms[1], changed);
      if (atom.kind != RuleAtomKind::built_in) continue;
      const auto built_in = static_cast<BuiltIn>(atom.predicate);
      if (form_of(built_in).binds_first && std::ranges::all_of(std::span(atom.terms).subspan(1), is_known))
        bind(atom.terms[0], changed);
      if (built_in == BuiltIn::equal && is_known(atom.terms[0])) bind(atom.terms[1], changed);
    }
  }
  const auto check = [&](RuleAtom& atom) {
    if (atom.kind == RuleAtomKind::unknown || std::ranges::all_of(atom.terms, is_known)) return;
    atom.kind = RuleAtomKind::unknown;
    if (rule_.problem.empty()) rule_.problem = "a swrl:Variable of a value that nothing binds";
  };
  std::ranges::for_each(rule_.body, check);
  std::ranges::for_each(rule_.heads, check);
}

}  // namespace geminga::clauses
