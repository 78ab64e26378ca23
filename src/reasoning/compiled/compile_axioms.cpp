// Writes terms and axioms in canonical order, and the tables by which explanations find them.
#include <algorithm>
#include <map>

#include "reasoning/compiled/compile_sections.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/modules/module.hpp"

namespace geminga::compiled {
namespace {

/// Numbers names. Classes come first, with the numbers of the classes; then all other names, ascending. The first of
/// those is the empty name, which expressions have.
std::vector<std::uint32_t> number_names(const CompilerInput& input, form::AxiomsT& out) {
  const owl::Ontology& source = input.source;
  std::vector<std::uint32_t> number_of(source.name_count(), none);
  std::uint32_t count = 0;
  for (const owl::NameId id : input.classification.classes) number_of[static_cast<std::size_t>(id)] = count++;
  std::vector<owl::NameId> others;
  for (const owl::TermId term : input.order.terms) {
    std::uint32_t& number = number_of[static_cast<std::size_t>(source.term(term).name)];
    if (number != none || source.name_of(term).empty()) continue;
    number = 0;  // until they are sorted
    others.push_back(source.term(term).name);
  }
  std::ranges::sort(others, {}, [&](owl::NameId id) { return source.name(id); });
  const std::uint32_t empty = count++;
  out.name_end.push_back(0);
  for (const owl::NameId id : others) {
    const std::string_view name = source.name(id);
    out.text.insert(out.text.end(), name.begin(), name.end());
    out.name_end.push_back(static_cast<std::uint32_t>(out.text.size()));
    number_of[static_cast<std::size_t>(id)] = count++;
  }
  for (const owl::TermId term : input.order.terms) {
    std::uint32_t& number = number_of[static_cast<std::size_t>(source.term(term).name)];
    if (number == none) number = empty;
  }
  return number_of;
}

void write_terms(const CompilerInput& input, const std::vector<std::uint32_t>& number_of_name, form::AxiomsT& out) {
  out.term_begin.push_back(0);
  for (const owl::TermId id : input.order.terms) {
    const owl::Term term = input.source.term(id);
    out.term_kind.push_back(static_cast<std::uint8_t>(term.kind));
    out.term_word.push_back(taxonomy::ClassifiedView::is_cardinality(term.kind)
                                ? term.number
                                : number_of_name[static_cast<std::size_t>(term.name)]);
    for (const owl::TermId argument :
         input.hashes.sorted(term.arguments, set_begin(term.kind, term.arguments.size()))) {
      out.term_arguments.push_back(input.order.number_of_term[static_cast<std::size_t>(argument)]);
    }
    out.term_begin.push_back(static_cast<std::uint32_t>(out.term_arguments.size()));
  }
}

void write_statements(const CompilerInput& input, form::AxiomsT& out) {
  out.axiom_begin.push_back(0);
  for (const auto& axiom : input.order.axioms) {
    out.axiom_kind.push_back(static_cast<std::uint8_t>(input.source.axiom(axiom.axiom).kind));
    out.axiom_file.push_back(static_cast<std::uint16_t>(axiom.file));
    out.axiom_line.push_back(axiom.line);
    for (const owl::TermId argument : axiom.arguments) {
      out.axiom_arguments.push_back(input.order.number_of_term[static_cast<std::size_t>(argument)]);
    }
    out.axiom_begin.push_back(static_cast<std::uint32_t>(out.axiom_arguments.size()));
  }
}

/// Writes the axioms that were not used in full, with the first place where each stands.
void write_unused(const CompilerInput& input, const form::TaxonomyT& taxonomy, form::AxiomsT& out) {
  std::map<std::string_view, std::uint32_t> groups;
  for (std::uint32_t group = 0; group < taxonomy.left_out.size(); ++group) {
    groups.emplace(taxonomy.left_out[group]->construct, group);
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> unused;
  for (const taxonomy::UnusedAxiom& one : input.classification.unused) {
    const auto group = groups.find(one.construct);
    if (group != groups.end()) unused.emplace_back(input.order.number_of_axiom[one.axiom], group->second);
  }
  std::ranges::sort(unused);
  for (const auto& [axiom, group] : unused) {
    out.unused_axiom.push_back(axiom);
    out.unused_group.push_back(group);
  }
}

/// A view of what has been written so far, without the tables of modules.
taxonomy::ClassifiedView view_of(const form::TaxonomyT& taxonomy, const form::AxiomsT& axioms) {
  taxonomy::ClassifiedView view;
  view.class_text = {reinterpret_cast<const char*>(taxonomy.class_text.data()), taxonomy.class_text.size()};
  view.class_end = taxonomy.class_end;
  view.term_text = {reinterpret_cast<const char*>(axioms.text.data()), axioms.text.size()};
  view.name_end = axioms.name_end;
  view.term_kind = axioms.term_kind;
  view.term_word = axioms.term_word;
  view.term_begin = axioms.term_begin;
  view.term_arguments = axioms.term_arguments;
  view.axiom_kind = axioms.axiom_kind;
  view.axiom_begin = axioms.axiom_begin;
  view.axiom_arguments = axioms.axiom_arguments;
  return view;
}

}  // namespace

bool write_axioms(const CompilerInput& input, const form::TaxonomyT& taxonomy, form::AxiomsT& out) {
  if (input.order.files.size() > 0xffff) return false;  // axiom_file has sixteen bits
  write_terms(input, number_names(input, out), out);
  write_statements(input, out);
  write_unused(input, taxonomy, out);
  modules::ModuleTables tables = modules::make_module_tables(view_of(taxonomy, out));
  if (tables.waiting.size() > max_list_items) return false;
  out.built_in = std::move(tables.built_in);
  out.uses = std::move(tables.uses);
  out.term_of_class = std::move(tables.term_of_class);
  out.waiting_begin = std::move(tables.waiting_begin);
  out.waiting = std::move(tables.waiting);
  out.unconditional = std::move(tables.unconditional);
  return true;
}

}  // namespace geminga::compiled
