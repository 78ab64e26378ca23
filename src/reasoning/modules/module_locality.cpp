// One kind of term or axiom after the other. A test that returns waiting leaves the names on top of the stack; the
// other answers leave none.
#include "reasoning/modules/module_locality.hpp"

namespace geminga::modules {

std::uint64_t LocalityTest::cost(std::size_t first, std::size_t last) const {
  std::uint64_t sum = 0;
  for (std::size_t at = first; at < last; ++at) sum += 1 + uses_[names_[at]];
  return sum;
}

/// Keeps one of two sets of names, each of which is enough to wait for: the one whose names are used less often.
Locality LocalityTest::keep_better(std::size_t start, std::size_t middle) {
  const auto at = [&](std::size_t position) { return names_.begin() + static_cast<std::ptrdiff_t>(position); };
  if (cost(middle, names_.size()) < cost(start, middle)) {
    names_.erase(at(start), at(middle));
  } else {
    names_.erase(at(middle), names_.end());
  }
  return Locality::waiting;
}

template <typename First, typename Second>
Locality LocalityTest::both(First&& first, Second&& second) {
  const std::size_t start = names_.size();
  const Locality one = first();
  if (one == Locality::always) return one;
  const std::size_t middle = names_.size();
  const Locality other = second();
  if (other == Locality::always) {
    names_.resize(start);
    return other;
  }
  if (one == Locality::not_local) return other;
  return other == Locality::not_local ? one : keep_better(start, middle);
}

template <typename Test>
Locality LocalityTest::any(Numbers terms, Test&& test) {
  const std::size_t start = names_.size();
  for (const std::uint32_t term : terms) {
    if (test(term) != Locality::not_local) continue;
    names_.resize(start);
    return Locality::not_local;
  }
  return names_.size() > start ? Locality::waiting : Locality::always;
}

template <typename Test>
Locality LocalityTest::all(Numbers terms, Test&& test) {
  const std::size_t start = names_.size();
  Locality result = Locality::not_local;
  for (const std::uint32_t term : terms) {
    const std::size_t middle = names_.size();
    const Locality one = test(term);
    if (one == Locality::always) {
      names_.resize(start);
      return one;
    }
    if (one == Locality::waiting) result = middle > start ? keep_better(start, middle) : one;
  }
  return result;
}

/// Whether at least two of the terms pass the test.
template <typename Test>
Locality LocalityTest::two(Numbers terms, Test&& test) {
  const std::size_t start = names_.size();
  std::size_t certain = 0;
  std::size_t waiting = 0;
  std::size_t dear = start;  // where the names of the one with the most uses begin
  std::size_t dear_end = start;
  for (const std::uint32_t term : terms) {
    const std::size_t before = names_.size();
    const Locality one = test(term);
    if (one == Locality::not_local && ++certain == 2) {
      names_.resize(start);
      return one;
    }
    if (one != Locality::waiting) continue;
    if (++waiting == 1 || cost(before, names_.size()) > cost(dear, dear_end)) {
      dear = before;
      dear_end = names_.size();
    }
  }
  if (waiting + certain < 2) {
    names_.resize(start);
    return Locality::always;
  }
  // If none passes yet, the first of the two is among any choice of all but one.
  if (certain == 0) {
    names_.erase(names_.begin() + static_cast<std::ptrdiff_t>(dear),
                 names_.begin() + static_cast<std::ptrdiff_t>(dear_end));
  }
  return Locality::waiting;
}

Locality LocalityTest::wait_for(std::uint32_t entity) {
  if (is_in_signature_[entity]) return Locality::not_local;
  names_.push_back(entity);
  return Locality::waiting;
}

Locality LocalityTest::not_empty_role(std::uint32_t term) {
  const Numbers arguments = view_.arguments_of_term(term);
  if (view_.kind_of_term(term) == owl::TermKind::object_inverse_of) return not_empty_role(arguments[0]);
  if (view_.kind_of_term(term) == owl::TermKind::object_property_chain) {
    return all(arguments, [&](std::uint32_t role) { return not_empty_role(role); });
  }
  if (term == built_in_.top_object_property || term == built_in_.top_data_property) return Locality::not_local;
  if (term == built_in_.bottom_object_property || term == built_in_.bottom_data_property) return Locality::always;
  return wait_for(term);
}

Locality LocalityTest::not_empty_successor(Numbers arguments) {
  return both([&] { return not_empty_role(arguments[0]); },
              [&] { return arguments.size() == 2 ? not_empty(arguments[1]) : Locality::not_local; });
}

Locality LocalityTest::not_empty(std::uint32_t term) {
  if (++looked_at_ > max_terms_looked_at) return Locality::not_local;
  const Numbers arguments = view_.arguments_of_term(term);
  const auto is_not_empty = [&](std::uint32_t part) { return not_empty(part); };
  switch (view_.kind_of_term(term)) {
    case owl::TermKind::named_class:
      if (term == built_in_.thing) return Locality::not_local;
      return term == built_in_.nothing ? Locality::always : wait_for(term);
    case owl::TermKind::object_intersection_of:
    case owl::TermKind::data_intersection_of:
      return all(arguments, is_not_empty);
    case owl::TermKind::object_union_of:
    case owl::TermKind::data_union_of:
    case owl::TermKind::object_one_of:
    case owl::TermKind::data_one_of:
      return any(arguments, is_not_empty);
    case owl::TermKind::object_complement_of:
      return not_everything(arguments[0]);
    case owl::TermKind::object_some_values_from:
    case owl::TermKind::data_some_values_from:
      return not_empty_successor(arguments);
    case owl::TermKind::object_has_value:
    case owl::TermKind::data_has_value:
    case owl::TermKind::object_has_self:
      return not_empty_role(arguments[0]);
    case owl::TermKind::object_min_cardinality:
    case owl::TermKind::data_min_cardinality:
    case owl::TermKind::object_exact_cardinality:
    case owl::TermKind::data_exact_cardinality:
      return view_.number_of_term(term) > 0 ? not_empty_successor(arguments) : Locality::not_local;
    default:
      return Locality::not_local;
  }
}

Locality LocalityTest::not_everything(std::uint32_t term) {
  if (++looked_at_ > max_terms_looked_at) return Locality::not_local;
  const Numbers arguments = view_.arguments_of_term(term);
  const auto is_not_everything = [&](std::uint32_t part) { return not_everything(part); };
  switch (view_.kind_of_term(term)) {
    case owl::TermKind::named_class:
      return term == built_in_.thing ? Locality::always : Locality::not_local;
    case owl::TermKind::object_intersection_of:
      return any(arguments, is_not_everything);
    case owl::TermKind::object_union_of:
      return all(arguments, is_not_everything);
    case owl::TermKind::object_complement_of:
      return not_empty(arguments[0]);
    case owl::TermKind::object_all_values_from:
      return both([&] { return not_empty_role(arguments[0]); }, [&] { return not_everything(arguments[1]); });
    case owl::TermKind::data_all_values_from:
      return not_empty_role(arguments[0]);
    case owl::TermKind::object_min_cardinality:
    case owl::TermKind::data_min_cardinality:
      return view_.number_of_term(term) == 0 ? Locality::always : Locality::not_local;
    case owl::TermKind::object_max_cardinality:
    case owl::TermKind::data_max_cardinality:
      return not_empty_successor(arguments);
    case owl::TermKind::object_exact_cardinality:
    case owl::TermKind::data_exact_cardinality:
      return view_.number_of_term(term) == 0 ? not_empty_successor(arguments) : Locality::not_local;
    default:
      return Locality::not_local;
  }
}

Locality LocalityTest::of_class_axiom(owl::AxiomKind kind, Numbers arguments) {
  const auto is_not_empty = [&](std::uint32_t part) { return not_empty(part); };
  switch (kind) {
    case owl::AxiomKind::sub_class_of:
      return both([&] { return not_empty(arguments[0]); }, [&] { return not_everything(arguments[1]); });
    case owl::AxiomKind::equivalent_classes:
      return both([&] { return any(arguments, is_not_empty); },
                  [&] { return any(arguments, [&](std::uint32_t part) { return not_everything(part); }); });
    case owl::AxiomKind::disjoint_union:
      return any(arguments, is_not_empty);
    case owl::AxiomKind::disjoint_classes:
      return two(arguments, is_not_empty);
    case owl::AxiomKind::has_key:
      return not_empty(arguments[0]);
    default:  // a class assertion
      return not_everything(arguments[0]);
  }
}

Locality LocalityTest::test(std::uint32_t axiom) {
  names_.clear();
  looked_at_ = 0;
  const Numbers arguments = view_.arguments_of_axiom(axiom);
  const owl::AxiomKind kind = view_.kind_of_axiom(axiom);
  const auto is_not_empty_role = [&](std::uint32_t role) { return not_empty_role(role); };
  switch (kind) {
    case owl::AxiomKind::declaration:
      return Locality::always;
    case owl::AxiomKind::sub_class_of:
    case owl::AxiomKind::equivalent_classes:
    case owl::AxiomKind::disjoint_union:
    case owl::AxiomKind::disjoint_classes:
    case owl::AxiomKind::has_key:
    case owl::AxiomKind::class_assertion:
      return of_class_axiom(kind, arguments);
    case owl::AxiomKind::sub_object_property_of:
    case owl::AxiomKind::sub_data_property_of:
    case owl::AxiomKind::functional_object_property:
    case owl::AxiomKind::inverse_functional_object_property:
    case owl::AxiomKind::irreflexive_object_property:
    case owl::AxiomKind::symmetric_object_property:
    case owl::AxiomKind::asymmetric_object_property:
    case owl::AxiomKind::transitive_object_property:
    case owl::AxiomKind::functional_data_property:
    case owl::AxiomKind::negative_object_property_assertion:
    case owl::AxiomKind::negative_data_property_assertion:
    case owl::AxiomKind::data_property_range:
      return not_empty_role(arguments[0]);
    case owl::AxiomKind::equivalent_object_properties:
    case owl::AxiomKind::equivalent_data_properties:
    case owl::AxiomKind::inverse_object_properties:
      return any(arguments, is_not_empty_role);
    case owl::AxiomKind::disjoint_object_properties:
    case owl::AxiomKind::disjoint_data_properties:
      return two(arguments, is_not_empty_role);
    case owl::AxiomKind::object_property_domain:
    case owl::AxiomKind::object_property_range:
    case owl::AxiomKind::data_property_domain:
      return both([&] { return not_empty_role(arguments[0]); }, [&] { return not_everything(arguments[1]); });
    default:
      return Locality::not_local;  // reflexivity, facts, equality: they always say something
  }
}

}  // namespace geminga::modules
