// A taxonomy written out: every entailed inclusion between named entities, an indented tree, or nodes as JSON.
#ifndef GEMINGA_ONTOLOGY_CLOSURE_HPP
#define GEMINGA_ONTOLOGY_CLOSURE_HPP

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"

namespace geminga::ontology {

/// Takes text piece by piece; false stops the writing.
using Sink = std::function<bool(std::string_view)>;

/// A taxonomy of classes or of properties, as its writers see it. It borrows from the source and the classification.
struct Hierarchy {
  std::vector<std::string_view> iris;               ///< ascending
  std::vector<std::uint32_t> representative;        ///< of each
  std::vector<std::vector<std::uint32_t>> members;  ///< of each representative, ascending; empty for others
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

/// One `SUB<TAB>SUPER` line of full IRIs for every entailed inclusion between different named entities, equivalents in
/// both directions, without the top one as super; the one line `NAME<TAB>BOTTOM` for one that can have no instance.
/// Sorted by octets.
[[nodiscard]] bool write_closure(const Hierarchy& hierarchy, const Sink& sink);

/// One line a node of equivalents, indented by two blanks a level, below every parent that it has; what stands below a
/// node that was written before is not written again and shown by `...`.
[[nodiscard]] bool write_tree(const Hierarchy& hierarchy,
                              const std::function<std::string(std::string_view)>& short_name, const Sink& sink);

/// The classes of each representative, ascending; empty for others.
[[nodiscard]] std::vector<std::vector<taxonomy::ClassNumber>> equivalents(
    const taxonomy::Classification& classification);

}  // namespace geminga::ontology

#endif
