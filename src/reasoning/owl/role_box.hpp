// The property axioms as a whole: which roles are equivalent, which are simple, and the automaton of each role that is
// not.
//
// A role is simple if no chain and no transitivity implies it. A role R that is not has a regular language of words
// S1 ... Sn with S1 o ... o Sn SubPropertyOf R, if the chains are regular (Horrocks, Kutz, Sattler: The Even More
// Irresistible SROIQ, 2006, section 3). Its automaton lets concepts travel along such paths, so that clauses need no
// chain (the same, section 4; OWL 2 structural specification, section 11 for what is regular).
#ifndef GEMINGA_REASONING_OWL_ROLE_BOX_HPP
#define GEMINGA_REASONING_OWL_ROLE_BOX_HPP

#include <algorithm>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "base/components.hpp"
#include "reasoning/owl/automaton.hpp"
#include "reasoning/owl/role.hpp"

namespace geminga::owl {

/// sub SubPropertyOf super
struct RoleInclusion {
  Role sub;
  Role super;
};
/// word[0] o ... o word[n] SubPropertyOf super
struct RoleChain {
  std::vector<Role> word;
  Role super;
  std::uint32_t axiom = 0;
};

class RoleBox {
 public:
  /// The result depends on the sets of inclusions and chains only.
  RoleBox(std::size_t property_count, std::span<const RoleInclusion> inclusions, std::span<const RoleChain> chains,
          std::size_t max_states);

  /// The representative of a set of equivalent roles. Clauses hold only representatives.
  [[nodiscard]] Role canonical(Role role) const { return canonical_[index(role)]; }
  [[nodiscard]] bool is_symmetric(Role role) const { return canonical(role) == canonical(inverse(role)); }
  [[nodiscard]] bool is_simple(Role role) const { return !is_composite_[index(canonical(role))]; }
  /// Of a canonical role that is not simple.
  [[nodiscard]] const Automaton& automaton(Role role) const { return automata_.at(role); }
  /// Chains that are left out, ascending: irregular, or their automaton is too large.
  [[nodiscard]] std::span<const std::uint32_t> left_out() const { return left_out_; }

 private:
  [[nodiscard]] static std::size_t index(Role role) {
    return (static_cast<std::size_t>(role.property) << 1) | std::size_t{role.is_inverse};
  }
  [[nodiscard]] static Role role_at(std::size_t index) {
    return {PropertyId{static_cast<std::uint32_t>(index >> 1)}, (index & 1) != 0};
  }
  /// The smaller number of a canonical role and its inverse. The automata of the two mirror each other.
  [[nodiscard]] std::size_t family(Role role) const {
    return std::min(index(canonical(role)), index(canonical(inverse(role))));
  }
  void find_equivalents(std::span<const RoleInclusion> inclusions);
  [[nodiscard]] base::Components components_of_families(std::span<const RoleChain> chains) const;
  void keep_regular_chains(std::span<const RoleChain> chains);
  void find_composites();
  void build_automata(std::size_t max_states);
  [[nodiscard]] Automaton build(Role role, std::size_t max_states) const;
  void add_chain(Automaton& automaton, Role role, std::span<const Role> word, std::size_t max_states) const;
  [[nodiscard]] std::vector<bool> supers_of(Role role) const;

  std::vector<Role> canonical_;
  std::vector<bool> is_composite_;
  std::vector<std::vector<std::uint32_t>> supers_;  ///< between canonical roles, by index
  std::vector<std::vector<std::uint32_t>> subs_;
  std::vector<RoleChain> chains_;          ///< kept ones, in canonical roles, with their mirror images
  std::vector<std::size_t> family_order_;  ///< lower ones first
  std::map<Role, Automaton> automata_;
  std::vector<std::uint32_t> left_out_;
};

}  // namespace geminga::owl

#endif
