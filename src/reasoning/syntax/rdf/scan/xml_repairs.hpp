// Faults of published RDF/XML, and the text that is read in their place. Jena and the OWL API read most such files,
// too.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_XML_REPAIRS_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_XML_REPAIRS_HPP

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/rdf/scan/rewrite.hpp"

namespace geminga::rdf {

/// White space of XML 1.0, section 2.3.
inline constexpr std::string_view xml_space = " \t\r\n";

/// XML's NCName, where every character beyond ASCII counts as a letter: raptor decides about those.
[[nodiscard]] bool is_xml_name(std::string_view name);

/// The name of an XML element, in its tag.
[[nodiscard]] std::string_view element_name(std::string_view tag);

/// `rdf:ID="NAME"` of a tag at this place as `rdf:about="#NAME"`, which may be any name. Gives NAME, too.
struct IdAttribute {
  std::string_view id;
  Rewrite as_about;
};
[[nodiscard]] std::optional<IdAttribute> id_attribute(std::string_view tag, std::size_t begin);

/// A name of XML for an rdf:nodeID that is none, such as `_:genid1`; different ones for different names.
[[nodiscard]] std::string legal_node_id(std::string_view name);

/// Makes an XML literal of the content of a property's element, whose tag stands at this place: a comment with markup
/// in it, such as `<rdfs:comment>see <a href="...">here</a></rdfs:comment>`. Nothing if the property is of OWL's own
/// vocabulary, so that its content is no text, or if the tag says what its content is. `rdf` is RDF's prefix.
[[nodiscard]] std::optional<Rewrite> as_xml_literal(std::string_view tag, std::size_t begin, std::string_view rdf);

}  // namespace geminga::rdf

#endif
