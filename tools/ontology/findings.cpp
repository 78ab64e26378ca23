// Gathers what is known after classification; derives nothing itself but the reasons of empty classes.
#include "findings.hpp"

#include <algorithm>
#include <boost/json.hpp>
#include <map>
#include <tuple>

#include "reasoning/compiled/compile.hpp"
#include "reasoning/compiled/compiled_view.hpp"
#include "reasoning/explanation/explain_module.hpp"
#include "reasoning/owl/print.hpp"
#include "reasoning/reasoner/excerpt.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

/// So many constructs and gaps are named in the one line of the verdict.
constexpr std::size_t max_reasons = 4;

void sort_axioms(std::vector<LeftOutGroup>& groups) {
  for (LeftOutGroup& entry : groups) {
    std::ranges::sort(entry.axioms, {},
                      [](const LeftOutAxiom& axiom) { return std::tie(axiom.file, axiom.line, axiom.axiom); });
  }
}

std::vector<LeftOutGroup> group(const Knowledge& knowledge) {
  const owl::Ontology& source = knowledge.loaded.source;
  const auto short_name = short_names(source);
  std::vector<LeftOutGroup> groups;
  std::map<std::string_view, std::size_t> place;
  for (owl::LeftOut& summary : taxonomy::left_out(source, knowledge.classification)) {
    groups.push_back({std::move(summary), {}});
  }
  for (std::size_t at = 0; at < groups.size(); ++at) place.emplace(groups[at].summary.construct, at);
  for (const taxonomy::UnusedAxiom& unused : knowledge.classification.unused) {
    const auto found = place.find(unused.construct);
    if (found == place.end()) continue;
    const owl::Axiom axiom = source.axiom(unused.axiom);
    groups[found->second].axioms.push_back(
        {owl::print(source, axiom, short_name), source.files()[static_cast<std::size_t>(axiom.file)].path, axiom.line});
  }
  sort_axioms(groups);
  return groups;
}

std::vector<LeftOutGroup> group(const compiled::Ontology& ontology) {
  std::vector<LeftOutGroup> groups;
  for (owl::LeftOut& summary : ontology.left_out()) groups.push_back({std::move(summary), {}});
  const taxonomy::ClassifiedView& view = ontology.axioms();
  explanation::Module module(ontology, {});
  for (std::size_t at = 0; at < view.unused_axiom.size(); ++at) {
    explanation::ExplainedAxiom axiom = module.explained_original(view.unused_axiom[at]);
    groups[view.unused_group[at]].axioms.push_back({std::move(axiom.text), std::move(axiom.file), axiom.line});
  }
  sort_axioms(groups);
  return groups;
}

Open find_open(const Knowledge& knowledge, const compiled::Ontology& ontology) {
  const reasoner::Undecided& undecided = knowledge.classification.undecided;
  Open open;
  open.consistency = undecided.consistency;
  for (const taxonomy::ClassNumber of : undecided.classes) open.classes.push_back(ontology.short_name(of));
  if (undecided.held_up_by) open.held_up_by = ontology.short_name(*undecided.held_up_by);
  return open;
}

/// What an explanation costs beside its counted work, in steps of a budget.
constexpr std::uint64_t steps_per_work = 10;

struct Reason {
  std::vector<explanation::ExplainedAxiom> axioms;
  bool was_hard = false;  ///< some question on the way was left undecided
};

Reason reason_of(const compiled::Ontology& ontology, taxonomy::ClassNumber sub, taxonomy::ClassNumber super,
                 base::Budget& budget, explanation::Patience patience) {
  if (!budget.spend(1)) return {};
  explanation::Explainer explainer(ontology, sub, super, patience);
  const auto found = explainer.find_one();
  static_cast<void>(budget.spend(steps_per_work * explainer.oracle().work()));
  Reason reason{{}, explainer.oracle().undecided_count() > 0};
  if (found) reason.axioms = explainer.explained(*found);
  return reason;
}

/// Of an ontology that does not contradict itself. There may be many reasons to find, so only easy ones are looked for,
/// and where one was hard, those of the other classes would be, too; `explain` takes its time.
std::vector<Unsatisfiable> find_unsatisfiable(const compiled::Ontology& ontology, base::Budget& budget) {
  std::vector<Unsatisfiable> found;
  bool was_hard = false;
  const auto nothing = ontology.find_iri(owl::owl_nothing);
  for (std::uint32_t number = 0; number < ontology.class_count() && nothing; ++number) {
    const taxonomy::ClassNumber named{number};
    if (named == *nothing || ontology.is_satisfiable(named)) continue;
    Unsatisfiable& one = found.emplace_back(ontology.short_name(named), std::vector<explanation::ExplainedAxiom>());
    if (found.size() > max_explained_classes || was_hard) continue;
    Reason reason = reason_of(ontology, named, *nothing, budget, explanation::Patience::of_a_daemon);
    one.reason = std::move(reason.axioms);
    was_hard = reason.was_hard;
  }
  return found;
}

