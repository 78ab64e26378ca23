// The findings as one JSON document.
#include <boost/json.hpp>

#include "ontology/command/words.hpp"
#include "ontology/findings/axioms.hpp"
#include "ontology/findings/findings.hpp"
#include "ontology/loading/consistency.hpp"

namespace geminga::ontology {
namespace {

boost::json::array places_as_json(const LeftOutGroup& entry) {
  boost::json::array list;
  for (const Place& one : entry.places) list.push_back(boost::json::object{{"file", one.file}, {"line", one.line}});
  return list;
}

boost::json::array left_out_as_json(const Findings& findings) {
  boost::json::array list;
  for (const LeftOutGroup& entry : findings.left_out) {
    boost::json::object group{
        {"construct", entry.summary.construct}, {"count", entry.summary.count}, {"first", entry.summary.first}};
    group["axioms"] = axiom_array(entry.axioms);
    group["places"] = places_as_json(entry);
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

boost::json::object units_as_json(const Sources& sources) {
  boost::json::object units{{"read", sources.units}};
  boost::json::array& left_out = units["left_out"].emplace_array();
  for (const owl::LeftOut& one : sources.units_left_out)
    left_out.push_back(boost::json::object{{"reason", one.construct}, {"count", one.count}, {"first", one.first}});
  return units;
}

}  // namespace

std::string as_json(const Findings& findings) {
  const Sources& sources = findings.sources;
  boost::json::object document{{"classes", sources.classes},
                               {"axioms", sources.axioms},
                               {"complete", findings.is_complete()},
                               {"verdict", verdict(findings)},
                               {"problem", findings.has_problem()}};
  put_consistency(findings.consistency, document);
  if (sources.triples) document["triples"] = *sources.triples;
  if (sources.outgrown) document["outgrown"] = *sources.outgrown;
  boost::json::array& files = document["files"].emplace_array();
  for (const owl::LoadedFile& file : sources.files)
    files.push_back(boost::json::object{{"path", file.path}, {"ontology", file.ontology_iri}});
  document["left_out"] = left_out_as_json(findings);
  boost::json::array& remarks = document["remarks"].emplace_array();
  for (const LeftOutGroup& remark : findings.remarks)
    remarks.push_back(boost::json::object{{"text", remark.summary.construct},
                                          {"count", remark.summary.count},
                                          {"first", remark.summary.first},
                                          {"places", places_as_json(remark)}});
  document["touched"] = findings.touched ? boost::json::value_from(*findings.touched) : boost::json::value(nullptr);
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
  boost::json::array& refused = document["refused"].emplace_array();
  for (const syntax::LoadError& one : sources.refused)
    refused.push_back(boost::json::object{{"file", one.file}, {"line", one.line}, {"text", one.text}});
  document["contradiction"] = axiom_array(findings.contradiction);
  boost::json::array& unsatisfiable = document["unsatisfiable"].emplace_array();
  for (const Unsatisfiable& found : findings.unsatisfiable)
    unsatisfiable.push_back(boost::json::object{{"class", found.name},
                                                {"root", found.root ? boost::json::value(*found.root) : nullptr},
                                                {"because", axiom_array(found.reason)}});
  document["unsatisfiable_is_whole"] = findings.is_searched_without_facts;
  boost::json::array& collisions = document["collisions"].emplace_array();
  for (const Collision& collision : findings.collisions.found)
    collisions.push_back(
        boost::json::object{{"id", collision.id}, {"names", boost::json::value_from(collision.names)}});
  document["collisions_is_whole"] = findings.collisions.is_whole;
  add_names(document, findings.names);
  return json_text(document) + '\n';
}

}  // namespace geminga::ontology
