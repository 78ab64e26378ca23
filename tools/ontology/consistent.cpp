// `geminga-ontology consistent`: whether the files contradict themselves.
#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <memory>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/loading/argument.hpp"
#include "ontology/loading/consistency.hpp"
#include "ontology/loading/refused.hpp"
#include "ontology/loading/verdict.hpp"

namespace geminga::ontology {
namespace {

using reasoner::Answer;
using reasoner::Verdict;

struct ConsistentRequest {
  std::vector<std::string> files;
  bool as_json = false;
  bool is_lenient = false;
  bool is_strict = false;
};

std::string as_json(const Answer& answer) {
  boost::json::object document;
  put_consistency(answer, document);
  return json_text(document) + '\n';
}

std::string as_text(const Answer& answer) {
  if (answer.verdict == Verdict::yes) return "Consistent: there can be a world as these files say.\n";
  if (answer.verdict == Verdict::no)
    return "Contradiction: no world can be as these files say; geminga-ontology explain --inconsistent shows why.\n";
  return {};
}

Exit consistent(const ConsistentRequest& request, const WorkLimits& limits) {
  Progress progress(!request.as_json);
  auto loaded =
      load(request.files, progress, {.leaves_out_refused = !request.is_strict, .is_lenient = request.is_lenient});
  if (!loaded) return say_failure(loaded.error().text, request.as_json);
  progress.show("deciding");
  base::Budget budget = budget_of(limits);
  const Answer answer = consistency_of(*loaded, reasoner::is_consistent(loaded->source, &budget), &budget);
  progress.clear();
  say_unresolved(*loaded);
  // Where anything else was left out, the answer is not yes.
  const auto ill_typed = find_unread(loaded->source, {}, true);
  if (answer.verdict == Verdict::yes && ill_typed)
    say_error(*ill_typed + "; there can be a world whatever value of the datatype is meant");
  if (!print(request.as_json ? as_json(answer) : as_text(answer))) return say_unwritten();
  return exit_of(answer, std::string(contradiction_question), budget);
}

}  // namespace

void add_consistent(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<ConsistentRequest>();
  CLI::App* command = program.add_subcommand("consistent", "Tell whether the files contradict themselves");
  add_files(*command, request->files);
  command->add_flag("--json", request->as_json, "print one JSON document");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nExit status: 0 they do not, 1 they do, 2 it cannot be decided (the reason is printed), or a file cannot be\n"
      "loaded, 4 a limit was reached before it was decided. Imports that no given file answers are left aside.\n"
      "A file of a folder that cannot be read is left out and named; then only a contradiction can be decided.\n"
      "In the document of --json `consistent` is true, false or null, and with null `reason` says why.\n"
      "\nExample:\n  geminga-ontology consistent team/");
  run_when_named(*command, choice, request, consistent);
}

}  // namespace geminga::ontology
