// Manchester syntax: axioms gathered in the frames of their subjects.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_FRAMES_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_FRAMES_HPP

#include "reasoning/syntax/writing/document.hpp"
#include "reasoning/syntax/writing/names.hpp"
#include "reasoning/syntax/writing/output.hpp"

namespace geminga::writing {

/// Writes a document. A frame stands where its subject first occurs. Every property and datatype has one, because the
/// syntax tells those of data from those of objects by their frames alone. Returns the
/// number of annotations of declarations, for which the syntax has no place.
[[nodiscard]] std::size_t write_frames(const Document& document, const Names& names, Output& output);

}  // namespace geminga::writing

#endif
