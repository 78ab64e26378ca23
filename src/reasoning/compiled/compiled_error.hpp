// Why a compiled ontology was refused.
#ifndef GEMINGA_REASONING_COMPILED_COMPILED_ERROR_HPP
#define GEMINGA_REASONING_COMPILED_COMPILED_ERROR_HPP

#include <string>

namespace geminga::compiled {

/// A compiled ontology that was refused. `text` says what is wrong and at which offset where there is one.
struct CompiledError {
  std::string text;
};

}  // namespace geminga::compiled

#endif
