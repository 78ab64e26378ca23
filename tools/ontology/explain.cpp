// `geminga-ontology explain`: the axioms that entail a subsumption, or what is missing for it.
#include <CLI/CLI.hpp>
#include <memory>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/explain_output.hpp"
#include "ontology/loading/class_names.hpp"
#include "ontology/loading/compiled_form.hpp"

namespace geminga::ontology {
namespace {

constexpr unsigned default_sets = 10;
constexpr unsigned max_sets = 1000;

struct ExplainRequest {
  std::vector<std::string> files;
  std::string sub;
  std::string super;
  bool is_about_contradiction = false;
  bool is_all = false;
  bool wants_proof = false;
  bool as_json = false;
  unsigned limit = default_sets;
};

Exit explain(const ExplainRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(limits);
  const auto ontology = open_or_say(request.files, {.as_json = request.as_json, .budget = &budget});
  if (!ontology) return Exit::usage;
  const bool is_plain = !request.is_about_contradiction;
  const auto sub = find_or_say(*ontology, is_plain ? request.sub : std::string(owl::owl_thing), request.as_json);
  const auto super = find_or_say(*ontology, is_plain ? request.super : std::string(owl::owl_nothing), request.as_json);
  if (!sub || !super) return Exit::usage;

  Explained explained;
  explained.sub = *sub;
  explained.super = *super;
  explained.is_all = request.is_all;
  explained.is_entailed = ontology->is_subsumed(*sub, *super);
  std::optional<explanation::Explainer> explainer;
  if (explained.is_entailed) {
    explainer.emplace(*ontology, *sub, *super);
    if (request.is_all) {
      explained.sets = explainer->find_all({.sets = request.limit});
    } else if (auto found = explainer->find_one()) {
      explained.sets.sets.push_back(std::move(*found));
    }
    if (request.wants_proof) {
      for (const explanation::AxiomSet& set : explained.sets.sets) explained.proofs.push_back(prove(*explainer, set));
    }
  } else if (is_plain) {
    explained.why_not = explanation::why_not(*ontology, *sub, *super);
  }
  const explanation::Explainer* found_by = explainer ? &*explainer : nullptr;
  std::string text =
      request.as_json ? as_json(*ontology, explained, found_by) : as_text(*ontology, explained, found_by);
  if (!is_plain && !explained.is_entailed && !request.as_json) text = "The ontology does not contradict itself\n";
  if (!print(text)) return say_unwritten();
  if (explained.is_entailed) return Exit::yes;
  return budget.is_spent() ? say_error(*budget.reason() + ": raise it", Exit::timed_out) : Exit::no;
}

}  // namespace

void add_explain(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<ExplainRequest>();
  CLI::App* command = program.add_subcommand(
      "explain", "Print a minimal set of axioms that entails that A is subsumed by B, or what is missing");
  add_files(*command, request->files);
  auto* sub = command->add_option("--sub", request->sub, "the narrower class")->type_name("A");
  auto* super =
      command->add_option("--super", request->super, "the broader class; owl:Nothing asks why A can have no instance")
          ->type_name("B");
  command
      ->add_flag("--inconsistent", request->is_about_contradiction,
                 "ask why the ontology contradicts itself, instead of --sub and --super")
      ->excludes(sub)
      ->excludes(super);
  command->add_flag("--all", request->is_all, "print all minimal sets, up to --limit");
  add_number(*command, "--limit", request->limit, 1, max_sets,
             "at most this many sets with --all (" + std::to_string(default_sets) + " unless told)");
  command->add_flag("--proof", request->wants_proof, "print the steps from the axioms to the conclusion");
  command->add_flag("--json", request->as_json, "print one JSON document");
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nExit status 0: it is subsumed; 1: it is not; 4: a limit was reached before it was decided.\n"
      "\nExamples:\n"
      "  geminga-ontology explain team/ --sub soccer:BallInfo --super geminga:TrackedObject\n"
      "  geminga-ontology explain team/ --sub soccer:SharedBallInfo --super soccer:TrackedObject --proof\n"
      "  geminga-ontology explain team/ --inconsistent --all --limit 3");
  command->callback([request, &choice] {
    if (!request->is_about_contradiction && (request->sub.empty() || request->super.empty()))
      throw CLI::ValidationError("explain", "--sub and --super, or --inconsistent, are required");
    choice.run = [request, &choice] { return explain(*request, choice.limits); };
  });
}

}  // namespace geminga::ontology