/// Classes, reasons and collisions: what both kinds of ontologies are asked for.
void find_problems(const compiled::Ontology& ontology, Findings& findings, base::Budget& budget) {
  findings.is_consistent = ontology.is_consistent();
  findings.collisions = find_collisions(ontology);
  if (findings.is_consistent) {
    findings.unsatisfiable = find_unsatisfiable(ontology, budget);
    return;
  }
  const auto thing = ontology.find_iri(owl::owl_thing);
  const auto nothing = ontology.find_iri(owl::owl_nothing);
  if (thing && nothing)
    findings.contradiction = reason_of(ontology, *thing, *nothing, budget, explanation::Patience::of_a_person).axioms;
}

/// What is wrong with classes comes to light in a contradiction only where facts are left aside: an instance of a class
/// that can have none is the commonest of all.
void find_unsatisfiable_without_facts(const owl::Ontology& source, Findings& findings, base::Budget& budget) {
  std::vector<std::uint32_t> terminology;
  for (std::uint32_t number = 0; number < source.axiom_count(); ++number) {
    if (source.axiom(number).kind < owl::AxiomKind::same_individual) terminology.push_back(number);
  }
  if (terminology.size() == source.axiom_count()) return;
  reasoner::Excerpt excerpt(source, terminology);
  for (const owl::Ontology::Prefix& prefix : source.prefixes())
    excerpt.source.add_prefix(source.name(prefix.prefix), source.name(prefix.iri));
  const auto classified = reasoner::classify(excerpt.source, {.budget = &budget});
  if (!classified || !classified->is_consistent) return;
  const auto ontology = compiled::Ontology::from_bytes(compiled::compile(excerpt.source, *classified));
  if (ontology) findings.unsatisfiable = find_unsatisfiable(*ontology, budget);
}

boost::json::array axioms_as_json(const std::vector<explanation::ExplainedAxiom>& axioms) {
  boost::json::array list;
  for (const explanation::ExplainedAxiom& axiom : axioms)
    list.push_back(boost::json::object{{"axiom", axiom.text}, {"file", axiom.file}, {"line", axiom.line}});
  return list;
}

boost::json::array left_out_as_json(const Findings& findings) {
  boost::json::array list;
  for (const LeftOutGroup& entry : findings.left_out) {
    boost::json::object group{
        {"construct", entry.summary.construct}, {"count", entry.summary.count}, {"first", entry.summary.first}};
    boost::json::array& axioms = group["axioms"].emplace_array();
    for (const LeftOutAxiom& axiom : entry.axioms)
      axioms.push_back(boost::json::object{{"axiom", axiom.axiom}, {"file", axiom.file}, {"line", axiom.line}});
    list.push_back(std::move(group));
  }
  return list;
}

boost::json::array names_as_json(const std::vector<DoubtfulName>& names) {
  boost::json::array list;
  for (const DoubtfulName& name : names)
    list.push_back(boost::json::object{{"name", name.name},
                                       {"iri", name.iri},
                                       {"kind", name.kind},
                                       {"file", name.file},
                                       {"line", name.line},
                                       {"similar", boost::json::value_from(name.similar)}});
  return list;
}

void add_names(boost::json::object& document, const NameFindings& names) {
  document["unknown_words"] = names_as_json(names.unknown_words);
  document["undeclared"] = names_as_json(names.undeclared);
  boost::json::array& others = document["other_namespaces"].emplace_array();
  for (const OtherNamespace& other : names.others)
    others.push_back(boost::json::object{{"iri", other.iri}, {"names", other.names}, {"first", other.first}});
  boost::json::array& clashes = document["label_clashes"].emplace_array();
  for (const LabelClash& clash : names.clashes)
    clashes.push_back(boost::json::object{{"label", clash.label}, {"classes", boost::json::value_from(clash.classes)}});
}

void find_units(const compiled::Ontology& ontology, Sources& sources) {
  sources.units = ontology.units().size();
  sources.units_left_out = ontology.units_left_out();
}

boost::json::object units_as_json(const Sources& sources) {
  boost::json::object units{{"read", sources.units}};
  boost::json::array& left_out = units["left_out"].emplace_array();
  for (const owl::LeftOut& one : sources.units_left_out)
    left_out.push_back(boost::json::object{{"reason", one.construct}, {"count", one.count}, {"first", one.first}});
  return units;
}

}  // namespace

