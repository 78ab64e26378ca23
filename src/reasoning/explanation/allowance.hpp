// A part of a budget, for work that is worth no more.
#ifndef GEMINGA_REASONING_EXPLANATION_ALLOWANCE_HPP
#define GEMINGA_REASONING_EXPLANATION_ALLOWANCE_HPP

#include <cstddef>
#include <cstdint>

#include "base/budget.hpp"

namespace geminga::explanation {

/// The steps for the reasons of one problem of an ontology with so many axioms, unless somebody asks for more.
/// Questions are about subsets, so that the steps grow with the ontology. How long they take: BENCHMARKS.md, "Reasons
/// of check".
[[nodiscard]] constexpr std::uint64_t steps_of_reasons(std::size_t axioms) {
  return 200'000'000 + 500 * static_cast<std::uint64_t>(axioms);
}

/// Steps of its own, for which a whole budget pays, too. Not thread-safe.
class Allowance {
 public:
  /// The whole budget is borrowed; null: there is none.
  Allowance(base::Budget* whole, std::uint64_t steps) : whole_(whole), budget_(steps, [this] { return !tell(); }) {}
  Allowance(const Allowance&) = delete;
  Allowance& operator=(const Allowance&) = delete;
  ~Allowance() { tell(); }

  /// It is spent when its steps are, or soon after the whole budget is.
  [[nodiscard]] base::Budget& budget() { return budget_; }

 private:
  /// Takes the steps since the last call from the whole budget. False if that is spent.
  bool tell() {
    if (whole_ == nullptr) return true;
    const std::uint64_t spent = budget_.spent();
    const std::uint64_t more = spent - told_;
    told_ = spent;
    return whole_->spend(more);
  }

  base::Budget* whole_;
  std::uint64_t told_ = 0;
  base::Budget budget_;
};

}  // namespace geminga::explanation

#endif
