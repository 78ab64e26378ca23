// `geminga-ontology entails`: whether every axiom of one ontology follows from another.
#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <memory>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/loading/argument.hpp"
#include "ontology/loading/refused.hpp"
#include "ontology/loading/verdict.hpp"
#include "reasoning/owl/loaded_file.hpp"
#include "reasoning/owl/print.hpp"
#include "reasoning/reasoner/ill_typed.hpp"

namespace geminga::ontology {
namespace {

using reasoner::Answer;
using reasoner::Verdict;

struct EntailsRequest {
  std::string premise;
  std::string conclusion;
  bool as_json = false;
  bool is_lenient = false;
  bool is_strict = false;
};

/// One axiom of the conclusion, and whether it follows.
struct Finding {
  std::string axiom;
  std::string place;
  std::string file;
  std::uint32_t line = 0;
  Answer answer;
};

/// The answer for all axioms together: no where one does not follow, else unknown where one is undecided.
Answer join(const std::vector<Finding>& findings, const Argument& argument) {
  Answer all{Verdict::yes, {}};
  for (const Finding& finding : findings) {
    if (finding.answer.verdict == Verdict::no) return finding.answer;
    if (finding.answer.verdict == Verdict::unknown && all.verdict == Verdict::yes) all = finding.answer;
  }
  if (all.verdict == Verdict::yes && argument.unread_conclusion) return {Verdict::unknown, *argument.unread_conclusion};
  return all;
}

std::vector<Finding> decide(Argument& argument, base::Budget& budget) {
  owl::Ontology& source = argument.loaded.source;
  const auto answers =
      reasoner::entails_each(source, argument.premise, argument.conclusion, argument.ill_typed, &budget);
  const auto short_name = short_names(source);
  std::vector<Finding> findings;
  for (std::size_t at = 0; at < answers.size(); ++at) {
    const owl::Axiom axiom = source.axiom(argument.conclusion[at]);
    const std::string& file = source.files()[static_cast<std::size_t>(axiom.file)].path;
    Finding finding{owl::print(source, axiom, short_name), file, file, axiom.line, answers[at]};
    if (axiom.line != 0) finding.place += ':' + std::to_string(axiom.line);
    // The axiom may follow from a part of the premise that was not understood.
    if (finding.answer.verdict == Verdict::no && argument.unread_premise)
      finding.answer = {Verdict::unknown, *argument.unread_premise};
    findings.push_back(std::move(finding));
  }
  return findings;
}

std::string as_json(const std::vector<Finding>& findings, const Answer& all) {
  boost::json::object document{{"entailed", verdict_as_json(all.verdict)}};
  if (!all.reason.empty()) document["reason"] = all.reason;
  boost::json::array& axioms = document["axioms"].emplace_array();
  for (const Finding& finding : findings) {
    boost::json::object entry{{"axiom", finding.axiom},
                              {"file", finding.file},
                              {"line", finding.line},
                              {"entailed", verdict_as_json(finding.answer.verdict)}};
    if (!finding.answer.reason.empty()) entry["reason"] = finding.answer.reason;
    axioms.push_back(std::move(entry));
  }
  return json_text(document) + '\n';
}

std::string as_text(const std::vector<Finding>& findings, const Answer& all) {
  std::string text;
  for (const Finding& finding : findings) {
    text += finding.answer.verdict == Verdict::yes  ? "follows:         "
            : finding.answer.verdict == Verdict::no ? "does not follow: "
                                                    : "is not decided:  ";
    text += finding.axiom + "   [" + finding.place + "]\n";
    if (!finding.answer.reason.empty()) text += "  because " + finding.answer.reason + '\n';
  }
  if (all.verdict == Verdict::yes)
    text += findings.size() == 1 ? "The axiom follows.\n"
                                 : "All " + counted(findings.size(), "axiom", "axioms") + " follow.\n";
  return text;
}

Exit entails(const EntailsRequest& request, const WorkLimits& limits) {
  Progress progress(!request.as_json);
  auto argument = load_argument(request.premise, request.conclusion, progress,
                                {.leaves_out_refused = !request.is_strict, .is_lenient = request.is_lenient});
  if (!argument) return say_failure(argument.error().text, request.as_json);
  progress.show("deciding");
  base::Budget budget = budget_of(limits);
  const std::vector<Finding> findings = decide(*argument, budget);
  const Answer all = join(findings, *argument);
  progress.clear();
  say_unresolved(argument->loaded);
  if (!print(request.as_json ? as_json(findings, all) : as_text(findings, all))) return say_unwritten();
  return exit_of(all, "whether all of it follows", budget);
}

}  // namespace

void add_entails(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<EntailsRequest>();
  CLI::App* command = program.add_subcommand("entails", "Tell whether every axiom of CONCLUSION follows from PREMISE");
  command->add_option("PREMISE", request->premise, "an ontology file, or a folder of them")->required()->type_name("");
  command->add_option("CONCLUSION", request->conclusion, "another; its anonymous individuals mean \"something\"")
      ->required()
      ->type_name("");
  command->add_flag("--json", request->as_json, "print one JSON document, with every axiom");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nImports are answered by files in the named folders; other imports are left out. An axiom with a literal\n"
      "that is not of its datatype is left out; a conclusion that depends on the value of such a literal cannot\n"
      "be decided, and all others can.\n"
      "Exit status: 0 all of it follows, 1 an axiom does not follow, 2 it cannot be decided (the reason is\n"
      "printed), or a file cannot be loaded, 4 a limit was reached before it was decided.\n"
      "A file of a folder that cannot be read is left out and named: in PREMISE only yes can be decided then, in\n"
      "CONCLUSION only no.\n"
      "\nExample:\n  geminga-ontology entails team/ expected.ttl");
  run_when_named(*command, choice, request, entails);
}

}  // namespace geminga::ontology
