// Literals of rdf:PlainLiteral, which hold their language in their lexical form.
#ifndef GEMINGA_REASONING_OWL_PLAIN_LITERAL_HPP
#define GEMINGA_REASONING_OWL_PLAIN_LITERAL_HPP

#include <string>
#include <string_view>

namespace geminga::owl {

inline constexpr std::string_view plain_literal_datatype = "http://www.w3.org/1999/02/22-rdf-syntax-ns#PlainLiteral";

/// Whether this has the form of a language tag (RFC 5646, section 2.1), of whatever language.
[[nodiscard]] bool is_language_tag(std::string_view tag);

struct PlainLiteral {
  std::string_view text;
  std::string language;  ///< in lower case; empty: none
};
/// "text@en"^^rdf:PlainLiteral is "text"@en, and "text@"^^rdf:PlainLiteral is "text" (OWL 2, section 5.7). Where no
/// language tag stands behind the last @, as in "me@example.org", all of it is the text: tools write texts so.
[[nodiscard]] PlainLiteral split_plain_literal(std::string_view lexical);

}  // namespace geminga::owl

#endif
