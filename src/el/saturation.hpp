// The closure of the rules: one context a concept, with everything that subsumes it and the links that end in it.
//
// The calculus is that of ELK (Kazakov, Kroetzsch, Simancik: The Incredible ELK, 2014) with three changes: only
// expressions that have rules enter a context (what merely stands above in the told hierarchy is found again by the
// taxonomy), told equivalents are one expression, and nominals are exact (nominals.hpp).
//
// Legend: C D E contexts and expressions, R S roles, C < D "C SubClassOf D", R <* S the role hierarchy,
// C -R-> D "everything in C has an R successor in D", T owl:Thing, F owl:Nothing, {a} a nominal; a rule's premises
// stand above the line, its conclusion below, its side condition in brackets.
#ifndef GEMINGA_EL_SATURATION_HPP
#define GEMINGA_EL_SATURATION_HPP

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <span>
#include <vector>

#include "el/growing_set.hpp"
#include "el/index.hpp"

namespace geminga::el {

/// One link of a context: the role and the context at the other end.
struct Link {
  RoleId role{};
  std::uint32_t context = 0;
  friend bool operator==(const Link&, const Link&) = default;
};
[[nodiscard]] inline std::uint64_t hash_of_key(Link link) {
  return ((static_cast<std::uint64_t>(link.role) << 32 | link.context) * 0x9e3779b97f4a7c15ULL) >> 20;
}

/// The successors of a context by a functional role and its sub-roles: they are one.
struct FunctionalGroup {
  RoleId functional{};
  std::uint32_t successor = 0;  ///< the context of all of them together
  std::vector<RoleId> roles;    ///< by which it is a successor
};

/// What is known of one atom, or of some together. The tails of its lists behind the cursors are its to-do queue: a
/// conclusion is tested for being new before it is queued, and every pair of premises meets once.
struct Context {
  ExprId root{};                 ///< F where it is of some atoms together
  std::vector<ExprId> together;  ///< the atoms that it is of, ascending, where they are several
  bool is_unsatisfiable = false;
  bool is_nonempty = false;  ///< it has an instance in every model; followed only where there are nominals
  bool is_queued = false;
  std::uint32_t subsumers_done = 0;
  std::uint32_t backward_done = 0;
  std::uint32_t forward_done = 0;
  std::uint32_t selfs_done = 0;
  GrowingSet<std::uint32_t> subsumers;  ///< active expressions, and marks of disjointness axioms behind them
  GrowingSet<Link> backward;            ///< links that end here
  std::vector<Link> forward;            ///< links that begin here, where something wants to know them
  std::vector<ExistentialRule> propagations;
  std::vector<RoleId> selfs;
  std::vector<FunctionalGroup> groups;
  std::vector<ExprId> derived;          ///< atoms above that no told axiom puts there
  std::vector<std::uint32_t> nominals;  ///< contexts of the nominals above, itself not
  std::vector<std::uint32_t> members;   ///< of a nominal's context: the contexts below it
};

/// Saturates contexts on demand. Not thread-safe; the index may be shared.
class Saturation {
 public:
  /// `max_conclusions` bounds the work and with it the memory.
  Saturation(const Index& index, std::size_t max_conclusions);

  /// Asks for the context of an atom that is its own representative.
  std::uint32_t require(ExprId root);
  /// Says that a context has an instance in every model.
  void require_nonempty(std::uint32_t context);
  /// Applies rules until none is left to fire, or the ontology is found inconsistent. False over max_conclusions.
  [[nodiscard]] bool run();

  [[nodiscard]] bool is_consistent() const { return is_consistent_; }
  [[nodiscard]] const std::deque<Context>& contexts() const { return contexts_; }
  /// The context of an atom, or null where nobody asked for it.
  [[nodiscard]] const Context* find(ExprId root) const;
  /// The number of an atom's context; there must be one.
  [[nodiscard]] std::uint32_t number_of(ExprId root) const { return context_of_[number(root)]; }
  [[nodiscard]] std::size_t conclusion_count() const { return conclusions_; }
  [[nodiscard]] std::size_t link_count() const { return links_; }

 private:
  void enqueue(std::uint32_t context);
  void process(std::uint32_t context);
  void process_subsumer(std::uint32_t context, ExprId subsumer);
  void process_backward(std::uint32_t context, Link link);
  void process_forward(std::uint32_t context, Link link);
  void apply_conjunctions(std::uint32_t context, std::span<const ConjunctionRule> rules);
  void add_subsumer(std::uint32_t context, ExprId subsumer);
  void add_derived_atom(std::uint32_t context, ExprId atom);
  void add_link(std::uint32_t from, RoleId role, std::uint32_t to);
  void add_self(std::uint32_t context, RoleId role);
  void process_self(std::uint32_t context, RoleId role);
  void add_bottom(std::uint32_t context);
  void add_disjointness(std::uint32_t context, std::uint32_t axiom);
  void compose(std::uint32_t from, RoleId first, RoleId second, std::uint32_t to);
  std::uint32_t require_together(const std::vector<ExprId>& atoms);
  void start(std::uint32_t context, std::span<const ExprId> atoms);
  [[nodiscard]] std::vector<ExprId> atoms_of(std::uint32_t context) const;
  void group_successor(std::uint32_t context, RoleId functional, Link link);
  void process_functional(std::uint32_t context, Link link);
  void process_functional_self(std::uint32_t context, RoleId functional);
  void process_nominal(std::uint32_t context, ExprId nominal);
  void merge_into_nominal(std::uint32_t context, std::uint32_t nominal);
  void find_selfs(std::uint32_t context, std::uint32_t nominal);
  void find_self_of_link(std::uint32_t from, RoleId role, std::uint32_t to);

  const Index& index_;
  std::size_t max_conclusions_;
  std::size_t conclusions_ = 0;
  std::size_t links_ = 0;
  bool is_consistent_ = true;
  bool keeps_forward_;  ///< all forward links, not only those that chains want
  std::deque<Context> contexts_;
  std::vector<std::uint32_t> context_of_;  ///< by atom
  std::map<std::vector<ExprId>, std::uint32_t> context_of_some_;
  std::vector<std::uint32_t> queue_;
};

}  // namespace geminga::el

#endif
