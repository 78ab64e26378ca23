// The roles whose links can matter to a rule or a test.
#ifndef GEMINGA_REASONING_EL_MODEL_HEARD_ROLES_HPP
#define GEMINGA_REASONING_EL_MODEL_HEARD_ROLES_HPP

#include <cstddef>
#include <vector>

#include "reasoning/el/index/indexed_ontology.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/model/inverse_roles.hpp"

namespace geminga::el {

class HeardRoles {
 public:
  HeardRoles(const IndexedOntology& index, const OpenParts& open, const InverseRoles& inverses);

  /// True if a rule or a test of the model may depend on whether there is a link of the role.
  [[nodiscard]] bool is_heard(RoleId role) const { return is_heard_[static_cast<std::size_t>(role)]; }
  /// True if the role is part of a chain whose result is heard.
  [[nodiscard]] bool is_composed(RoleId role) const { return is_composed_[static_cast<std::size_t>(role)]; }

 private:
  void hear_directly(const IndexedOntology& index, const OpenParts& open);
  [[nodiscard]] bool hear_through(const IndexedOntology& index, const InverseRoles& inverses, RoleId role);

  std::vector<bool> is_heard_;
  std::vector<bool> is_composed_;
};

}  // namespace geminga::el

#endif
