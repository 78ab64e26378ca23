// Mends what people do wrong in RDF/XML and every browser forgives: encodings, names that XML forbids, bare ampersands.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TOLERANT_REPAIR_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TOLERANT_REPAIR_HPP

#include <optional>
#include <string>
#include <string_view>

namespace geminga::rdf {

/// The text of an XML file in UTF-8, if it is not: what is declared as windows-1252, ISO-8859-1 or -15, and octets that
/// are no UTF-8 where nothing is declared, are taken for windows-1252, which begins as ISO-8859-1 does. The declaration
/// of the encoding becomes spaces. Lines stay. Nothing where the text is UTF-8 already, or in an encoding that is
/// unknown.
[[nodiscard]] std::optional<std::string> in_utf8(std::string_view xml);

/// The same text with rdf:about in place of each rdf:ID that XML does not allow as a name or that was given before,
/// with `&amp;` for an ampersand that begins no reference to anything, spaces for control characters but NUL and for
/// doubled dashes in comments, nothing before the XML declaration, and a declaration of each prefix that no tag
/// declares: of those of RDF, OWL and OWL-S their own, of others one that is made up. Lines stay but for those before
/// the XML declaration.
[[nodiscard]] std::string with_legal_names(std::string_view xml);

}  // namespace geminga::rdf

#endif
