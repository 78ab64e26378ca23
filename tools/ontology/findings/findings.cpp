#include "ontology/findings/findings.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "base/sorted.hpp"
#include "ontology/command/words.hpp"
#include "ontology/findings/axioms.hpp"
#include "ontology/findings/touched_classes.hpp"
#include "ontology/loading/consistency.hpp"
#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/explanation/allowance.hpp"
#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/explanation/unsatisfiable.hpp"
#include "reasoning/owl/prefixes/prefixes.hpp"
#include "reasoning/owl/print.hpp"
#include "reasoning/reasoner/excerpt.hpp"

namespace geminga::ontology {
namespace {

/// The most constructs and gaps that the line of the verdict names.
constexpr std::size_t max_reasons = 4;

void sort_axioms(std::vector<LeftOutGroup>& groups) {
  for (LeftOutGroup& entry : groups) {
    std::ranges::sort(entry.axioms, {}, [](const explanation::ExplainedAxiom& axiom) {
      return std::tie(axiom.file, axiom.line, axiom.text);
    });
  }
}

void add_places(const owl::Ontology& source, const owl::Ontology::Omission& omission, LeftOutGroup& to) {
  const std::string& file = source.files()[static_cast<std::size_t>(omission.file)].path;
  for (const std::uint32_t line : omission.lines) to.places.push_back({file, line});
}

void sort_places(std::vector<LeftOutGroup>& groups) {
  for (LeftOutGroup& entry : groups) base::sort_unique(entry.places);
}

std::vector<LeftOutGroup> group(const ClassifiedFiles& classified) {
  const owl::Ontology& source = classified.loaded.source;
  const auto short_name = short_names(source);
  std::vector<LeftOutGroup> groups;
  std::map<std::string_view, std::size_t> place;
  for (owl::LeftOut& summary : taxonomy::left_out(source, classified.classification)) {
    groups.push_back({std::move(summary), {}, {}});
  }
  for (std::size_t at = 0; at < groups.size(); ++at) place.emplace(groups[at].summary.construct, at);
  for (const taxonomy::UnusedAxiom& unused : classified.classification.unused) {
    const auto found = place.find(unused.construct);
    if (found == place.end()) continue;
    const owl::Axiom axiom = source.axiom(unused.axiom);
    groups[found->second].axioms.push_back(
        {owl::print(source, axiom, short_name), source.files()[static_cast<std::size_t>(axiom.file)].path, axiom.line});
  }
  for (const owl::Ontology::Omission& omission : source.omissions()) {
    const auto found = place.find(source.name(omission.construct));
    if (found != place.end()) add_places(source, omission, groups[found->second]);
  }
  sort_axioms(groups);
  sort_places(groups);
  return groups;
}

std::vector<LeftOutGroup> remarks_of(const owl::Ontology& source) {
  std::map<std::string_view, LeftOutGroup> remarks;
  for (const owl::Ontology::Omission& remark : source.remarks()) {
    const auto file = static_cast<std::uint32_t>(remark.file);
    const std::string_view text = source.name(remark.construct);
    const auto [found, is_new] =
        remarks.try_emplace(text, LeftOutGroup{{std::string(text), 0, {}, file, remark.line}, {}, {}});
    if (is_new) found->second.summary.first = place(source.files()[file].path, remark.line);
    found->second.summary.count += remark.count;
    add_places(source, remark, found->second);
  }
  std::vector<LeftOutGroup> found;
  for (auto& [text, remark] : remarks) found.push_back(std::move(remark));
  sort_places(found);
  return found;
}

std::vector<LeftOutGroup> group(const compiled::Ontology& ontology) {
  std::vector<LeftOutGroup> groups;
  for (owl::LeftOut& summary : ontology.left_out()) groups.push_back({std::move(summary), {}, {}});
  const taxonomy::ClassifiedView& view = ontology.axioms();
  explanation::Module module(ontology, {});
  for (std::size_t at = 0; at < view.unused_axiom.size(); ++at) {
    groups[view.unused_group[at]].axioms.push_back(module.explained_original(view.unused_axiom[at]));
  }
  sort_axioms(groups);
  return groups;
}

Open find_open(const ClassifiedFiles& classified, const compiled::Ontology& ontology) {
  const reasoner::Undecided& undecided = classified.classification.undecided;
  Open open;
  for (const taxonomy::ClassNumber of : undecided.classes) open.classes.push_back(ontology.short_name(of));
  if (undecided.held_up_by) open.held_up_by = ontology.short_name(*undecided.held_up_by);
  return open;
}

std::vector<explanation::ExplainedAxiom> contradiction_of(const compiled::Ontology& ontology, base::Budget& budget) {
  const auto thing = ontology.find_iri(owl::owl_thing);
  const auto nothing = ontology.find_iri(owl::owl_nothing);
  if (!thing || !nothing) return {};
  explanation::Allowance allowance(&budget, explanation::steps_of_reasons(ontology.axiom_count()));
  explanation::Explainer explainer(ontology, *thing, *nothing, explanation::Patience::of_a_person, &allowance.budget());
  const auto found = explainer.find_one();
  if (!found || allowance.budget().is_spent()) return {};  // it need not be minimal
  return explainer.explained(*found);
}

/// Requires an ontology without a contradiction.
std::vector<Unsatisfiable> find_unsatisfiable(const compiled::Ontology& ontology, base::Budget& budget) {
  std::vector<Unsatisfiable> found;
  for (explanation::Unsatisfiable& one : explanation::find_unsatisfiable(ontology, &budget)) {
    found.push_back({ontology.short_name(one.number), std::nullopt, std::move(one.reason)});
    if (one.root) found.back().root = ontology.short_name(*one.root);
  }
  return found;
}

/// Adds the findings that files and compiled ontologies have alike: unsatisfiable classes, reasons and collisions.
void find_problems(const compiled::Ontology& ontology, Findings& findings, base::Budget& budget) {
  findings.is_consistent = ontology.is_consistent();
  findings.collisions = find_collisions(ontology);
  if (findings.is_consistent) {
    findings.unsatisfiable = find_unsatisfiable(ontology, budget);
    return;
  }
  findings.contradiction = contradiction_of(ontology, budget);
}

/// Classifies the terminology without the facts. The commonest contradiction is an instance of a class that can have
/// none, and only without facts does the ontology show which class that is.
void find_unsatisfiable_without_facts(const owl::Ontology& source, Findings& findings, base::Budget& budget) {
  std::vector<std::uint32_t> terminology;
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    if (source.axiom(number).kind < owl::AxiomKind::same_individual) terminology.push_back(number);
  }
  if (terminology.size() == source.axiom_count()) return;
  findings.is_searched_without_facts = false;
  reasoner::Excerpt excerpt(source, terminology);
  const owl::Prefixes prefixes(source);
  for (const auto& [word, iri] : prefixes.all()) excerpt.source.add_prefix(word, iri);
  explanation::Allowance allowance(&budget, explanation::steps_of_reasons(terminology.size()));
  const auto classified = reasoner::classify(excerpt.source, {.budget = &allowance.budget()});
  if (!classified) return;
  if (!classified->is_consistent) {
    findings.is_searched_without_facts = true;  // each of them is one
    return;
  }
  const auto ontology = compiled::Ontology::from_bytes(compiled::compile(excerpt.source, *classified));
  if (!ontology) return;
  findings.is_searched_without_facts = !classified->is_cut_off;
  findings.unsatisfiable = find_unsatisfiable(*ontology, budget);
}

void note(reasoner::Answer consistency, Findings& findings) {
  findings.open.consistency = consistency.verdict == reasoner::Verdict::unknown;
  findings.consistency = std::move(consistency);
}

/// Says which classes left-out axioms may matter to, where all that was left out are axioms.
void find_touched(const compiled::Ontology& ontology, Findings& findings) {
  const auto has_all_axioms = [](const LeftOutGroup& entry) { return entry.axioms.size() == entry.summary.count; };
  if (findings.left_out.empty() || !findings.is_consistent || !findings.gaps.empty() ||
      !findings.sources.refused.empty() || !std::ranges::all_of(findings.left_out, has_all_axioms))
    return;
  const auto touched = find_touched_classes(ontology);
  if (!touched) return;
  findings.touched.emplace();
  for (const taxonomy::ClassNumber number : *touched) findings.touched->push_back(ontology.short_name(number));
}

void find_units(const compiled::Ontology& ontology, Sources& sources) {
  sources.units = ontology.units().size();
  sources.units_left_out = ontology.units_left_out();
}

}  // namespace

