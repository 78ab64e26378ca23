// A world is a saturation with one more required instance.
#include "reasoning/el/worlds.hpp"

#include <algorithm>

#include "reasoning/el/closure/atoms_above.hpp"

namespace geminga::el {
namespace {

/// True if a context below a nominal has subsumers with rules that the nominal has not.
bool says_more(const IndexedOntology& index, const Saturation& saturation, const Context& context) {
  return std::ranges::any_of(context.nominals, [&](std::uint32_t nominal) {
    const Context& individual = saturation.contexts()[nominal];
    return std::ranges::any_of(context.subsumers.items(), [&](std::uint32_t subsumer) {
      return subsumer < index.size() && !individual.subsumers.contains(subsumer);
    });
  });
}

}  // namespace

std::vector<ExprId> find_conditional_roots(const IndexedOntology& index, const Saturation& saturation,
                                           std::span<const ExprId> asked) {
  std::vector<ExprId> roots;
  if (!index.has_nominals() || !saturation.is_consistent()) return roots;
  // Walks backwards from contexts below a nominal that need not have an instance and say more than the nominal.
  const auto& contexts = saturation.contexts();
  std::vector<bool> is_conditional(contexts.size(), false);
  std::vector<std::uint32_t> stack;
  for (std::uint32_t at = 0; at < contexts.size(); ++at) {
    const Context& context = contexts[at];
    if (context.is_nonempty || context.is_unsatisfiable || context.nominals.empty()) continue;
    is_conditional[at] = true;
    if (says_more(index, saturation, context)) stack.push_back(at);
  }
  std::vector<bool> seen(contexts.size(), false);
  while (!stack.empty()) {
    const std::uint32_t at = stack.back();
    stack.pop_back();
    if (seen[at]) continue;
    seen[at] = true;
    is_conditional[at] = true;
    for (const Link link : contexts[at].backward.items()) stack.push_back(link.context);
  }
  for (const ExprId root : asked) {
    const Context* context = saturation.find(root);
    if (context == nullptr || context->is_nonempty || context->is_unsatisfiable) continue;
    if (is_conditional[saturation.number_of(root)]) roots.push_back(root);
  }
  return roots;
}

std::optional<World> find_world(const IndexedOntology& index, ExprId root, std::span<const ExprId> individuals,
                                const SaturationLimits& limits) {
  Saturation saturation(index, limits);
  for (const ExprId individual : individuals) saturation.require(index.representative(individual));
  saturation.require_nonempty(saturation.require(index.representative(root)));
  if (!saturation.run()) return std::nullopt;
  World world;
  world.is_possible = saturation.is_consistent();
  if (!world.is_possible) return world;
  AtomsAbove above(index, saturation);
  const std::span<const ExprId> found = above.gather(root);
  world.above.assign(found.begin(), found.end());
  return world;
}

}  // namespace geminga::el
