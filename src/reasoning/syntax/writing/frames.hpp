// Manchester syntax: axioms gathered in the frames of their subjects.
#ifndef GEMINGA_REASONING_SYNTAX_WRITING_FRAMES_HPP
#define GEMINGA_REASONING_SYNTAX_WRITING_FRAMES_HPP

#include <cstddef>
#include <string>
#include <vector>

#include "reasoning/syntax/writing/document.hpp"
#include "reasoning/syntax/writing/names.hpp"
#include "reasoning/syntax/writing/output.hpp"

namespace geminga::writing {

/// The parts of a document that Manchester syntax cannot say.
struct Unsaid {
  std::size_t annotations = 0;                    ///< of declarations
  std::vector<std::string> declared_subjects;     ///< of annotations, that only this syntax makes individuals
  std::vector<std::string> ambiguous_properties;  ///< of objects and of data at once
};

/// Writes a document. A frame stands where its subject first occurs. Every property and datatype has one, because the
/// syntax tells those of data from those of objects by their frames alone.
[[nodiscard]] Unsaid write_frames(const Document& document, const Names& names, Output& output);

}  // namespace geminga::writing

#endif
