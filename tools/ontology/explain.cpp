// `geminga-ontology explain`: the axioms that entail a subsumption, or what is missing for it.
#include "reasoning/explanation/explain.hpp"

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/explaining/explained.hpp"
#include "ontology/explaining/question.hpp"
#include "reasoning/owl/left_out.hpp"

namespace geminga::ontology {
namespace {

constexpr unsigned default_sets = 10;
constexpr unsigned max_sets = 1000;

struct ExplainRequest {
  std::vector<std::string> files;
  QuestionWords words;
  bool is_about_contradiction = false;
  bool is_all = false;
  bool wants_proof = false;
  bool is_laconic = false;
  bool as_json = false;
  bool is_lenient = false;
  bool is_strict = false;
  unsigned limit = default_sets;
};

Exit explain(const ExplainRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(limits);
  const QuestionWords contradiction{std::string(owl::owl_thing), std::string(owl::owl_nothing), {}};
  const auto question = open_question(request.files, request.is_about_contradiction ? contradiction : request.words,
                                      {.as_json = request.as_json,
                                       .leaves_out_refused = !request.is_strict,
                                       .is_lenient = request.is_lenient,
                                       .budget = &budget});
  if (!question) return Exit::usage;
  const taxonomy::ClassNumber sub = question->sub.number;
  const taxonomy::ClassNumber super = question->super.number;
  Explained explained;
  explained.is_all = request.is_all;
  explained.answer = decide(*question, budget);
  std::optional<explanation::Explainer> explainer;
  Progress progress(!request.as_json);
  progress.show("looking for reasons");
  base::Budget explaining = budget_of(limits);  // its own steps: a search that took all of them may have an answer
  if (explained.is_entailed()) {
    explainer.emplace(question->ontology(), sub, super, explanation::Patience::of_a_person, &explaining);
    if (request.is_all) {
      explained.sets = explainer->find_all({.sets = request.limit});
    } else if (auto found = explainer->find_one()) {
      explained.sets.sets.push_back(std::move(*found));
    }
    if (request.wants_proof) {
      for (const explanation::AxiomSet& set : explained.sets.sets) explained.proofs.push_back(prove(*explainer, set));
    }
    if (request.is_laconic) {
      for (const explanation::AxiomSet& set : explained.sets.sets)
        explained.laconic.push_back(explanation::find_laconic(*explainer, set));
    }
  } else if (explained.answer.verdict == reasoner::Verdict::no && !question->is_about_contradiction() &&
             !question->has_definitions()) {
    explained.why_not = explanation::why_not(question->ontology(), sub, super);
    explained.why_not->may_be_incomplete = !question->ontology().left_out().empty();
  }
  progress.clear();
  const explanation::Explainer* found_by = explainer ? &*explainer : nullptr;
  if (!print(request.as_json ? as_json(*question, explained, found_by) : as_text(*question, explained, found_by)))
    return say_unwritten();
  if (explaining.is_spent())
    return say_error(*explaining.reason() + ": what is printed entails it, and may hold more than is needed: raise it",
                     Exit::timed_out);
  if (explained.is_entailed()) return Exit::yes;
  return budget.is_spent() ? say_error(*budget.reason() + ": raise it", Exit::timed_out) : Exit::no;
}

}  // namespace

void add_explain(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<ExplainRequest>();
  CLI::App* command = program.add_subcommand(
      "explain", "Print a minimal set of axioms that entails that A is subsumed by B, or what is missing");
  add_files(*command, request->files);
  auto* sub =
      command->add_option("--sub", request->words.sub, "the narrower class or class expression")->type_name("A");
  auto* individual =
      command->add_option("--individual", request->words.individual, "an individual, to ask why it is in B")
          ->type_name("I")
          ->excludes(sub);
  auto* super = command
                    ->add_option("--super", request->words.super,
                                 "the broader class or class expression; owl:Nothing asks why A can have no instance")
                    ->type_name("B");
  command
      ->add_flag("--inconsistent", request->is_about_contradiction,
                 "ask why the ontology contradicts itself, instead of --sub and --super")
      ->excludes(sub)
      ->excludes(individual)
      ->excludes(super);
  command->add_flag("--all", request->is_all, "print all minimal sets, up to --limit");
  add_number(*command, "--limit", request->limit, 1, max_sets,
             "at most this many sets with --all (default: " + std::to_string(default_sets) + ")");
  CLI::Option* proof =
      command->add_flag("--proof", request->wants_proof, "print the steps from the axioms to the conclusion");
  command
      ->add_flag("--laconic", request->is_laconic,
                 "print only the parts of axioms that are needed: each class that can be left out is")
      ->excludes(proof);
  command->add_flag("--json", request->as_json, "print one JSON document");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nA class expression is written in Manchester syntax, with the names of the files. For it, and for an\n"
      "individual, a class is defined (about:sub, about:super, about:individual), which only the steps of --proof\n"
      "name.\n"
      "\nExit status 0: it is subsumed; 1: it is not, or is not known to be; 4: a limit was reached before it was\n"
      "decided. In the document of --json `entailed` is null and has a `reason` where it is not known.\n"
      "A file of a folder that cannot be read is left out and named; then only yes can be decided.\n"
      "\nExamples:\n"
      "  geminga-ontology explain team/ --sub soccer:BallInfo --super geminga:TrackedObject\n"
      "  geminga-ontology explain team/ --sub soccer:SharedBallInfo --super soccer:TrackedObject --proof\n"
      "  geminga-ontology explain team/ --sub soccer:SharedBallInfo --super soccer:TrackedObject --laconic\n"
      "  geminga-ontology explain ontology/ robot.ttl --individual geminga:self --super 'hasPart some Gripper'\n"
      "  geminga-ontology explain team/ --inconsistent --all --limit 3");
  command->callback([request, &choice] {
    if (!request->is_about_contradiction &&
        ((request->words.sub.empty() && request->words.individual.empty()) || request->words.super.empty()))
      throw CLI::ValidationError("explain", "--sub or --individual with --super, or --inconsistent, are required");
    choice.run = [request, &choice] { return explain(*request, choice.limits); };
  });
}

}  // namespace geminga::ontology
