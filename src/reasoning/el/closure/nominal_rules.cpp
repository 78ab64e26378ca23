// The legend is in saturation.hpp.
#include "reasoning/el/closure/nominal_rules.hpp"

#include <algorithm>
#include <vector>

namespace geminga::el {

void NominalRules::require_nonempty(std::uint32_t context) {
  std::vector<std::uint32_t> stack = {context};
  while (!stack.empty()) {
    const std::uint32_t at = stack.back();
    stack.pop_back();
    if (!conclusions_.mark_nonempty(at)) continue;
    const Context& self = contexts_[at];
    // Rules that are still to be applied will see the mark.
    for (std::uint32_t done = 0; done < self.forward_done; ++done) stack.push_back(self.forward[done].context);
    for (const std::uint32_t nominal : self.nominals) merge_into_nominal(at, nominal);
  }
}

//  C < {a}   {a} < D     C < {a}   C < D
//  -----------------     --------------- [C is not empty; neither rule where C is of values, which are no individuals]
//  C < D                 {a} < D
void NominalRules::apply(std::uint32_t context, ExprId subsumer) {
  if (is_of_values(context)) return;
  Context& self = contexts_[context];
  // A new subsumer of a nominal goes to the contexts below the nominal and to the nominals that are equal to it.
  conclusions_.count_work(self.members.size());
  for (std::size_t at = 0; at < self.members.size(); ++at) conclusions_.add_subsumer(self.members[at], subsumer);
  if (self.is_nonempty) {
    for (const std::uint32_t nominal : self.nominals) conclusions_.add_subsumer(nominal, subsumer);
  }
  if (!index_.is_nominal(subsumer)) return;
  const std::uint32_t nominal = conclusions_.require(subsumer);
  if (nominal == context) return;
  self.nominals.own().push_back(nominal);
  contexts_[nominal].members.own().push_back(context);
  const base::ArenaSet<std::uint32_t>& known = contexts_[nominal].subsumers;
  conclusions_.count_work(known.size());
  for (std::size_t at = 0; at < known.size(); ++at) {
    if (known[at] < index_.size()) conclusions_.add_subsumer(context, ExprId{known[at]});
  }
  if (self.is_nonempty) merge_into_nominal(context, nominal);
  if (index_.has_negative_self()) find_selfs(context, nominal);
}

bool NominalRules::is_of_values(std::uint32_t context) const {
  const Context& self = contexts_[context];
  if (self.together.empty()) return index_.is_value(self.root);
  return std::ranges::any_of(self.together, [&](ExprId atom) { return index_.is_value(atom); });
}

void NominalRules::merge_into_nominal(std::uint32_t context, std::uint32_t nominal) {
  for (const ExprId atom : conclusions_.members_of(context)) conclusions_.add_atom(nominal, atom);
  const base::ArenaSet<std::uint32_t>& known = contexts_[context].subsumers;
  conclusions_.count_work(known.size());
  for (std::size_t at = 0; at < known.size(); ++at) {
    if (known[at] < index_.size()) conclusions_.add_subsumer(nominal, ExprId{known[at]});
  }
}

//  C < {a}   D < {a}   C -R-> D
//  ----------------------------
//  C < R Self
void NominalRules::find_selfs(std::uint32_t context, std::uint32_t nominal) {
  const auto is_same = [&](std::uint32_t other) {
    return other == nominal ||
           std::ranges::find(contexts_[other].nominals.get(), nominal) != contexts_[other].nominals.get().end();
  };
  for (std::size_t at = 0; at < contexts_[context].backward.size(); ++at) {
    const Link link = contexts_[context].backward[at];
    if (is_same(link.context)) conclusions_.add_self(link.context, link.role);
  }
  for (std::size_t at = 0; at < contexts_[context].forward.size(); ++at) {
    const Link link = contexts_[context].forward[at];
    if (is_same(link.context)) conclusions_.add_self(context, link.role);
  }
}

void NominalRules::apply_to_link(std::uint32_t from, RoleId role, std::uint32_t to) {
  if (contexts_[from].is_nonempty) require_nonempty(to);
  if (!index_.has_negative_self()) return;
  const auto nominals_of = [&](std::uint32_t context) {
    std::vector<std::uint32_t> nominals = contexts_[context].nominals.get();
    if (index_.is_nominal(contexts_[context].root)) nominals.push_back(context);
    return nominals;
  };
  const std::vector<std::uint32_t> ends = nominals_of(to);
  for (const std::uint32_t nominal : nominals_of(from)) {
    if (std::ranges::find(ends, nominal) != ends.end()) return conclusions_.add_self(from, role);
  }
}

}  // namespace geminga::el
