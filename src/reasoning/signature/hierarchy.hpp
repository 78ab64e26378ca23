// The hierarchy of concepts, and the information that each step down adds.
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

/// An inclusion: every instance of the first concept is one of the second.
using Inclusion = std::pair<Concept, Concept>;

/// A concept as the set of all concepts above it, itself included.
struct Meaning {
  std::uint32_t node = 0;                ///< equal for equivalent concepts
  std::vector<std::uint32_t> ancestors;  ///< ascending; empty for the top
  double bits = 0;                       ///< the information of all ancestors together
};

/// An immutable taxonomy for comparing concepts (RANK.md argues for the figures). Only its structure counts: equal
/// inclusions give equal figures, whatever the names.
class Hierarchy {
 public:
  /// The limit of nodes above one concept that count; the nearest ones do. It protects from ontologies of one long
  /// chain.
  static constexpr std::size_t max_ancestors = 10'000;

  /// Concepts that include each other are one node. Inclusions in `top`, the concept above all, say nothing. The last
  /// `foreign_count` concepts are in no ontology: they have no inclusions, share nothing with other concepts, and do
  /// not enlarge the open world.
  Hierarchy(std::uint32_t concept_count, std::span<const Inclusion> inclusions, std::optional<Concept> top = {},
            std::uint32_t foreign_count = 0);

  /// The ancestors of a concept. O(ancestors).
  [[nodiscard]] Meaning meaning(Concept of) const;
  /// The information of the ancestors that both share.
  [[nodiscard]] double shared_bits(const Meaning& a, const Meaning& b) const;
  [[nodiscard]] std::uint32_t concept_count() const { return static_cast<std::uint32_t>(node_of_.size()); }

 private:
  std::vector<std::uint32_t> node_of_;  ///< by concept
  std::optional<std::uint32_t> top_;
  base::Rows<std::uint32_t> parents_;
  /// By node, the information that it adds to its parents: log2 of how many nodes are below all its parents, for each
  /// node below it. A node without parents is in the open world, which has as many nodes again as the ontologies.
  std::vector<double> added_;
};

/// True if the first concept is below the second or the same.
[[nodiscard]] bool is_under(const Meaning& sub, const Meaning& super);

}  // namespace geminga::signature

#endif
