// Modules of ontologies written in tests, as the line numbers of their axioms.
#ifndef GEMINGA_TESTS_REASONING_MODULES_EXTRACTED_HPP
#define GEMINGA_TESTS_REASONING_MODULES_EXTRACTED_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "reasoning/owl/source.hpp"

namespace geminga::modules {

/// The lines of the axioms in the module for a signature of whole IRIs, ascending.
[[nodiscard]] std::vector<std::uint32_t> lines_of_module(const owl::Ontology& source,
                                                         const std::vector<std::string>& signature);

/// A copy of a source in which each axiom is on its own line, which is its number plus one.
[[nodiscard]] owl::Ontology numbered(const owl::Ontology& source);
/// The axioms on these lines, with a declaration of each class of the source.
[[nodiscard]] owl::Ontology only(const owl::Ontology& numbered, const std::vector<std::uint32_t>& lines);

}  // namespace geminga::modules

#endif
