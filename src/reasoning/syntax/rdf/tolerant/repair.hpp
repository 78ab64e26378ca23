// Repairs common faults of RDF/XML: wrong encodings, names that XML forbids, bare ampersands.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TOLERANT_REPAIR_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TOLERANT_REPAIR_HPP

#include <optional>
#include <string>
#include <string_view>

namespace geminga::rdf {

/// The text of an XML file in UTF-8. Nothing if it is UTF-8 already, or in an unknown encoding. A text that declares
/// windows-1252, ISO-8859-1 or -15, and octets that are no UTF-8 in a text that declares nothing, are read as
/// windows-1252. The declaration of the encoding becomes spaces. Lines stay.
[[nodiscard]] std::optional<std::string> in_utf8(std::string_view xml);

/// The same text with rdf:about in place of each rdf:ID that XML does not allow as a name or that was given before,
/// with `&amp;` for an ampersand that begins no reference to anything, spaces for control characters but NUL and for
/// doubled dashes in comments, nothing before the XML declaration, and a declaration of each prefix that no tag
/// declares: of those of RDF, OWL and OWL-S their own, of others one that is made up. Lines stay but for those before
/// the XML declaration.
[[nodiscard]] std::string with_legal_names(std::string_view xml);

}  // namespace geminga::rdf

#endif
