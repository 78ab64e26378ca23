// The mirror image of a chain has the inverses of its roles in reverse order. Legend as in expressions.hpp.
#include "reasoning/el/normaliser/role_chains.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <utility>

#include "reasoning/el/index/implied_roles.hpp"
#include "reasoning/el/normaliser/property_roles.hpp"

namespace geminga::el {
namespace {

constexpr std::size_t max_mirror_images = 16;  // of one chain

/// Removes the roles that are below another one, and of equal roles all but the first.
void keep_greatest(std::vector<RoleId>& roles, const Roles& closed) {
  const std::vector<RoleId> all = roles;
  std::erase_if(roles, [&](RoleId one) {
    return std::ranges::any_of(all, [&](RoleId other) {
      return other != one && closed.is_sub_role(one, other) && (!closed.is_sub_role(other, one) || other < one);
    });
  });
}

/// The mirror images of the word of a chain. Ends as soon as there are too many.
std::vector<std::vector<RoleId>> mirror_images(const owl::RoleChain& chain,
                                               std::span<const std::vector<RoleId>> inverses_below) {
  std::vector<std::vector<RoleId>> words = {{}};
  for (std::size_t letter = chain.word.size(); letter-- > 0 && words.size() <= max_mirror_images;) {
    std::vector<std::vector<RoleId>> longer;
    for (const std::vector<RoleId>& word : words) {
      for (const RoleId below : inverses_below[static_cast<std::size_t>(chain.word[letter].property)]) {
        longer.push_back(word);
        longer.back().push_back(below);
      }
    }
    words = std::move(longer);
  }
  return words;
}

}  // namespace

void RoleChains::add(std::span<const RoleId> word, RoleId super) {
  index_.roles().add_chain(word, super);
  owl::RoleChain chain{{}, role_of(super), static_cast<std::uint32_t>(chains_.size())};
  for (const RoleId role : word) chain.word.push_back(role_of(role));
  chains_.push_back(std::move(chain));
}

//  R <* S through two inverses  is  R < S
//  R1 o ... o Rn < R, R(x,y) says S(y,x), Ti(x,y) says Ri(y,x)  is  Tn o ... o T1 < S
bool RoleChains::mirror(std::span<const InverseInclusion> inverses) {
  if (inverses.empty()) return true;
  Roles closed = index_.roles();
  if (!closed.close_hierarchy(max_role_pairs)) return true;  // the index will not close either, and that is reported
  const auto implied = find_implied_roles(closed, inverses);
  std::vector<std::vector<RoleId>> inverses_below(closed.count());  // T by R: T(x,y) says R(y,x)
  for (std::uint32_t role = 0; role < closed.count(); ++role) {
    for (const ImpliedRole& other : implied[role]) {
      if (other.is_backward) {
        inverses_below[static_cast<std::size_t>(other.role)].push_back(RoleId{role});
      } else {
        index_.roles().add_sub_role(RoleId{role}, other.role);
      }
    }
  }
  // The greatest roles are enough: a role below one of them has it as a super role.
  for (std::vector<RoleId>& below : inverses_below) keep_greatest(below, closed);
  std::set<std::pair<std::vector<owl::Role>, owl::Role>> known;
  for (const owl::RoleChain& chain : chains_) known.emplace(chain.word, chain.super);
  bool has_all = true;
  const std::size_t told = chains_.size();
  for (std::size_t at = 0; at < told; ++at) {
    const owl::RoleChain chain = chains_[at];
    const std::vector<std::vector<RoleId>> words = mirror_images(chain, inverses_below);
    if (words.size() > max_mirror_images) {
      has_all = false;
      continue;
    }
    for (const ImpliedRole& super : implied[static_cast<std::size_t>(chain.super.property)]) {
      if (!super.is_backward) continue;
      for (const std::vector<RoleId>& word : words) {
        std::vector<owl::Role> roles;
        for (const RoleId role : word) roles.push_back(role_of(role));
        if (known.emplace(std::move(roles), role_of(super.role)).second) add(word, super.role);
      }
    }
  }
  return has_all;
}

}  // namespace geminga::el
