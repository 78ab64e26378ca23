// Contexts of several atoms together: what the rules for functional properties (rules.hpp) merge, and what universals
// restrict.

#include "reasoning/el/saturation_worker.hpp"

namespace geminga::el {

std::uint32_t SaturationWorker::require_together(const std::vector<ExprId>& atoms) {
  if (atoms.size() == 1) return require(atoms.front());
  const std::scoped_lock lock(shared_.together_mutex);  // in ontologies with functional properties only
  const auto [known, is_new] = shared_.context_of_some.try_emplace(atoms, 0);
  if (!is_new) return known->second;
  const std::uint32_t created = contexts_.add();
  known->second = created;
  contexts_[created].root = bottom_expr;
  contexts_[created].together.own() = atoms;
  conclusions_ += atoms.size();
  shared_.merged_atoms += atoms.size();
  if (shared_.merged_atoms > shared_.limits.merged_atoms) {
    shared_.is_over_merged = true;
    shared_.is_over_limit = true;
  }
  std::vector<ExprId> above = atoms;
  above.push_back(top_expr);
  start(created, above);
  return created;
}

std::vector<ExprId> SaturationWorker::members_of(std::uint32_t context) const {
  const Context& self = contexts_[context];
  return self.together.empty() ? std::vector<ExprId>{self.root} : self.together.get();
}

}  // namespace geminga::el
