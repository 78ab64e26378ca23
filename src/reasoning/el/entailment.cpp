// A saturation that starts from one class only.
#include "reasoning/el/entailment.hpp"

#include <algorithm>
#include <optional>

#include "reasoning/el/index/index_builder.hpp"
#include "reasoning/el/normaliser/rule_normaliser.hpp"
#include "reasoning/el/worlds.hpp"

namespace geminga::el {

Entailed find_entailed(const owl::Ontology& source, std::span<const std::uint32_t> axioms, owl::TermId sub,
                       owl::TermId super) {
  constexpr std::size_t max_pairs = std::size_t{1} << 26;
  IndexBuilder builder;
  RuleNormaliser normaliser(source, builder);
  bool is_complete = true;
  for (const std::uint32_t axiom : axioms) is_complete &= normaliser.add(axiom) == owl::Construct::none;
  const ExprId from = normaliser.expression(sub);
  const ExprId to = normaliser.expression(super);
  is_complete &= normaliser.finish().empty();
  const Entailed otherwise = is_complete ? Entailed::no : Entailed::not_found;
  const auto index = builder.finish(max_pairs);
  if (!index) return Entailed::not_found;
  const std::optional<World> world = find_world(*index, from, normaliser.individuals(), {.conclusions = max_pairs});
  if (!world) return Entailed::not_found;
  if (!world->is_possible) return Entailed::yes;
  const bool is_above = std::ranges::find(world->above, index->representative(to)) != world->above.end();
  return is_above ? Entailed::yes : otherwise;
}

}  // namespace geminga::el
