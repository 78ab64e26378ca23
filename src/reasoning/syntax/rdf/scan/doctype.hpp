// The internal entities that a DOCTYPE declares, as Protégé writes them, and their expanded sizes.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_DOCTYPE_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_DOCTYPE_HPP

#include <cstddef>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"

namespace geminga::rdf {

/// One DOCTYPE that declares plain internal entities and nothing else. Borrows the file's bytes.
class Doctype {
 public:
  /// Reads the DOCTYPE at `place`. Parameter entities, external entities and DTDs, entities that hold markup, that
  /// contain themselves or expand to too much, and every other declaration are refused.
  [[nodiscard]] static std::expected<Doctype, ScanProblem> read(std::string_view bytes, std::size_t place,
                                                                const syntax::FileLimits& limits);

  /// The place behind the closing bracket.
  [[nodiscard]] std::size_t end() const { return end_; }
  /// The octets that a reference to this entity expands to; 1 for an entity that is not declared here.
  [[nodiscard]] std::size_t expanded_bytes(std::string_view name) const;
  /// The text that is declared for an entity, with its own references; nothing for one that is not declared here.
  [[nodiscard]] std::optional<std::string_view> value_of(std::string_view name) const;

 private:
  struct Entity {
    std::string_view value;
    std::size_t bytes = 0;  ///< expanded
  };
  std::size_t end_ = 0;
  std::map<std::string_view, Entity> entities_;
};

/// The value of an attribute, its references to the entities of the DOCTYPE and of XML expanded. Nothing where it has
/// others. As long as the references of the DOCTYPE say (expanded_bytes()).
[[nodiscard]] std::optional<std::string> expanded(std::string_view written, const Doctype* doctype);

}  // namespace geminga::rdf

#endif
