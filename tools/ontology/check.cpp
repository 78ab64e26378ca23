// `geminga-ontology check`: everything that one should know about an ontology before robots rely on it.
#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <memory>

#include "base/text.hpp"
#include "collisions.hpp"
#include "command.hpp"
#include "knowledge.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

struct Request {
  std::vector<std::string> files;
  bool as_json = false;
};

struct Unsatisfiable {
  std::string name;
  std::vector<el::ExplainedAxiom> reason;
};

struct Findings {
  std::vector<el::LeftOut> left_out;
  std::vector<Unsatisfiable> unsatisfiable;
  Collisions collisions;
  [[nodiscard]] bool has_problem(const Knowledge& knowledge) const {
    return !unsatisfiable.empty() || !collisions.found.empty() || !knowledge.classification.is_consistent;
  }
};

Findings look(const Knowledge& knowledge, const el::Ontology& ontology) {
  Findings findings;
  const el::Classification& classification = knowledge.classification;
  findings.left_out = el::left_out(knowledge.loaded.source, classification);
  for (std::uint32_t number = 0; number < classification.class_count() && classification.is_consistent; ++number) {
    const el::ClassNumber named{number};
    if (named == classification.nothing || !is_unsatisfiable(classification, named)) continue;
    findings.unsatisfiable.push_back(
        {ontology.short_name(named),
         ontology.explain(named, classification.nothing).value_or(std::vector<el::ExplainedAxiom>{})});
  }
  findings.collisions = find_collisions(knowledge, ontology);
  return findings;
}

std::string place(const std::string& file, std::uint32_t line) {
  return line == 0 ? file : file + ':' + std::to_string(line);
}

std::string verdict(const Knowledge& knowledge, const Findings& findings) {
  if (!knowledge.classification.is_consistent)
    return "Contradiction: no robot's world can be as these files say, so everything follows from them.\n";
  if (!findings.left_out.empty())
    return "Incomplete: every answer is right, but some may be missing, because of what was left out.\n";
  return "Complete: everything that follows from these files was found.\n";
}

std::string as_text(const Knowledge& knowledge, const Findings& findings) {
  const rdf::Loaded& loaded = knowledge.loaded;
  std::string text = counted(loaded.source.files().size(), "file", "files") + ", " +
                     counted(loaded.triples, "triple", "triples") + ", " +
                     counted(class_count(knowledge), "class", "classes") + ", " +
                     counted(knowledge.classification.counts.axioms, "axiom", "axioms") + '\n';
  for (const el::LoadedFile& file : loaded.source.files())
    text += "  " + file.path + (file.ontology_iri.empty() ? "" : "  <" + file.ontology_iri + ">") + '\n';
  if (!findings.left_out.empty()) text += "Left out:\n";
  for (const el::LeftOut& entry : findings.left_out)
    text += "  " + entry.construct + ": " + std::to_string(entry.count) + ", first at " + entry.first + '\n';
  if (!loaded.unresolved.empty())
    text += "Imports that no given file answers (nothing is fetched: name the files, too):\n";
  for (const rdf::UnresolvedImport& import : loaded.unresolved)
    text += "  <" + import.iri + "> at " + place(import.file, import.line) + '\n';
  if (!loaded.conflicts.empty()) text += "Prefixes that mean several IRIs (write the others in full):\n";
  for (const rdf::PrefixConflict& conflict : loaded.conflicts) {
    text += "  " + conflict.prefix + ": is <" + conflict.chosen + ">, not";
    for (const std::string& other : conflict.others) text += " <" + other + ">";
    text += '\n';
  }
  if (!findings.unsatisfiable.empty()) text += "Classes that can have no instance:\n";
  for (const Unsatisfiable& found : findings.unsatisfiable) {
    text += "  " + found.name + '\n';
    for (const el::ExplainedAxiom& axiom : found.reason)
      text += "    because " + axiom.text + "   [" + place(axiom.file, axiom.line) + "]\n";
  }
  if (!findings.collisions.found.empty())
    text += "Names with equal 32-bit identities (they never match by accident):\n";
  for (const Collision& collision : findings.collisions.found) {
    text += "  0x" + base::to_hex(collision.id, 8) + ':';
    for (const std::string& name : collision.names) text += ' ' + name;
    text += '\n';
  }
  if (!findings.collisions.is_whole)
    text += "Identities of concepts with representations were not compared: there are too many.\n";
  return text + verdict(knowledge, findings);
}

boost::json::array axioms_as_json(const std::vector<el::ExplainedAxiom>& axioms) {
  boost::json::array list;
  for (const el::ExplainedAxiom& axiom : axioms)
    list.push_back(boost::json::object{{"axiom", axiom.text}, {"file", axiom.file}, {"line", axiom.line}});
  return list;
}

std::string as_json(const Knowledge& knowledge, const Findings& findings) {
  const rdf::Loaded& loaded = knowledge.loaded;
  boost::json::object document{{"triples", loaded.triples},
                               {"classes", class_count(knowledge)},
                               {"axioms", knowledge.classification.counts.axioms},
                               {"consistent", knowledge.classification.is_consistent},
                               {"complete", findings.left_out.empty()},
                               {"problem", findings.has_problem(knowledge)}};
  boost::json::array& files = document["files"].emplace_array();
  for (const el::LoadedFile& file : loaded.source.files())
    files.push_back(boost::json::object{{"path", file.path}, {"ontology", file.ontology_iri}});
  boost::json::array& left_out = document["left_out"].emplace_array();
  for (const el::LeftOut& entry : findings.left_out)
    left_out.push_back(
        boost::json::object{{"construct", entry.construct}, {"count", entry.count}, {"first", entry.first}});
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

Exit check(const Request& request) {
  const auto knowledge = learn(request.files);
  if (!knowledge) return say_error(knowledge.error().text, knowledge.error().is_unreadable ? Exit::usage : Exit::no);
  const auto ontology = open_or_say(*knowledge);
  if (!ontology) return Exit::usage;
  const Findings findings = look(*knowledge, *ontology);
  if (!print(request.as_json ? as_json(*knowledge, findings) : as_text(*knowledge, findings)))
    return say_error("standard output cannot be written");
  return findings.has_problem(*knowledge) ? Exit::no : Exit::yes;
}

}  // namespace

void add_check(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<Request>();
  CLI::App* command = program.add_subcommand(
      "check",
      "Load and classify; list what could not be used, classes that can have no instance, and hash collisions");
  add_files(*command, request->files);
  command->add_flag("--json", request->as_json, "print one JSON document");
  command->footer(
      "\nExit status 1: a broken file, a contradiction, a class that can have no instance, or a hash collision.\n"
      "\nExample:\n  geminga-ontology check team/ soma.rdf");
  command->callback([request, &choice] { choice.run = [request] { return check(*request); }; });
}

}  // namespace geminga::ontology
