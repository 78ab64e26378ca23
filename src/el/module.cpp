// Locality: what an axiom says where every name outside the signature is empty.
#include "el/module.hpp"

#include <algorithm>

namespace geminga::el {
namespace {

/// Decides locality against a growing signature. Recursion is bounded by the nesting of terms.
class Locality {
 public:
  explicit Locality(const CompiledView& view) : view_(view), is_in_signature_(view.term_count(), false) {}

  /// Adds a term's entities; whether one of them was new.
  bool add(std::uint32_t term) {
    if (is_in_signature_[term]) return false;
    is_in_signature_[term] = true;
    for (const std::uint32_t argument : view_.arguments_of_term(term)) add(argument);
    return true;
  }

  [[nodiscard]] bool is_local(std::uint32_t axiom) const;

 private:
  using Numbers = CompiledView::Numbers;

  [[nodiscard]] bool is_empty_role(std::uint32_t term) const;
  [[nodiscard]] bool is_bottom(std::uint32_t term) const;
  [[nodiscard]] bool is_top(std::uint32_t term) const;
  [[nodiscard]] bool is_empty_filler(Numbers arguments) const {
    return arguments.size() == 2 && is_bottom(arguments[1]);
  }
  [[nodiscard]] std::size_t count_not_bottom(Numbers terms) const {
    return static_cast<std::size_t>(std::ranges::count_if(terms, [&](std::uint32_t term) { return !is_bottom(term); }));
  }
  [[nodiscard]] std::size_t count_not_empty_roles(Numbers terms) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(terms, [&](std::uint32_t term) { return !is_empty_role(term); }));
  }

  const CompiledView& view_;
  std::vector<bool> is_in_signature_;
};

bool Locality::is_empty_role(std::uint32_t term) const {
  const Numbers arguments = view_.arguments_of_term(term);
  if (view_.kind_of_term(term) == TermKind::object_inverse_of) return is_empty_role(arguments[0]);
  if (view_.kind_of_term(term) == TermKind::object_property_chain) {
    return std::ranges::any_of(arguments, [&](std::uint32_t role) { return is_empty_role(role); });
  }
  const std::string_view iri = view_.name(view_.term_name[term]);
  return !is_in_signature_[term] && iri != "http://www.w3.org/2002/07/owl#topObjectProperty" &&
         iri != "http://www.w3.org/2002/07/owl#topDataProperty";
}

bool Locality::is_bottom(std::uint32_t term) const {
  const Numbers arguments = view_.arguments_of_term(term);
  const auto is_bottom_one = [&](std::uint32_t part) { return is_bottom(part); };
  switch (view_.kind_of_term(term)) {
    case TermKind::named_class: {
      const std::string_view iri = view_.name(view_.term_name[term]);
      return iri == owl_nothing || (iri != owl_thing && !is_in_signature_[term]);
    }
    case TermKind::object_intersection_of:
    case TermKind::data_intersection_of:
      return std::ranges::any_of(arguments, is_bottom_one);
    case TermKind::object_union_of:
    case TermKind::data_union_of:
    case TermKind::object_one_of:
    case TermKind::data_one_of:
      return std::ranges::all_of(arguments, is_bottom_one);
    case TermKind::object_complement_of:
      return is_top(arguments[0]);
    case TermKind::object_some_values_from:
    case TermKind::data_some_values_from:
    case TermKind::object_has_value:
    case TermKind::data_has_value:
    case TermKind::object_has_self:
      return is_empty_role(arguments[0]) || is_empty_filler(arguments);
    case TermKind::object_min_cardinality:
    case TermKind::data_min_cardinality:
    case TermKind::object_exact_cardinality:
    case TermKind::data_exact_cardinality:
      return view_.term_number[term] > 0 && (is_empty_role(arguments[0]) || is_empty_filler(arguments));
    default:
      return false;
  }
}

