// Which syntax a file is in, by its name and by how its content begins.
#ifndef GEMINGA_REASONING_SYNTAX_SYNTAX_HPP
#define GEMINGA_REASONING_SYNTAX_SYNTAX_HPP

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>

namespace geminga::syntax {

enum class Syntax : std::uint8_t {
  rdf_xml,
  turtle,
  n_triples,
  // Syntaxes of OWL 2, without triples; modules of their own read them.
  functional,
  manchester,
  owl_xml,
};

/// "Turtle", "OWL/XML".
[[nodiscard]] std::string_view to_string(Syntax syntax);
[[nodiscard]] constexpr bool is_xml(Syntax syntax) { return syntax == Syntax::rdf_xml || syntax == Syntax::owl_xml; }
[[nodiscard]] constexpr bool has_triples(Syntax syntax) { return syntax <= Syntax::n_triples; }
/// Whether an undeclared property in this syntax is typed by what all other files say about it, so that it is read
/// last.
[[nodiscard]] constexpr bool is_read_last(Syntax syntax) { return syntax == Syntax::manchester; }

/// The syntax of a file, or why it cannot be read, as the words behind "FILE: ". A name that ends in .ttl or .nt
/// decides, and so does one that ends in .trig or .nq: TriG holds Turtle, N-Quads hold N-Triples, and the scan of
/// rdf/scan takes their graphs away. The endings .owl, .rdf and .xml are used for several syntaxes, and the content
/// decides. The syntaxes of OWL 2 are recognised by their content, whatever the name; .ofn, .fss, .omn and .owx can be
/// nothing else. With any other name the content decides alone. A .gz behind the name does not count.
[[nodiscard]] std::expected<Syntax, std::string> detect_syntax(std::string_view path, std::string_view content);

/// Whether a file begins as XML and names neither RDF's nor OWL's namespace there, so that it belongs to another
/// program.
[[nodiscard]] bool is_foreign_xml(std::string_view begin);

}  // namespace geminga::syntax

#endif
