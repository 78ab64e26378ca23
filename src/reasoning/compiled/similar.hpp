// "Did you mean": the names of an ontology that are nearest to one that it does not know.
#ifndef GEMINGA_REASONING_COMPILED_SIMILAR_HPP
#define GEMINGA_REASONING_COMPILED_SIMILAR_HPP

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/compiled/ontology.hpp"

namespace geminga::compiled {

/// How far to look.
struct SimilarLimits {
  std::size_t names = 3;  ///< that are given
  /// Classes that the name is compared with letter by letter: all, or where there are more, those that share the most
  /// pairs of letters with it, which the compiled form knows.
  std::size_t classes = std::numeric_limits<std::size_t>::max();
};

/// So many are compared in an event of the daemon: at most a millisecond, beside a look at the signature of each class
/// (350 000 take three).
inline constexpr std::size_t max_compared_classes = 4096;

/// The pairs of neighbouring letters of a word, each as one of 64 bits; the case of ASCII letters does not count. One
/// wrong, missing, added or swapped letter changes six bits at most.
[[nodiscard]] std::uint64_t signature_of(std::string_view word);
/// What stands behind the last `:`, `/` or `#` of a name or IRI.
[[nodiscard]] std::string_view local_name(std::string_view name);

/// Short names of classes that are a few letters away from `name`, or whose local name or label is: nearest first, then
/// by name. Letters may be wrong, missing, too many, swapped, or of the other case. Linear in the classes, with a large
/// constant for those that are compared only.
[[nodiscard]] std::vector<std::string> find_similar(const Ontology& ontology, std::string_view name,
                                                    const SimilarLimits& limits = {});

/// "A", "A or B", "A, B or C"; of more than `most`, how many more there are.
[[nodiscard]] std::string alternatives(const std::vector<std::string>& names, std::size_t most = 20);

/// `: did you mean A, B or C?`, or nothing where there are none; behind the text of an error.
[[nodiscard]] std::string did_you_mean(const std::vector<std::string>& names);

}  // namespace geminga::compiled

#endif
