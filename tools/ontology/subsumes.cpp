// `geminga-ontology subsumes`: whether one class or class expression is subsumed by another.
#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <memory>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/loading/argument.hpp"
#include "ontology/loading/class_expressions.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "ontology/loading/refused.hpp"
#include "ontology/loading/verdict.hpp"
#include "reasoning/compiled/entity_names.hpp"
#include "reasoning/reasoner/reasoner.hpp"

namespace geminga::ontology {
namespace {

struct SubsumesRequest {
  std::vector<std::string> files;
  std::string sub;
  std::string super;
  bool as_json = false;
  bool is_lenient = false;
  bool is_strict = false;
};

/// Decides by the taxonomy for two classes, by the engines for expressions.
reasoner::Answer decide(ClassifiedFiles& classified, const compiled::Ontology& ontology,
                        const manchester::Expression& sub, const manchester::Expression& super, base::Budget& budget) {
  const auto sub_class = class_of(ontology, sub);
  const auto super_class = class_of(ontology, super);
  if (sub_class && super_class) {
    const bool holds =
        is_unsatisfiable(classified.classification, *sub_class) || ontology.is_subsumed(*sub_class, *super_class);
    if (holds) return {.verdict = reasoner::Verdict::yes, .reason = {}};
    if (!is_undecided(classified.classification, *sub_class)) return {.verdict = reasoner::Verdict::no, .reason = {}};
    return {.verdict = reasoner::Verdict::unknown, .reason = why_undecided(classified).value_or("")};
  }
  owl::Ontology& source = classified.loaded.source;
  const owl::TermId below = source.copy(sub.source, sub.term);
  const owl::TermId above = source.copy(super.source, super.term);
  return reasoner::entails(source, std::nullopt, below, above, &budget);
}

std::string as_json(const std::string& sub, const std::string& super, const reasoner::Answer& answer) {
  boost::json::object document{{"sub", sub}, {"super", super}, {"subsumed", verdict_as_json(answer.verdict)}};
  if (!answer.reason.empty()) document["reason"] = answer.reason;
  return json_text(document) + '\n';
}

/// The exit status of an answer. Yes is certain whatever limit was reached.
Exit exit_of(const reasoner::Answer& answer, const base::Budget& budget) {
  if (answer.verdict == reasoner::Verdict::yes) return Exit::yes;
  return answer.verdict == reasoner::Verdict::unknown && budget.is_spent() ? Exit::timed_out : Exit::no;
}

Exit subsumes(const SubsumesRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(limits);
  auto classified = classify_or_say(request.files, {.as_json = request.as_json,
                                                    .leaves_out_refused = !request.is_strict,
                                                    .is_lenient = request.is_lenient,
                                                    .budget = &budget});
  if (!classified) return Exit::usage;
  const auto ontology = compile_or_say(*classified);
  if (!ontology) return Exit::usage;
  const compiled::EntityNames names(*ontology);
  const auto sub = read_expression_or_say(*ontology, names, request.sub, request.as_json);
  const auto super = sub ? read_expression_or_say(*ontology, names, request.super, request.as_json) : std::nullopt;
  if (!sub || !super) return Exit::usage;
  reasoner::Answer answer = decide(*classified, *ontology, *sub, *super, budget);
  auto missing = describe_refused(classified->loaded);
  if (!missing) missing = find_unread(classified->loaded.source, {}, true);
  if (answer.verdict == reasoner::Verdict::no && missing) answer = {reasoner::Verdict::unknown, std::move(*missing)};
  const bool is_subsumed = answer.verdict == reasoner::Verdict::yes;
  if (request.as_json)
    return print_or_say(as_json(words_of(*ontology, *sub), words_of(*ontology, *super), answer),
                        exit_of(answer, budget));
  std::string text = words_of(*ontology, *sub) + (is_subsumed ? " is subsumed by " : " is not subsumed by ");
  if (answer.verdict == reasoner::Verdict::unknown)
    text = words_of(*ontology, *sub) + " is not known to be subsumed by ";
  text += words_of(*ontology, *super) + (answer.reason.empty() ? "" : ": " + answer.reason);
  return print_or_say(text + '\n', exit_of(answer, budget));
}

}  // namespace

void add_subsumes(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<SubsumesRequest>();
  CLI::App* command = program.add_subcommand(
      "subsumes", "Tell whether class A is subsumed by class B: exit 0 yes, 1 no or not known, 4 a limit was reached");
  add_files(*command, request->files);
  command->add_option("--sub", request->sub, "the class or class expression that may be the narrower one")
      ->required()
      ->type_name("A");
  command->add_option("--super", request->super, "the class or class expression that may be the broader one")
      ->required()
      ->type_name("B");
  command->add_flag("--json", request->as_json, "print one JSON document");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nA file of a folder that cannot be read is left out and named; then only yes can be decided.\n"
      "\nExamples:\n"
      "  geminga-ontology subsumes team/ --sub soccer:BallInfo --super geminga:TrackedObject\n"
      "  geminga-ontology subsumes team/ --sub soccer:SharedBallInfo --super 'soccer:BallInfo or soccer:GoalInfo'");
  run_when_named(*command, choice, request, subsumes);
}

}  // namespace geminga::ontology
