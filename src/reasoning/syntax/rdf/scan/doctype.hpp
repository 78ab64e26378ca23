// The internal entities that a DOCTYPE declares, as Protégé writes them, their expanded sizes, and what it declares in
// other files, which are never read.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_SCAN_DOCTYPE_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_SCAN_DOCTYPE_HPP

#include <cstddef>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/syntax/limits.hpp"
#include "reasoning/syntax/rdf/scan/rewrite.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"

namespace geminga::rdf {

/// One DOCTYPE as far as it declares plain internal entities. Borrows the file's bytes.
class Doctype {
 public:
  /// Reads the DOCTYPE at `place`. External DTDs and entities, and what is declared of elements, is passed over.
  /// Internal parameter entities, default values of attributes, entities that hold markup or references to its
  /// characters, that contain themselves or expand to too much are refused.
  [[nodiscard]] static std::expected<Doctype, ScanProblem> read(std::string_view bytes, std::size_t place,
                                                                const syntax::FileLimits& limits);

  /// The place behind the closing bracket.
  [[nodiscard]] std::size_t end() const { return end_; }
  /// Whether it names an external DTD, or declares an entity of another file.
  [[nodiscard]] bool names_other_files() const { return names_other_files_ || names_other_entities_; }
  /// Cuts out all that was passed over, so that no parser asks for another file.
  [[nodiscard]] const std::vector<Rewrite>& cuts() const { return cuts_; }
  /// Whether a reference is to an entity that only another file can declare.
  [[nodiscard]] bool is_elsewhere(std::string_view name) const;
  /// The octets that a reference to this entity expands to; 1 for an entity that is not declared here.
  [[nodiscard]] std::size_t expanded_bytes(std::string_view name) const;
  /// The text that is declared for an entity, with its own references; nothing for one that is not declared here.
  [[nodiscard]] std::optional<std::string_view> value_of(std::string_view name) const;

 private:
  struct Entity {
    std::string_view value;
    std::size_t bytes = 0;      ///< expanded
    bool is_elsewhere = false;  ///< it, or one that it refers to
  };
  std::size_t end_ = 0;
  bool names_other_files_ = false;     ///< with declarations
  bool names_other_entities_ = false;  ///< by declarations of its own
  std::vector<Rewrite> cuts_;
  std::map<std::string_view, Entity> entities_;
};

/// The value of an attribute, its references to characters and to the entities of the DOCTYPE and of XML expanded.
/// Nothing where it has others. As long as the references of the DOCTYPE say (expanded_bytes()).
[[nodiscard]] std::optional<std::string> expanded(std::string_view written, const Doctype* doctype);

}  // namespace geminga::rdf

#endif
