// The agenda of a simulated world: what is to happen, and when.
#ifndef GEMINGA_TESTS_SIM_AGENDA_HPP
#define GEMINGA_TESTS_SIM_AGENDA_HPP

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "base/time.hpp"

namespace geminga::sim {

/// Ordered by instant, and at one instant in the order in which it was entered. What happens is a small value that says
/// where the rest stands, since a thousand participants move their timers with every datagram.
template <typename What>
class Agenda {
 public:
  [[nodiscard]] bool is_empty() const { return heap_.empty(); }
  /// Of the first; base::never where there is none.
  [[nodiscard]] base::Instant next() const { return heap_.empty() ? base::never : heap_.front().instant; }

  void add(base::Instant instant, What what) {
    heap_.push_back({.instant = instant, .order = order_++, .what = what});
    std::ranges::push_heap(heap_, std::greater<>());
  }
  /// Requires that it is not empty.
  What take() {
    std::ranges::pop_heap(heap_, std::greater<>());
    const What what = heap_.back().what;
    heap_.pop_back();
    return what;
  }

 private:
  struct Entry {
    base::Instant instant;
    std::uint64_t order;
    What what;
    auto operator<=>(const Entry& other) const {
      return instant != other.instant ? instant <=> other.instant : order <=> other.order;
    }
    bool operator==(const Entry& other) const { return order == other.order; }
  };

  std::vector<Entry> heap_;
  std::uint64_t order_ = 0;
};

}  // namespace geminga::sim

#endif
