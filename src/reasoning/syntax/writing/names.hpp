// Names as they are written: with the prefixes of the files where one fits.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_NAMES_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_NAMES_HPP

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::writing {

/// The prefixes of one source that every syntax can declare and use. A name without a fitting prefix stands in full.
class Names {
 public:
  using Prefix = std::pair<std::string_view, std::string_view>;  ///< without the colon; the IRI

  explicit Names(const owl::Ontology& source);

  /// Sorted, each once, without those of OWL's own words where the files do not declare them.
  [[nodiscard]] std::span<const Prefix> prefixes() const { return prefixes_; }
  /// `prefix:Local` or `<IRI>`.
  [[nodiscard]] std::string written(std::string_view iri) const;
  /// The label of an anonymous individual as every syntax can write it, with `_:`. Different names have different
  /// labels.
  [[nodiscard]] static std::string blank(std::string_view name);

 private:
  std::vector<Prefix> prefixes_;
};

/// Whether an IRI can stand between angle brackets.
[[nodiscard]] bool is_writable(std::string_view iri);
/// Why a document with a name that is not writable cannot be written.
[[nodiscard]] std::string unwritable(std::string_view iri);

}  // namespace geminga::writing

#endif
