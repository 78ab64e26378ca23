// `geminga-ontology instances`: the individuals that are in a class expression.
#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <memory>
#include <string>

#include "base/text.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/individuals/realized_files.hpp"
#include "ontology/loading/argument.hpp"
#include "ontology/loading/class_expressions.hpp"
#include "ontology/loading/compiled_form.hpp"
#include "ontology/loading/consistency.hpp"
#include "ontology/loading/refused.hpp"
#include "reasoning/compiled/entity_names.hpp"

namespace geminga::ontology {
namespace {

struct InstancesRequest {
  std::vector<std::string> words;  ///< the files, and last the expression
  bool as_json = false;
  bool is_lenient = false;
  bool is_strict = false;
};

/// Reads a class expression, of which a name is the simplest; nothing after saying what is wrong.
std::optional<owl::TermId> read_or_say(ClassifiedFiles& classified, const std::string& text, bool as_json) {
  const auto ontology = compile_or_say(classified);
  if (!ontology) return std::nullopt;
  const compiled::EntityNames names(*ontology);
  const auto expression = read_expression_or_say(*ontology, names, text, as_json);
  if (!expression) return std::nullopt;
  return classified.loaded.source.copy(expression->source, expression->term);
}

std::string as_json(const owl::Ontology& source, const realization::Instances& found,
                    const reasoner::Answer& consistency) {
  const auto iris = [&](const std::vector<owl::TermId>& individuals) {
    boost::json::array array;
    for (const owl::TermId individual : individuals) array.emplace_back(source.name_of(individual));
    return array;
  };
  boost::json::object document;
  put_consistency(consistency, document);
  document["instances"] = iris(found.found);
  if (!found.undecided.empty()) document["undecided"] = iris(found.undecided);
  if (!found.gaps.empty()) document["gaps"] = boost::json::value_from(found.gaps);
  return json_text(document) + '\n';
}

std::string as_text(const owl::Ontology& source, const realization::Instances& found) {
  const auto short_name = short_names(source);
  std::string text;
  for (const owl::TermId individual : found.found) text += short_name(source.name_of(individual)) + '\n';
  return text;
}

/// The exit status of the contract; says what is not decided.
Exit judge(const rdf::Loaded& loaded, const realization::Instances& found, const base::Budget& budget) {
  const owl::Ontology& source = loaded.source;
  const auto open = describe_open(source, found.undecided, found.gaps);
  if (!open) return exit_of_answer(loaded, found.found.empty() ? Exit::no : Exit::yes);
  say_error((found.found.empty() ? "it cannot be decided whether there is an instance: "
                                 : "what is printed follows, and more may: ") +
            *open);
  if (budget.is_spent()) return Exit::timed_out;
  return found.found.empty() ? Exit::usage : Exit::yes;
}

Exit instances(const InstancesRequest& request, const WorkLimits& limits) {
  if (request.words.size() < 2)
    return say_failure("name the files, and behind them the class expression", request.as_json);
  base::Budget classifying = budget_of(first_half(limits));
  const std::vector<std::string> files(request.words.begin(), request.words.end() - 1);
  auto classified = classify_or_say(files, {.as_json = request.as_json,
                                            .leaves_out_refused = !request.is_strict,
                                            .is_lenient = request.is_lenient,
                                            .budget = &classifying});
  if (!classified) return Exit::usage;
  const auto expression = read_or_say(*classified, request.words.back(), request.as_json);
  if (!expression) return Exit::usage;
  owl::Ontology& source = classified->loaded.source;
  base::Budget budget = budget_of(limits);
  realization::Instances found;
  found.is_consistent = classified->classification.is_consistent;
  if (found.is_consistent) {
    Progress progress(!request.as_json);
    realization::Options options{.budget = &budget};
    options.progress = [&](std::string_view phase, double done) { progress.show(phase, done); };
    found = realization::find_instances(source, *expression, options);
    progress.clear();
  }
  if (found.is_consistent) note_unread(source, found.gaps);
  if (!found.is_consistency_open) note_model(classified->classification);
  say_unresolved(classified->loaded);
  if (!found.is_consistent) say_error(contradiction_words);
  reasoner::Answer consistency{reasoner::Verdict::no, {}};
  if (request.as_json && found.is_consistent) consistency = consistency_of(*classified, &budget);
  if (!print(request.as_json ? as_json(source, found, consistency) : as_text(source, found))) return say_unwritten();
  return found.is_consistent ? judge(classified->loaded, found, budget) : Exit::no;
}

}  // namespace

void add_instances(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<InstancesRequest>();
  CLI::App* command = program.add_subcommand("instances", "Print the individuals that are in a class expression");
  command
      ->add_option("FILES EXPRESSION", request->words,
                   "ontology files, or folders of them, and a class expression in Manchester syntax behind them")
      ->required()
      ->type_name("");
  command->add_flag("--json", request->as_json, "print one JSON document");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_work_limits(*command, choice.limits);
  command->footer(
      std::string(
          "\nThe output is the named individuals that are in the expression in every model, as in Protege's DL query.\n"
          "Where there may be more, standard error names the individuals that are not decided.\n"
          "Exit status: 0 there are some, 1 there are none, or the ontology contradicts itself (standard error says\n"
          "so), 2 it cannot be decided whether there are any (the reason is printed), or a file cannot be loaded, 4 a\n"
          "limit was reached.\n") +
      consistency_of_json + refused_of_answer +
      "\nExamples:\n"
      "  geminga-ontology instances team/ soccer:BallInfo\n"
      "  geminga-ontology instances team/ 'soccer:Message and (geminga:carries some soccer:TrackedObject)' --json");
  run_when_named(*command, choice, request, instances);
}

}  // namespace geminga::ontology
