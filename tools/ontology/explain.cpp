// `geminga-ontology explain`: which axioms entail that one class is subsumed by another?
#include "reasoner/explain.hpp"

#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <memory>

#include "command.hpp"
#include "knowledge.hpp"
#include "words.hpp"

namespace geminga::ontology {
namespace {

struct Request {
  std::vector<std::string> files;
  std::string sub;
  std::string super;
  bool as_json = false;
};

std::string as_text(const std::vector<reasoner::ExplainedAxiom>& axioms) {
  std::string text;
  for (const reasoner::ExplainedAxiom& axiom : axioms) {
    text += axiom.text;
    if (!axiom.file.empty())
      text += "   [" + axiom.file + (axiom.line == 0 ? "" : ':' + std::to_string(axiom.line)) + ']';
    text += '\n';
  }
  return text;
}

std::string as_json(const el::Ontology& ontology, el::ClassNumber sub, el::ClassNumber super,
                    const std::vector<reasoner::ExplainedAxiom>* axioms) {
  boost::json::object document{
      {"sub", ontology.iri(sub)}, {"super", ontology.iri(super)}, {"entailed", axioms != nullptr}};
  boost::json::array& list = document["axioms"].emplace_array();
  if (axioms != nullptr) {
    for (const reasoner::ExplainedAxiom& axiom : *axioms)
      list.push_back(boost::json::object{{"axiom", axiom.text}, {"file", axiom.file}, {"line", axiom.line}});
  }
  return boost::json::serialize(document) + '\n';
}

Exit explain(const Request& request) {
  const auto knowledge = learn_or_say(request.files);
  if (!knowledge) return Exit::usage;
  const auto ontology = open_or_say(*knowledge);
  if (!ontology) return Exit::usage;
  const auto sub = find_or_say(*ontology, request.sub);
  const auto super = find_or_say(*ontology, request.super);
  if (!sub || !super) return Exit::usage;
  const auto axioms = reasoner::explain(*ontology, *sub, *super);
  std::string text;
  if (request.as_json) {
    text = as_json(*ontology, *sub, *super, axioms ? &*axioms : nullptr);
  } else if (!axioms) {
    text = ontology->short_name(*sub) + " is not subsumed by " + ontology->short_name(*super) + '\n';
  } else {
    text = ontology->short_name(*sub) + " is subsumed by " + ontology->short_name(*super);
    text += axioms->empty() ? ": that is so in every ontology\n" : ", because:\n" + as_text(*axioms);
  }
  if (!print(text)) return say_error("standard output cannot be written");
  return axioms ? Exit::yes : Exit::no;
}

}  // namespace

void add_explain(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<Request>();
  CLI::App* command =
      program.add_subcommand("explain", "Print a minimal set of axioms that entails that A is subsumed by B");
  add_files(*command, request->files);
  command->add_option("--sub", request->sub, "the narrower class")->required()->type_name("A");
  command->add_option("--super", request->super, "the broader class; owl:Nothing asks why A can have no instance")
      ->required()
      ->type_name("B");
  command->add_flag("--json", request->as_json, "print one JSON document");
  command->footer("\nExample:\n  geminga-ontology explain team/ --sub soccer:BallInfo --super geminga:TrackedObject");
  command->callback([request, &choice] { choice.run = [request] { return explain(*request); }; });
}

}  // namespace geminga::ontology
