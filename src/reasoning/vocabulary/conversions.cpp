// The graph of declared conversions, and its remembered answers.
#include "reasoning/vocabulary/conversions.hpp"

#include "reasoning/compiled/ontology.hpp"

namespace geminga::vocabulary {

using taxonomy::ClassNumber;

Conversions::Conversions(std::shared_ptr<const compiled::Ontology> ontology) : graph_(ontology) {
  std::uint32_t place = 0;
  for (const taxonomy::Conversion& one : ontology->conversions()) {
    const Step step{.from = ClassNumber{one.from}, .to = ClassNumber{one.to}, .cost = one.cost};
    if (ontology->is_satisfiable(step.from) && ontology->is_satisfiable(step.to)) {
      graph_.put(place, step, place);
      ++place;
    }
  }
}

std::shared_ptr<const Chain> Conversions::cheapest(ClassNumber offered, ClassNumber requested) const {
  if (size() == 0) return nullptr;
  const std::pair pair(offered, requested);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = remembered_.find(pair); known != remembered_.end()) return known->second;
  }
  const auto way = graph_.cheapest(offered, requested);
  auto found = way.empty() ? nullptr : std::make_shared<const Chain>(graph_.chain_of(way, offered, requested));
  const std::lock_guard lock(mutex_);
  if (remembered_.size() >= max_remembered) remembered_.clear();
  remembered_.emplace(pair, found);
  return found;
}

}  // namespace geminga::vocabulary