Findings find(const Knowledge& knowledge, const compiled::Ontology& ontology, base::Budget& budget) {
  const rdf::Loaded& loaded = knowledge.loaded;
  Findings findings;
  findings.sources.files.assign(loaded.source.files().begin(), loaded.source.files().end());
  findings.sources.triples = loaded.triples;
  findings.sources.classes = class_count(knowledge);
  findings.sources.axioms = knowledge.classification.counts.axioms;
  findings.sources.unresolved = loaded.unresolved;
  findings.sources.conflicts = loaded.conflicts;
  find_units(ontology, findings.sources);
  findings.left_out = group(knowledge);
  findings.gaps = knowledge.classification.gaps;
  findings.open = find_open(knowledge, ontology);
  findings.names = find_doubtful_names(loaded);
  find_problems(ontology, findings, budget);
  if (!findings.is_consistent) find_unsatisfiable_without_facts(loaded.source, findings, budget);
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
  return findings;
}

std::string verdict(const Findings& findings) {
  if (!findings.is_consistent)
    return "Contradiction: no robot's world can be as these files say, so everything follows from them.";
  if (findings.is_complete()) return "Complete: everything that follows from these files was found.";
  std::vector<std::string> reasons;
  for (const LeftOutGroup& entry : findings.left_out)
    reasons.push_back(entry.summary.construct + " (" + std::to_string(entry.summary.count) + ')');
  reasons.insert(reasons.end(), findings.gaps.begin(), findings.gaps.end());
  std::string text = "Incomplete: every answer is right, but some may be missing, because of ";
  for (std::size_t at = 0; at < std::min(reasons.size(), max_reasons); ++at)
    text += (at == 0 ? "" : ", ") + reasons[at];
  if (reasons.size() > max_reasons) text += " and " + std::to_string(reasons.size() - max_reasons) + " more";
  return text + '.';
}

std::string place(const std::string& file, std::uint32_t line) {
  return line == 0 ? file : file + ':' + std::to_string(line);
}

std::string unresolved_as_text(const std::vector<rdf::UnresolvedImport>& unresolved) {
  if (unresolved.empty()) return {};
  std::string text = "Imports that no given file answers (nothing is fetched: name the files, too):\n";
  for (const rdf::UnresolvedImport& import : unresolved)
    text += "  <" + import.iri + "> at " + place(import.file, import.line) + '\n';
  return text;
}

std::string as_json(const Findings& findings) {
  const Sources& sources = findings.sources;
  boost::json::object document{{"classes", sources.classes},           {"axioms", sources.axioms},
                               {"consistent", findings.is_consistent}, {"complete", findings.is_complete()},
                               {"verdict", verdict(findings)},         {"problem", findings.has_problem()}};
  if (sources.triples) document["triples"] = *sources.triples;
  if (sources.outgrown) document["outgrown"] = *sources.outgrown;
  boost::json::array& files = document["files"].emplace_array();
  for (const owl::LoadedFile& file : sources.files)
    files.push_back(boost::json::object{{"path", file.path}, {"ontology", file.ontology_iri}});
  document["left_out"] = left_out_as_json(findings);
  document["units"] = units_as_json(sources);
  document["gaps"] = boost::json::value_from(findings.gaps);
  boost::json::object& open = document["undecided"].emplace_object();
  open["classes"] = boost::json::value_from(findings.open.classes);
  open["consistency"] = findings.open.consistency;
  open["held_up_by"] = findings.open.held_up_by ? boost::json::value(*findings.open.held_up_by) : nullptr;
  boost::json::array& imports = document["unresolved_imports"].emplace_array();
  for (const rdf::UnresolvedImport& import : sources.unresolved)
    imports.push_back(boost::json::object{{"iri", import.iri}, {"file", import.file}, {"line", import.line}});
  boost::json::array& conflicts = document["prefix_conflicts"].emplace_array();
  for (const rdf::PrefixConflict& conflict : sources.conflicts)
    conflicts.push_back(boost::json::object{{"prefix", conflict.prefix},
                                            {"chosen", conflict.chosen},
                                            {"others", boost::json::value_from(conflict.others)}});
  document["contradiction"] = axioms_as_json(findings.contradiction);
  boost::json::array& unsatisfiable = document["unsatisfiable"].emplace_array();
  for (const Unsatisfiable& found : findings.unsatisfiable)
    unsatisfiable.push_back(boost::json::object{{"class", found.name}, {"because", axioms_as_json(found.reason)}});
  boost::json::array& collisions = document["collisions"].emplace_array();
  for (const Collision& collision : findings.collisions.found)
    collisions.push_back(
        boost::json::object{{"id", collision.id}, {"names", boost::json::value_from(collision.names)}});
  add_names(document, findings.names);
  return boost::json::serialize(document) + '\n';
}

}  // namespace geminga::ontology
