// The rules of EL first.
#include "reasoner/explain_oracle.hpp"

namespace geminga::reasoner {

el::Entailed Oracle::find_by_rules(std::span<const std::uint32_t> axioms, el::TermId sub, el::TermId super) {
  work_ += 1 + axioms.size();
  return el::find_entailed(source_, axioms, sub, super);
}

bool Oracle::holds(std::span<const std::uint32_t> axioms, el::TermId sub, el::TermId super) {
  const el::Entailed by_rules = find_by_rules(axioms, sub, super);
  if (by_rules == el::Entailed::not_found) was_undecided_ = true;
  return by_rules == el::Entailed::yes;
}

}  // namespace geminga::reasoner
