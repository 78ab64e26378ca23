// The result of mapping a node to which several others may refer.
#ifndef GEMINGA_REASONING_SYNTAX_RDF_MAPPING_MAPPED_ONCE_HPP
#define GEMINGA_REASONING_SYNTAX_RDF_MAPPING_MAPPED_ONCE_HPP

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/assert.hpp"
#include "reasoning/syntax/rdf/mapping/triple_reader.hpp"

namespace geminga::rdf {

/// The few different texts that say why a node is not mapped, by number.
class Obstacles {
 public:
  [[nodiscard]] const char* text(std::uint32_t number) const { return texts_[number]; }
  std::uint32_t number_of(const char* text) {
    const auto known = std::ranges::find(texts_, text);
    const auto number = static_cast<std::uint32_t>(known - texts_.begin());
    if (known == texts_.end()) texts_.push_back(text);
    return number;
  }

 private:
  std::vector<const char*> texts_;  ///< literals of the program, compared by address
};

/// The result of mapping one node, kept, so that it is mapped once however often it is used. Four octets: there is one
/// for each of millions of nodes, and they are read in no order.
class MappedOnce {
 public:
  [[nodiscard]] bool was_tried() const { return state_ != untried; }
  [[nodiscard]] bool is_mapped() const { return state_ >= first_term; }
  /// The result, if there is one. `circular` is the obstacle where the node is being mapped: it contains itself.
  [[nodiscard]] std::optional<Mapped> known(const Obstacles& obstacles, const char* circular) const {
    if (state_ == untried) return std::nullopt;
    if (state_ == open) return std::unexpected(circular);
    if (!is_mapped()) return std::unexpected(obstacles.text(state_ - first_obstacle));
    return term();
  }
  /// Requires that it is mapped.
  [[nodiscard]] owl::TermId term() const { return owl::TermId{state_ - first_term}; }
  void begin() { state_ = open; }
  Mapped end(Mapped result, Obstacles& obstacles) {
    state_ = result ? first_term + static_cast<std::uint32_t>(*result)
                    : first_obstacle + obstacles.number_of(result.error());
    GEMINGA_ASSERT(is_mapped() == result.has_value());
    return result;
  }

 private:
  static constexpr std::uint32_t untried = 0;
  static constexpr std::uint32_t open = 1;
  static constexpr std::uint32_t first_obstacle = 2;
  static constexpr std::uint32_t first_term = 1024;

  std::uint32_t state_ = untried;  ///< one of the first two, or from the others on the number of an obstacle or term
};

}  // namespace geminga::rdf

#endif
