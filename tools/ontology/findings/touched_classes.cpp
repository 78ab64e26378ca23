#include "ontology/findings/touched_classes.hpp"

#include <algorithm>
#include <cstdint>
#include <span>

#include "reasoning/modules/module.hpp"
#include "reasoning/owl/source.hpp"

namespace geminga::ontology {
namespace {

/// The most classes times axioms; a second at most.
constexpr std::uint64_t max_work = 50'000'000;

}  // namespace

std::optional<std::vector<taxonomy::ClassNumber>> find_touched_classes(const compiled::Ontology& ontology) {
  const taxonomy::ClassifiedView& view = ontology.axioms();
  if (std::uint64_t{ontology.class_count()} * view.axiom_count() > max_work) return std::nullopt;
  std::vector<bool> is_unused(view.axiom_count(), false);
  for (const std::uint32_t axiom : view.unused_axiom) is_unused[axiom] = true;
  const auto touches = [&](std::uint32_t axiom) { return is_unused[axiom]; };
  const modules::ModuleIndex index = ontology.module_index();
  const auto thing = ontology.find_iri(owl::owl_thing);
  const auto nothing = ontology.find_iri(owl::owl_nothing);
  std::vector<taxonomy::ClassNumber> touched;
  for (std::uint32_t of = 0; of < ontology.class_count(); ++of) {
    const taxonomy::ClassNumber number{of};
    if (number == thing || number == nothing) continue;
    if (std::ranges::any_of(modules::extract_module(index, std::span(&number, 1)), touches)) touched.push_back(number);
  }
  return touched;
}

}  // namespace geminga::ontology
