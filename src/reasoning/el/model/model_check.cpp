// The tests of all contexts and links, and of the world of the individuals.
#include "reasoning/el/model/model_check.hpp"

#include <vector>

namespace geminga::el {

ModelCheck::ModelCheck(const IndexedOntology& index, const Saturation& saturation, const OpenParts& open,
                       const InverseRoles& inverses, std::span<const ExprId> classes)
    : index_(index),
      saturation_(saturation),
      open_(open),
      heard_(index, open, inverses),
      test_(index, saturation, open, inverses, heard_),
      unions_(index, saturation, open, classes),
      failing_(saturation.contexts()) {
  test_contexts();
  test_counts();
  test_links_to_unions();
  test_world();
}

bool ModelCheck::is_settled(ExprId atom) {
  const ExprId representative = index_.representative(atom);
  ExprId root = representative;
  if (index_.needs_no_context(representative)) {
    root = index_.frontier(representative).empty() ? index_.representative(top_expr)
                                                   : index_.frontier(representative).front();
  }
  return saturation_.find(root) != nullptr && unions_.is_settled(failing_, saturation_.number_of(root));
}

void ModelCheck::test_contexts() {
  const ContextStore& contexts = saturation_.contexts();
  for (std::uint32_t at = 0; at < contexts.size(); ++at) {
    const Context& context = contexts[at];
    if (context.is_unsatisfiable) continue;
    // A context below an individual that need not have an instance is no element of its own.
    if (!context.nominals.empty() && !context.is_nonempty) failing_.add(at);
    for (const RoleId role : context.selfs) test_link(at, role, at);
    for (const Link link : context.backward.items()) {
      if (is_satisfiable(link.context)) test_link(link.context, link.role, at);
    }
  }
}

void ModelCheck::test_link(std::uint32_t from, RoleId role, std::uint32_t to) {
  if (!failing_.has(from) && !test_.is_implied_satisfied(from, role, to)) failing_.add(from);
}

// Lemma 8.
void ModelCheck::test_counts() {
  const ContextStore& contexts = saturation_.contexts();
  if (open_.at_most.empty() && open_.at_least.empty()) return;
  std::vector<std::uint32_t> links_of(contexts.size(), 0);
  for (const Context& context : contexts) {
    if (context.is_unsatisfiable) continue;
    for (const Link link : context.backward.items()) ++links_of[link.context];
  }
  const bool may_all_be_counted = index_.has_nominals() || !open_.at_most.empty();
  for (std::uint32_t at = 0; at < contexts.size(); ++at) {
    if (contexts[at].is_unsatisfiable) continue;
    //  x in X   [X < at least n R C]; the model has n copies of the successor, unless something counts them
    for (const OpenCount& open : open_.at_least) {
      const bool may_be_counted = may_all_be_counted || index_.may_be_functional(open.role);
      if (may_be_counted && test_.is_in(at, open.whole)) failing_.add(at);
    }
    //  x in X   [X < at most n R C]; links of other properties are counted, too
    for (const OpenCount& open : open_.at_most) {
      if (links_of[at] > open.count && test_.is_in(at, open.whole)) failing_.add(at);
    }
  }
}

// A part that fails is no part to lead to, so all links are tested again until no further context fails.
void ModelCheck::test_links_to_unions() {
  const ContextStore& contexts = saturation_.contexts();
  std::size_t known = 0;
  do {
    failing_.follow();
    known = failing_.count();
    for (std::uint32_t at = 0; at < contexts.size(); ++at) {
      if (!unions_.is_open(at) || failing_.has(at)) continue;
      for (const Link link : contexts[at].backward.items()) {
        if (failing_.has(link.context) || !is_satisfiable(link.context)) continue;
        if (!unions_.can_lead_to_a_part(test_, heard_, failing_, link, at)) failing_.add(link.context);
      }
    }
  } while (failing_.count() != known);
}

// The individuals stand in one world: a link to one of them leads to all of them (Lemma 9).
void ModelCheck::test_world() {
  const ContextStore& contexts = saturation_.contexts();
  for (std::uint32_t at = 0; at < contexts.size(); ++at) {
    const ExprId root = contexts[at].root;
    const bool must_be = index_.is_nominal(root) || root == index_.representative(top_expr);
    if (must_be && is_satisfiable(at) && (failing_.has(at) || unions_.is_open(at))) is_world_settled_ = false;
  }
  if (is_world_settled_) return;
  for (std::uint32_t at = 0; at < contexts.size(); ++at) {
    if (index_.is_nominal(contexts[at].root) && is_satisfiable(at)) failing_.add(at);
  }
  test_links_to_unions();
}

}  // namespace geminga::el
