// Taxonomies as tests compare them: what a .taxonomy file says, and what a classification says.
#ifndef GEMINGA_TESTS_CASES_TAXONOMY_HPP
#define GEMINGA_TESTS_CASES_TAXONOMY_HPP

#include <cstddef>
#include <expected>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reasoning/el/classify.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::cases {

/// What is entailed, one `SUB < SUPER` line for each pair of different named classes, sorted. As in the contract of
/// `classify --closure`: no line has owl:Thing as super unless nothing else says that it exists, an unsatisfiable class
/// has the one line `SUB < Nothing`, and an inconsistent ontology the one line `inconsistent`. Beyond the contract,
/// owl:Thing is a sub where something is equivalent to it.
using Closure = std::vector<std::string>;

/// Reads a tree as README.md describes it. The error says which line is wrong.
[[nodiscard]] std::expected<Closure, std::string> read_tree(std::string_view text);

/// Of a classification, walked up from each class. Names are what follows the last `#` or `/` of an IRI where
/// `are_short`, and whole IRIs otherwise.
[[nodiscard]] Closure closure_of(const owl::Ontology& source, const taxonomy::Classification& classification,
                                 bool are_short = true);

/// Edges of the taxonomy that another way round it makes superfluous, as `SUB < SUPER` lines: none in a reduced one.
[[nodiscard]] std::vector<std::string> superfluous_edges(const owl::Ontology& source,
                                                         const taxonomy::Classification& classification);

/// The closure of `sub, super` pairs of names, in which owl:Thing and owl:Nothing are `Thing` and `Nothing`.
[[nodiscard]] Closure closure_of_pairs(const std::vector<std::pair<std::string, std::string>>& pairs);

/// Lines of the first that are not in the second; both are sorted.
[[nodiscard]] Closure without(const Closure& lines, const Closure& others);

/// What of `found` does not follow where exactly `expected` does: from an unsatisfiable class everything does.
[[nodiscard]] Closure unsound(const Closure& found, const Closure& expected);

}  // namespace geminga::cases

#endif
