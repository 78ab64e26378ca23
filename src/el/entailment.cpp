// A saturation that starts from one class only.
#include "el/entailment.hpp"

#include <algorithm>
#include <optional>

#include "el/index.hpp"
#include "el/nominals.hpp"
#include "el/normaliser.hpp"

namespace geminga::el {

bool entails(const OntologySource& source, std::span<const std::uint32_t> axioms, TermId sub, TermId super) {
  constexpr std::size_t max_pairs = std::size_t{1} << 26;
  Index index;
  Normaliser normaliser(source, index);
  for (const std::uint32_t axiom : axioms) normaliser.add(axiom);
  const ExprId from = normaliser.expression(sub);
  const ExprId to = normaliser.expression(super);
  (void)normaliser.finish();  // what is left out is classify()'s to say
  if (!index.finish(max_pairs)) return false;
  const std::optional<World> world = find_world(index, from, normaliser.individuals(), max_pairs);
  if (!world) return false;
  return !world->is_possible || std::ranges::find(world->above, index.representative(to)) != world->above.end();
}

}  // namespace geminga::el
