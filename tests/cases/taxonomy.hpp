// Taxonomies as tests compare them: of a .taxonomy file, and of a classification.
#ifndef GEMINGA_TESTS_CASES_TAXONOMY_HPP
#define GEMINGA_TESTS_CASES_TAXONOMY_HPP

#include <expected>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::cases {

/// The entailed subsumptions, one `SUB < SUPER` line for each pair of different named classes, sorted. As in the
/// contract of `classify --closure`, a line has owl:Thing as super only if the class has no other line, an
/// unsatisfiable class has the one line `SUB < Nothing`, and an inconsistent ontology the one line `inconsistent`.
/// Beyond the contract, owl:Thing is a sub if a class is equivalent to it.
using Closure = std::vector<std::string>;

/// Reads a tree as README.md describes it. The error says which line is wrong.
[[nodiscard]] std::expected<Closure, std::string> read_tree(std::string_view text);

/// The closure of a classification, by walks up from each class. Names are whole IRIs, or their ends behind the last
/// `#` or `/` if `are_short`.
[[nodiscard]] Closure closure_of(const owl::Ontology& source, const taxonomy::Classification& classification,
                                 bool are_short = true);

/// Edges of the taxonomy that a longer way implies, as `SUB < SUPER` lines. A reduced taxonomy has none.
[[nodiscard]] std::vector<std::string> superfluous_edges(const owl::Ontology& source,
                                                         const taxonomy::Classification& classification);

/// The closure of `sub, super` pairs of names, in which owl:Thing and owl:Nothing are `Thing` and `Nothing`.
[[nodiscard]] Closure closure_of_pairs(const std::vector<std::pair<std::string, std::string>>& pairs);

/// Lines of the first that are not in the second; both are sorted.
[[nodiscard]] Closure without(const Closure& lines, const Closure& others);

/// The lines of `found` that do not follow if exactly `expected` does. An unsatisfiable class is below every class.
[[nodiscard]] Closure unsound(const Closure& found, const Closure& expected);

}  // namespace geminga::cases

#endif
