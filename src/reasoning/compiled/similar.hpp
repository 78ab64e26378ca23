// "Did you mean": the names of an ontology that are nearest to an unknown one.
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
  /// How many classes are compared letter by letter. If there are more classes, those are taken that share the most
  /// pairs of letters with the name, as the signatures of the compiled form tell.
  std::size_t classes = std::numeric_limits<std::size_t>::max();
};

/// How many classes are compared in one event of the daemon. It takes at most a millisecond, and looking at the
/// signatures of 350 000 classes takes three more.
inline constexpr std::size_t max_compared_classes = 4096;

/// The pairs of neighbouring letters of a word, each as one of 64 bits. The case of ASCII letters does not count. One
/// wrong, missing, added or swapped letter changes at most six bits.
[[nodiscard]] std::uint64_t signature_of(std::string_view word);
/// The part of a name or IRI behind the last `:`, `/` or `#`.
[[nodiscard]] std::string_view local_name(std::string_view name);

/// Short names of classes that differ from `name` in a few letters, or whose local name or label does: nearest first,
/// then by name. Letters may be wrong, missing, superfluous, swapped, or of the other case. Linear in the classes, with
/// a large constant for those that are compared.
[[nodiscard]] std::vector<std::string> find_similar(const Ontology& ontology, std::string_view name,
                                                    const SimilarLimits& limits = {});

/// "A", "A or B", "A, B or C". If there are more than `most`, it says how many more.
[[nodiscard]] std::string alternatives(const std::vector<std::string>& names, std::size_t most = 20);

/// `: did you mean A, B or C?` to append to an error, or nothing if there are no alternatives.
[[nodiscard]] std::string did_you_mean(const std::vector<std::string>& names);

}  // namespace geminga::compiled

#endif
