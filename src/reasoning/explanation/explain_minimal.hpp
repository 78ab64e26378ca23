// The black box method: a minimal set of axioms for which a question holds, found by asking it about subsets.
#ifndef GEMINGA_REASONING_EXPLANATION_EXPLAIN_MINIMAL_HPP
#define GEMINGA_REASONING_EXPLANATION_EXPLAIN_MINIMAL_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace geminga::explanation {

/// Numbers of axioms of one source.
using AxiomSet = std::vector<std::uint32_t>;
/// A question about axioms. It is monotone: if it holds for a set, it holds for every larger set.
using Holds = std::function<bool(std::span<const std::uint32_t>)>;

/// A minimal subset of `candidates` for which `holds` is true, ascending. It must be true for all of them. It is asked
/// O(k log(n / k)) times for a subset of k among n (QuickXplain, Junker 2004).
[[nodiscard]] AxiomSet find_minimal(const AxiomSet& candidates, const Holds& holds);

/// The shortest sufficient prefix of the candidates, up to a factor of two. Nothing if the question does not hold for
/// all of them. If near axioms come first, few remain, and no question is larger than necessary.
[[nodiscard]] std::optional<AxiomSet> find_sufficient_prefix(const AxiomSet& candidates, const Holds& holds);

}  // namespace geminga::explanation

#endif
