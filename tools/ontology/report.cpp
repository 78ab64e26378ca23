// `geminga-ontology report`: what the authors of an ontology may want to mend, by level, one line each.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <boost/json.hpp>
#include <memory>
#include <string>
#include <vector>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/findings/axioms.hpp"
#include "ontology/lint/rules.hpp"
#include "ontology/loading/classified_files.hpp"
#include "ontology/loading/refused.hpp"

namespace geminga::ontology {
namespace {

struct ReportRequest {
  std::vector<std::string> files;
  std::vector<std::string> ignored;
  std::string level = "info";
  std::string fail_on = "error";
  bool lists_rules = false;
  bool is_lenient = false;
  bool is_strict = false;
  bool as_json = false;
};

std::array<std::size_t, 3> counts_of(const std::vector<LintFinding>& findings) {
  std::array<std::size_t, 3> counts{};
  for (const LintFinding& one : findings) ++counts.at(static_cast<std::size_t>(one.rule->level));
  return counts;
}

/// `FILE:LINE: LEVEL: WORDS [CODE]`, as compilers write, so that an editor finds the place.
std::string report_as_text(const std::vector<LintFinding>& findings) {
  std::string text;
  for (const LintFinding& one : findings) {
    if (!one.file.empty()) text += place(one.file, one.line) + ": ";
    text.append(to_string(one.rule->level)).append(": ").append(one.words).append(" [").append(one.rule->code) += "]\n";
  }
  const auto counts = counts_of(findings);
  return text + counted(counts[0], "error", "errors") + ", " + counted(counts[1], "warning", "warnings") + ", " +
         counted(counts[2], "remark", "remarks") + '\n';
}

std::string report_as_json(const std::vector<LintFinding>& findings) {
  const auto counts = counts_of(findings);
  boost::json::object document{{"errors", counts[0]}, {"warnings", counts[1]}, {"infos", counts[2]}};
  boost::json::array& list = document["findings"].emplace_array();
  for (const LintFinding& one : findings)
    list.push_back(boost::json::object{{"level", to_string(one.rule->level)},
                                       {"code", one.rule->code},
                                       {"iri", one.iri},
                                       {"file", one.file},
                                       {"line", one.line},
                                       {"words", one.words}});
  return json_text(document) + '\n';
}

std::string rules_as_text() {
  std::string text;
  for (const Rule& rule : rules())
    text.append(rule.code).append("\t").append(to_string(rule.level)).append("\t").append(rule.meaning) += '\n';
  return text;
}

Exit lint(const ReportRequest& request, const WorkLimits& limits) {
  if (request.lists_rules) return print_or_say(rules_as_text());
  if (request.files.empty()) return say_failure("name the files to look at", request.as_json);
  for (const std::string& code : request.ignored) {
    if (find_rule(code) == nullptr)
      return say_failure(code + " is no rule: geminga-ontology report --rules lists them", request.as_json);
  }
  base::Budget budget = budget_of(limits);
  const auto classified = classify_or_say(request.files, {.as_json = request.as_json,
                                                          .annotations = KeptAnnotations::all,
                                                          .leaves_out_refused = !request.is_strict,
                                                          .is_lenient = request.is_lenient,
                                                          .budget = &budget});
  if (!classified) return Exit::usage;
  const Entities entities(classified->loaded);
  LintFindings collected;
  check_names(classified->loaded, entities, collected);
  check_hierarchy(*classified, entities, collected);
  std::vector<LintFinding> findings = collected.take();
  const Level least = *find_level(request.level);
  std::erase_if(findings, [&](const LintFinding& one) {
    return one.rule->level > least || std::ranges::find(request.ignored, one.rule->code) != request.ignored.end();
  });
  const auto failing = find_level(request.fail_on);  // nothing: none
  const bool fails =
      failing && std::ranges::any_of(findings, [&](const LintFinding& one) { return one.rule->level <= *failing; });
  const Exit exit =
      print_or_say(request.as_json ? report_as_json(findings) : report_as_text(findings), fails ? Exit::no : Exit::yes);
  return exit == Exit::usage ? exit : exit_of(*classified, exit_of_list(classified->loaded, exit));
}

}  // namespace

void add_report(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<ReportRequest>();
  CLI::App* command =
      program.add_subcommand("report", "List what the authors of an ontology may want to mend, by level");
  add_files(*command, request->files)->required(false);
  command->add_option("--level", request->level, "the least level to print; default: info")
      ->check(CLI::IsMember({"error", "warning", "info"}))
      ->type_name("error|warning|info");
  command->add_option("--fail-on", request->fail_on, "the least level that makes the exit status 1; default: error")
      ->check(CLI::IsMember({"error", "warning", "info", "none"}))
      ->type_name("error|warning|info|none");
  command->add_option("--ignore", request->ignored, "a rule to leave out; may be given many times")->type_name("CODE");
  command->add_flag("--rules", request->lists_rules, "print the rules with their levels, and look at nothing");
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  command->add_flag("--json", request->as_json, "print one JSON document");
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nIt looks at the classes, properties and datatypes that the files declare or describe. Names of ontologies "
      "that\n"
      "were not given are left alone. `check` says more about errors: why a class can have no instance, what was left "
      "out.\n"
      "A file of a folder that cannot be read is left out and named, and the exit status is 1.\n"
      "Exit status: 0 nothing at the level of --fail-on or above, 1 something, 2 a file cannot be loaded, 4 a limit "
      "was\n"
      "reached.\n"
      "\nExamples:\n"
      "  geminga-ontology report team/\n"
      "  geminga-ontology report team/ --level warning --fail-on warning --ignore no-label\n"
      "  geminga-ontology report --rules");
  run_when_named(*command, choice, request, lint);
}

}  // namespace geminga::ontology
