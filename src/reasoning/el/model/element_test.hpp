// Tests of one element of the model, and of one link between two, against the axioms that the rules do not use.
#ifndef GEMINGA_REASONING_EL_MODEL_ELEMENT_TEST_HPP
#define GEMINGA_REASONING_EL_MODEL_ELEMENT_TEST_HPP

#include <cstdint>

#include "reasoning/el/closure/atoms_above.hpp"
#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/model/heard_roles.hpp"
#include "reasoning/el/model/inverse_roles.hpp"

namespace geminga::el {

/// Each context stands for elements of the model (README.md, "The model"). Every test is on the safe side: true means
/// that the model satisfies what is asked, false that it may not. Source and target of a link are contexts.
class ElementTest {
 public:
  ElementTest(const IndexedOntology& index, const Saturation& saturation, const OpenParts& open,
              const InverseRoles& inverses, const HeardRoles& heard)
      : index_(index),
        saturation_(saturation),
        open_(open),
        inverses_(inverses),
        heard_(heard),
        above_(index, saturation) {}

  /// Requires an atom that has rules or is watched.
  [[nodiscard]] bool is_in(std::uint32_t context, ExprId atom) const;
  /// Lemma 5: a further link between the two adds nothing. Source and target may change places (`is_backward`): then
  /// the source is a successor of the target.
  [[nodiscard]] bool is_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to, bool is_backward);
  /// Lemma 6: the links that inverses imply of a link add nothing, and its ends learn nothing new of each other.
  [[nodiscard]] bool is_implied_satisfied(std::uint32_t from, RoleId role, std::uint32_t to);

 private:
  [[nodiscard]] bool is_individual(std::uint32_t context) const;
  [[nodiscard]] bool has(std::uint32_t context, ExprId atom, bool is_only_successor);
  [[nodiscard]] bool has_what_is_told(std::uint32_t context, ExprId named, bool is_only_successor);
  [[nodiscard]] bool knows_what_it_learns(std::uint32_t from, RoleId role, std::uint32_t to);
  [[nodiscard]] bool is_backward_link_satisfied(std::uint32_t from, RoleId role, std::uint32_t to);
  [[nodiscard]] bool may_be_linked(std::uint32_t from, RoleId role, std::uint32_t to, bool is_backward);

  const IndexedOntology& index_;
  const Saturation& saturation_;
  const OpenParts& open_;
  const InverseRoles& inverses_;
  const HeardRoles& heard_;
  AtomsAbove above_;
};

}  // namespace geminga::el

#endif
