// The classes that can have no instance, root ones apart from those that have none because of another.
//
// A class is derived if one of its minimal sets of axioms holds one of another class and more; it is a root if not
// (Kalyanpur, Parsia, Sirin, Hendler: Debugging Unsatisfiable Classes in OWL Ontologies, 2005). A derived class is
// often mended by mending its root, and cannot be mended before.
#ifndef GEMINGA_REASONING_EXPLANATION_UNSATISFIABLE_HPP
#define GEMINGA_REASONING_EXPLANATION_UNSATISFIABLE_HPP

#include <cstddef>
#include <optional>
#include <vector>

#include "base/budget.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/explanation/explain_oracle.hpp"

namespace geminga::explanation {

/// A class that can have no instance.
struct Unsatisfiable {
  taxonomy::ClassNumber number{};
  /// The root that it is derived from; nothing: no reason was found by which it depends on another class.
  std::optional<taxonomy::ClassNumber> root;
  /// Of a root: a minimal set of axioms, in the order of the argument. Of a derived class: the axiom that leads it to a
  /// class that can have no instance, or a minimal set that holds one of its root. Empty: none was looked for or found.
  std::vector<ExplainedAxiom> reason;
};

/// The most classes for which minimal sets are looked for. Classes that an axiom leads to another one need none.
inline constexpr std::size_t max_explained_classes = 100;

/// The unsatisfiable classes without owl:Nothing: roots first, each of both kinds ascending. Requires an ontology
/// without a contradiction, and its axioms. A pass over the axioms, and a minimal set for each class that no axiom
/// leads to another one: only easy sets are looked for, none after a hard one, since the others would be hard, too, and
/// none once steps_of_reasons() are spent for all of them.
[[nodiscard]] std::vector<Unsatisfiable> find_unsatisfiable(const compiled::Ontology& ontology, base::Budget* budget,
                                                            Patience patience = Patience::of_a_daemon);

}  // namespace geminga::explanation

#endif