Findings find(ClassifiedFiles& classified, const compiled::Ontology& ontology, base::Budget& budget) {
  const rdf::Loaded& loaded = classified.loaded;
  Findings findings;
  findings.sources.files.assign(loaded.source.files().begin(), loaded.source.files().end());
  findings.sources.triples = loaded.triples;
  findings.sources.classes = class_count(classified);
  findings.sources.axioms = classified.classification.counts.axioms;
  findings.sources.unresolved = loaded.unresolved;
  findings.sources.conflicts = loaded.conflicts;
  findings.sources.refused = loaded.refused;
  find_units(ontology, findings.sources);
  findings.left_out = group(classified);
  findings.remarks = remarks_of(loaded.source);
  findings.gaps = classified.classification.gaps;
  findings.open = find_open(classified, ontology);
  findings.names = find_doubtful_names(loaded);
  find_problems(ontology, findings, budget);
  if (!findings.is_consistent) find_unsatisfiable_without_facts(loaded.source, findings, budget);
  find_touched(ontology, findings);
  note(consistency_of(classified, &budget), findings);
  return findings;
}

Findings find(const compiled::Ontology& ontology, base::Budget& budget) {
  Findings findings;
  findings.sources.files = ontology.files();
  findings.sources.classes = std::max(ontology.class_count(), 2U) - 2;  // without owl:Thing and owl:Nothing
  findings.sources.axioms = ontology.axiom_count();
  findings.sources.outgrown = ontology.stale_source();
  find_units(ontology, findings.sources);
  findings.left_out = group(ontology);
  findings.gaps = ontology.gaps();
  find_problems(ontology, findings, budget);
  findings.is_searched_without_facts =
      findings.is_consistent;  // the file keeps one classification, that with the facts
  find_touched(ontology, findings);
  note(consistency_of(ontology), findings);
  return findings;
}

