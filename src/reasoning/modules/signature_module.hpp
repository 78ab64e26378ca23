// The module of a source for a signature: the axioms that can matter for what it says about these names.
#ifndef GEMINGA_REASONING_MODULES_SIGNATURE_MODULE_HPP
#define GEMINGA_REASONING_MODULES_SIGNATURE_MODULE_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::modules {

enum class ModuleKind : std::uint8_t {
  bottom,  ///< and everything above the names: their superclasses and superproperties
  top,     ///< and everything below them
  star,    ///< neither: the smallest of the three, by top and bottom in turn until nothing more goes
};

/// The numbers of the module's axioms, ascending. They entail each axiom over the signature that the source entails
/// (Sattler, Schneider, Zakharyaschev: Which Kind of Module Should I Extract?, 2009). Declarations are not among them,
/// and what the reader left out is unknown. `signature` are entities of the source. Costs a test for each axiom, and
/// one more for each name of it that enters the signature.
[[nodiscard]] std::vector<std::uint32_t> extract_module(const owl::Ontology& source,
                                                        std::span<const owl::TermId> signature, ModuleKind kind);

}  // namespace geminga::modules

#endif
