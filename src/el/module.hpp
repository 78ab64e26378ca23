// The axioms that can matter for a question: a module by bottom locality (Cuenca Grau, Horrocks, Kazakov, Sattler
// 2008).
#ifndef GEMINGA_EL_MODULE_HPP
#define GEMINGA_EL_MODULE_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "el/compiled_view.hpp"

namespace geminga::el {

/// Ascending numbers of axioms that hold every minimal set that entails anything about the given terms (entities).
/// Declarations are never among them. Cost: some passes over the axioms.
[[nodiscard]] std::vector<std::uint32_t> extract_module(const CompiledView& view, std::span<const std::uint32_t> terms);

}  // namespace geminga::el

#endif
