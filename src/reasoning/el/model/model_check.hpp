// The model check: finds the classes whose subsumers are all known although the rules do not use every axiom.
//
// The contexts of a saturation are a model of the axioms that the rules use. If this model satisfies the other axioms
// as well, what was not derived does not follow. README.md has the argument as lemmas and says on which ontologies the
// check pays.
#ifndef GEMINGA_REASONING_EL_MODEL_MODEL_CHECK_HPP
#define GEMINGA_REASONING_EL_MODEL_MODEL_CHECK_HPP

#include <cstdint>
#include <span>

#include "reasoning/el/closure/saturation.hpp"
#include "reasoning/el/index/open_parts.hpp"
#include "reasoning/el/model/element_test.hpp"
#include "reasoning/el/model/failing_contexts.hpp"
#include "reasoning/el/model/heard_roles.hpp"
#include "reasoning/el/model/inverse_roles.hpp"
#include "reasoning/el/model/open_unions.hpp"

namespace geminga::el {

class ModelCheck {
 public:
  /// Requires a saturation that has ended within its limits and without contradiction, and that `open` holds all axioms
  /// that it does not use. Completeness is tested for `classes` (representatives) only.
  ModelCheck(const IndexedOntology& index, const Saturation& saturation, const OpenParts& open,
             const InverseRoles& inverses, std::span<const ExprId> classes);

  /// True if all subsumers of the atom are known, provided that the ontology is consistent.
  [[nodiscard]] bool is_settled(ExprId atom);
  /// True if everything that must have an instance is settled; then the ontology is consistent.
  [[nodiscard]] bool is_world_settled() const { return is_world_settled_; }

 private:
  void test_contexts();
  void test_counts();
  void test_link(std::uint32_t from, RoleId role, std::uint32_t to);
  void test_links_to_unions();
  void test_world();
  [[nodiscard]] bool is_satisfiable(std::uint32_t context) const {
    return !saturation_.contexts()[context].is_unsatisfiable;
  }

  const IndexedOntology& index_;
  const Saturation& saturation_;
  const OpenParts& open_;
  HeardRoles heard_;
  ElementTest test_;
  OpenUnions unions_;
  FailingContexts failing_;
  bool is_world_settled_ = true;
};

}  // namespace geminga::el

#endif
