// The order of number restrictions: which of them imply others, and which exclude each other.
//
//   >= n R.A -> >= m S.B    where m <= n, R is below S and A below B
//   <= n S.B -> <= m R.A    where m >= n, R is below S and A below B
//   >= n R.A, <= m S.B -> false    where m < n, R is below S and A below B
//   >= n1 R1.A1, ..., >= nk Rk.Ak, <= m S.B -> false    where m < n1 + ... + nk, each Ri is below S and each Ai below
//   B,
//                                                       and no two of the Ai have an instance in common, or no two
//                                                       of the Ri a pair
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

/// Knows what single clauses say: R(x,y) -> S(x,y), A(x) -> B(x), A(x), B(x) -> false, and R(x,y), S(x,y) -> false.
/// Restrictions of other forms are compared with nothing.
class NumberOrder {
 public:
  /// An at-least, of values if `is_data`.
  struct AtLeastId {
    std::uint32_t index = 0;
    bool is_data = false;
  };

  NumberOrder() = default;
  /// The `inclusions` are clauses A(x) -> B(x) that follow from the set.
  NumberOrder(const clauses::ClauseSet& set, std::span<const clauses::Clause> inclusions,
              std::span<const Bound> bounds);

  /// The number of the families above that of the at-least. It is greater than that of each of these.
  [[nodiscard]] std::size_t specificity(AtLeastId at_least) const { return above_[of(at_least).family].size(); }
  [[nodiscard]] std::uint32_t count(AtLeastId at_least) const { return of(at_least).count; }
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
  /// Whether a bound above the at-least may be exceeded by several at-leasts together only.
  [[nodiscard]] bool may_be_added(AtLeastId at_least) const { return of(at_least).may_be_added; }
  /// Whether `holds` is true of such a bound.
  template <typename Holds>
  [[nodiscard]] bool any_adding(AtLeastId at_least, Holds&& holds) const {
    return any_bound(of(at_least), no_predicate,
                     [&](std::uint32_t bound) { return may_be_added(bound) && holds(bound); });
  }
  /// Whether `holds` is true of a bound that counts the neighbours of the at-least.
  template <typename Holds>
  [[nodiscard]] bool any_counting(AtLeastId at_least, Holds&& holds) const {
    return any_bound(of(at_least), no_predicate, holds);
  }
  [[nodiscard]] bool may_be_added(std::uint32_t bound) const { return bounds_[bound].may_be_added; }
  /// Whether the bound counts the neighbours of the at-least.
  [[nodiscard]] bool counts(std::uint32_t bound, AtLeastId at_least) const {
    return is_below(of(at_least), bounds_[bound]);
  }
  /// Whether no neighbour is one of both at-leasts, which may_be_added().
  [[nodiscard]] bool are_disjoint(AtLeastId one, AtLeastId other) const;
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
    bool may_be_added = false;
  };
  /// The concepts, or directions, that are known of a neighbour, and those that these exclude; ascending.
  struct Reach {
    std::vector<std::uint32_t> above;
    std::vector<std::uint32_t> excluded;
    [[nodiscard]] bool excludes(const Reach& other) const;
  };
  /// Of a family whose at-leasts may be added up: what is known of their neighbours.
  struct Neighbours {
    Reach in;     ///< concepts; nothing of values
    Reach along;  ///< directions
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
  void find_above(const clauses::ClauseSet& set, std::span<const clauses::Clause> inclusions);
  void find_comparable();
  void find_sums(const clauses::ClauseSet& set, std::span<const clauses::Clause> inclusions);

  std::uint32_t first_data_ = 0;
  std::vector<Restriction> at_leasts_;
  std::vector<Restriction> data_at_leasts_;
  std::vector<Restriction> bounds_;
  std::map<Family, std::uint32_t> index_;
  std::vector<std::vector<std::uint32_t>> above_;      ///< by family: those above it and itself, ascending
  std::vector<std::vector<std::uint32_t>> bounds_in_;  ///< by family: its bounds, ascending by number
  std::map<std::uint32_t, Neighbours> neighbours_;     ///< by family
};

}  // namespace geminga::hypertableau

#endif
