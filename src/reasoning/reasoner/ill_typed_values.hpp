// The values that can stand in place of one ill-typed literal: one or some of each class of values that nothing
// distinguishes.
#ifndef GEMINGA_REASONING_REASONER_ILL_TYPED_VALUES_HPP
#define GEMINGA_REASONING_REASONER_ILL_TYPED_VALUES_HPP

#include <expected>
#include <set>
#include <string>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// Ranges, literals and counts that distinguish values from each other.
struct Distinctions {
  std::set<owl::TermId> datatypes;
  std::set<owl::TermId> literals;
  std::set<owl::TermId> facets;
};

/// Literals of the source: one of each class of values of the datatype, or `alike` different ones if the class has so
/// many. The given literals are distinguished from all others. The others are not among `taken`. The error says why the
/// classes are not known.
[[nodiscard]] std::expected<std::vector<owl::TermId>, std::string> values_of(owl::Ontology& source,
                                                                             std::string_view datatype,
                                                                             const Distinctions& distinctions,
                                                                             const std::set<owl::TermId>& taken,
                                                                             std::size_t alike);

}  // namespace geminga::reasoner

#endif
