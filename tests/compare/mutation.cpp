#include "compare/mutation.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "compare/edits.hpp"
#include "reasoning/dl/clauses/clausify.hpp"
#include "reasoning/modules/signature_module.hpp"

namespace geminga::compare {
namespace {

using owl::AxiomKind;
using owl::TermId;
using owl::TermKind;

/// Edits of one mutation. With many more, nearly all ontologies of individuals have a contradiction.
constexpr std::size_t most_edits = 100;

/// The axioms to take from an original, ascending, and a word for how they were chosen.
std::pair<std::vector<std::uint32_t>, std::string> sample(const owl::Ontology& original, base::Random& random) {
  std::vector<std::uint32_t> all(original.axiom_count());
  std::iota(all.begin(), all.end(), 0U);
  const std::uint64_t draw = random.below(10);
  if (draw < 3) return {all, "whole"};
  if (draw < 6) {
    std::vector<TermId> names;
    for (std::uint32_t id = 0; id < original.term_count(); ++id) {
      if (original.kind(TermId{id}) == TermKind::named_class) names.push_back(TermId{id});
    }
    std::vector<TermId> signature;
    for (std::size_t left = 1 + random.below(12); left > 0 && !names.empty(); --left)
      signature.push_back(names[random.below(names.size())]);
    const auto kind = random.chance(0.5) ? modules::ModuleKind::bottom : modules::ModuleKind::top;
    std::vector<std::uint32_t> module = modules::extract_module(original, signature, kind);
    if (module.size() > 10) return {std::move(module), "module"};
  }
  const std::uint64_t percent = 30 + random.below(70);
  std::erase_if(all, [&](std::uint32_t) { return random.below(100) >= percent; });
  return {all, std::to_string(percent) + " %"};
}

/// The axioms of several originals over the terms of one ontology.
struct Draft {
  owl::Ontology terms;
  std::vector<Statement> axioms;
};

/// Adds axioms. Some names of the original become names that the draft has, so that the two meet.
void join(Draft& draft, const owl::Ontology& original, std::span<const std::uint32_t> axioms, std::size_t place,
          base::Random& random) {
  std::array<std::vector<TermId>, 6> names;  // of the draft, by kind
  for (std::uint32_t id = 0; id < draft.terms.term_count() && place > 0; ++id) {
    const TermKind kind = draft.terms.kind(TermId{id});
    if (kind <= TermKind::individual && !draft.terms.name_of(TermId{id}).starts_with("http://www.w3.org/"))
      names[static_cast<std::size_t>(kind)].push_back(TermId{id});
  }
  std::vector<TermId> mapped;
  for (std::uint32_t id = 0; id < original.term_count(); ++id) {
    const owl::Term term = original.term(TermId{id});
    std::string name(original.name(term.name));
    std::vector<TermId> arguments;
    for (const TermId part : term.arguments) arguments.push_back(mapped[static_cast<std::size_t>(part)]);
    if (term.kind == TermKind::anonymous_individual) name += '.' + std::to_string(place);
    const bool is_name = term.kind <= TermKind::individual && !name.starts_with("http://www.w3.org/");
    const bool may_meet = is_name && !names[static_cast<std::size_t>(term.kind)].empty();
    if (may_meet && random.chance(term.kind == TermKind::named_class ? 0.05 : 0.1)) {
      const std::vector<TermId>& others = names[static_cast<std::size_t>(term.kind)];
      mapped.push_back(others[random.below(others.size())]);
    } else {
      mapped.push_back(draft.terms.copy(term.kind, name, term.number, arguments));
    }
  }
  for (const std::uint32_t number : axioms) {
    const owl::Axiom axiom = original.axiom(number);
    if (axiom.kind == AxiomKind::declaration || axiom.kind == AxiomKind::dl_safe_rule) continue;
    Statement statement{axiom.kind, {}};
    for (const TermId id : axiom.arguments) statement.arguments.push_back(mapped[static_cast<std::size_t>(id)]);
    draft.axioms.push_back(std::move(statement));
  }
}

/// The ontology of the draft's axioms, without terms that no axiom has.
owl::Ontology finished(const Draft& draft) {
  owl::Ontology source;
  const owl::FileId file = source.add_file("mutation");
  for (std::size_t at = 0; at < draft.axioms.size(); ++at) {
    std::vector<TermId> arguments;
    for (const TermId id : draft.axioms[at].arguments) arguments.push_back(source.copy(draft.terms, id));
    source.add(draft.axioms[at].kind, arguments, file, static_cast<std::uint32_t>(at + 1));
  }
  for (std::uint32_t id = 0, count = static_cast<std::uint32_t>(source.term_count()); id < count; ++id) {
    if (source.kind(TermId{id}) <= TermKind::individual &&
        !source.name_of(TermId{id}).starts_with("http://www.w3.org/"))
      source.add(AxiomKind::declaration, {TermId{id}}, file, 0);
  }
  return source;
}

/// Takes out the axioms that OWL 2 DL forbids. A chain that goes may leave others regular, so one look is enough.
void keep_to_dl(Draft& draft) {
  const owl::Ontology source = finished(draft);
  const auto set = clauses::clausify(source, {}, {});
  if (!set) return;
  std::vector<bool> is_forbidden(draft.axioms.size());
  for (const auto& unused : set->unused) {
    const std::uint32_t line = source.axiom(unused.axiom).line;
    if (line > 0) is_forbidden[line - 1] = true;
  }
  std::size_t at = 0;
  std::erase_if(draft.axioms, [&](const Statement&) { return bool{is_forbidden[at++]}; });
}

}  // namespace

Mutation mutation(std::span<const owl::Ontology* const> originals, std::uint64_t seed, std::size_t facts) {
  base::Random random(seed);
  Draft draft;
  std::string words;
  for (std::size_t place = 0; place < originals.size(); ++place) {
    const auto [axioms, choice] = sample(*originals[place], random);
    join(draft, *originals[place], axioms, place, random);
    words += (place == 0 ? "" : ", ") + choice;
  }
  const std::uint64_t per_thousand = random.chance(0.7) ? 3 + random.below(38) : 40 + random.below(160);
  const std::size_t edits = std::min(draft.axioms.size() * per_thousand / 1000 + 2 + random.below(8), most_edits);
  Editor editor(draft.terms, draft.axioms, random);
  for (std::size_t left = edits; left > 0; --left) editor.edit();
  for (std::size_t left = facts; left > 0; --left) editor.add_about_individuals();
  const bool is_dl = !random.chance(0.05);
  if (is_dl) keep_to_dl(draft);
  words += ", " + std::to_string(draft.axioms.size()) + " axioms, " + std::to_string(edits) + " edits";
  if (!is_dl) words += ", maybe not OWL 2 DL";
  return {finished(draft), std::move(words)};
}

}  // namespace geminga::compare
