// The names of RDF, RDFS and OWL 2 that the mapping knows, numbered so that a graph can compare them as numbers.
#ifndef GEMINGA_REASONING_SYNTAX_VOCABULARY_HPP
#define GEMINGA_REASONING_SYNTAX_VOCABULARY_HPP

#include <cstdint>
#include <string>
#include <string_view>

namespace geminga::syntax {

inline constexpr std::string_view rdf_namespace = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
inline constexpr std::string_view rdfs_namespace = "http://www.w3.org/2000/01/rdf-schema#";
inline constexpr std::string_view owl_namespace = "http://www.w3.org/2002/07/owl#";
inline constexpr std::string_view xsd_namespace = "http://www.w3.org/2001/XMLSchema#";
inline constexpr std::string_view skos_namespace = "http://www.w3.org/2004/02/skos/core#";
inline constexpr std::string_view swrl_namespace = "http://www.w3.org/2003/11/swrl#";

/// A word of the vocabulary. Its number is its node's number in every Graph.
enum class Word : std::uint32_t {
  none,
  rdf_type,
  rdf_first,
  rdf_rest,
  rdf_nil,
  rdf_list,
  rdf_property,
  rdf_plain_literal,
  rdf_xml_literal,
  rdf_lang_string,
  rdfs_class,
  rdfs_resource,
  rdfs_datatype,
  rdfs_literal,
  rdfs_sub_class_of,
  rdfs_sub_property_of,
  rdfs_domain,
  rdfs_range,
  rdfs_label,
  rdfs_comment,
  rdfs_see_also,
  rdfs_is_defined_by,
  skos_pref_label,
  owl_class,
  owl_restriction,
  owl_data_range,
  owl_ontology,
  owl_axiom,
  owl_annotation,
  owl_named_individual,
  owl_thing,
  owl_nothing,
  owl_object_property,
  owl_datatype_property,
  owl_annotation_property,
  owl_ontology_property,
  owl_deprecated_class,
  owl_deprecated_property,
  owl_functional_property,
  owl_inverse_functional_property,
  owl_reflexive_property,
  owl_irreflexive_property,
  owl_symmetric_property,
  owl_asymmetric_property,
  owl_transitive_property,
  owl_all_disjoint_classes,
  owl_all_disjoint_properties,
  owl_all_different,
  owl_negative_property_assertion,
  owl_top_object_property,
  owl_bottom_object_property,
  owl_top_data_property,
  owl_bottom_data_property,
  owl_real,
  owl_rational,
  owl_equivalent_class,
  owl_disjoint_with,
  owl_disjoint_union_of,
  owl_equivalent_property,
  owl_property_disjoint_with,
  owl_inverse_of,
  owl_property_chain_axiom,
  owl_has_key,
  owl_same_as,
  owl_different_from,
  owl_intersection_of,
  owl_union_of,
  owl_complement_of,
  owl_one_of,
  owl_datatype_complement_of,
  owl_on_property,
  owl_on_properties,
  owl_on_class,
  owl_on_data_range,
  owl_on_datatype,
  owl_with_restrictions,
  owl_some_values_from,
  owl_all_values_from,
  owl_has_value,
  owl_has_self,
  owl_min_cardinality,
  owl_max_cardinality,
  owl_cardinality,
  owl_min_qualified_cardinality,
  owl_max_qualified_cardinality,
  owl_qualified_cardinality,
  owl_members,
  owl_distinct_members,
  owl_source_individual,
  owl_assertion_property,
  owl_target_individual,
  owl_target_value,
  owl_annotated_source,
  owl_annotated_property,
  owl_annotated_target,
  owl_imports,
  owl_version_iri,
  owl_version_info,
  owl_prior_version,
  owl_backward_compatible_with,
  owl_incompatible_with,
  owl_deprecated,
  count,
};

/// The IRI of a word.
[[nodiscard]] std::string_view iri_of(Word word);
/// `owl:onProperty` for a name of RDF, RDFS, OWL, XSD, SKOS or SWRL; the IRI in angle brackets for any other.
[[nodiscard]] std::string short_word(std::string_view iri);

}  // namespace geminga::syntax

#endif
