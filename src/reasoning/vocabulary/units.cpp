#include "reasoning/vocabulary/units.hpp"

#include <algorithm>

#include "base/edit_distance.hpp"
#include "reasoning/compiled/ontology.hpp"
#include "reasoning/owl/unit.hpp"

namespace geminga::vocabulary {

static_assert(unit_base_count == owl::unit_base_count);

struct Units::Declared {
  std::shared_ptr<const compiled::Ontology> ontology;
  compiled::UnitsView view;
};

Units::Units(std::shared_ptr<const compiled::Ontology> ontology) {
  if (ontology == nullptr || ontology->units().size() == 0) return;
  const compiled::UnitsView view = ontology->units();
  declared_ = std::make_shared<const Declared>(std::move(ontology), view);
}

std::size_t Units::size() const { return is_empty() ? 0 : declared_->view.size(); }

FoundUnit Units::at(std::uint32_t number) const {
  const compiled::UnitsView& view = declared_->view;
  const std::uint32_t alone = view.alone[number];
  const std::uint32_t symbol = view.symbol[number];
  return {.factor = view.factor[number],
          .offset = view.offset[number],
          .dimension = view.dimension.subspan(std::size_t{number} * owl::unit_base_count, owl::unit_base_count),
          .alone = alone == compiled::UnitsView::none ? 0 : alone + 1,
          .symbol = symbol == compiled::UnitsView::none ? std::string_view() : view.name(symbol)};
}

std::optional<FoundUnit> Units::by_symbol(std::string_view symbol) const { return by_iri("", symbol); }

std::optional<FoundUnit> Units::by_iri(std::string_view space, std::string_view name) const {
  if (is_empty()) return std::nullopt;
  const auto number = declared_->view.find(space, name);
  return number ? std::optional(at(*number)) : std::nullopt;
}

std::optional<FoundUnit> Units::by_name(std::string_view prefixed) const {
  const std::size_t colon = prefixed.find(':');
  if (is_empty() || colon == std::string_view::npos) return std::nullopt;
  const std::string_view prefix = prefixed.substr(0, colon);
  const std::string_view name = prefixed.substr(colon + 1);
  for (const auto& [word, iri] : declared_->ontology->prefixes()) {
    if (word != prefix) continue;
    if (auto found = by_iri(iri, name)) return found;
  }
  if (prefix == "unit") return by_iri(owl::qudt_unit_namespace, name);
  return prefix == "om" ? by_iri(owl::om_namespace, name) : std::nullopt;
}

std::string_view Units::similar_symbol(std::string_view text) const {
  if (is_empty() || text.size() > owl::max_unit_symbol_octets) return {};
  const compiled::UnitsView& view = declared_->view;
  for (std::size_t number = 0; number < view.name_end.size(); ++number) {
    const std::string_view name = view.name(number);
    const bool is_near = name.size() + 1 >= text.size() && name.size() <= text.size() + 1;
    if (is_near && !name.contains(':') && base::edit_distance(text, name, 1) == 1) return name;
  }
  return {};
}

}  // namespace geminga::vocabulary
