// Told superclasses come from the index, derived ones from the contexts.
#include "reasoning/el/closure/atoms_above.hpp"

namespace geminga::el {

void AtomsAbove::reach(ExprId atom) {
  if (seen_in_[number(atom)] == round_) return;
  seen_in_[number(atom)] = round_;
  found_.push_back(atom);
}

std::span<const ExprId> AtomsAbove::gather(ExprId atom) {
  ++round_;
  found_.clear();
  reach(index_.representative(atom));
  reach(index_.representative(top_expr));
  for (std::size_t at = 0; at < found_.size(); ++at) {
    const ExprId node = found_[at];
    for (const ExprId above : index_.told_atoms(node)) reach(above);
    if (const Context* context = saturation_.find(node)) {
      for (const ExprId above : context->derived) reach(above);
    }
  }
  return found_;
}

}  // namespace geminga::el
