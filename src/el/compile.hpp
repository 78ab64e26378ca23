// Writes the compiled form of a classified ontology (format: COMPILED.md), which el::Ontology reads.
#ifndef GEMINGA_EL_COMPILE_HPP
#define GEMINGA_EL_COMPILE_HPP

#include <cstddef>
#include <vector>

#include "el/classify.hpp"
#include "el/source.hpp"

namespace geminga::el {

/// The bytes of the compiled form. Equal for the same axioms, labels, prefixes and files, whatever their order. Empty
/// where they would be more than max_compiled_bytes; el::Ontology refuses that.
[[nodiscard]] std::vector<std::byte> compile(const OntologySource& source, const Classification& classification);

/// What compile() writes as the digest: equal for the same axioms and classes, whatever their order, files or syntax.
[[nodiscard]] std::uint64_t digest(const OntologySource& source);

}  // namespace geminga::el

#endif
