// Which properties are object and which are data properties. Manchester syntax writes both alike, and their
// declarations may stand behind their first use or in another file.
#ifndef GEMINGA_REASONING_SYNTAX_FRAMES_DECLARED_HPP
#define GEMINGA_REASONING_SYNTAX_FRAMES_DECLARED_HPP

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "reasoning/owl/source.hpp"

namespace geminga::frames {

/// The kinds with which all files of a load declare IRIs, or use them in a syntax that distinguishes kinds.
class Declared {
 public:
  void add(owl::TermKind kind, std::string_view iri);
  /// Adds the properties and datatypes of a source.
  void add(const owl::Ontology& source);
  [[nodiscard]] bool has(owl::TermKind kind, std::string_view iri) const;

 private:
  struct TextHash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
  };
  /// A bit for each kind of entity.
  std::unordered_map<std::string, std::uint8_t, TextHash, std::equal_to<>> kinds_;
};

}  // namespace geminga::frames

#endif
