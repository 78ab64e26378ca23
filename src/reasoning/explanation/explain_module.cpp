// Terms are copied once, with their parts.
#include "reasoning/explanation/explain_module.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "reasoning/modules/module.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/print.hpp"

namespace geminga::explanation {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::Ontology;
using owl::Term;
using owl::TermId;
using owl::TermKind;

std::vector<TermId> entities_in(const Ontology& source, std::span<const TermId> terms) {
  std::vector<TermId> entities = owl::terms_in(source, terms);
  std::erase_if(entities, [&](TermId id) {
    const Term term = source.term(id);
    return !term.arguments.empty() || term.kind == TermKind::datatype;
  });
  return entities;
}

/// The subject of an axiom: the individual of a fact, else the first argument.
TermId subject_of(const Axiom& axiom) {
  const bool is_fact = axiom.kind >= AxiomKind::class_assertion && axiom.arguments.size() > 1;
  return axiom.arguments[is_fact ? 1 : 0];
}

}  // namespace

Module::Module(const compiled::Ontology& ontology, std::span<const taxonomy::ClassNumber> classes,
               std::span<const std::uint32_t> more_terms, std::size_t most)
    : ontology_(ontology), classes_(classes.begin(), classes.end()), more_terms_(more_terms.begin(), more_terms.end()) {
  for (const owl::LoadedFile& file : ontology.files()) source_.add_file(file.path, file.ontology_iri);
  const auto axioms = modules::extract_module(ontology.module_index(), classes, more_terms, most);
  for (const std::uint32_t axiom : axioms) copy(axiom);
  is_begun_ = axioms.size() == most;
}

void Module::complete() {
  if (!std::exchange(is_begun_, false)) return;
  const std::vector<bool> is_copied = copied();
  for (const std::uint32_t axiom : modules::extract_module(ontology_.module_index(), classes_, more_terms_)) {
    if (!is_copied[axiom]) copy(axiom);
  }
}

std::vector<bool> Module::copied() const {
  std::vector<bool> is_copied(ontology_.axioms().axiom_count(), false);
  for (const std::uint32_t axiom : originals_) is_copied[axiom] = true;
  return is_copied;
}

void Module::add_rest() {
  const taxonomy::ClassifiedView& view = ontology_.axioms();
  const std::vector<bool> is_copied = copied();
  for (std::uint32_t axiom = 0; axiom < view.axiom_count(); ++axiom) {
    if (!is_copied[axiom] && view.kind_of_axiom(axiom) != AxiomKind::declaration) copy(axiom);
  }
}

void Module::copy(std::uint32_t axiom) {
  const taxonomy::ClassifiedView& view = ontology_.axioms();
  std::vector<TermId> arguments;
  for (const std::uint32_t argument : view.arguments_of_axiom(axiom)) arguments.push_back(copy_term(argument));
  source_.add(view.kind_of_axiom(axiom), arguments, owl::FileId{view.axiom_file[axiom]}, view.axiom_line[axiom]);
  originals_.push_back(axiom);
  axiom_count_ = static_cast<std::uint32_t>(originals_.size());
}

TermId Module::copy_term(std::uint32_t term) {
  if (const auto known = terms_.find(term); known != terms_.end()) return known->second;
  const taxonomy::ClassifiedView& view = ontology_.axioms();
  std::vector<TermId> arguments;
  for (const std::uint32_t argument : view.arguments_of_term(term)) arguments.push_back(copy_term(argument));
  const TermId copied =
      source_.copy(view.kind_of_term(term), view.name_of_term(term), view.number_of_term(term), arguments);
  terms_.emplace(term, copied);
  return copied;
}

AxiomSet Module::all() const {
  AxiomSet numbers(axiom_count_);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

TermId Module::term(taxonomy::ClassNumber number) { return source_.named_class(ontology_.iri(number)); }

ExplainedAxiom Module::explained(std::uint32_t number) const {
  const Axiom axiom = source_.axiom(number);
  const auto shorten = [&](std::string_view iri) { return ontology_.short_name(iri); };
  return {owl::print(source_, axiom, shorten), source_.files()[static_cast<std::size_t>(axiom.file)].path, axiom.line};
}

ExplainedAxiom Module::explained_original(std::uint32_t axiom) {
  const taxonomy::ClassifiedView& view = ontology_.axioms();
  std::vector<TermId> arguments;
  for (const std::uint32_t argument : view.arguments_of_axiom(axiom)) arguments.push_back(copy_term(argument));
  const auto shorten = [&](std::string_view iri) { return ontology_.short_name(iri); };
  const Axiom copied{view.kind_of_axiom(axiom), owl::FileId{view.axiom_file[axiom]}, view.axiom_line[axiom], arguments};
  return {owl::print(source_, copied, shorten), source_.files()[static_cast<std::size_t>(copied.file)].path,
          copied.line};
}

std::string Module::print(TermId term) const {
  return owl::print(source_, term, [&](std::string_view iri) { return ontology_.short_name(iri); });
}

AxiomSet Module::in_order_of_argument(AxiomSet axioms, TermId first) const {
  std::vector<TermId> known = {first};
  AxiomSet ordered;
  const auto is_known = [&](TermId id) { return std::ranges::find(known, id) != known.end(); };
  while (!axioms.empty()) {
    std::size_t best = 0;
    std::size_t best_score = 0;
    for (std::size_t at = 0; at < axioms.size(); ++at) {
      const Axiom axiom = source_.axiom(axioms[at]);
      const TermId subject_term = subject_of(axiom);
      const std::vector<TermId> subject = entities_in(source_, std::span(&subject_term, 1));
      const std::vector<TermId> all = entities_in(source_, axiom.arguments);
      const bool follows = std::ranges::all_of(subject, is_known);
      const std::size_t score = (follows ? 2U : 0U) + (std::ranges::any_of(all, is_known) ? 1U : 0U);
      if (score > best_score) {
        best_score = score;
        best = at;
      }
    }
    const Axiom axiom = source_.axiom(axioms[best]);
    std::ranges::copy(entities_in(source_, axiom.arguments), std::back_inserter(known));
    ordered.push_back(axioms[best]);
    axioms.erase(axioms.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return ordered;
}

}  // namespace geminga::explanation
