// `geminga-ontology convert` and `merge`: an ontology in another syntax, and many files as one.
#include <CLI/CLI.hpp>
#include <limits>
#include <memory>
#include <span>

#include "base/text.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/output.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/format.hpp"
#include "ontology/graph/asserted.hpp"
#include "ontology/graph/document.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {
namespace {

struct ConvertRequest {
  std::vector<std::string> files;
  std::string out;
  std::string format;
  bool merges = false;
  bool is_lenient = false;
};

/// Names the constructs that were read and cannot be written. Where triples are written, those of files stand as they
/// are. Axioms with ill-typed literals are written as they were read.
void say_lost(const rdf::Loaded& loaded, bool writes_triples) {
  for (const owl::Ontology::Omission& lost : loaded.source.omissions()) {
    const auto file = static_cast<std::size_t>(lost.file);
    const std::string_view construct = loaded.source.name(lost.construct);
    if ((writes_triples && syntax::has_triples(loaded.syntaxes[file])) || owl::is_ill_typed(construct) ||
        construct.starts_with("owl:imports "))
      continue;
    say_error(base::printable(loaded.source.files()[file].path, 4096) + ':' + std::to_string(lost.line) + ": " +
              base::printable(construct, 200) + " is not written" +
              (lost.count == 1 ? "" : ", and " + std::to_string(lost.count - 1) + " more of it are not") +
              ": no axiom of OWL 2 says it");
  }
}

Exit convert(const ConvertRequest& request, const WorkLimits&) {
  const auto format = chosen_document_format(request.format, request.out);
  if (!format) return say_error(format.error());
  Progress progress(true);
  const auto* const syntax = std::get_if<syntax::Syntax>(&*format);
  const auto loaded = load(request.files, progress,
                           {.annotations = syntax == nullptr ? KeptAnnotations::of_owl_syntaxes : KeptAnnotations::all,
                            .is_lenient = request.is_lenient});
  progress.clear();
  if (!loaded) return say_error(loaded.error().text);
  if (would_destroy_source(request.out, request.files, loaded->source)) return Exit::usage;
  if (!request.merges && loaded->syntaxes.size() != 1)
    return say_error("these are " + std::to_string(loaded->syntaxes.size()) +
                     " files, and convert writes one: geminga-ontology merge makes one of many");
  if (syntax != nullptr) {
    say_lost(*loaded, false);
    const owl::Annotations annotations(loaded->annotations);
    return put_document(request.out, document_of(*loaded, annotations), *syntax);
  }
  graph::Graph graph({.octets = std::numeric_limits<std::size_t>::max()});  // it holds what the files hold
  if (const auto problem = add_asserted(*loaded, graph)) return say_error(*problem);
  graph.sort();
  const auto text = graph.write(std::get<graph::Format>(*format), prefixes_of(loaded->source));
  if (!text) return say_error(text.error());
  say_lost(*loaded, true);
  return put(request.out, std::as_bytes(std::span(*text)));
}

void add(CLI::App& program, Choice& choice, bool merges) {
  auto request = std::make_shared<ConvertRequest>();
  request->merges = merges;
  CLI::App* command =
      program.add_subcommand(merges ? "merge" : "convert",
                             merges ? "Write many files as one ontology" : "Write an ontology in another syntax");
  add_files(*command, request->files);
  add_output(*command, request->out, request->format);
  add_lenient(*command, request->is_lenient);
  add_run_limits(*command, choice);
  command->footer(
      merges ? "\nThe result has the name and the header of the first file that has one, and imports what none of the\n"
               "files is.\n"
               "\nExample:\n  geminga-ontology merge team/ -o team.owl"
             : "\nFrom triples to triples every triple is written as it stands. Otherwise all axioms and annotations "
               "are\n"
               "written, with the prefixes of the file; what no axiom of OWL 2 says is named on standard error.\n"
               "\nExamples:\n  geminga-ontology convert oeo.omn -o oeo.ttl\n"
               "  geminga-ontology convert pizza.owl -o pizza.omn\n"
               "  geminga-ontology convert pizza.owl -o - --to functional");
  run_when_named(*command, choice, request, convert);
}

}  // namespace

void add_convert(CLI::App& program, Choice& choice) { add(program, choice, false); }

void add_merge(CLI::App& program, Choice& choice) { add(program, choice, true); }

}  // namespace geminga::ontology
