// Roles that a rule or a test asks for, then roles whose links imply or compose links of these.
#include "reasoning/el/model/heard_roles.hpp"

#include <cstdint>

namespace geminga::el {

HeardRoles::HeardRoles(const IndexedOntology& index, const OpenParts& open, const InverseRoles& inverses)
    : is_heard_(index.roles().count(), false), is_composed_(index.roles().count(), false) {
  hear_directly(index, open);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t role = 0; role < index.roles().count(); ++role) {
      changed = hear_through(index, inverses, RoleId{role}) || changed;
    }
  }
}

void HeardRoles::hear_directly(const IndexedOntology& index, const OpenParts& open) {
  const auto hear = [&](RoleId role) { is_heard_[static_cast<std::size_t>(role)] = true; };
  for (std::uint32_t id = 0; id < index.size(); ++id) {
    for (const ExistentialRule& rule : index.existentials(ExprId{id})) hear(rule.role);
    for (const UniversalRule& rule : index.universals(ExprId{id})) hear(rule.role);
  }
  for (const OpenCount& count : open.at_most) hear(count.role);
  for (std::uint32_t id = 0; id < index.roles().count(); ++id) {
    const RoleId role{id};
    const bool is_asked =
        index.range_of(role) != top_expr || index.may_be_functional(role) || index.negative_self(role) != bottom_expr;
    if (is_asked) hear(role);
  }
}

/// Marks the role if it implies a heard role, and the parts of its chains whose results are heard. True if that is new.
bool HeardRoles::hear_through(const IndexedOntology& index, const InverseRoles& inverses, RoleId role) {
  bool changed = false;
  const auto set = [&](std::vector<bool>& flags, RoleId at) {
    changed = changed || !flags[static_cast<std::size_t>(at)];
    flags[static_cast<std::size_t>(at)] = true;
  };
  for (const RoleId super : index.roles().supers(role)) {
    if (is_heard(super)) set(is_heard_, role);
  }
  for (const ImpliedRole& other : inverses.implied(role)) {
    if (is_heard(other.role)) set(is_heard_, role);
  }
  for (const Composition& rule : index.roles().compositions(role)) {
    if (!is_heard(rule.result)) continue;
    for (const RoleId part : {role, rule.second}) {
      set(is_heard_, part);
      set(is_composed_, part);
    }
  }
  return changed;
}

}  // namespace geminga::el
