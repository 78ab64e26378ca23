// Faults of RDF/XML for which raptor passes over a statement and goes on.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_PASSED_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_TRIPLES_PASSED_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::rdf {

/// A fault that costs a file no more than a word, an attribute, or one element of a property.
struct Passed {
  std::string fault;
  std::uint32_t line = 0;
  bool is_harmless = false;  ///< no axiom can be lost: an attribute without a namespace, a mistyped rdf:nil
};

/// The fault that a message of raptor is about, if raptor goes on behind it. Those for which it passes over a node are
/// not among them: a node may be a member of a list, which would be a shorter one.
[[nodiscard]] std::optional<Passed> passed_over(std::string_view message, bool has_collections, std::uint32_t line);

}  // namespace geminga::rdf

#endif
