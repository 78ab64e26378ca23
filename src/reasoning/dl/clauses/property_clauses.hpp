// The clauses of axioms about object and data properties.
#ifndef GEMINGA_REASONING_DL_CLAUSES_PROPERTY_CLAUSES_HPP
#define GEMINGA_REASONING_DL_CLAUSES_PROPERTY_CLAUSES_HPP

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "reasoning/dl/clauses/allowed.hpp"
#include "reasoning/dl/clauses/ordered_axiom.hpp"
#include "reasoning/dl/clauses/translator.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::clauses {

/// Appends the inclusions and chains that an axiom states.
void collect_roles(const OrderedAxiom& axiom, Vocabulary& vocabulary, std::vector<owl::RoleInclusion>& inclusions,
                   std::vector<owl::RoleChain>& chains);

class PropertyClauses {
 public:
  PropertyClauses(Vocabulary& vocabulary, Allowed& allowed, Translator& translator)
      : vocabulary_(vocabulary), allowed_(allowed), translator_(translator) {}

  /// Adds the inclusions between different roles, and the symmetry of roles.
  void add_hierarchy(std::span<const owl::RoleInclusion> inclusions, const owl::RoleBox& roles,
                     std::size_t property_count);
  /// Why the axiom has no clauses. Empty if it has, or is about no property.
  [[nodiscard]] std::string_view problem(const OrderedAxiom& axiom);
  /// Adds the clauses of an axiom about properties, beside the hierarchy.
  void add(const OrderedAxiom& axiom);

 private:
  void add_object_property_axiom(const OrderedAxiom& axiom);
  void add_data_property_axiom(const OrderedAxiom& axiom);

  Vocabulary& vocabulary_;
  Allowed& allowed_;
  Translator& translator_;
};

}  // namespace geminga::clauses

#endif
