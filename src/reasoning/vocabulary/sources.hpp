// The files that an ontology was read from, and what was left out of them.
#ifndef GEMINGA_REASONING_VOCABULARY_SOURCES_HPP
#define GEMINGA_REASONING_VOCABULARY_SOURCES_HPP

#include "reasoning/owl/left_out.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::vocabulary {

/// The results of Vocabulary::files() and Vocabulary::left_out(), for those who read them.
using owl::LeftOut;
using owl::LoadedFile;

}  // namespace geminga::vocabulary

#endif
