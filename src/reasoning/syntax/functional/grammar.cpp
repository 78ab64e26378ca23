#include "reasoning/syntax/functional/grammar.hpp"

#include <cstddef>

namespace geminga::functional {
namespace {

using owl::AxiomKind;
using owl::TermKind;
using enum Operand;
using First = std::array<Operand, 3>;

constexpr Production special(std::string_view word, Form form) { return {word, form, 0, none, false, {}, none, none}; }

constexpr Production entity(std::string_view word, TermKind kind) {
  return {word, Form::entity, static_cast<std::uint8_t>(kind), none, false, {}, none, none};
}

constexpr Production term(std::string_view word, TermKind kind, Operand result, First first, Operand repeated = none) {
  return {word, Form::expression, static_cast<std::uint8_t>(kind), result, false, first, none, repeated};
}

constexpr Production list(std::string_view word, TermKind kind, Operand result, Operand repeated) {
  return term(word, kind, result, {}, repeated);
}

constexpr Production cardinality(std::string_view word, TermKind kind, Operand property, Operand filler) {
  return {word, Form::expression, static_cast<std::uint8_t>(kind), class_expression, true, {property}, filler, none};
}

constexpr Production of_rules(std::string_view word, Form form, TermKind kind, Operand result) {
  return {word, form, static_cast<std::uint8_t>(kind), result, false, {}, none, none};
}

constexpr Production quantified_data(std::string_view word, TermKind kind) {
  return {word, Form::n_ary_data, static_cast<std::uint8_t>(kind), class_expression, false, {}, none, none};
}

constexpr Production axiom(std::string_view word, AxiomKind kind, First first, Operand repeated = none) {
  return {word, Form::axiom, static_cast<std::uint8_t>(kind), none, false, first, none, repeated};
}

constexpr Production axiom_list(std::string_view word, AxiomKind kind, Operand repeated) {
  return axiom(word, kind, {}, repeated);
}

/// In the order of the specification: documents, annotations, entities, expressions, ranges, axioms.
constexpr std::array productions{
    special("Prefix", Form::document),
    special("Ontology", Form::document),
    special("Import", Form::import),
    special("Annotation", Form::annotation),

    special("Declaration", Form::declaration),
    entity("Class", TermKind::named_class),
    entity("Datatype", TermKind::datatype),
    entity("ObjectProperty", TermKind::object_property),
    entity("DataProperty", TermKind::data_property),
    entity("AnnotationProperty", TermKind::annotation_property),
    entity("NamedIndividual", TermKind::individual),

    term("ObjectInverseOf", TermKind::object_inverse_of, object_property, {named_object_property}),
    list("ObjectPropertyChain", TermKind::object_property_chain, property_chain, object_property),

    list("ObjectIntersectionOf", TermKind::object_intersection_of, class_expression, class_expression),
    list("ObjectUnionOf", TermKind::object_union_of, class_expression, class_expression),
    term("ObjectComplementOf", TermKind::object_complement_of, class_expression, {class_expression}),
    list("ObjectOneOf", TermKind::object_one_of, class_expression, individual),
    term("ObjectSomeValuesFrom", TermKind::object_some_values_from, class_expression,
         {object_property, class_expression}),
    term("ObjectAllValuesFrom", TermKind::object_all_values_from, class_expression,
         {object_property, class_expression}),
    term("ObjectHasValue", TermKind::object_has_value, class_expression, {object_property, individual}),
    term("ObjectHasSelf", TermKind::object_has_self, class_expression, {object_property}),
    cardinality("ObjectMinCardinality", TermKind::object_min_cardinality, object_property, class_expression),
    cardinality("ObjectMaxCardinality", TermKind::object_max_cardinality, object_property, class_expression),
    cardinality("ObjectExactCardinality", TermKind::object_exact_cardinality, object_property, class_expression),
    quantified_data("DataSomeValuesFrom", TermKind::data_some_values_from),
    quantified_data("DataAllValuesFrom", TermKind::data_all_values_from),
    term("DataHasValue", TermKind::data_has_value, class_expression, {data_property, literal}),
    cardinality("DataMinCardinality", TermKind::data_min_cardinality, data_property, data_range),
    cardinality("DataMaxCardinality", TermKind::data_max_cardinality, data_property, data_range),
    cardinality("DataExactCardinality", TermKind::data_exact_cardinality, data_property, data_range),

    list("DataIntersectionOf", TermKind::data_intersection_of, data_range, data_range),
    list("DataUnionOf", TermKind::data_union_of, data_range, data_range),
    term("DataComplementOf", TermKind::data_complement_of, data_range, {data_range}),
    list("DataOneOf", TermKind::data_one_of, data_range, literal),
    term("DatatypeRestriction", TermKind::datatype_restriction, data_range, {datatype}, facet),

    axiom("SubClassOf", AxiomKind::sub_class_of, {class_expression, class_expression}),
    axiom_list("EquivalentClasses", AxiomKind::equivalent_classes, class_expression),
    axiom_list("DisjointClasses", AxiomKind::disjoint_classes, class_expression),
    axiom("DisjointUnion", AxiomKind::disjoint_union, {named_class}, class_expression),

    axiom("SubObjectPropertyOf", AxiomKind::sub_object_property_of, {property_chain, object_property}),
    axiom_list("EquivalentObjectProperties", AxiomKind::equivalent_object_properties, object_property),
    axiom_list("DisjointObjectProperties", AxiomKind::disjoint_object_properties, object_property),
    axiom("InverseObjectProperties", AxiomKind::inverse_object_properties, {object_property, object_property}),
    axiom("ObjectPropertyDomain", AxiomKind::object_property_domain, {object_property, class_expression}),
    axiom("ObjectPropertyRange", AxiomKind::object_property_range, {object_property, class_expression}),
    axiom("FunctionalObjectProperty", AxiomKind::functional_object_property, {object_property}),
    axiom("InverseFunctionalObjectProperty", AxiomKind::inverse_functional_object_property, {object_property}),
    axiom("ReflexiveObjectProperty", AxiomKind::reflexive_object_property, {object_property}),
    axiom("IrreflexiveObjectProperty", AxiomKind::irreflexive_object_property, {object_property}),
    axiom("SymmetricObjectProperty", AxiomKind::symmetric_object_property, {object_property}),
    axiom("AsymmetricObjectProperty", AxiomKind::asymmetric_object_property, {object_property}),
    axiom("TransitiveObjectProperty", AxiomKind::transitive_object_property, {object_property}),

    axiom("SubDataPropertyOf", AxiomKind::sub_data_property_of, {data_property, data_property}),
    axiom_list("EquivalentDataProperties", AxiomKind::equivalent_data_properties, data_property),
    axiom_list("DisjointDataProperties", AxiomKind::disjoint_data_properties, data_property),
    axiom("DataPropertyDomain", AxiomKind::data_property_domain, {data_property, class_expression}),
    axiom("DataPropertyRange", AxiomKind::data_property_range, {data_property, data_range}),
    axiom("FunctionalDataProperty", AxiomKind::functional_data_property, {data_property}),
    axiom("DatatypeDefinition", AxiomKind::datatype_definition, {datatype, data_range}),

    special("HasKey", Form::has_key),

    axiom_list("SameIndividual", AxiomKind::same_individual, individual),
    axiom_list("DifferentIndividuals", AxiomKind::different_individuals, individual),
    axiom("ClassAssertion", AxiomKind::class_assertion, {class_expression, individual}),
    axiom("ObjectPropertyAssertion", AxiomKind::object_property_assertion, {object_property, individual, individual}),
    axiom("NegativeObjectPropertyAssertion", AxiomKind::negative_object_property_assertion,
          {object_property, individual, individual}),
    axiom("DataPropertyAssertion", AxiomKind::data_property_assertion, {data_property, individual, literal}),
    axiom("NegativeDataPropertyAssertion", AxiomKind::negative_data_property_assertion,
          {data_property, individual, literal}),

    special("AnnotationAssertion", Form::annotation_assertion),
    special("SubAnnotationPropertyOf", Form::annotation_axiom),
    special("AnnotationPropertyDomain", Form::annotation_axiom),
    special("AnnotationPropertyRange", Form::annotation_axiom),

    // Rules of SWRL, in the words of Glimm, Horridge, Parsia, Patel-Schneider: A Syntax for Rules in OWL 2, 2009.
    axiom("DLSafeRule", AxiomKind::dl_safe_rule, {body, head}),
    of_rules("Body", Form::atoms, TermKind::atom_list, body),
    of_rules("Head", Form::atoms, TermKind::atom_list, head),
    term("ClassAtom", TermKind::class_atom, atom, {class_expression, rule_argument}),
    term("DataRangeAtom", TermKind::data_range_atom, atom, {data_range, rule_argument}),
    term("ObjectPropertyAtom", TermKind::object_property_atom, atom, {object_property, rule_argument, rule_argument}),
    term("DataPropertyAtom", TermKind::data_property_atom, atom, {data_property, rule_argument, rule_argument}),
    term("SameIndividualAtom", TermKind::same_individual_atom, atom, {rule_argument, rule_argument}),
    term("DifferentIndividualsAtom", TermKind::different_individuals_atom, atom, {rule_argument, rule_argument}),
    term("SameAsAtom", TermKind::same_individual_atom, atom, {rule_argument, rule_argument}),  // as before 2009
    term("DifferentFromAtom", TermKind::different_individuals_atom, atom, {rule_argument, rule_argument}),  // the same
    of_rules("BuiltInAtom", Form::built_in, TermKind::built_in_atom, atom),
    of_rules("Variable", Form::variable, TermKind::variable, rule_argument),

    // Description graphs, as the OWL API writes them.
    special("DGRule", Form::extension),
    special("DescriptionGraph", Form::extension),
};

constexpr std::size_t slot_count = 512;
constexpr std::uint8_t empty_slot = 0xff;
static_assert(productions.size() < empty_slot);

/// A hash of the first letters, the end and the length of a word.
constexpr std::size_t slot_of(std::string_view word) {
  std::uint32_t hash = static_cast<std::uint32_t>(word.size());
  for (const char c : word) hash = (hash ^ static_cast<unsigned char>(c)) * 0x01000193U;
  return (hash ^ hash >> 15U) % slot_count;
}

constexpr std::array<std::uint8_t, slot_count> make_slots() {
  std::array<std::uint8_t, slot_count> slots{};
  slots.fill(empty_slot);
  for (std::size_t number = 0; number < productions.size(); ++number) {
    std::size_t slot = slot_of(productions[number].word);
    while (slots[slot] != empty_slot) slot = (slot + 1) % slot_count;
    slots[slot] = static_cast<std::uint8_t>(number);
  }
  return slots;
}
constexpr std::array<std::uint8_t, slot_count> slots = make_slots();

constexpr std::size_t max_word_bytes = 31;
static_assert([] {
  for (const Production& production : productions) {
    if (production.word.size() > max_word_bytes) return false;
  }
  return true;
}());

}  // namespace

const Production* find_production(std::string_view word) {
  if (word.size() > max_word_bytes) return nullptr;
  for (std::size_t slot = slot_of(word); slots[slot] != empty_slot; slot = (slot + 1) % slot_count) {
    const Production& production = productions[slots[slot]];
    if (production.word == word) return &production;
  }
  return nullptr;
}

std::string_view to_string(Operand operand) {
  switch (operand) {
    case none:
      return "nothing";
    case named_class:
      return "the name of a class";
    case class_expression:
      return "a class expression";
    case named_object_property:
      return "the name of an object property";
    case object_property:
      return "an object property";
    case property_chain:
      return "an object property or a chain of them";
    case data_property:
      return "a data property";
    case datatype:
      return "the name of a datatype";
    case data_range:
      return "a data range";
    case individual:
      return "an individual";
    case literal:
      return "a literal";
    case facet:
      return "a facet";
    case rule_argument:
      return "an individual, a literal or a variable";
    case atom:
      return "an atom of a rule";
    case body:
      return "the body of a rule";
    case head:
      return "the head of a rule";
  }
  return "";
}

}  // namespace geminga::functional
