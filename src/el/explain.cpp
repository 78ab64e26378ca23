// Module, then the minimal set, then an order in which one reads it.
#include "el/explain.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "el/entailment.hpp"
#include "el/module.hpp"

namespace geminga::el {
namespace {

using Numbers = std::vector<std::uint32_t>;
using Holds = std::function<bool(std::span<const std::uint32_t>)>;

/// What of `candidates` is needed beside `given`. `has_grown`: given changed since holds(given) was last found false.
Numbers find_needed(Numbers given, bool has_grown, const Numbers& candidates, const Holds& holds) {
  if (has_grown && holds(given)) return {};
  if (candidates.size() == 1) return candidates;
  const auto half = candidates.begin() + static_cast<std::ptrdiff_t>(candidates.size() / 2);
  const Numbers first(candidates.begin(), half);
  const Numbers second(half, candidates.end());
  Numbers with_first = given;
  with_first.insert(with_first.end(), first.begin(), first.end());
  Numbers needed = find_needed(std::move(with_first), !first.empty(), second, holds);
  given.insert(given.end(), needed.begin(), needed.end());
  const Numbers more = find_needed(std::move(given), !needed.empty(), first, holds);
  needed.insert(needed.end(), more.begin(), more.end());
  return needed;
}

/// Copies axioms out of a compiled ontology.
class Copier {
 public:
  Copier(const CompiledView& view, OntologySource& source) : view_(view), source_(source) {
    for (const LoadedFile& file : files_of(view)) source_.add_file(file.path, file.ontology_iri);
  }

  void copy(std::uint32_t axiom) {
    std::vector<TermId> arguments;
    for (const std::uint32_t argument : view_.arguments_of_axiom(axiom)) arguments.push_back(copy_term(argument));
    source_.add(view_.kind_of_axiom(axiom), arguments, FileId{view_.axiom_file[axiom]}, view_.axiom_line[axiom]);
  }

 private:
  TermId copy_term(std::uint32_t term) {
    std::vector<TermId> arguments;
    for (const std::uint32_t argument : view_.arguments_of_term(term)) arguments.push_back(copy_term(argument));
    return source_.copy(view_.kind_of_term(term), view_.name(view_.term_name[term]), view_.term_number[term],
                        arguments);
  }

  const CompiledView& view_;
  OntologySource& source_;
};

void collect_entities(const OntologySource& source, TermId id, std::vector<TermId>& entities) {
  const Term term = source.term(id);
  if (term.arguments.empty() && term.kind != TermKind::datatype) entities.push_back(id);
  for (const TermId argument : term.arguments) collect_entities(source, argument, entities);
}

/// What an axiom is about: an individual of a fact, else its first argument.
TermId subject_of(const Axiom& axiom) {
  const bool is_fact = axiom.kind >= AxiomKind::class_assertion && axiom.arguments.size() > 1;
  return axiom.arguments[is_fact ? 1 : 0];
}

/// Puts axioms into an order in which each speaks, where possible, of what was spoken of before.
Numbers in_order_of_argument(const OntologySource& source, Numbers axioms, TermId sub) {
  std::vector<TermId> known = {sub};
  Numbers ordered;
  const auto is_known = [&](TermId id) { return std::ranges::find(known, id) != known.end(); };
  while (!axioms.empty()) {
    std::size_t best = 0;
    std::size_t best_score = 0;
    for (std::size_t at = 0; at < axioms.size(); ++at) {
      const Axiom axiom = source.axiom(axioms[at]);
      std::vector<TermId> subject;
      collect_entities(source, subject_of(axiom), subject);
      std::vector<TermId> all;
      for (const TermId argument : axiom.arguments) collect_entities(source, argument, all);
      const bool follows = std::ranges::all_of(subject, is_known);
      const std::size_t score = (follows ? 2U : 0U) + (std::ranges::any_of(all, is_known) ? 1U : 0U);
      if (score > best_score) {
        best_score = score;
        best = at;
      }
    }
    const Axiom axiom = source.axiom(axioms[best]);
    for (const TermId argument : axiom.arguments) collect_entities(source, argument, known);
    ordered.push_back(axioms[best]);
    axioms.erase(axioms.begin() + static_cast<std::ptrdiff_t>(best));
  }
  return ordered;
}

}  // namespace

std::vector<std::uint32_t> find_minimal(std::vector<std::uint32_t> candidates, const Holds& holds) {
  if (candidates.empty() || holds({})) return {};
  Numbers minimal = find_needed({}, false, candidates, holds);
  std::ranges::sort(minimal);
  return minimal;
}

std::optional<Excerpt> explain(const ModuleIndex& index, std::uint32_t sub, std::uint32_t super) {
  const CompiledView& view = index.view();
  Numbers module = extract_module(index, std::array{ClassNumber{sub}, ClassNumber{super}});
  std::ranges::sort(module);
  for (const bool is_retry : {false, true}) {
    Excerpt excerpt;
    Copier copier(view, excerpt.source);
    // Where the module is not enough for the rules, which are not all of OWL, all axioms are.
    if (is_retry) {
      module.resize(view.axiom_count());
      for (std::uint32_t axiom = 0; axiom < view.axiom_count(); ++axiom) module[axiom] = axiom;
    }
    for (const std::uint32_t axiom : module) copier.copy(axiom);
    excerpt.sub = excerpt.source.named_class(view.name(view.class_name[sub]));
    excerpt.super = excerpt.source.named_class(view.name(view.class_name[super]));
    const auto holds = [&](std::span<const std::uint32_t> axioms) {
      return entails(excerpt.source, axioms, excerpt.sub, excerpt.super);
    };
    Numbers all(excerpt.source.axiom_count());
    for (std::uint32_t axiom = 0; axiom < all.size(); ++axiom) all[axiom] = axiom;
    if (!holds(all)) continue;
    excerpt.axioms = in_order_of_argument(excerpt.source, find_minimal(all, holds), excerpt.sub);
    return excerpt;
  }
  return std::nullopt;
}

}  // namespace geminga::el
