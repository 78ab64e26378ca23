// Which terms may stand where: the grammar of the OWL 2 structural specification, one level at a time.
#include <algorithm>

#include "reasoning/owl/source.hpp"

namespace geminga::owl {
namespace {

/// Looks at the kinds of a list of arguments.
class Shape {
 public:
  explicit Shape(std::span<const TermKind> arguments) : arguments_(arguments) {}

  [[nodiscard]] bool has(std::size_t count) const { return arguments_.size() == count; }
  [[nodiscard]] bool has_at_least(std::size_t count) const { return arguments_.size() >= count; }
  template <typename Test>
  [[nodiscard]] bool at(std::size_t index, Test&& test) const {
    return index < arguments_.size() && test(arguments_[index]);
  }
  template <typename Test>
  [[nodiscard]] bool all(Test&& test, std::size_t from = 0) const {
    return std::ranges::all_of(arguments_.subspan(std::min(from, arguments_.size())), test);
  }

 private:
  std::span<const TermKind> arguments_;
};

constexpr auto is = [](TermKind wanted) { return [wanted](TermKind kind) { return kind == wanted; }; };

/// The terms that an atom of a rule may be about.
bool is_object(TermKind kind) { return is_individual(kind) || kind == TermKind::variable; }
bool is_value(TermKind kind) { return kind == TermKind::literal || kind == TermKind::variable; }

}  // namespace

bool is_class_expression(TermKind kind) {
  return kind == TermKind::named_class ||
         (kind >= TermKind::object_intersection_of && kind <= TermKind::data_exact_cardinality);
}

bool is_object_property_expression(TermKind kind) {
  return kind == TermKind::object_property || kind == TermKind::object_inverse_of;
}

bool is_data_range(TermKind kind) {
  return kind == TermKind::datatype ||
         (kind >= TermKind::data_intersection_of && kind <= TermKind::datatype_restriction);
}

bool is_individual(TermKind kind) { return kind == TermKind::individual || kind == TermKind::anonymous_individual; }

namespace {

/// Entities, literals and language tags.
bool is_well_formed_name(TermKind kind, const Shape& shape) {
  switch (kind) {
    case TermKind::named_class:
    case TermKind::object_property:
    case TermKind::data_property:
    case TermKind::annotation_property:
    case TermKind::datatype:
    case TermKind::individual:
    case TermKind::anonymous_individual:
    case TermKind::language_tag:
      return shape.has(0);
    case TermKind::literal:
      return shape.at(0, is(TermKind::datatype)) &&
             (shape.has(1) || (shape.has(2) && shape.at(1, is(TermKind::language_tag))));
    default:
      return false;
  }
}

/// Expressions of object properties, and of classes by them.
bool is_well_formed_over_objects(TermKind kind, const Shape& shape) {
  switch (kind) {
    case TermKind::object_inverse_of:
      return shape.has(1) && shape.at(0, is(TermKind::object_property));
    case TermKind::object_property_chain:
      return shape.has_at_least(2) && shape.all(is_object_property_expression);
    case TermKind::object_intersection_of:
    case TermKind::object_union_of:
      return shape.all(is_class_expression);
    case TermKind::object_complement_of:
      return shape.has(1) && shape.all(is_class_expression);
    case TermKind::object_one_of:
      return shape.all(is_individual);
    case TermKind::object_some_values_from:
    case TermKind::object_all_values_from:
      return shape.has(2) && shape.at(0, is_object_property_expression) && shape.at(1, is_class_expression);
    case TermKind::object_has_value:
      return shape.has(2) && shape.at(0, is_object_property_expression) && shape.at(1, is_individual);
    case TermKind::object_has_self:
      return shape.has(1) && shape.at(0, is_object_property_expression);
    case TermKind::object_min_cardinality:
    case TermKind::object_max_cardinality:
    case TermKind::object_exact_cardinality:
      return shape.at(0, is_object_property_expression) &&
             (shape.has(1) || (shape.has(2) && shape.at(1, is_class_expression)));
    default:
      return false;
  }
}

/// Class expressions by data properties, and data ranges.
bool is_well_formed_over_values(TermKind kind, const Shape& shape) {
  switch (kind) {
    case TermKind::data_some_values_from:
    case TermKind::data_all_values_from:
      return shape.has(2) && shape.at(0, is(TermKind::data_property)) && shape.at(1, is_data_range);
    case TermKind::data_has_value:
      return shape.has(2) && shape.at(0, is(TermKind::data_property)) && shape.at(1, is(TermKind::literal));
    case TermKind::data_min_cardinality:
    case TermKind::data_max_cardinality:
    case TermKind::data_exact_cardinality:
      return shape.at(0, is(TermKind::data_property)) && (shape.has(1) || (shape.has(2) && shape.at(1, is_data_range)));
    case TermKind::data_intersection_of:
    case TermKind::data_union_of:
      return shape.all(is_data_range);
    case TermKind::data_complement_of:
      return shape.has(1) && shape.all(is_data_range);
    case TermKind::data_one_of:
      return shape.all(is(TermKind::literal));
    case TermKind::datatype_restriction:
      return shape.has_at_least(2) && shape.at(0, is(TermKind::datatype)) && shape.all(is(TermKind::facet), 1);
    case TermKind::facet:
      return shape.has(1) && shape.at(0, is(TermKind::literal));
    default:
      return false;
  }
}

/// Variables and atoms.
bool is_well_formed_in_rules(TermKind kind, const Shape& shape) {
  switch (kind) {
    case TermKind::variable:
      return shape.has(0);
    case TermKind::class_atom:
      return shape.has(2) && shape.at(0, is_class_expression) && shape.at(1, is_object);
    case TermKind::data_range_atom:
      return shape.has(2) && shape.at(0, is_data_range) && shape.at(1, is_value);
    case TermKind::object_property_atom:
      return shape.has(3) && shape.at(0, is_object_property_expression) && shape.all(is_object, 1);
    case TermKind::data_property_atom:
      return shape.has(3) && shape.at(0, is(TermKind::data_property)) && shape.at(1, is_object) &&
             shape.at(2, is_value);
    case TermKind::same_individual_atom:
    case TermKind::different_individuals_atom:
      return shape.has(2) && shape.all(is_object);
    case TermKind::built_in_atom:
      return shape.all(is_value);
    case TermKind::atom_list:
      return shape.all([](TermKind atom) { return atom >= TermKind::class_atom && atom <= TermKind::built_in_atom; });
    default:
      return false;
  }
}

/// Declarations, and axioms that relate classes.
bool is_well_formed_of_classes(AxiomKind kind, const Shape& shape) {
  switch (kind) {
    case AxiomKind::declaration:
      return shape.has(1) && shape.all([](TermKind term) { return term <= TermKind::individual; });
    case AxiomKind::sub_class_of:
      return shape.has(2) && shape.all(is_class_expression);
    case AxiomKind::equivalent_classes:
    case AxiomKind::disjoint_classes:
      return shape.has_at_least(2) && shape.all(is_class_expression);
    case AxiomKind::disjoint_union:
      return shape.has_at_least(2) && shape.at(0, is(TermKind::named_class)) && shape.all(is_class_expression, 1);
    default:
      return false;
  }
}

/// Axioms about object properties.
bool is_well_formed_of_object_properties(AxiomKind kind, const Shape& shape) {
  switch (kind) {
    case AxiomKind::sub_object_property_of:
      return shape.has(2) && shape.at(1, is_object_property_expression) && shape.at(0, [](TermKind term) {
        return is_object_property_expression(term) || term == TermKind::object_property_chain;
      });
    case AxiomKind::equivalent_object_properties:
    case AxiomKind::disjoint_object_properties:
      return shape.has_at_least(2) && shape.all(is_object_property_expression);
    case AxiomKind::inverse_object_properties:
      return shape.has(2) && shape.all(is_object_property_expression);
    case AxiomKind::object_property_domain:
    case AxiomKind::object_property_range:
      return shape.has(2) && shape.at(0, is_object_property_expression) && shape.at(1, is_class_expression);
    case AxiomKind::functional_object_property:
    case AxiomKind::inverse_functional_object_property:
    case AxiomKind::reflexive_object_property:
    case AxiomKind::irreflexive_object_property:
    case AxiomKind::symmetric_object_property:
    case AxiomKind::asymmetric_object_property:
    case AxiomKind::transitive_object_property:
      return shape.has(1) && shape.all(is_object_property_expression);
    default:
      return false;
  }
}

/// Axioms about data properties and datatypes.
bool is_well_formed_of_values(AxiomKind kind, const Shape& shape) {
  switch (kind) {
    case AxiomKind::sub_data_property_of:
      return shape.has(2) && shape.all(is(TermKind::data_property));
    case AxiomKind::equivalent_data_properties:
    case AxiomKind::disjoint_data_properties:
      return shape.has_at_least(2) && shape.all(is(TermKind::data_property));
    case AxiomKind::data_property_domain:
      return shape.has(2) && shape.at(0, is(TermKind::data_property)) && shape.at(1, is_class_expression);
    case AxiomKind::data_property_range:
      return shape.has(2) && shape.at(0, is(TermKind::data_property)) && shape.at(1, is_data_range);
    case AxiomKind::functional_data_property:
      return shape.has(1) && shape.all(is(TermKind::data_property));
    case AxiomKind::datatype_definition:
      return shape.has(2) && shape.at(0, is(TermKind::datatype)) && shape.at(1, is_data_range);
    default:
      return false;
  }
}

/// Keys, facts and rules.
bool is_well_formed_of_individuals(AxiomKind kind, const Shape& shape) {
  const auto is_property = [](TermKind term) {
    return is_object_property_expression(term) || term == TermKind::data_property;
  };
  switch (kind) {
    case AxiomKind::has_key:
      return shape.has_at_least(2) && shape.at(0, is_class_expression) && shape.all(is_property, 1);
    case AxiomKind::same_individual:
    case AxiomKind::different_individuals:
      return shape.has_at_least(2) && shape.all(is_individual);
    case AxiomKind::class_assertion:
      return shape.has(2) && shape.at(0, is_class_expression) && shape.at(1, is_individual);
    case AxiomKind::object_property_assertion:
    case AxiomKind::negative_object_property_assertion:
      return shape.has(3) && shape.at(0, is_object_property_expression) && shape.all(is_individual, 1);
    case AxiomKind::data_property_assertion:
    case AxiomKind::negative_data_property_assertion:
      return shape.has(3) && shape.at(0, is(TermKind::data_property)) && shape.at(1, is_individual) &&
             shape.at(2, is(TermKind::literal));
    case AxiomKind::dl_safe_rule:
      return shape.has(2) && shape.all(is(TermKind::atom_list));
    default:
      return false;
  }
}

}  // namespace

// The kinds of a group stand together in their enumeration.

bool is_well_formed(TermKind kind, std::span<const TermKind> arguments) {
  const Shape shape(arguments);
  if (kind <= TermKind::language_tag) return is_well_formed_name(kind, shape);
  if (kind <= TermKind::object_exact_cardinality) return is_well_formed_over_objects(kind, shape);
  if (kind <= TermKind::facet) return is_well_formed_over_values(kind, shape);
  return is_well_formed_in_rules(kind, shape);
}

bool is_well_formed(AxiomKind kind, std::span<const TermKind> arguments) {
  const Shape shape(arguments);
  if (kind <= AxiomKind::disjoint_union) return is_well_formed_of_classes(kind, shape);
  if (kind <= AxiomKind::transitive_object_property) return is_well_formed_of_object_properties(kind, shape);
  if (kind <= AxiomKind::datatype_definition) return is_well_formed_of_values(kind, shape);
  return is_well_formed_of_individuals(kind, shape);
}

}  // namespace geminga::owl
