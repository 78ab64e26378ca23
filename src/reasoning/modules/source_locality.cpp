#include "reasoning/modules/source_locality.hpp"

#include <algorithm>

#include "reasoning/modules/module_locality.hpp"
#include "reasoning/owl/datatypes.hpp"

namespace geminga::modules {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

SourceLocality::Extension SourceLocality::named(TermId id) const {
  const std::string_view iri = source_.name_of(id);
  if (iri == owl::owl_thing || iri == owl::owl_top_object_property || iri == owl::owl_top_data_property)
    return Extension::everything;
  if (iri == owl::owl_nothing || iri == owl::owl_bottom_object_property || iri == owl::owl_bottom_data_property)
    return Extension::empty;
  if (is_in_signature_[static_cast<std::size_t>(id)]) return Extension::unknown;
  return outside_ == Outside::is_empty ? Extension::empty : Extension::everything;
}

SourceLocality::Extension SourceLocality::of(TermId id) {
  if (++looked_at_ > max_terms_looked_at) return Extension::unknown;
  const owl::Term term = source_.term(id);
  const auto complement = [](Extension inner) {
    if (inner == Extension::unknown) return inner;
    return inner == Extension::empty ? Extension::everything : Extension::empty;
  };
  switch (term.kind) {
    case TermKind::named_class:
    case TermKind::object_property:
    case TermKind::data_property:
      return named(id);
    case TermKind::datatype:
      return source_.name(term.name) == owl::rdfs_literal ? Extension::everything : Extension::unknown;
    case TermKind::object_inverse_of:
      return of(term.arguments[0]);
    case TermKind::object_property_chain:
      return std::ranges::any_of(term.arguments, [this](TermId part) { return is_empty(part); }) ? Extension::empty
             : all_are(term.arguments, Extension::everything)                                    ? Extension::everything
                                                                                                 : Extension::unknown;
    case TermKind::object_intersection_of:
    case TermKind::data_intersection_of:
      return of_boolean(term, true);
    case TermKind::object_union_of:
    case TermKind::data_union_of:
      return of_boolean(term, false);
    case TermKind::object_complement_of:
    case TermKind::data_complement_of:
      return complement(of(term.arguments[0]));
    case TermKind::object_one_of:
    case TermKind::data_one_of:
      return term.arguments.empty() ? Extension::empty : Extension::unknown;
    default:
      return of_restriction(term);
  }
}

SourceLocality::Extension SourceLocality::of_boolean(const owl::Term& term, bool is_intersection) {
  const Extension absorbing = is_intersection ? Extension::empty : Extension::everything;
  const Extension neutral = is_intersection ? Extension::everything : Extension::empty;
  bool is_neutral = true;
  for (const TermId part : term.arguments) {
    const Extension one = of(part);
    if (one == absorbing) return absorbing;
    is_neutral = is_neutral && one == neutral;
  }
  return is_neutral ? neutral : Extension::unknown;
}

SourceLocality::Extension SourceLocality::filler(const owl::Term& term) {
  return term.arguments.size() < 2 ? Extension::everything : of(term.arguments[1]);
}

/// The domain is not empty, so that a universal role leads from everything to something; it may have one element only.
SourceLocality::Extension SourceLocality::at_least(std::uint32_t number, Extension role, Extension filler) const {
  if (number == 0) return Extension::everything;
  if (role == Extension::empty || filler == Extension::empty) return Extension::empty;
  const bool is_sure = role == Extension::everything && filler == Extension::everything && number == 1;
  return is_sure ? Extension::everything : Extension::unknown;
}

SourceLocality::Extension SourceLocality::of_restriction(const owl::Term& term) {
  const auto complement = [](Extension inner) {
    if (inner == Extension::unknown) return inner;
    return inner == Extension::empty ? Extension::everything : Extension::empty;
  };
  switch (term.kind) {
    case TermKind::object_some_values_from:
    case TermKind::data_some_values_from:
      return at_least(1, of(term.arguments[0]), filler(term));
    case TermKind::object_all_values_from:
    case TermKind::data_all_values_from: {
      const Extension role = of(term.arguments[0]);
      const Extension inner = filler(term);
      if (role == Extension::empty || inner == Extension::everything) return Extension::everything;
      return role == Extension::everything && inner == Extension::empty ? Extension::empty : Extension::unknown;
    }
    case TermKind::object_has_value:
    case TermKind::data_has_value:
    case TermKind::object_has_self:
      return of(term.arguments[0]);
    case TermKind::object_min_cardinality:
    case TermKind::data_min_cardinality:
      return at_least(term.number, of(term.arguments[0]), filler(term));
    case TermKind::object_max_cardinality:
    case TermKind::data_max_cardinality: {
      const Extension role = of(term.arguments[0]);
      const Extension inner = filler(term);
      // At most n is the complement of at least n + 1.
      if (role == Extension::empty || inner == Extension::empty) return Extension::everything;
      return term.number == 0 ? complement(at_least(1, role, inner)) : Extension::unknown;
    }
    case TermKind::object_exact_cardinality:
    case TermKind::data_exact_cardinality: {
      const Extension role = of(term.arguments[0]);
      const Extension inner = filler(term);
      const bool is_none = role == Extension::empty || inner == Extension::empty;
      if (term.number == 0) return is_none ? Extension::everything : complement(at_least(1, role, inner));
      return is_none ? Extension::empty : Extension::unknown;
    }
    default:
      return Extension::unknown;
  }
}

bool SourceLocality::all_are(Terms terms, Extension extension) {
  return std::ranges::all_of(terms, [&](TermId term) { return of(term) == extension; });
}

bool SourceLocality::at_most_one_is_not_empty(Terms terms) {
  return std::ranges::count_if(terms, [this](TermId term) { return !is_empty(term); }) <= 1;
}

/// A union that is empty with all of its parts, or everything by one part beside empty ones.
bool SourceLocality::is_trivial_union(Terms arguments) {
  const Terms parts = arguments.subspan(1);
  if (is_empty(arguments[0])) return all_are(parts, Extension::empty);
  return is_everything(arguments[0]) && at_most_one_is_not_empty(parts) &&
         std::ranges::any_of(parts, [this](TermId part) { return is_everything(part); });
}

/// A rule whose body never holds, or whose head always does.
bool SourceLocality::is_trivial_rule(Terms arguments) {
  const auto has_predicate = [](const owl::Term& atom) {
    return atom.kind >= TermKind::class_atom && atom.kind <= TermKind::data_property_atom;
  };
  const auto is_atom = [&](TermId id, Extension extension) {
    const owl::Term atom = source_.term(id);
    return has_predicate(atom) && of(atom.arguments[0]) == extension;
  };
  const Terms head = source_.term(arguments[1]).arguments;
  return std::ranges::any_of(source_.term(arguments[0]).arguments,
                             [&](TermId atom) { return is_atom(atom, Extension::empty); }) ||
         (!head.empty() &&
          std::ranges::all_of(head, [&](TermId atom) { return is_atom(atom, Extension::everything); }));
}

bool SourceLocality::is_local_property_axiom(const owl::Axiom& axiom) {
  const Terms arguments = axiom.arguments;
  switch (axiom.kind) {
    case AxiomKind::functional_object_property:
    case AxiomKind::inverse_functional_object_property:
    case AxiomKind::functional_data_property:
    case AxiomKind::irreflexive_object_property:
    case AxiomKind::asymmetric_object_property:
      return is_empty(arguments[0]);
    case AxiomKind::reflexive_object_property:
      return is_everything(arguments[0]);
    case AxiomKind::symmetric_object_property:
    case AxiomKind::transitive_object_property:
      return is_one_extension(arguments);
    default:
      return false;
  }
}

bool SourceLocality::is_local(const owl::Axiom& axiom) {
  looked_at_ = 0;
  const Terms arguments = axiom.arguments;
  switch (axiom.kind) {
    case AxiomKind::declaration:
      return true;
    case AxiomKind::sub_class_of:
    case AxiomKind::sub_object_property_of:
    case AxiomKind::sub_data_property_of:
    case AxiomKind::object_property_domain:
    case AxiomKind::object_property_range:
    case AxiomKind::data_property_domain:
    case AxiomKind::data_property_range:
      return is_empty(arguments[0]) || is_everything(arguments[1]);
    case AxiomKind::equivalent_classes:
    case AxiomKind::equivalent_object_properties:
    case AxiomKind::equivalent_data_properties:
    case AxiomKind::inverse_object_properties:
      return is_one_extension(arguments);
    case AxiomKind::disjoint_classes:
    case AxiomKind::disjoint_object_properties:
    case AxiomKind::disjoint_data_properties:
      return at_most_one_is_not_empty(arguments);
    case AxiomKind::disjoint_union:
      return is_trivial_union(arguments);
    case AxiomKind::datatype_definition:
      return !is_in_signature_[static_cast<std::size_t>(arguments[0])];
    case AxiomKind::has_key:
      return std::ranges::any_of(arguments, [this](TermId part) { return is_empty(part); });
    case AxiomKind::class_assertion:
    case AxiomKind::object_property_assertion:
    case AxiomKind::data_property_assertion:
      return is_everything(arguments[0]);
    case AxiomKind::negative_object_property_assertion:
    case AxiomKind::negative_data_property_assertion:
      return is_empty(arguments[0]);
    case AxiomKind::same_individual:
    case AxiomKind::different_individuals:
      return false;
    case AxiomKind::dl_safe_rule:
      return is_trivial_rule(arguments);
    default:
      return is_local_property_axiom(axiom);
  }
}

}  // namespace geminga::modules
