// `geminga-ontology infer`: the ontology with the relations that follow from it, for other tools.
#include <CLI/CLI.hpp>
#include <memory>
#include <span>
#include <string_view>

#include "ontology/command/options.hpp"
#include "ontology/command/output.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/format.hpp"
#include "ontology/graph/asserted.hpp"
#include "ontology/graph/inferred.hpp"

namespace geminga::ontology {
namespace {

struct InferRequest {
  std::vector<std::string> files;
  std::string out;
  std::string format;
  bool only_inferred = false;
  bool as_closure = false;
};

/// Says that relations may be missing. An error or a contradiction ends the command with its exit status.
Exit judge(const std::expected<ClassifiedFiles, LoadFailure>& classified) {
  if (!classified) return say_error(classified.error().text);
  if (!classified->classification.is_consistent)
    return say_error("the ontology contradicts itself, so that everything follows from it: see geminga-ontology check",
                     Exit::no);
  // exit_of() tells of a limit that was reached.
  const auto why = why_incomplete(*classified);
  if (why && !classified->classification.is_cut_off) say_error("more may follow: " + *why);
  return Exit::yes;
}

Exit infer(const InferRequest& request, const WorkLimits& limits) {
  const auto format = chosen_format(request.format, request.out);
  if (!format) return say_error(format.error());
  Progress progress(true);
  auto loaded = load(request.files, progress, {.keeps_annotations = true});
  if (!loaded) return say_error(loaded.error().text);
  if (would_destroy_source(request.out, request.files, loaded->source)) return Exit::usage;
  const graph::GraphLimits graph_limits{.octets = graph_octets(limits)};
  graph::Graph asserted(graph_limits);
  if (const auto problem = add_asserted(*loaded, asserted)) return say_error(*problem, exit_of(asserted));
  base::Budget budget = budget_of(limits);
  const auto classified = classify_with_individuals(std::move(*loaded), progress, {.budget = &budget});
  progress.clear();
  if (const Exit exit = judge(classified); exit != Exit::yes) return exit;
  progress.show("collecting what follows");
  const auto fail = [&](std::string_view text, Exit status) {
    progress.clear();
    return say_error(text, status);
  };
  graph::Graph alone(graph_limits);
  graph::Graph& graph = request.only_inferred ? alone : asserted;
  base::Budget writing(WorkLimits::default_steps);  // its own: what a search has settled within its limits is written
  if (const auto problem = add_inferred(*classified, request.as_closure, writing, graph))
    return fail(*problem, Exit::timed_out);
  if (graph.problem()) return fail(*graph.problem(), exit_of(graph));
  graph.sort();
  if (request.only_inferred) {
    asserted.sort();
    alone.remove(asserted);
    add_declarations(*classified, alone);
    if (alone.problem()) return fail(*alone.problem(), exit_of(alone));
    alone.sort();
  }
  const auto text = graph.write(*format, prefixes_of(classified->loaded.source));
  if (!text) return fail(text.error(), Exit::usage);
  progress.clear();
  const Exit exit = put(request.out, std::as_bytes(std::span(*text)));
  return exit == Exit::yes ? exit_of(*classified, exit) : exit;
}

}  // namespace

void add_infer(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<InferRequest>();
  CLI::App* command = program.add_subcommand(
      "infer", "Write the ontology with what follows from it: hierarchies, types of individuals");
  add_files(*command, request->files);
  add_output(*command, request->out, request->format);
  command->add_flag("--only-inferred", request->only_inferred, "write only what the files do not say themselves");
  command->add_flag("--closure", request->as_closure, "write all that follows, not only the direct relations");
  add_memory_limit(*command, choice);
  add_graph_limit(*command, choice.limits);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nWritten are rdfs:subClassOf and owl:equivalentClass, rdfs:subPropertyOf and owl:equivalentProperty, rdf:type\n"
      "and owl:sameAs, between names. Exit status 1 if the ontology contradicts itself; 4 if a limit was reached: "
      "what\n"
      "is written follows, and standard error says what is not decided. Nothing is written where the triples take "
      "more\n"
      "than --graph-limit: the closure grows with the square of a chain of classes.\n"
      "\nExamples:\n  geminga-ontology infer team/ -o inferred.owl\n"
      "  geminga-ontology infer team/ --only-inferred --closure -o - --to ntriples");
  run_when_named(*command, choice, request, infer);
}

}  // namespace geminga::ontology
