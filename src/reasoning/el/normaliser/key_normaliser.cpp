// Keys as rules, one for each combination of values. Legend as in expressions.hpp; p are properties, x values.
#include "reasoning/el/normaliser/key_normaliser.hpp"

#include <algorithm>
#include <utility>

namespace geminga::el {

owl::Construct KeyNormaliser::add(const owl::Axiom& axiom) {
  const owl::TermId of = axiom.arguments[0];
  const owl::Construct unused = expressions_.use_left(of);
  Key key{pending_.axiom(), terms_.expression(of), {}};
  for (const owl::TermId argument : axiom.arguments.subspan(1)) {
    const Property one = terms_.property(argument);
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
// An element on the left is then unique, and y may be this element, or any element if there is none.
void KeyNormaliser::finish(UnusedAxioms& unused) {
  if (keys_.empty()) return;
  const Values values = find_values();
  if (values.individuals.size() < 2) return;  // no two can be found to be one
  const ExprId is_named = index_.add_atom();
  for (const ExprId individual : values.individuals) index_.add_told(individual, is_named);
  for (const Key& key : keys_) {
    const std::size_t tuples = count_tuples(key, values);
    if (tuples > max_key_tuples) {
      unused.emplace_back(key.axiom, owl::Construct::has_key);
    } else {
      write_out(key, is_named, tuples, values);
    }
  }
}

KeyNormaliser::Values KeyNormaliser::find_values() {
  Values values;
  for (std::uint32_t id = 0; id < source_.term_count(); ++id) {
    const owl::TermId term{id};
    if (!terms_.has_expression(term)) continue;
    const owl::TermKind kind = source_.kind(term);
    if (kind == owl::TermKind::individual) values.individuals.push_back(terms_.expression(term));
    if (kind == owl::TermKind::literal) values.literals.push_back(term);
  }
  return values;
}

// The count ends beyond max_key_tuples.
std::size_t KeyNormaliser::count_tuples(const Key& key, const Values& values) {
  std::size_t tuples = 1;
  for (const Property& property : key.properties) {
    tuples *= values.count(property);
    if (tuples > max_key_tuples) break;
  }
  return tuples;
}

void KeyNormaliser::write_out(const Key& key, ExprId is_named, std::size_t tuples, const Values& values) {
  pending_.begin(key.axiom);
  const bool asks_for_literals = std::ranges::any_of(key.properties, &Property::is_data);
  std::vector<ExprId> literals;
  for (const owl::TermId literal : values.literals) {
    if (asks_for_literals) expressions_.use_left(literal);
    literals.push_back(terms_.expression(literal));
  }
  for (std::size_t tuple = 0; tuple < tuples; ++tuple) make_rule(key, is_named, tuple, values.individuals, literals);
}

// Adds the rule for the tuple of this number: its digits, each to the base of its property, select the values.
void KeyNormaliser::make_rule(const Key& key, ExprId is_named, std::size_t tuple,
                              const std::vector<ExprId>& individuals, const std::vector<ExprId>& literals) {
  std::vector<ExprId> parts = {key.of, is_named};
  for (const Property& property : key.properties) {
    const std::vector<ExprId>& values = property.is_data ? literals : individuals;
    parts.push_back(expressions_.recognised_some(property, values[tuple % values.size()]));
    tuple /= values.size();
  }
  const ExprId all = index_.conjunction(std::move(parts));
  index_.mark_negative(all);
  index_.add_told(all, index_.add_nominal());
}

}  // namespace geminga::el
