// The meanings of the names in a class expression: all that a reader of expressions must know of an ontology.
#ifndef GEMINGA_REASONING_OWL_NAMES_HPP
#define GEMINGA_REASONING_OWL_NAMES_HPP

#include <expected>
#include <string>
#include <string_view>

#include "reasoning/owl/axiom.hpp"

namespace geminga::owl {

/// Resolves names as people write them.
class Names {
 public:
  virtual ~Names() = default;
  /// The full IRI of an entity of this kind, or one line that says why there is none. `name` is `<IRI>`, a bare IRI,
  /// `prefix:Name`, or any other name that the ontology knows.
  [[nodiscard]] virtual std::expected<std::string, std::string> find(TermKind kind, std::string_view name) const = 0;
};

}  // namespace geminga::owl

#endif
