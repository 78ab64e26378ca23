// The most that one file in functional-style syntax may hold.
#ifndef GEMINGA_REASONING_SYNTAX_FUNCTIONAL_LIMITS_HPP
#define GEMINGA_REASONING_SYNTAX_FUNCTIONAL_LIMITS_HPP

#include <cstddef>

namespace geminga::functional {

/// A file that exceeds one of these is refused, with the line. The limits of owl::SourceLimits hold as well.
struct FunctionalLimits {
  std::size_t file_bytes = std::size_t{1} << 30;
  /// Of one IRI, written out, and of one word, language tag, number or blank node's label.
  std::size_t iri_bytes = 8192;
  /// Of one text, after its escapes.
  std::size_t literal_bytes = std::size_t{1} << 20;
  /// Expressions within expressions, and annotations of annotations. The reader descends once for each.
  std::size_t nesting = 512;
  /// Of one expression or axiom.
  std::size_t operands = 1'000'000;
  std::size_t prefixes = 10'000;
  std::size_t imports = 10'000;
  /// Axioms that the grammar does not allow, each of which is left out by name.
  std::size_t wrong_axioms = 1000;
};

}  // namespace geminga::functional

#endif