bool Locality::is_top(std::uint32_t term) const {
  const Numbers arguments = view_.arguments_of_term(term);
  const auto is_top_one = [&](std::uint32_t part) { return is_top(part); };
  switch (view_.kind_of_term(term)) {
    case TermKind::named_class:
      return view_.name(view_.term_name[term]) == owl_thing;
    case TermKind::object_intersection_of:
      return std::ranges::all_of(arguments, is_top_one);
    case TermKind::object_union_of:
      return std::ranges::any_of(arguments, is_top_one);
    case TermKind::object_complement_of:
      return is_bottom(arguments[0]);
    case TermKind::object_all_values_from:
      return is_empty_role(arguments[0]) || is_top(arguments[1]);
    case TermKind::data_all_values_from:
      return is_empty_role(arguments[0]);
    case TermKind::object_min_cardinality:
    case TermKind::data_min_cardinality:
      return view_.term_number[term] == 0;
    case TermKind::object_max_cardinality:
    case TermKind::data_max_cardinality:
      return is_empty_role(arguments[0]) || is_empty_filler(arguments);
    case TermKind::object_exact_cardinality:
    case TermKind::data_exact_cardinality:
      return view_.term_number[term] == 0 && (is_empty_role(arguments[0]) || is_empty_filler(arguments));
    default:
      return false;
  }
}

bool Locality::is_local(std::uint32_t axiom) const {
  const Numbers arguments = view_.arguments_of_axiom(axiom);
  switch (view_.kind_of_axiom(axiom)) {
    case AxiomKind::declaration:
      return true;
    case AxiomKind::sub_class_of:
      return is_bottom(arguments[0]) || is_top(arguments[1]);
    case AxiomKind::equivalent_classes:
      return count_not_bottom(arguments) == 0 ||
             std::ranges::all_of(arguments, [&](std::uint32_t part) { return is_top(part); });
    case AxiomKind::disjoint_union:
      return count_not_bottom(arguments) == 0;
    case AxiomKind::disjoint_classes:
      return count_not_bottom(arguments) <= 1;
    case AxiomKind::sub_object_property_of:
    case AxiomKind::sub_data_property_of:
    case AxiomKind::functional_object_property:
    case AxiomKind::inverse_functional_object_property:
    case AxiomKind::irreflexive_object_property:
    case AxiomKind::symmetric_object_property:
    case AxiomKind::asymmetric_object_property:
    case AxiomKind::transitive_object_property:
    case AxiomKind::functional_data_property:
    case AxiomKind::negative_object_property_assertion:
    case AxiomKind::negative_data_property_assertion:
    case AxiomKind::data_property_range:
      return is_empty_role(arguments[0]);
    case AxiomKind::equivalent_object_properties:
    case AxiomKind::equivalent_data_properties:
    case AxiomKind::inverse_object_properties:
      return count_not_empty_roles(arguments) == 0;
    case AxiomKind::disjoint_object_properties:
    case AxiomKind::disjoint_data_properties:
      return count_not_empty_roles(arguments) <= 1;
    case AxiomKind::object_property_domain:
    case AxiomKind::object_property_range:
    case AxiomKind::data_property_domain:
      return is_empty_role(arguments[0]) || is_top(arguments[1]);
    case AxiomKind::has_key:
      return is_bottom(arguments[0]);
    case AxiomKind::class_assertion:
      return is_top(arguments[0]);
    default:
      return false;  // reflexivity, facts, equality: they always say something
  }
}

}  // namespace

std::vector<std::uint32_t> extract_module(const CompiledView& view, std::span<const std::uint32_t> terms) {
  Locality locality(view);
  for (const std::uint32_t term : terms) locality.add(term);
  std::vector<bool> is_taken(view.axiom_count(), false);
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    for (std::uint32_t axiom = 0; axiom < view.axiom_count(); ++axiom) {
      if (is_taken[axiom] || locality.is_local(axiom)) continue;
      is_taken[axiom] = true;
      for (const std::uint32_t argument : view.arguments_of_axiom(axiom)) has_grown |= locality.add(argument);
    }
  }
  std::vector<std::uint32_t> module;
  for (std::uint32_t axiom = 0; axiom < view.axiom_count(); ++axiom) {
    if (is_taken[axiom]) module.push_back(axiom);
  }
  return module;
}

}  // namespace geminga::el
