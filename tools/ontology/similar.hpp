// "Did you mean": the names of an ontology that are nearest to one that it does not know.
#ifndef GEMINGA_ONTOLOGY_SIMILAR_HPP
#define GEMINGA_ONTOLOGY_SIMILAR_HPP

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "el/ontology.hpp"

namespace geminga::ontology {

/// Short names of classes that are a few letters away from `name`, or whose local name or label is: nearest first, then
/// by name, at most `count`. Letters may be wrong, missing, too many, swapped, or of the other case. Linear in the
/// classes.
[[nodiscard]] std::vector<std::string> find_similar(const el::Ontology& ontology, std::string_view name,
                                                    std::size_t count = 3);

}  // namespace geminga::ontology

#endif
