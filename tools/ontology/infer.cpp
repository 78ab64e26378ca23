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
#include "ontology/graph/document.hpp"
#include "ontology/graph/inferred.hpp"
#include "ontology/individuals/realized_files.hpp"

namespace geminga::ontology {
namespace {

struct InferRequest {
  std::vector<std::string> files;
  std::string out;
  std::string format;
  bool only_inferred = false;
  bool is_lenient = false;
  bool as_closure = false;
  bool with_facts = false;
};

/// Says that relations may be missing.
void say_open(const ClassifiedFiles& classified, const realization::Realization& realization) {
  // exit_of() tells of a limit that was reached.
  if (classified.classification.is_cut_off) return;
  auto why = why_incomplete(classified);
  if (!why) why = describe_open(classified.loaded.source, undecided_individuals(realization), realization.gaps);
  if (why) say_error("more may follow: " + *why);
}

/// Writes the first `said` axioms of the source, or none of them, and those that follow.
Exit put_axioms(const InferRequest& request, syntax::Syntax syntax, const graph::Graph& inferred, std::size_t said,
                ClassifiedFiles& classified) {
  owl::Ontology& source = classified.loaded.source;
  const std::vector<std::uint32_t> following = add_inferred_axioms(inferred, classified);
  const std::vector<std::uint32_t> names =
      request.only_inferred ? add_declarations(following, source) : std::vector<std::uint32_t>();
  if (const auto& problem = source.problem()) return say_error(*problem, Exit::timed_out);
  const owl::Annotations annotations(classified.loaded.annotations);
  writing::Document document = document_of(classified.loaded, annotations);
  document.axioms.resize(request.only_inferred ? 0 : said);
  document.axioms.insert(document.axioms.end(), names.begin(), names.end());
  document.axioms.insert(document.axioms.end(), following.begin(), following.end());
  document.has_ill_typed = document.has_annotations = !request.only_inferred;
  const Exit exit = put_document(request.out, document, syntax);
  return exit == Exit::yes ? exit_of(classified, exit) : exit;
}

Exit infer(const InferRequest& request, const WorkLimits& limits) {
  const auto format = chosen_document_format(request.format, request.out);
  if (!format) return say_error(format.error());
  Progress progress(true);
  const auto* const syntax = std::get_if<syntax::Syntax>(&*format);
  auto loaded = load(request.files, progress,
                     {.annotations = syntax == nullptr ? KeptAnnotations::of_owl_syntaxes : KeptAnnotations::all,
                      .is_lenient = request.is_lenient});
  if (!loaded) return say_error(loaded.error().text);
  if (would_destroy_source(request.out, request.files, loaded->source)) return Exit::usage;
  const graph::GraphLimits graph_limits{.octets = graph_octets(limits)};
  graph::Graph asserted(graph_limits);
  if (const auto problem = add_asserted(*loaded, asserted)) return say_error(*problem, exit_of(asserted));
  const std::size_t said = loaded->source.axiom_count();
  base::Budget classifying = budget_of(first_half(limits));
  auto classified = classify_files(std::move(*loaded), 0, progress, {.budget = &classifying});
  if (!classified) return say_error(classified.error().text);
  base::Budget budget = budget_of(limits);
  const auto realization = realize_files(*classified, budget, progress,
                                         request.with_facts ? std::optional(graph_limits.octets) : std::nullopt);
  progress.clear();
  if (!realization.is_consistent) return say_error(contradiction_words, Exit::no);
  if (realization.has_too_many_facts)
    return say_error(graph::too_many_octets(graph_limits.octets, "--facts"), Exit::timed_out);
  say_open(*classified, realization);
  progress.show("collecting what follows");
  const auto fail = [&](std::string_view text, Exit status) {
    progress.clear();
    return say_error(text, status);
  };
  graph::Graph alone(graph_limits);
  graph::Graph& graph = request.only_inferred || syntax != nullptr ? alone : asserted;
  base::Budget writing(WorkLimits::default_steps);  // its own: what a search has settled within its limits is written
  if (const auto problem = add_inferred(*classified, realization, request.as_closure, writing, graph))
    return fail(*problem, Exit::timed_out);
  if (graph.problem()) return fail(*graph.problem(), exit_of(graph));
  graph.sort();
  if (&graph == &alone) {
    asserted.sort();
    alone.remove(asserted);
  }
  if (syntax != nullptr) progress.clear();
  if (syntax != nullptr) return put_axioms(request, *syntax, alone, said, *classified);
  if (request.only_inferred) {
    if (const auto problem = add_declarations(*classified, alone)) return fail(*problem, Exit::timed_out);
    alone.sort();
  }
  const auto text = graph.write(std::get<graph::Format>(*format), prefixes_of(classified->loaded.source));
  if (!text) return fail(text.error(), Exit::usage);
  progress.clear();
  const Exit exit = put(request.out, std::as_bytes(std::span(*text)));
  if (exit != Exit::yes) return exit;
  return budget.is_spent() && !classified->classification.is_cut_off ? Exit::timed_out : exit_of(*classified, exit);
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
  command->add_flag("--facts", request->with_facts, "write the facts of individuals that follow, too");
  add_lenient(*command, request->is_lenient);
  add_memory_limit(*command, choice);
  add_graph_limit(*command, choice.limits);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nThe output has rdfs:subClassOf and owl:equivalentClass, rdfs:subPropertyOf and owl:equivalentProperty,\n"
      "rdf:type and owl:sameAs between names. With --facts it also has the property values of individuals.\n"
      "Nothing is written where the triples take more than --graph-limit: the closure grows with the square of a\n"
      "chain of classes.\n"
      "Exit status: 0 done, 1 the ontology contradicts itself, 2 a file cannot be loaded, 4 a limit was reached:\n"
      "what is written follows, and standard error says what is not decided.\n"
      "\nExamples:\n  geminga-ontology infer team/ -o inferred.owl\n"
      "  geminga-ontology infer team/ --only-inferred --closure -o - --to ntriples");
  run_when_named(*command, choice, request, infer);
}

}  // namespace geminga::ontology
