// The order of number restrictions: which of them imply others, and which exclude each other.
//
//   >= n R.A -> >= m S.B    where m <= n, R is below S and A below B
//   <= n S.B -> <= m R.A    where m >= n, R is below S and A below B
//   >= n R.A, <= m S.B -> false    where m < n, R is below S and A below B
//
// A definition by a number (an atom of aluminium has exactly 13 protons) makes a choice "aluminium, at least 14 or at
// most 12" for each atom. Of a hundred such definitions the number of one decides all others.
#ifndef GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_NUMBER_ORDER_HPP
#define GEMINGA_REASONING_DL_HYPERTABLEAU_PROGRAM_NUMBER_ORDER_HPP

#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "reasoning/dl/clauses/clause.hpp"
#include "reasoning/dl/hypertableau/program/bound.hpp"

namespace geminga::hypertableau {

/// Knows the inclusions that single clauses say: R(x,y) -> S(x,y) and A(x) -> B(x). Restrictions of other forms are
/// compared with nothing.
class NumberOrder {
 public:
  /// An at-least, of values if `is_data`.
  struct AtLeastId {
    std::uint32_t index = 0;
    bool is_data = false;
  };

  NumberOrder() = default;
  NumberOrder(const clauses::ClauseSet& set, std::span<const Bound> bounds);

  [[nodiscard]] bool implies(AtLeastId known, AtLeastId asked) const {
    return of(known).count >= of(asked).count && is_below(of(known), of(asked));
  }
  /// Whether `holds` is true of a bound that implies the bound.
  template <typename Holds>
  [[nodiscard]] bool any_implying(std::uint32_t bound, Holds&& holds) const {
    return any_bound(bounds_[bound], bounds_[bound].count, holds);
  }
  /// Whether `holds` is true of a bound that excludes the at-least.
  template <typename Holds>
  [[nodiscard]] bool any_excluding(AtLeastId at_least, Holds&& holds) const {
    return of(at_least).count > 0 && any_bound(of(at_least), of(at_least).count - 1, holds);
  }
  [[nodiscard]] bool excludes(AtLeastId at_least, std::uint32_t bound) const {
    return bounds_[bound].count < of(at_least).count && is_below(of(at_least), bounds_[bound]);
  }
  /// Whether any at-least implies the at-least, or any bound excludes it. Most are compared with nothing.
  [[nodiscard]] bool may_be_implied(AtLeastId at_least) const { return of(at_least).may_be_implied; }
  [[nodiscard]] bool may_be_excluded(AtLeastId at_least) const { return of(at_least).may_be_excluded; }
  /// The same of a bound, which bounds imply and at-leasts exclude.
  [[nodiscard]] bool may_be_implied(std::uint32_t bound) const { return bounds_[bound].may_be_implied; }
  [[nodiscard]] bool may_be_excluded(std::uint32_t bound) const { return bounds_[bound].may_be_excluded; }

 private:
  using Direction = std::uint32_t;
  struct Family {
    Direction direction = 0;
    std::uint32_t filler = 0;
    friend auto operator<=>(const Family&, const Family&) = default;
  };
  /// `family` is an index, or no_predicate.
  struct Restriction {
    std::uint32_t count = 0;
    std::uint32_t family = no_predicate;
    bool may_be_implied = false;
    bool may_be_excluded = false;
  };

  [[nodiscard]] const Restriction& of(AtLeastId at_least) const {
    return at_least.is_data ? data_at_leasts_[at_least.index] : at_leasts_[at_least.index];
  }
  [[nodiscard]] bool is_below(const Restriction& low, const Restriction& high) const;
  /// Whether `holds` is true of a bound of a family above that of `low`, with a number up to `most`.
  template <typename Holds>
  [[nodiscard]] bool any_bound(const Restriction& low, std::uint32_t most, Holds&& holds) const {
    if (low.family == no_predicate) return false;
    for (const std::uint32_t family : above_[low.family]) {
      for (const std::uint32_t bound : bounds_in_[family]) {
        if (bounds_[bound].count > most) break;
        if (holds(bound)) return true;
      }
    }
    return false;
  }
  std::uint32_t family_of(const Family& family);
  void find_above(const clauses::ClauseSet& set);
  void find_comparable();

  std::uint32_t first_data_ = 0;
  std::vector<Restriction> at_leasts_;
  std::vector<Restriction> data_at_leasts_;
  std::vector<Restriction> bounds_;
  std::map<Family, std::uint32_t> index_;
  std::vector<std::vector<std::uint32_t>> above_;      ///< by family: those above it and itself, ascending
  std::vector<std::vector<std::uint32_t>> bounds_in_;  ///< by family: its bounds, ascending by number
};

}  // namespace geminga::hypertableau

#endif
