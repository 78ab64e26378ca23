// Writes a source as a document in Manchester syntax, as OWL tools do, so that a test can read it again.
#ifndef GEMINGA_TESTS_REASONING_SYNTAX_FRAMES_WRITER_HPP
#define GEMINGA_TESTS_REASONING_SYNTAX_FRAMES_WRITER_HPP

#include <string>

#include "reasoning/owl/source.hpp"

namespace geminga::frames {

/// Each axiom is a frame of its own, in the order of the source; declarations stand behind all others, so that every
/// name is used before it is declared.
[[nodiscard]] std::string manchester(const owl::Ontology& source);

}  // namespace geminga::frames

#endif
