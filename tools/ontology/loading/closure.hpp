// The subsumptions between named classes that follow, as sorted pairs that can be compared between ontologies.
#ifndef GEMINGA_ONTOLOGY_LOADING_CLOSURE_HPP
#define GEMINGA_ONTOLOGY_LOADING_CLOSURE_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ontology/loading/hierarchy.hpp"
#include "reasoning/taxonomy/class_number.hpp"

namespace geminga::ontology {

struct Subsumption {
  taxonomy::ClassNumber sub{};
  taxonomy::ClassNumber super{};
  friend auto operator<=>(const Subsumption&, const Subsumption&) = default;
};

/// The most subsumptions of an ontology that are compared with others.
inline constexpr std::size_t max_compared_subsumptions = 4'000'000;

/// The subsumptions between different classes that can have instances, without those of owl:Thing: ascending.
struct Closure {
  std::vector<Subsumption> pairs;
  std::vector<bool> is_empty;  ///< by class: it can have no instance
};

/// Numbers of classes by IRI, from 0 without gaps; they may hold more classes than one hierarchy.
using ClassNumbers = std::unordered_map<std::string_view, std::uint32_t>;

/// Nothing if there are too many subsumptions. Requires a number for each class of the hierarchy.
[[nodiscard]] std::optional<Closure> closure_of(const Hierarchy& hierarchy, const ClassNumbers& numbers);

/// Those of the different subsumptions that follow from no other one and what is kept, up to so many.
[[nodiscard]] std::vector<Subsumption> telling(const std::vector<Subsumption>& different, const Closure& kept,
                                               std::size_t most);

}  // namespace geminga::ontology

#endif
