// `geminga-ontology realize`: the types of individuals, who is the same, and the facts that follow.
#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <memory>
#include <string>

#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/individuals/realized_files.hpp"
#include "ontology/individuals/realized_forms.hpp"
#include "ontology/loading/argument.hpp"
#include "ontology/loading/consistency.hpp"
#include "ontology/loading/refused.hpp"
#include "reasoning/syntax/graph/limits.hpp"

namespace geminga::ontology {
namespace {

struct RealizeRequest {
  std::vector<std::string> files;
  bool all = false;
  bool as_closure = false;
  bool with_facts = false;
  bool as_json = false;
  bool is_lenient = false;
  bool is_strict = false;
};

bool write_json(const RealizedForms& forms, bool with_facts, const std::optional<std::string>& open,
                const reasoner::Answer& consistency) {
  boost::json::object document;
  put_consistency(consistency, document);
  document["things"] = forms.json_things();
  if (open) document["undecided"] = *open;
  std::string text = json_text(document);
  if (!with_facts) return print_more(text + '\n');
  text.pop_back();  // the brace, before which the facts stand
  return print_more(text + ",\"facts\":") && forms.write_json_facts(print_more) && print_more("}\n");
}

bool write(const RealizedForms& forms, const RealizeRequest& request) {
  if (request.with_facts)
    return request.as_closure ? forms.write_fact_closure(print_more) : forms.write_facts(print_more);
  return request.as_closure ? forms.write_closure(print_more) : forms.write_types(print_more);
}

Exit say_contradiction(bool as_json) {
  say_error(contradiction_words);
  return as_json ? print_or_say(json_text(boost::json::object{{"consistent", false}}) + '\n', Exit::no) : Exit::no;
}

Exit realize(const RealizeRequest& request, const WorkLimits& limits) {
  base::Budget classifying = budget_of(first_half(limits));
  auto classified = classify_or_say(request.files, {.as_json = request.as_json,
                                                    .leaves_out_refused = !request.is_strict,
                                                    .is_lenient = request.is_lenient,
                                                    .budget = &classifying});
  if (!classified) return Exit::usage;
  if (!classified->classification.is_consistent) return say_contradiction(request.as_json);
  base::Budget budget = budget_of(limits);
  Progress progress(!request.as_json);
  const std::size_t most_octets = graph_octets(limits);
  const auto found =
      realize_files(*classified, budget, progress, request.with_facts ? std::optional(most_octets) : std::nullopt);
  if (!found.is_consistent) return say_contradiction(request.as_json);
  if (found.has_too_many_facts)
    return say_failure(graph::too_many_octets(most_octets, "--facts"), request.as_json, Exit::timed_out);
  if (!found.is_consistency_open) note_model(classified->classification);
  const owl::Ontology& source = classified->loaded.source;
  auto open = describe_open(source, undecided_individuals(found), found.gaps);
  if (const auto classes = describe_undecided(*classified)) open = open ? *open + "; " + *classes : *classes;
  const RealizedForms forms(*classified, found, request.all);
  const bool is_written = request.as_json
                              ? write_json(forms, request.with_facts, open, consistency_of(*classified, &budget))
                              : write(forms, request);
  if (!is_written || !print("")) return say_unwritten();
  say_unresolved(classified->loaded);
  if (open) say_error("what is printed follows, and more may: " + *open);
  if (budget.is_spent() || classified->classification.is_cut_off) return Exit::timed_out;
  return exit_of_list(classified->loaded, Exit::yes);
}

}  // namespace

void add_realize(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<RealizeRequest>();
  CLI::App* command = program.add_subcommand(
      "realize", "Print the most specific types of each individual, and which individuals are the same");
  add_files(*command, request->files);
  command->add_flag("--all", request->all, "print all types, not only the most specific ones");
  CLI::Option* closure =
      command->add_flag("--closure", request->as_closure,
                        "print INDIVIDUAL<TAB>CLASS for every type, full IRIs, sorted, without owl:Thing");
  command->add_flag("--facts", request->with_facts,
                    "print the facts that hold between individuals, and their values, instead (with --json: too)");
  command->add_flag("--json", request->as_json, "print one JSON document")->excludes(closure);
  add_lenient(*command, request->is_lenient);
  add_strict(*command, request->is_strict);
  add_memory_limit(*command, choice);
  add_graph_limit(*command, choice.limits);
  add_work_limits(*command, choice.limits);
  command->footer(
      std::string(
          "\nFacts are those of the files and those that follow from them: by inverses, super-properties, chains,\n"
          "transitivity, keys and individuals that are the same. With --closure they are\n"
          "SUBJECT<TAB>PROPERTY<TAB>OBJECT lines. An individual without a class is an owl:Thing. Anonymous individuals "
          "are\n"
          "not printed. What is printed follows; where more may follow, standard error says why and which individuals "
          "are\n"
          "not decided. Nothing is printed where the facts take more than --graph-limit: individuals that are the same "
          "have\n"
          "each other's facts. Exit status: 0 done; 1 the ontology contradicts itself, so that everything follows and "
          "nothing "
          "is\n"
          "printed; 2 a file cannot be loaded; 4 a limit was reached.\n") +
      consistency_of_json + refused_of_list +
      "\nExamples:\n  geminga-ontology realize team/\n"
      "  geminga-ontology realize team/ --closure --time-limit 10\n"
      "  geminga-ontology realize team/ --facts");
  run_when_named(*command, choice, request, realize);
}

}  // namespace geminga::ontology
