// Each axiom is tested once against the empty signature, when an ontology is compiled.
#include "base/rows.hpp"
#include "reasoning/modules/module.hpp"

namespace geminga::modules {
namespace {

/// The entity of a kind and name, or ClassifiedView::none.
std::uint32_t find_entity(const taxonomy::ClassifiedView& view, owl::TermKind kind, std::string_view iri) {
  for (std::uint32_t term = 0; term < view.term_count(); ++term) {
    if (view.kind_of_term(term) == kind && view.name_of_term(term) == iri) return term;
  }
  return taxonomy::ClassifiedView::none;
}

BuiltIn find_built_in(const taxonomy::ClassifiedView& view) {
  return {.thing = find_entity(view, owl::TermKind::named_class, owl::owl_thing),
          .nothing = find_entity(view, owl::TermKind::named_class, owl::owl_nothing),
          .top_object_property = find_entity(view, owl::TermKind::object_property, owl::owl_top_object_property),
          .top_data_property = find_entity(view, owl::TermKind::data_property, owl::owl_top_data_property),
          .bottom_object_property = find_entity(view, owl::TermKind::object_property, owl::owl_bottom_object_property),
          .bottom_data_property = find_entity(view, owl::TermKind::data_property, owl::owl_bottom_data_property)};
}

}  // namespace

ModuleTables make_module_tables(const taxonomy::ClassifiedView& view) {
  ModuleTables tables;
  const BuiltIn built_in = find_built_in(view);
  tables.built_in = {built_in.thing,
                     built_in.nothing,
                     built_in.top_object_property,
                     built_in.top_data_property,
                     built_in.bottom_object_property,
                     built_in.bottom_data_property};
  tables.uses.assign(view.term_count(), 0);
  for (const std::uint32_t argument : view.term_arguments) ++tables.uses[argument];
  for (const std::uint32_t argument : view.axiom_arguments) ++tables.uses[argument];
  tables.term_of_class.assign(view.class_count(), taxonomy::ClassifiedView::none);
  for (std::uint32_t term = 0; term < view.term_count(); ++term) {
    const bool is_class =
        view.kind_of_term(term) == owl::TermKind::named_class && view.term_word[term] < view.class_count();
    if (is_class) tables.term_of_class[view.term_word[term]] = term;
  }
  const std::vector<bool> nothing_yet(view.term_count(), false);
  LocalityTest test(view, built_in, nothing_yet, tables.uses);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> waiting;
  waiting.reserve(view.axiom_count());
  for (std::uint32_t axiom = 0; axiom < view.axiom_count(); ++axiom) {
    const Locality locality = test.test(axiom);
    for (const std::uint32_t name : test.names()) waiting.emplace_back(name, axiom);
    if (locality != Locality::not_local) continue;
    tables.unconditional.push_back(axiom);
    // The axiom is in every module. The walk reaches it early if it is filed under its names.
    for (const std::uint32_t argument : view.arguments_of_axiom(axiom)) {
      if (is_entity(view.kind_of_term(argument))) waiting.emplace_back(argument, axiom);
    }
  }
  const base::Rows<std::uint32_t> rows(view.term_count(), waiting);
  tables.waiting_begin.push_back(0);
  for (std::uint32_t term = 0; term < view.term_count(); ++term) {
    tables.waiting.insert(tables.waiting.end(), rows[term].begin(), rows[term].end());
    tables.waiting_begin.push_back(static_cast<std::uint32_t>(tables.waiting.size()));
  }
  return tables;
}

}  // namespace geminga::modules
