// The roles that stand for properties.
#ifndef GEMINGA_REASONING_EL_NORMALISER_PROPERTY_ROLES_HPP
#define GEMINGA_REASONING_EL_NORMALISER_PROPERTY_ROLES_HPP

#include <cstdint>
#include <vector>

#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/owl/role.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::el {

/// A property expression: a role, or the inverse of one.
struct Property {
  RoleId role{};
  bool is_inverse = false;
  bool is_top = false;
  bool is_data = false;
};

/// The role as the automata of chains name it.
[[nodiscard]] inline owl::Role role_of(RoleId role) {
  return {owl::PropertyId{static_cast<std::uint32_t>(role)}, false};
}

/// Gives each property of an ontology its role, when it is first asked for.
class PropertyRoles {
 public:
  PropertyRoles(const owl::Ontology& source, IndexBuilder& index);

  Property find(owl::TermId property);

 private:
  const owl::Ontology& source_;
  IndexBuilder& index_;
  std::vector<std::uint32_t> roles_;  ///< by term
};

}  // namespace geminga::el

#endif
