// Keys, which OWL 2 gives to named individuals only, as nominals. Legend as in indexed_ontology.hpp; p are properties,
// x values.
#include <algorithm>

#include "reasoning/el/rule_normaliser.hpp"

namespace geminga::el {

owl::Construct RuleNormaliser::add_key(const owl::Axiom& axiom) {
  const owl::TermId of = axiom.arguments[0];
  owl::Construct unused = use_negative(of);
  Key key{current_axiom_, expression(of), {}};
  for (const owl::TermId argument : axiom.arguments.subspan(1)) {
    const Property one = property(argument);
    if (one.is_top) return owl::Construct::top_property;
    if (one.is_inverse) return owl::Construct::inverse_of;
    key.properties.push_back(one);
  }
  if (key.properties.empty()) return owl::Construct::has_key;
  keys_.push_back(std::move(key));
  return unused;
}

//  C HasKey (p1 ... pn)  is  C and N and p1 some {x1} and ... and pn some {xn} < {y} for all named individuals or
//  literals xi, where {a} < N for every named individual a, and y is an individual of no other axiom
//
// Whatever is on the left is then one thing, and y may be that thing, or, where there is none, anything.
void RuleNormaliser::use_keys(Unused& unused) {
  if (keys_.empty()) return;
  std::vector<ExprId> named;
  std::vector<owl::TermId> literals;
  for (std::uint32_t id = 0; id < source_.term_count(); ++id) {
    if (exprs_[id] == base::NumberTable::none) continue;
    const owl::TermKind kind = source_.kind(owl::TermId{id});
    if (kind == owl::TermKind::individual) named.push_back(ExprId{exprs_[id]});
    if (kind == owl::TermKind::literal) literals.push_back(owl::TermId{id});
  }
  if (named.size() < 2) return;  // then no two can be found to be one
  const ExprId is_named = index_.add_atom();
  for (const ExprId individual : named) index_.add_told(individual, is_named);
  for (const Key& key : keys_) {
    std::size_t tuples = 1;
    for (const Property& property : key.properties) {
      tuples *= property.is_data ? literals.size() : named.size();
      if (tuples > max_key_tuples) break;
    }
    if (tuples > max_key_tuples) {
      unused.emplace_back(key.axiom, owl::Construct::has_key);
      continue;
    }
    current_axiom_ = key.axiom;
    std::vector<ExprId> values;
    for (const owl::TermId literal : literals) {
      const bool is_wanted = std::ranges::any_of(key.properties, &Property::is_data);
      if (is_wanted) use_negative(literal);
      values.push_back(expression(literal));
    }
    for (std::size_t tuple = 0; tuple < tuples; ++tuple) use_key(key, is_named, tuple, named, values);
  }
}

/// The rule for the tuple of this number: its digits, each to the base of its property, say which values.
void RuleNormaliser::use_key(const Key& key, ExprId is_named, std::size_t tuple, const std::vector<ExprId>& named,
                             const std::vector<ExprId>& literals) {
  std::vector<ExprId> parts = {key.of, is_named};
  for (const Property& property : key.properties) {
    const std::vector<ExprId>& values = property.is_data ? literals : named;
    parts.push_back(negative_some(property, values[tuple % values.size()]));
    tuple /= values.size();
  }
  const ExprId all = index_.conjunction(std::move(parts));
  index_.mark_negative(all);
  index_.add_told(all, index_.add_nominal());
}

}  // namespace geminga::el
