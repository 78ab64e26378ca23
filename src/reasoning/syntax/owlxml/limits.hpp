// The most that one file in OWL/XML may hold.
#ifndef GEMINGA_REASONING_SYNTAX_OWLXML_LIMITS_HPP
#define GEMINGA_REASONING_SYNTAX_OWLXML_LIMITS_HPP

#include <cstddef>

namespace geminga::owlxml {

/// A file that exceeds one of these is refused, with the line. The limits of owl::SourceLimits hold as well.
struct XmlLimits {
  std::size_t file_bytes = std::size_t{1} << 30;
  /// Not a limit: from this size on two threads read a file, where there may be two.
  std::size_t apart_bytes = std::size_t{1} << 20;
  /// Of one IRI, written out.
  std::size_t iri_bytes = 8192;
  /// Of one text.
  std::size_t literal_bytes = std::size_t{1} << 20;
  /// Nested elements. libxml2 has a limit of its own, which is 256.
  std::size_t nesting = 250;
  /// Of one element: libxml2 compares each with each.
  std::size_t attributes = 1024;
  /// Of one expression or axiom.
  std::size_t operands = 1'000'000;
  std::size_t prefixes = 10'000;
  std::size_t imports = 10'000;
  /// Of a DOCTYPE: how many, and what one of them expands to.
  std::size_t entities = 4096;
  std::size_t entity_bytes = std::size_t{1} << 16;
};

}  // namespace geminga::owlxml

#endif
