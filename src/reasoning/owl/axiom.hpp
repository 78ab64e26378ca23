// The vocabulary of axioms: the terms and axioms of the OWL 2 structural specification as numbers and small kinds.
//
// How a reader uses it (the builder is Ontology in reasoning/owl/source.hpp):
//
//   Ontology source;
//   const FileId file = source.add_file("soccer.ttl", "https://geminga.example/soccer");
//   const TermId ball = source.named_class("https://geminga.example/soccer#BallInfo");
//   const TermId seen_by = source.object_property("https://geminga.example/soccer#seenBy");
//   const TermId robot = source.named_class("https://geminga.example/core#Robot");
//   const TermId seen = source.term(TermKind::object_some_values_from, {seen_by, robot});
//   source.add(AxiomKind::sub_class_of, {ball, seen}, file, 17);
//   source.add_label("https://geminga.example/soccer#BallInfo", "ball", "en");
//   source.add_prefix("soccer", "https://geminga.example/soccer#");
//   source.leave_out("owl:onProperties", file, 30);               // what no axiom kind can express
//   if (auto problem = source.problem()) ...                      // a limit was exceeded: refuse the ontology
//   auto classification = classify(source, {});               // reasoning/el/classify.hpp
//   std::vector<std::byte> bytes = compile(source, *classification);   // reasoning/compiled/compile.hpp
//   auto ontology = Ontology::from_bytes(std::move(bytes));            // reasoning/compiled/ontology.hpp
//
// The arguments of every term and axiom stand in the order of the OWL 2 functional-style syntax. A reader hands over
// everything that has a kind here, whether the reasoner can use it or not: what is used is the reasoner's business,
// and it names what it leaves out.
#ifndef GEMINGA_REASONING_OWL_AXIOM_HPP
#define GEMINGA_REASONING_OWL_AXIOM_HPP

#include <cstdint>
#include <span>
#include <string_view>

