// The values that one damaged literal may have meant, one or some of each class that can be told apart.
#ifndef GEMINGA_REASONING_REASONER_DAMAGED_VALUES_HPP
#define GEMINGA_REASONING_REASONER_DAMAGED_VALUES_HPP

#include <expected>
#include <set>
#include <string>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// What values can be told from each other by.
struct Distinctions {
  std::set<owl::TermId> datatypes;
  std::set<owl::TermId> literals;
  std::set<owl::TermId> facets;
};

/// Literals of the source: of each class of values of the datatype one, or `alike` different ones where it has so many.
/// Those that are given are told apart from all others. None of the others is one of `taken`. Or why the classes are
/// not known.
[[nodiscard]] std::expected<std::vector<owl::TermId>, std::string> values_of(owl::Ontology& source,
                                                                             std::string_view datatype,
                                                                             const Distinctions& distinctions,
                                                                             const std::set<owl::TermId>& taken,
                                                                             std::size_t alike);

}  // namespace geminga::reasoner

#endif
