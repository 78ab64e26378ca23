// Files in other encodings than UTF-8, before anything else looks at them.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_ENCODING_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_ENCODING_HPP

#include <expected>
#include <string>

#include "reasoning/syntax/error.hpp"
#include "reasoning/syntax/files.hpp"

namespace geminga::rdf {

/// Turns a file in UTF-16 into UTF-8: one that begins with a byte order mark (RFC 2781, section 3.2), or with a
/// character of ASCII in UTF-16, as every ontology does. Spaces take the place of the encoding that its XML declaration
/// names. XML that declares windows-1252 becomes UTF-8, too. Any other file stays as it is. A character by halves, and
/// UTF-32, refuse the file.
[[nodiscard]] std::expected<syntax::FileBytes, syntax::LoadError> decoded(const std::string& path,
                                                                          syntax::FileBytes bytes);

/// Adds an octet of windows-1252 in UTF-8.
void append_windows_1252(unsigned char byte, std::string& out);

}  // namespace geminga::rdf

#endif
