// Which syntax a file is in, by its name and by how its content begins.
#ifndef GEMINGA_RDF_SYNTAX_HPP
#define GEMINGA_RDF_SYNTAX_HPP

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

namespace geminga::rdf {

enum class Syntax : std::uint8_t {
  rdf_xml,
  turtle,
  n_triples,
  functional,  ///< of OWL 2: no triples, read by somebody else
};

/// Text without the byte order mark that some editors begin UTF-8 with.
[[nodiscard]] std::string_view without_mark(std::string_view content);

/// The syntax of a file, or why it cannot be read, as the words behind "FILE: ". A name that ends in .ttl or .nt says
/// what the file is; .owl, .rdf and .xml are used for several syntaxes, and the content decides. Functional syntax is
/// known by its content whatever the name; .ofn and .fss can be nothing else.
[[nodiscard]] std::expected<Syntax, std::string> detect_syntax(std::string_view path, std::string_view content);

}  // namespace geminga::rdf

#endif
