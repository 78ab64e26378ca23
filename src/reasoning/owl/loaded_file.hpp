// A file that an ontology was read from.
#ifndef GEMINGA_REASONING_OWL_LOADED_FILE_HPP
#define GEMINGA_REASONING_OWL_LOADED_FILE_HPP

#include <string>

#include "reasoning/owl/fingerprint.hpp"

namespace geminga::owl {

/// One file that was loaded.
struct LoadedFile {
  std::string path;
  std::string ontology_iri;  ///< empty: the file names none
  Fingerprint content{};     ///< of what was read; not known where the reader did not say
};

}  // namespace geminga::owl

#endif
