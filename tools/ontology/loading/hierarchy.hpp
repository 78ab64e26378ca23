// A hierarchy of named classes or properties, and its two forms in text: all inclusions, and an indented tree.
#ifndef GEMINGA_ONTOLOGY_LOADING_HIERARCHY_HPP
#define GEMINGA_ONTOLOGY_LOADING_HIERARCHY_HPP

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/rows.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::ontology {

/// Takes text piece by piece; false stops the writing.
using Sink = std::function<bool(std::string_view)>;

/// A taxonomy of classes or of properties. Borrows from the source and the classification.
struct Hierarchy {
  std::vector<std::string_view> iris;         ///< ascending
  std::vector<std::uint32_t> representative;  ///< of each
  base::Rows<std::uint32_t> members;          ///< of each representative, ascending; empty for others
  std::span<const std::uint32_t> parent_begin;
  std::vector<std::uint32_t> parents;
  std::uint32_t top = 0;
  std::uint32_t bottom = 0;
  bool is_consistent = true;

  [[nodiscard]] std::span<const std::uint32_t> parents_of(std::uint32_t node) const {
    return std::span(parents).subspan(parent_begin[node], parent_begin[node + 1] - parent_begin[node]);
  }
  [[nodiscard]] bool is_empty(std::uint32_t number) const {
    return !is_consistent || representative[number] == representative[bottom];
  }
};

[[nodiscard]] Hierarchy class_hierarchy(const owl::Ontology& source, const taxonomy::Classification& classification);
[[nodiscard]] Hierarchy property_hierarchy(const owl::Ontology& source, const taxonomy::PropertyTaxonomy& taxonomy,
                                           bool is_consistent);

/// The nodes right below each node, ascending; none below the leaves.
[[nodiscard]] base::Rows<std::uint32_t> children_of(const Hierarchy& hierarchy);

/// Writes one `SUB<TAB>SUPER` line of full IRIs for every entailed inclusion between different names, sorted by octets.
/// Equivalents stand in both directions, the top one is never SUPER, and a name that can have no instance has the one
/// line `NAME<TAB>BOTTOM`.
[[nodiscard]] bool write_closure(const Hierarchy& hierarchy, const Sink& sink);

/// Writes one line for each node of equivalents, indented by two blanks a level, below every parent that it has. The
/// nodes below a node are written once; a repeated node ends in `...` instead.
[[nodiscard]] bool write_tree(const Hierarchy& hierarchy,
                              const std::function<std::string(std::string_view)>& short_name, const Sink& sink);

}  // namespace geminga::ontology

#endif
