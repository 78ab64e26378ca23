// Sets of classes, each closed upwards and stored once: most individuals share their types with others.
#ifndef GEMINGA_REASONING_REALIZATION_TYPE_SETS_HPP
#define GEMINGA_REASONING_REALIZATION_TYPE_SETS_HPP

#include <cstdint>
#include <map>
#include <vector>

#include "reasoning/taxonomy/classification.hpp"

namespace geminga::realization {

using Classes = std::vector<taxonomy::ClassNumber>;

class TypeSets {
 public:
  explicit TypeSets(const taxonomy::Classification& classification) : classification_(classification) {}

  /// The number of the set of these classes and all classes above them, as representatives without owl:Thing's.
  std::uint32_t number_of(Classes classes);
  [[nodiscard]] const Classes& set(std::uint32_t number) const { return sets_[number]; }
  [[nodiscard]] std::vector<Classes> take() { return std::move(sets_); }

 private:
  [[nodiscard]] Classes closed(const Classes& classes) const;

  const taxonomy::Classification& classification_;
  std::map<Classes, std::uint32_t> numbers_;  ///< of sets that were asked for, and of closed sets
  std::vector<Classes> sets_;
};

}  // namespace geminga::realization

#endif