std::string verdict(const Findings& findings) {
  if (!findings.is_consistent)
    return "Contradiction: no robot's world can be as these files say, so everything follows from them.";
  if (findings.is_complete()) return "Complete: everything that follows from these files was found.";
  std::vector<std::string> reasons;
  for (const LeftOutGroup& entry : findings.left_out)
    reasons.push_back(entry.summary.construct + " (" + std::to_string(entry.summary.count) + ')');
  if (const std::size_t count = findings.sources.refused.size(); count > 0)
    reasons.push_back(counted(count, "file", "files") + " that cannot be read");
  reasons.insert(reasons.end(), findings.gaps.begin(), findings.gaps.end());
  std::string text = "Incomplete: every answer is right, but some may be missing, because of ";
  for (std::size_t at = 0; at < std::min(reasons.size(), max_reasons); ++at)
    text += (at == 0 ? "" : ", ") + reasons[at];
  if (reasons.size() > max_reasons) text += " and " + std::to_string(reasons.size() - max_reasons) + " more";
  text += '.';
  if (findings.touched)
    text += " All superclasses of " + std::to_string(findings.sources.classes - findings.touched->size()) + " of " +
            counted(findings.sources.classes, "class", "classes") + " were found.";
  return text;
}

std::string unresolved_as_text(const std::vector<rdf::UnresolvedImport>& unresolved) {
  if (unresolved.empty()) return {};
  std::string text = "Imports that no given file answers (nothing is fetched: name the files, too):\n";
  for (const rdf::UnresolvedImport& import : unresolved)
    text += "  <" + import.iri + "> at " + place(import.file, import.line) + '\n';
  return text;
}

}  // namespace geminga::ontology
