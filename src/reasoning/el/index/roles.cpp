// The closure of the property box.
#include "reasoning/el/index/roles.hpp"

#include <algorithm>
#include <tuple>

#include "base/sorted.hpp"

namespace geminga::el {
namespace {

constexpr std::size_t max_matrix_roles = 4096;  // 2 MiB of bits

std::uint32_t number(RoleId role) { return static_cast<std::uint32_t>(role); }

}  // namespace

RoleId Roles::add() { return RoleId{static_cast<std::uint32_t>(count_++)}; }

void Roles::add_sub_role(RoleId sub, RoleId super) {
  if (sub != super) told_supers_.emplace_back(number(sub), super);
}

void Roles::add_chain(std::span<const RoleId> chain, RoleId super) {
  RoleId first = chain[0];
  for (std::size_t at = 1; at < chain.size(); ++at) {
    const RoleId result = at + 1 == chain.size() ? super : add();
    chains_.push_back({first, chain[at], result});
    first = result;
  }
}

bool Roles::close(std::size_t max_pairs) { return close_hierarchy(max_pairs) && close_chains(max_pairs); }

bool Roles::close_hierarchy(std::size_t max_pairs) {
  base::Rows<RoleId> told(count_, told_supers_);
  told.sort_unique();
  std::vector<std::pair<std::uint32_t, RoleId>> up;
  std::vector<std::pair<std::uint32_t, RoleId>> down;
  std::vector<std::uint32_t> seen_from(count_, static_cast<std::uint32_t>(-1));
  std::vector<RoleId> stack;
  for (std::uint32_t role = 0; role < count_; ++role) {
    stack.assign(1, RoleId{role});
    seen_from[role] = role;
    while (!stack.empty()) {
      const RoleId super = stack.back();
      stack.pop_back();
      if (up.size() >= max_pairs) return false;
      up.emplace_back(role, super);
      down.emplace_back(number(super), RoleId{role});
      for (const RoleId next : told[number(super)]) {
        if (seen_from[number(next)] == role) continue;
        seen_from[number(next)] = role;
        stack.push_back(next);
      }
    }
  }
  supers_ = base::Rows<RoleId>(count_, up);
  supers_.sort_unique();
  subs_ = base::Rows<RoleId>(count_, down);
  if (count_ <= max_matrix_roles) {
    const std::size_t words = (count_ + 63) / 64;
    matrix_.assign(count_ * words, 0);
    for (const auto& [sub, super] : up) matrix_[sub * words + number(super) / 64] |= 1ULL << (number(super) % 64);
  }
  return true;
}

bool Roles::is_sub_role(RoleId sub, RoleId super) const {
  if (!matrix_.empty()) {
    const std::size_t words = (count_ + 63) / 64;
    return (matrix_[number(sub) * words + number(super) / 64] >> (number(super) % 64) & 1) != 0;
  }
  return std::ranges::binary_search(supers(sub), super);
}

bool Roles::close_chains(std::size_t max_pairs) {
  is_second_.assign(count_, false);
  std::ranges::sort(chains_, {},
                    [](const Chain& chain) { return std::tuple(chain.first, chain.second, chain.result); });
  const auto repeated = std::ranges::unique(chains_, [](const Chain& a, const Chain& b) {
    return std::tie(a.first, a.second, a.result) == std::tie(b.first, b.second, b.result);
  });
  chains_.erase(repeated.begin(), repeated.end());
  std::vector<std::pair<std::uint32_t, std::uint32_t>> beginnings;  // of chains, by role
  for (std::uint32_t chain = 0; chain < chains_.size(); ++chain) {
    for (const RoleId first : subs_[number(chains_[chain].first)]) {
      if (beginnings.size() >= max_pairs) return false;
      beginnings.emplace_back(number(first), chain);
    }
  }
  const base::Rows<std::uint32_t> chains_of(count_, beginnings);
  std::vector<std::pair<std::uint32_t, Composition>> pairs;
  std::size_t pair_count = 0;
  std::vector<std::uint64_t> row;  // (second, result) as one word: most of the time goes into sorting these
  for (std::uint32_t first = 0; first < count_; ++first) {
    row.clear();
    for (const std::uint32_t chain : chains_of[first]) {
      for (const RoleId second : subs_[number(chains_[chain].second)]) {
        if (pair_count++ >= max_pairs) return false;
        row.push_back((std::uint64_t{number(second)} << 32) | number(chains_[chain].result));
        is_second_[number(second)] = true;
      }
    }
    base::sort_unique(row);
    for (const std::uint64_t entry : row) {
      pairs.push_back(
          {first, {RoleId{static_cast<std::uint32_t>(entry >> 32)}, RoleId{static_cast<std::uint32_t>(entry)}}});
    }
  }
  compositions_ = base::Rows<Composition>(count_, pairs);
  composes_itself_.resize(count_);
  for (std::uint32_t role = 0; role < count_; ++role) {
    const auto has = [&](RoleId second, RoleId result) {
      return std::ranges::binary_search(compositions_[role], Composition{second, result});
    };
    const auto takes_result = [&](const Composition& rule) { return has(rule.result, rule.result); };
    composes_itself_[role] = has(RoleId{role}, RoleId{role}) && std::ranges::all_of(compositions_[role], takes_result);
  }
  return true;
}

}  // namespace geminga::el
