// The units of measurement that the ontology in force declares.
#ifndef GEMINGA_REASONING_VOCABULARY_UNITS_HPP
#define GEMINGA_REASONING_VOCABULARY_UNITS_HPP

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace geminga::compiled {
class Ontology;
}

namespace geminga::vocabulary {

/// The number of base units: owl::unit_base_count.
inline constexpr std::size_t unit_base_count = 11;

/// A unit as it is declared. The symbol lives as long as the ontology.
struct FoundUnit {
  double factor = 1;
  double offset = 0;
  std::span<const std::int8_t> dimension;  ///< unit_base_count exponents
  std::uint32_t alone = 0;                 ///< not 0: it can be compared only with units of the same number
  std::string_view symbol;                 ///< the usual one; empty: none
};

/// The meanings of names of units. A value: copies are cheap, share their ontology and keep it alive.
class Units {
 public:
  /// No units.
  Units() = default;
  /// Null: without an ontology.
  explicit Units(std::shared_ptr<const compiled::Ontology> ontology);

  [[nodiscard]] bool is_empty() const { return declared_ == nullptr; }
  [[nodiscard]] std::size_t size() const;
  /// Whether both are copies of one value, or have no unit.
  friend bool operator==(const Units& a, const Units& b) { return a.declared_ == b.declared_; }

  /// The unit with this symbol. O(log n) without an allocation, like the next two.
  [[nodiscard]] std::optional<FoundUnit> by_symbol(std::string_view symbol) const;
  /// The unit whose IRI is both texts together.
  [[nodiscard]] std::optional<FoundUnit> by_iri(std::string_view space, std::string_view name) const;
  /// The unit of `prefix:Name` by the prefixes of the ontology. `om:` and `unit:` are known unless the ontology
  /// declares them.
  [[nodiscard]] std::optional<FoundUnit> by_name(std::string_view prefixed) const;
  /// For "did you mean": a symbol that differs from the text by one letter, or empty. Looks at all symbols.
  [[nodiscard]] std::string_view similar_symbol(std::string_view text) const;

 private:
  struct Declared;
  [[nodiscard]] FoundUnit at(std::uint32_t number) const;

  std::shared_ptr<const Declared> declared_;  ///< null where there are no units
};

}  // namespace geminga::vocabulary

#endif
