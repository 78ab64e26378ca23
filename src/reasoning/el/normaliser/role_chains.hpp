// Chains of properties, and their mirror images by inverses. Legend as in expressions.hpp.
#ifndef GEMINGA_REASONING_EL_NORMALISER_ROLE_CHAINS_HPP
#define GEMINGA_REASONING_EL_NORMALISER_ROLE_CHAINS_HPP

#include <span>
#include <vector>

#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::el {

/// Adds the chains of properties to the index, and the chains that follow of inverses.
class RoleChains {
 public:
  explicit RoleChains(IndexBuilder& index) : index_(index) {}

  /// Adds R1 o ... o Rn < R.
  void add(std::span<const RoleId> word, RoleId super);
  /// The added chains. Each has its own number in place of its axiom's.
  [[nodiscard]] std::span<const owl::RoleChain> all() const { return chains_; }

  /// Adds the inclusions and chains that follow from the chains and these inverses. False if one chain has too many
  /// mirror images, which are then left out. To be called once, after the last chain.
  [[nodiscard]] bool mirror(std::span<const InverseInclusion> inverses);

 private:
  IndexBuilder& index_;
  std::vector<owl::RoleChain> chains_;
};

}  // namespace geminga::el

#endif
