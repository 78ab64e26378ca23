// What inverses say of properties alone, told of the properties themselves. Legend as in indexed_ontology.hpp.
#include <algorithm>
#include <set>

#include "reasoning/el/inverse_roles.hpp"
#include "reasoning/el/rule_normaliser.hpp"

namespace geminga::el {
namespace {

constexpr std::size_t max_mirror_images = 16;  // of one chain

}  // namespace

//  R <* S through two inverses  is  R < S
//  R1 o ... o Rn < R, R(x,y) says S(y,x), Ti(x,y) says Ri(y,x)  is  Tn o ... o T1 < S
void RuleNormaliser::mirror_roles() {
  if (open_.inverses.empty()) return;
  Roles closed = index_.roles();
  if (!closed.close_hierarchy(max_role_pairs)) return;  // the index will not close either, and that is reported
  const auto implied = find_implied_roles(closed, open_.inverses);
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
  // Of these the greatest are enough: what is below one has it as a super role.
  for (std::vector<RoleId>& below : inverses_below) {
    const std::vector<RoleId> all = below;
    std::erase_if(below, [&](RoleId one) {
      return std::ranges::any_of(all, [&](RoleId other) {
        return other != one && closed.is_sub_role(one, other) && (!closed.is_sub_role(other, one) || other < one);
      });
    });
  }
  std::set<std::pair<std::vector<owl::Role>, owl::Role>> known;
  for (const owl::RoleChain& chain : chains_) known.emplace(chain.word, chain.super);
  const std::size_t told = chains_.size();
  for (std::size_t at = 0; at < told; ++at) {
    const owl::RoleChain chain = chains_[at];
    std::vector<std::vector<RoleId>> words = {{}};
    for (std::size_t letter = chain.word.size(); letter-- > 0;) {
      std::vector<std::vector<RoleId>> longer;
      for (const std::vector<RoleId>& word : words) {
        for (const RoleId below : inverses_below[static_cast<std::size_t>(chain.word[letter].property)]) {
          longer.push_back(word);
          longer.back().push_back(below);
        }
      }
      words = std::move(longer);
      if (words.size() <= max_mirror_images) continue;
      open_.is_mirrored = false;
      words.clear();
    }
    for (const ImpliedRole& super : implied[static_cast<std::size_t>(chain.super.property)]) {
      if (!super.is_backward) continue;
      for (const std::vector<RoleId>& word : words) {
        std::vector<owl::Role> roles;
        for (const RoleId role : word) roles.push_back(role_of(role));
        if (known.emplace(std::move(roles), role_of(super.role)).second) add_chain(word, super.role);
      }
    }
  }
}

}  // namespace geminga::el
