// The reduced hierarchy of the properties of an ontology: nodes of equivalent properties, and the direct
// super-properties of each.
//
// It is derived from the property axioms: inclusions, equivalents, inverses, symmetry, chains in which all links but
// one are reflexive, and emptiness (below the bottom property, disjoint with itself, without any domain or range).
// Consequences that need class axioms are not derived.
#ifndef GEMINGA_REASONING_TAXONOMY_PROPERTY_TAXONOMY_HPP
#define GEMINGA_REASONING_TAXONOMY_PROPERTY_TAXONOMY_HPP

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::taxonomy {

/// The dense number of a named property in one taxonomy.
enum class PropertyNumber : std::uint32_t {};

/// The named object properties, or the named data properties, that the axioms use, and the top and the bottom property.
/// They are numbered in ascending order of their IRIs (octet by octet).
struct PropertyTaxonomy {
  std::vector<owl::NameId> properties;  ///< the IRI of each
  PropertyNumber top{};
  PropertyNumber bottom{};
  /// The smallest property that each is equivalent to, which is usually itself. Empty properties have that of the
  /// bottom property.
  std::vector<PropertyNumber> representative;
  /// The direct super-properties of each representative, as representatives, ascending. Empty for properties that are
  /// no representative, for the top property, and for the bottom property's representative, which lies below every
  /// leaf.
  std::vector<std::uint32_t> parent_begin;
  std::vector<PropertyNumber> parents;

  [[nodiscard]] std::span<const PropertyNumber> parents_of(PropertyNumber number) const {
    const auto index = static_cast<std::size_t>(number);
    return std::span(parents).subspan(parent_begin[index], parent_begin[index + 1] - parent_begin[index]);
  }
};

enum class PropertyKind : std::uint8_t { object, data };

/// Classifies the properties. The result depends only on the set of axioms. All properties of an inconsistent ontology
/// are one node; the caller says whether it is inconsistent. Linear in axioms, except for the closure of the chains.
[[nodiscard]] PropertyTaxonomy classify_properties(const owl::Ontology& source, PropertyKind kind,
                                                   bool is_consistent = true);

}  // namespace geminga::taxonomy

#endif
