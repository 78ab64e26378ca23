// Why one class is below another: a minimal set of axioms, found among those of a compiled ontology.
#ifndef GEMINGA_EL_EXPLAIN_HPP
#define GEMINGA_EL_EXPLAIN_HPP

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "el/module.hpp"
#include "el/source.hpp"

namespace geminga::el {

/// A minimal subset of `candidates` for which `holds` is true, ascending; `holds` must be monotone and hold for all of
/// them. It is asked O(k log(n / k)) times for a subset of k among n (QuickXplain, Junker 2004).
[[nodiscard]] std::vector<std::uint32_t> find_minimal(std::vector<std::uint32_t> candidates,
                                                      const std::function<bool(std::span<const std::uint32_t>)>& holds);

/// Axioms of a compiled ontology as a source of their own.
struct Excerpt {
  OntologySource source;
  TermId sub{};
  TermId super{};
  std::vector<std::uint32_t> axioms;  ///< the minimal set, in the order of the argument
};

/// Nothing where the axioms do not entail that class `sub` is below class `super`.
[[nodiscard]] std::optional<Excerpt> explain(const ModuleIndex& index, std::uint32_t sub, std::uint32_t super);

}  // namespace geminga::el

#endif