namespace geminga::owl {

/// An interned string (an IRI, a blank node, a lexical form, a language tag) of one Ontology.
enum class NameId : std::uint32_t {};
/// An interned term of one Ontology: equal terms have equal ids.
enum class TermId : std::uint32_t {};
/// A loaded file of one Ontology.
enum class FileId : std::uint32_t {};

/// The kind of a term. Comments give the arguments. The numbers are part of the compiled form: only ever appended.
enum class TermKind : std::uint8_t {
  // Entities: a name, no arguments. The same IRI may be used in several kinds (punning); they are different terms.
  named_class = 0,  ///< owl:Thing and owl:Nothing are named classes, too
  object_property = 1,
  data_property = 2,
  annotation_property = 3,
  datatype = 4,
  individual = 5,
  anonymous_individual = 6,  ///< the name is unique to the file, as in `_:1.b0`
  // Literals: the lexical form is the name.
  literal = 7,       ///< datatype, and a language_tag where there is one
  language_tag = 8,  ///< a name, no arguments
  // Property expressions.
  object_inverse_of = 9,       ///< object property
  object_property_chain = 10,  ///< two or more object property expressions
  // Class expressions.
  object_intersection_of = 11,    ///< class expressions
  object_union_of = 12,           ///< class expressions
  object_complement_of = 13,      ///< class expression
  object_one_of = 14,             ///< individuals
  object_some_values_from = 15,   ///< object property expression, class expression
  object_all_values_from = 16,    ///< object property expression, class expression
  object_has_value = 17,          ///< object property expression, individual
  object_has_self = 18,           ///< object property expression
  object_min_cardinality = 19,    ///< number; object property expression, and a class expression where it is qualified
  object_max_cardinality = 20,    ///< the same
  object_exact_cardinality = 21,  ///< the same
  data_some_values_from = 22,     ///< data property, data range
  data_all_values_from = 23,      ///< data property, data range
  data_has_value = 24,            ///< data property, literal
  data_min_cardinality = 25,      ///< number; data property, and a data range where it is qualified
  data_max_cardinality = 26,      ///< the same
  data_exact_cardinality = 27,    ///< the same
  // Data ranges.
  data_intersection_of = 28,  ///< data ranges
  data_union_of = 29,         ///< data ranges
  data_complement_of = 30,    ///< data range
  data_one_of = 31,           ///< literals
  datatype_restriction = 32,  ///< datatype, then facets
  facet = 33,                 ///< the name is the facet's IRI; a literal
  // Rules (SWRL). An object of an atom is an individual or a variable, and a value is a literal or a variable.
  variable = 34,                    ///< a name, no arguments
  class_atom = 35,                  ///< class expression, object
  data_range_atom = 36,             ///< data range, value
  object_property_atom = 37,        ///< object property expression, object, object
  data_property_atom = 38,          ///< data property, object, value
  same_individual_atom = 39,        ///< object, object
  different_individuals_atom = 40,  ///< object, object
  built_in_atom = 41,               ///< the name is the built-in's IRI; values
  atom_list = 42,                   ///< atoms, all of which hold
};
inline constexpr std::uint8_t term_kind_count = 43;

/// The kind of an axiom. Comments give the arguments. The numbers are part of the compiled form: only ever appended.
enum class AxiomKind : std::uint8_t {
  declaration = 0,                   ///< an entity
  sub_class_of = 1,                  ///< sub, super
  equivalent_classes = 2,            ///< two or more class expressions
  disjoint_classes = 3,              ///< two or more class expressions
  disjoint_union = 4,                ///< a named class, then its parts
  sub_object_property_of = 5,        ///< an object property expression or chain, then the super property
  equivalent_object_properties = 6,  ///< two or more
  disjoint_object_properties = 7,    ///< two or more
  inverse_object_properties = 8,     ///< two
  object_property_domain = 9,        ///< property, class expression
  object_property_range = 10,        ///< property, class expression
  functional_object_property = 11,
  inverse_functional_object_property = 12,
  reflexive_object_property = 13,
  irreflexive_object_property = 14,
  symmetric_object_property = 15,
  asymmetric_object_property = 16,
  transitive_object_property = 17,
  sub_data_property_of = 18,
  equivalent_data_properties = 19,
  disjoint_data_properties = 20,
  data_property_domain = 21,  ///< property, class expression
  data_property_range = 22,   ///< property, data range
  functional_data_property = 23,
  datatype_definition = 24,  ///< datatype, data range
  has_key = 25,              ///< class expression, then object and data properties
  same_individual = 26,      ///< two or more individuals
  different_individuals = 27,
  class_assertion = 28,                     ///< class expression, individual
  object_property_assertion = 29,           ///< property, individual, individual
  negative_object_property_assertion = 30,  ///< the same
  data_property_assertion = 31,             ///< property, individual, literal
  negative_data_property_assertion = 32,    ///< the same
  dl_safe_rule = 33,                        ///< an atom list as its body, another as its head
};
inline constexpr std::uint8_t axiom_kind_count = 34;

/// The word of the functional-style syntax: "ObjectSomeValuesFrom", "SubClassOf".
[[nodiscard]] std::string_view to_string(TermKind kind);
[[nodiscard]] std::string_view to_string(AxiomKind kind);

/// A term as its source holds it. The span is valid until the source is changed.
struct Term {
  TermKind kind = TermKind::named_class;
  NameId name{};             ///< of entities, literals, language tags and facets
  std::uint32_t number = 0;  ///< of cardinalities
  std::span<const TermId> arguments;
};

/// An axiom as its source holds it. The span is valid until the source is changed.
struct Axiom {
  AxiomKind kind = AxiomKind::declaration;
  FileId file{};
  std::uint32_t line = 0;  ///< from 1; 0: unknown
  std::span<const TermId> arguments;
};

inline constexpr std::string_view owl_thing = "http://www.w3.org/2002/07/owl#Thing";
inline constexpr std::string_view owl_nothing = "http://www.w3.org/2002/07/owl#Nothing";
inline constexpr std::string_view owl_top_object_property = "http://www.w3.org/2002/07/owl#topObjectProperty";
inline constexpr std::string_view owl_bottom_object_property = "http://www.w3.org/2002/07/owl#bottomObjectProperty";
inline constexpr std::string_view owl_top_data_property = "http://www.w3.org/2002/07/owl#topDataProperty";
inline constexpr std::string_view owl_bottom_data_property = "http://www.w3.org/2002/07/owl#bottomDataProperty";

}  // namespace geminga::owl

#endif
