// Describes axioms that could not be used.
#ifndef GEMINGA_REASONING_REASONER_UNUSED_HPP
#define GEMINGA_REASONING_REASONER_UNUSED_HPP

#include <cstdint>
#include <string>
#include <string_view>

#include "reasoning/owl/source.hpp"

namespace geminga::reasoner {

/// "an axiom cannot be used because of owl:hasKey: soma.owl:17"
[[nodiscard]] std::string describe_unused(const owl::Ontology& source, std::uint32_t axiom, std::string_view construct);

}  // namespace geminga::reasoner

#endif
