// Axioms that were left out of an ontology, and their places.
#ifndef GEMINGA_REASONING_OWL_LEFT_OUT_HPP
#define GEMINGA_REASONING_OWL_LEFT_OUT_HPP

#include <cstdint>
#include <string>

namespace geminga::owl {

/// Axioms of one kind that the reasoner did not use, e.g. {"owl:inverseOf", 12, "soma.owl:17"}.
struct LeftOut {
  std::string construct;
  std::uint32_t count = 0;
  std::string first;  ///< file:line of the first
  /// The place as a number of files(). Past the end if it is not known.
  std::uint32_t file = 0xffffffff;
  std::uint32_t line = 0;
};

}  // namespace geminga::owl

#endif
