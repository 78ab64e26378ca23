// The properties of an ontology: hierarchy, chains, reflexivity and ranges, closed once before saturation.
#ifndef GEMINGA_REASONING_EL_INDEX_ROLES_HPP
#define GEMINGA_REASONING_EL_INDEX_ROLES_HPP

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ranges>
#include <span>
#include <utility>
#include <vector>

#include "base/rows.hpp"

namespace geminga::el {

/// The limit of pairs in the closures of the property hierarchy and of chains, each at most 24 octets. A chain of 1400
/// properties, each below the next, has so many.
inline constexpr std::size_t max_role_pairs = std::size_t{1} << 20;

/// A property, of objects or of data, as the rules see it. Dense.
enum class RoleId : std::uint32_t {};

/// Two links in a row imply a link of another role: first o second SubPropertyOf result.
struct Composition {
  RoleId second{};
  RoleId result{};
  friend auto operator<=>(const Composition&, const Composition&) = default;
};

/// The closed property box. It is filled, then closed, then only read.
class Roles {
 public:
  RoleId add();
  void add_sub_role(RoleId sub, RoleId super);
  /// Adds chain[0] o ... o chain[n - 1] SubPropertyOf super; requires n >= 2. Longer chains get roles of their own.
  void add_chain(std::span<const RoleId> chain, RoleId super);
  /// Computes the closure. False if it has more than `max_pairs` pairs; then nothing else may be called.
  [[nodiscard]] bool close(std::size_t max_pairs);
  /// Computes the part of the closure that supers(), is_sub_role() and chains() need.
  [[nodiscard]] bool close_hierarchy(std::size_t max_pairs);

  [[nodiscard]] std::size_t count() const { return count_; }
  /// Every super role, itself included, ascending. O(1).
  [[nodiscard]] std::span<const RoleId> supers(RoleId role) const { return supers_[static_cast<std::size_t>(role)]; }
  /// True if sub SubPropertyOf super. O(1) up to 4096 roles, O(log n) beyond.
  [[nodiscard]] bool is_sub_role(RoleId sub, RoleId super) const;
  /// The compositions of a link of `first` with a next link, ascending by second. Sub-roles of both are included.
  [[nodiscard]] std::span<const Composition> compositions(RoleId first) const {
    return compositions_[static_cast<std::size_t>(first)];
  }
  /// The roles of a link of `first` followed by one of `second`.
  [[nodiscard]] auto composed(RoleId first, RoleId second) const {
    const std::span<const Composition> all = compositions(first);
    // Few chains have the same two roles: they are walked one by one.
    const auto begin = std::ranges::lower_bound(all, second, {}, &Composition::second);
    return std::ranges::subrange(begin, all.end()) |
           std::views::take_while([second](const Composition& rule) { return rule.second == second; }) |
           std::views::transform(&Composition::result);
  }
  /// True if the role may be the second of a composition.
  [[nodiscard]] bool is_second(RoleId role) const { return is_second_[static_cast<std::size_t>(role)]; }
  /// True if a link of `result` that is composed of these two need not be the first of another composition: its first
  /// part gives the same conclusions with the compositions of its second part.
  [[nodiscard]] bool is_last(RoleId first, RoleId second, RoleId result) const {
    return composes_itself_[static_cast<std::size_t>(result)] && is_sub_role(first, result) &&
           is_sub_role(second, result);
  }
  [[nodiscard]] bool has_compositions() const { return compositions_.item_count() != 0; }
  /// The binary chains as they were added, for the check of OWL 2 EL's restriction on ranges: (first, second, result).
  struct Chain {
    RoleId first{};
    RoleId second{};
    RoleId result{};
  };
  [[nodiscard]] std::span<const Chain> chains() const { return chains_; }
  /// The inclusions as they were added: sub, super.
  [[nodiscard]] std::span<const std::pair<std::uint32_t, RoleId>> told_supers() const { return told_supers_; }

 private:
  [[nodiscard]] bool close_chains(std::size_t max_pairs);

  std::size_t count_ = 0;
  std::vector<std::pair<std::uint32_t, RoleId>> told_supers_;
  std::vector<Chain> chains_;
  base::Rows<RoleId> supers_;
  base::Rows<RoleId> subs_;
  std::vector<std::uint64_t> matrix_;  ///< row-wise bits of is_sub_role, where there are few roles
  base::Rows<Composition> compositions_;
  std::vector<bool> is_second_;
  std::vector<bool> composes_itself_;  ///< R o S < T says R o T < T for each S and T, and R o R < R
};

}  // namespace geminga::el

#endif
