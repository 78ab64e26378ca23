// The value of a literal of an ontology, and the facets that may restrict a datatype.
#ifndef GEMINGA_REASONING_OWL_LITERAL_VALUE_HPP
#define GEMINGA_REASONING_OWL_LITERAL_VALUE_HPP

#include <optional>
#include <span>
#include <vector>

#include "reasoning/owl/datatypes.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::owl {

/// Nothing if the datatype is not known. Every literal of an axiom is of its datatype (Ontology::literal()).
[[nodiscard]] std::optional<DataValue> value_of(const Ontology& source, const Term& literal);

/// Whether each facet is in the facet space of the datatype that it restricts (OWL 2 structural specification, sections
/// 4.1 to 4.7): xsd:double has bounds that are xsd:double, and no pattern. `restriction` is the datatype and its
/// facets. True if nothing is known of the datatype, or of that of a facet's value.
[[nodiscard]] bool has_its_facets(const Ontology& source, std::span<const TermId> restriction);

/// The same restriction of a numeric datatype with its bounds read as numbers of that datatype: xsd:double[<=
/// "1"^^xsd:integer] as xsd:double[<= "1"^^xsd:double]. Nothing if it needs no such reading, or has a bound that
/// cannot be read so. Adds terms to the source.
[[nodiscard]] std::optional<std::vector<TermId>> with_numeric_bounds(Ontology& source,
                                                                     std::span<const TermId> restriction);

/// Whether a lexical form that is not of this numeric datatype is that of an xsd:decimal, and the number one of its
/// values: "5.0" for xsd:integer. Of "7.5" or "300" for xsd:byte nobody knows which of its values is meant, and as
/// another number it would contradict a range.
[[nodiscard]] bool is_decimal_instead(std::string_view lexical, std::string_view datatype_iri);

}  // namespace geminga::owl

#endif
