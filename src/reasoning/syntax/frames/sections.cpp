#include "reasoning/syntax/frames/sections.hpp"

#include <algorithm>
#include <array>

namespace geminga::frames {
namespace {

using owl::AxiomKind;
using enum Frame;
using enum Member;

constexpr std::array<std::string_view, 34> words{
    "AnnotationProperty:",
    "Annotations:",
    "Characteristics:",
    "Class:",
    "DataProperty:",
    "Datatype:",
    "DifferentFrom:",
    "DifferentIndividuals:",
    "DisjointClasses:",
    "DisjointProperties:",
    "DisjointUnionOf:",
    "DisjointWith:",
    "Domain:",
    "EquivalentClasses:",
    "EquivalentProperties:",
    "EquivalentTo:",
    "Facts:",
    "HasKey:",
    "Import:",
    "Individual:",
    "InverseOf:",
    "ObjectProperty:",
    "Ontology:",
    "Prefix:",
    "Range:",
    "Rule:",
    "SameAs:",
    "SameIndividual:",
    "SubClassOf:",
    "SubPropertyChain:",
    "SubPropertyOf:",
    "SuperClassOf:",
    "SuperPropertyOf:",
    "Types:",
};

constexpr std::array sections{
    Section{of_class, "SubClassOf:", class_expression, AxiomKind::sub_class_of, true, false},
    Section{of_class, "SuperClassOf:", class_expression, AxiomKind::sub_class_of, true, true},
    Section{of_class, "EquivalentTo:", class_expression, AxiomKind::equivalent_classes, true, false},
    Section{of_class, "DisjointWith:", class_expression, AxiomKind::disjoint_classes, true, false},

    Section{of_object_property, "Domain:", class_expression, AxiomKind::object_property_domain, true, false},
    Section{of_object_property, "Range:", class_expression, AxiomKind::object_property_range, true, false},
    Section{of_object_property, "SubPropertyOf:", object_property, AxiomKind::sub_object_property_of, true, false},
    Section{of_object_property, "SuperPropertyOf:", object_property, AxiomKind::sub_object_property_of, true, true},
    Section{of_object_property, "EquivalentTo:", object_property, AxiomKind::equivalent_object_properties, true, false},
    Section{of_object_property, "DisjointWith:", object_property, AxiomKind::disjoint_object_properties, true, false},
    Section{of_object_property, "InverseOf:", object_property, AxiomKind::inverse_object_properties, true, false},

    Section{of_data_property, "Domain:", class_expression, AxiomKind::data_property_domain, true, false},
    Section{of_data_property, "Range:", data_range, AxiomKind::data_property_range, true, false},
    Section{of_data_property, "SubPropertyOf:", data_property, AxiomKind::sub_data_property_of, true, false},
    Section{of_data_property, "SuperPropertyOf:", data_property, AxiomKind::sub_data_property_of, true, true},
    Section{of_data_property, "EquivalentTo:", data_property, AxiomKind::equivalent_data_properties, true, false},
    Section{of_data_property, "DisjointWith:", data_property, AxiomKind::disjoint_data_properties, true, false},

    Section{of_annotation_property, "Domain:", iri, AxiomKind::declaration, false, false},
    Section{of_annotation_property, "Range:", iri, AxiomKind::declaration, false, false},
    Section{of_annotation_property, "SubPropertyOf:", annotation_property, AxiomKind::declaration, false, false},

    Section{of_datatype, "EquivalentTo:", data_range, AxiomKind::datatype_definition, true, false},

    Section{of_individual, "Types:", class_expression, AxiomKind::class_assertion, true, true},
    Section{of_individual, "SameAs:", individual, AxiomKind::same_individual, true, false},
    Section{of_individual, "DifferentFrom:", individual, AxiomKind::different_individuals, true, false},
};

constexpr std::array characteristics{
    Characteristic{"Functional", AxiomKind::functional_object_property},
    Characteristic{"InverseFunctional", AxiomKind::inverse_functional_object_property},
    Characteristic{"Reflexive", AxiomKind::reflexive_object_property},
    Characteristic{"Irreflexive", AxiomKind::irreflexive_object_property},
    Characteristic{"Symmetric", AxiomKind::symmetric_object_property},
    Characteristic{"Asymmetric", AxiomKind::asymmetric_object_property},
    Characteristic{"Transitive", AxiomKind::transitive_object_property},
};
constexpr Characteristic functional_data{"Functional", AxiomKind::functional_data_property};

}  // namespace

static_assert(std::ranges::is_sorted(words));

std::span<const std::string_view> section_words() { return words; }

const Section* find_section(Frame frame, std::string_view word) {
  const auto found = std::ranges::find_if(
      sections, [&](const Section& section) { return section.frame == frame && section.word == word; });
  return found == sections.end() ? nullptr : &*found;
}

const Characteristic* find_characteristic(std::string_view word, bool is_data) {
  if (is_data) return word == functional_data.word ? &functional_data : nullptr;
  const auto found = std::ranges::find(characteristics, word, &Characteristic::word);
  return found == characteristics.end() ? nullptr : &*found;
}

bool begins_frame(std::string_view word) {
  constexpr std::array<std::string_view, 14> beginnings{"EquivalentProperties:",
                                                        "Class:",
                                                        "ObjectProperty:",
                                                        "DataProperty:",
                                                        "AnnotationProperty:",
                                                        "Datatype:",
                                                        "Individual:",
                                                        "Rule:",
                                                        "Import:",
                                                        "EquivalentClasses:",
                                                        "DisjointClasses:",
                                                        "DisjointProperties:",
                                                        "SameIndividual:",
                                                        "DifferentIndividuals:"};
  return std::ranges::find(beginnings, word) != beginnings.end();
}

}  // namespace geminga::frames
