// Classes of one ontology by number.
#ifndef GEMINGA_REASONING_TAXONOMY_CLASS_NUMBER_HPP
#define GEMINGA_REASONING_TAXONOMY_CLASS_NUMBER_HPP

#include <cstdint>

namespace geminga::taxonomy {

/// The dense number of a named class in one ontology, [0, class_count). It means nothing in another ontology.
enum class ClassNumber : std::uint32_t {};

}  // namespace geminga::taxonomy

#endif
