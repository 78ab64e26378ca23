// The facts about one individual as a class expression of which it is an instance.
#ifndef GEMINGA_ONTOLOGY_DESCRIPTION_DESCRIPTION_HPP
#define GEMINGA_ONTOLOGY_DESCRIPTION_DESCRIPTION_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <vector>

#include "reasoning/owl/print.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::ontology {

/// The individual that a file describes.
inline constexpr std::string_view self_iri = "https://geminga.example/core#self";
/// Octets of the longest expression that can be announced (src/discovery/announcement/limits.hpp).
inline constexpr std::size_t max_described_bytes = 640;
/// Individuals that one chain of facts passes, and facts that are taken in all, each as often as it is met.
inline constexpr std::size_t max_described_depth = 32;
inline constexpr std::size_t max_described_facts = 4096;

/// Something of the file that is not in the description.
struct Dropped {
  std::uint32_t line = 0;  ///< 0: unknown
  std::string text;
};

struct Description {
  std::string expression;        ///< canonical (manchester/canonical.hpp)
  std::vector<Dropped> dropped;  ///< by line
};

/// The facts about `self_iri`: its classes are conjuncts, a fact with an individual becomes `property some (what is
/// said of that)`, nested, and one with a literal `property value literal`. The expression follows from the facts of
/// all files: `self_iri` is an instance of it. What of `file` is not in it is named: chains that lead back to where
/// they came from, negative facts, the same and different individuals, and what is no fact about it or what it has.
/// Adds terms to the source. The error is one line without the name of the file.
[[nodiscard]] std::expected<Description, std::string> describe_self(owl::Ontology& source, owl::FileId file,
                                                                    const owl::ShortName& short_name);

}  // namespace geminga::ontology

#endif
