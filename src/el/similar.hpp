// "Did you mean": the names of an ontology that are nearest to one that it does not know.
#ifndef GEMINGA_EL_SIMILAR_HPP
#define GEMINGA_EL_SIMILAR_HPP

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "el/ontology.hpp"

namespace geminga::el {

/// How far to look.
struct SimilarLimits {
  std::size_t names = 3;  ///< that are given
  /// Classes that the name is compared with: all, or where there are more, those that stand nearest to it in the order
  /// of IRIs, which begin as it does.
  std::size_t classes = std::numeric_limits<std::size_t>::max();
};

/// Short names of classes that are a few letters away from `name`, or whose local name or label is: nearest first, then
/// by name. Letters may be wrong, missing, too many, swapped, or of the other case. Linear in the classes that are
/// compared.
[[nodiscard]] std::vector<std::string> find_similar(const Ontology& ontology, std::string_view name,
                                                    const SimilarLimits& limits = {});

/// "A", "A or B", "A, B or C"; of more than `most`, how many more there are.
[[nodiscard]] std::string alternatives(const std::vector<std::string>& names, std::size_t most = 20);

/// `: did you mean A, B or C?`, or nothing where there are none; behind the text of an error.
[[nodiscard]] std::string did_you_mean(const std::vector<std::string>& names);

}  // namespace geminga::el

#endif
