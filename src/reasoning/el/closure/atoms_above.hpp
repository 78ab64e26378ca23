// The atoms above an atom, by told axioms and by the conclusions of a saturation.
#ifndef GEMINGA_REASONING_EL_CLOSURE_ATOMS_ABOVE_HPP
#define GEMINGA_REASONING_EL_CLOSURE_ATOMS_ABOVE_HPP

#include <cstdint>
#include <span>
#include <vector>

#include "reasoning/el/closure/saturation.hpp"

namespace geminga::el {

/// Walks up from one atom after the other, in memory that the walks share.
class AtomsAbove {
 public:
  AtomsAbove(const IndexedOntology& index, const Saturation& saturation)
      : index_(index), saturation_(saturation), seen_in_(index.size(), 0) {}

  /// The representatives above an atom, itself and T included. Valid until the next call.
  std::span<const ExprId> gather(ExprId atom);
  /// True if the last call of gather() found the atom.
  [[nodiscard]] bool contains(ExprId atom) const { return seen_in_[number(index_.representative(atom))] == round_; }

 private:
  void reach(ExprId atom);

  const IndexedOntology& index_;
  const Saturation& saturation_;
  std::vector<std::uint32_t> seen_in_;  ///< by atom: the last call that found it
  std::uint32_t round_ = 0;
  std::vector<ExprId> found_;
};

}  // namespace geminga::el

#endif
