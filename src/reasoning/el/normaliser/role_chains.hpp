// Chains of properties, and what inverses say of them. Legend as in indexed_ontology.hpp.
#ifndef GEMINGA_REASONING_EL_NORMALISER_ROLE_CHAINS_HPP
#define GEMINGA_REASONING_EL_NORMALISER_ROLE_CHAINS_HPP

#include <span>
#include <vector>

#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::el {

/// Tells the index the chains of properties, and tells the properties themselves what inverses say of them.
class RoleChains {
 public:
  explicit RoleChains(IndexedOntology& index) : index_(index) {}

  /// R1 o ... o Rn < R
  void add(std::span<const RoleId> word, RoleId super);
  /// The chains that were added; each has its number instead of its axiom's.
  [[nodiscard]] std::span<const owl::RoleChain> all() const { return chains_; }

  /// To be called once, after the last chain. Adds the inclusions and chains that follow from the chains and from these
  /// inverses. False where there are too many mirror images of one chain, which are then left out.
  [[nodiscard]] bool mirror(std::span<const InverseInclusion> inverses);

 private:
  IndexedOntology& index_;
  std::vector<owl::RoleChain> chains_;
};

}  // namespace geminga::el

#endif
