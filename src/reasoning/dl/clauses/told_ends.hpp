// The named classes that the ends of edges are told to be in: by domains, ranges and the classes above these.
//
// Families and places have a domain and a range for each of their properties, also for those that chains imply. If the
// last edge of each path puts its end into the class already, the path need not be followed to say so again.
#ifndef GEMINGA_REASONING_DL_CLAUSES_TOLD_ENDS_HPP
#define GEMINGA_REASONING_DL_CLAUSES_TOLD_ENDS_HPP

#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "reasoning/dl/clauses/allowed.hpp"
#include "reasoning/dl/clauses/ordered_axiom.hpp"
#include "reasoning/dl/clauses/vocabulary.hpp"
#include "reasoning/owl/role_box.hpp"

namespace geminga::clauses {

/// Says of single edges what clauses about single edges and about classes derive. Paths are left out on purpose: what
/// is known here may replace clauses about paths.
class ToldEnds {
 public:
  /// Borrows the source and the roles. Of the axioms only the parts that have clauses are used.
  ToldEnds(Vocabulary& vocabulary, const owl::RoleBox& roles, std::span<const owl::RoleInclusion> inclusions,
           Allowed& allowed, std::span<const OrderedAxiom> axioms);

  /// Whether R(x,y) -> C(x) follows for the edges of the role.
  [[nodiscard]] bool begins_in(Role role, owl::TermId named_class) { return ends_in(inverse(role), named_class); }
  /// Whether R(x,y) -> C(y) follows for the edges of the role.
  [[nodiscard]] bool ends_in(Role role, owl::TermId named_class);

 private:
  void add_classes(const OrderedAxiom& axiom, Allowed& allowed);
  void add_inclusion(owl::TermId sub, owl::TermId super, Allowed& allowed);
  [[nodiscard]] const std::vector<owl::TermId>& ends_of(Role role);

  const owl::Ontology& source_;
  const owl::RoleBox& roles_;
  std::map<Role, std::vector<owl::TermId>> ranges_;  ///< as they are told, of canonical roles
  std::map<Role, std::vector<Role>> supers_;         ///< as they are told, of canonical roles
  std::unordered_map<owl::TermId, std::vector<owl::TermId>> above_;
  std::map<Role, std::vector<owl::TermId>> ends_;  ///< of canonical roles that were asked about, sorted
};

}  // namespace geminga::clauses

#endif
