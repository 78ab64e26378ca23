// Gathers what is known after classification; derives nothing itself but the reasons of empty classes.
#include "findings.hpp"

#include <algorithm>
#include <boost/json.hpp>
#include <map>
#include <tuple>

#include "el/print.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

/// So many constructs and gaps are named in the one line of the verdict.
constexpr std::size_t max_reasons = 4;

std::vector<LeftOutGroup> group(const Knowledge& knowledge) {
  const el::OntologySource& source = knowledge.loaded.source;
  const auto short_name = short_names(source);
  std::vector<LeftOutGroup> groups;
  std::map<std::string_view, std::size_t> place;
  for (el::LeftOut& summary : el::left_out(source, knowledge.classification)) {
    groups.push_back({std::move(summary), {}});
  }
  for (std::size_t at = 0; at < groups.size(); ++at) place.emplace(groups[at].summary.construct, at);
  for (const el::UnusedAxiom& unused : knowledge.classification.unused) {
    const auto found = place.find(unused.construct);
    if (found == place.end()) continue;
    const el::Axiom axiom = source.axiom(unused.axiom);
    groups[found->second].axioms.push_back(
        {el::print(source, axiom, short_name), source.files()[static_cast<std::size_t>(axiom.file)].path, axiom.line});
  }
  for (LeftOutGroup& entry : groups) {
    std::ranges::sort(entry.axioms, {},
                      [](const LeftOutAxiom& axiom) { return std::tie(axiom.file, axiom.line, axiom.axiom); });
  }
  return groups;
}

boost::json::array axioms_as_json(const std::vector<reasoner::ExplainedAxiom>& axioms) {
  boost::json::array list;
  for (const reasoner::ExplainedAxiom& axiom : axioms)
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

}  // namespace

Findings find(const Knowledge& knowledge, const el::Ontology& ontology) {
  Findings findings;
  const reasoner::Classified& classification = knowledge.classification;
  findings.left_out = group(knowledge);
  findings.gaps = classification.gaps;
  findings.is_consistent = classification.is_consistent;
  for (std::uint32_t number = 0; number < classification.class_count() && classification.is_consistent; ++number) {
    const el::ClassNumber named{number};
    if (named == classification.nothing || !is_unsatisfiable(classification, named)) continue;
    auto reason = reasoner::explain(ontology, named, classification.nothing);
    findings.unsatisfiable.push_back(
        {ontology.short_name(named), std::move(reason).value_or(std::vector<reasoner::ExplainedAxiom>{})});
  }
  findings.collisions = find_collisions(knowledge, ontology);
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

std::string as_json(const Knowledge& knowledge, const Findings& findings) {
  const rdf::Loaded& loaded = knowledge.loaded;
  boost::json::object document{{"triples", loaded.triples},
                               {"classes", class_count(knowledge)},
                               {"axioms", knowledge.classification.counts.axioms},
                               {"consistent", findings.is_consistent},
                               {"complete", findings.is_complete()},
                               {"verdict", verdict(findings)},
                               {"problem", findings.has_problem()}};
  boost::json::array& files = document["files"].emplace_array();
  for (const el::LoadedFile& file : loaded.source.files())
    files.push_back(boost::json::object{{"path", file.path}, {"ontology", file.ontology_iri}});
  document["left_out"] = left_out_as_json(findings);
  document["gaps"] = boost::json::value_from(findings.gaps);
  boost::json::array& imports = document["unresolved_imports"].emplace_array();
  for (const rdf::UnresolvedImport& import : loaded.unresolved)
    imports.push_back(boost::json::object{{"iri", import.iri}, {"file", import.file}, {"line", import.line}});
  boost::json::array& conflicts = document["prefix_conflicts"].emplace_array();
  for (const rdf::PrefixConflict& conflict : loaded.conflicts)
    conflicts.push_back(boost::json::object{{"prefix", conflict.prefix},
                                            {"chosen", conflict.chosen},
                                            {"others", boost::json::value_from(conflict.others)}});
  boost::json::array& unsatisfiable = document["unsatisfiable"].emplace_array();
  for (const Unsatisfiable& found : findings.unsatisfiable)
    unsatisfiable.push_back(boost::json::object{{"class", found.name}, {"because", axioms_as_json(found.reason)}});
  boost::json::array& collisions = document["collisions"].emplace_array();
  for (const Collision& collision : findings.collisions.found)
    collisions.push_back(
        boost::json::object{{"id", collision.id}, {"names", boost::json::value_from(collision.names)}});
  return boost::json::serialize(document) + '\n';
}

}  // namespace geminga::ontology
