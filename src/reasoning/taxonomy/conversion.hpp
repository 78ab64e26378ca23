// One declared step from a representation to another, as classes by number.
#ifndef GEMINGA_REASONING_TAXONOMY_CONVERSION_HPP
#define GEMINGA_REASONING_TAXONOMY_CONVERSION_HPP

#include <cstdint>

namespace geminga::taxonomy {

/// A conversion turns an instance of `from` into an instance of `to`.
struct Conversion {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::uint32_t cost = 1;  ///< 1 to owl::max_conversion_cost
};

}  // namespace geminga::taxonomy

#endif
