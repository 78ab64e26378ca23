// What stands above which concept, and how much information each step down adds.
#ifndef GEMINGA_REASONING_SIGNATURE_HIERARCHY_HPP
#define GEMINGA_REASONING_SIGNATURE_HIERARCHY_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/rows.hpp"

namespace geminga::signature {

/// The dense number of a concept that a parameter may have.
enum class Concept : std::uint32_t {};

/// That every instance of the first is one of the second.
using Inclusion = std::pair<Concept, Concept>;

/// A concept as the set of all that stands above it, itself included.
struct Meaning {
  std::uint32_t node = 0;                ///< equal for equivalent concepts
  std::vector<std::uint32_t> ancestors;  ///< ascending; empty for the top
  double bits = 0;                       ///< the information of all of them together
};

/// An immutable taxonomy for comparing concepts (RANK.md says why by these figures). Only its structure counts: equal
/// inclusions give equal figures, whatever the names.
class Hierarchy {
 public:
  /// The most nodes above one concept that count, the nearest ones. Protects from ontologies that are one long chain.
  static constexpr std::size_t max_ancestors = 10'000;

  /// Concepts that include each other are one node. What is said of `top`, the concept above all, has no meaning:
  /// everything is below it anyway. The last `foreign_count` concepts are in no ontology: nothing is said of them, they
  /// have nothing in common with any other, and the open world has the same size without them.
  Hierarchy(std::uint32_t concept_count, std::span<const Inclusion> inclusions, std::optional<Concept> top = {},
            std::uint32_t foreign_count = 0);

  /// O(ancestors).
  [[nodiscard]] Meaning meaning(Concept of) const;
  /// The information that stands above both.
  [[nodiscard]] double shared_bits(const Meaning& a, const Meaning& b) const;
  /// What a node adds to what its parents say together: log2 of how many nodes are below all of its parents, for each
  /// node that is below it. Below no parent is the open world, which has as many nodes again as the ontologies.
  [[nodiscard]] double added_bits(std::uint32_t node) const { return added_[node]; }
  [[nodiscard]] std::uint32_t concept_count() const { return static_cast<std::uint32_t>(node_of_.size()); }

 private:
  std::vector<std::uint32_t> node_of_;  ///< by concept
  std::optional<std::uint32_t> top_;
  base::Rows<std::uint32_t> parents_;
  std::vector<double> added_;
};

/// Whether the first is below the second or the same.
[[nodiscard]] bool is_under(const Meaning& sub, const Meaning& super);

}  // namespace geminga::signature

#endif
