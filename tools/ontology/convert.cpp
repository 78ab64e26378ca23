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
#include "ontology/loading/classified_files.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {
namespace {

struct ConvertRequest {
  std::vector<std::string> files;
  std::string out;
  std::string format;
  bool merges = false;
};

/// Names the constructs that were read and cannot be written. Triples are written as they stand, and ill-typed literals
/// as they were read.
void say_lost(const rdf::Loaded& loaded) {
  for (const owl::Ontology::Omission& lost : loaded.source.omissions()) {
    const auto file = static_cast<std::size_t>(lost.file);
    const std::string_view construct = loaded.source.name(lost.construct);
    if (syntax::has_triples(loaded.syntaxes[file]) || construct == owl::ill_typed_literal ||
        construct.starts_with("owl:imports "))
      continue;
    say_error(base::printable(loaded.source.files()[file].path, 4096) + ':' + std::to_string(lost.line) + ": " +
              base::printable(construct, 200) + " is not written" +
              (lost.count == 1 ? "" : ", and " + std::to_string(lost.count - 1) + " more of it are not") +
              ": no axiom of OWL 2 says it");
  }
}

Exit convert(const ConvertRequest& request, const WorkLimits&) {
  const auto format = chosen_format(request.format, request.out);
  if (!format) return say_error(format.error());
  Progress progress(true);
  const auto loaded = load(request.files, progress, {.keeps_annotations = true});
  progress.clear();
  if (!loaded) return say_error(loaded.error().text);
  if (would_destroy_source(request.out, request.files, loaded->source)) return Exit::usage;
  if (!request.merges && loaded->syntaxes.size() != 1)
    return say_error("these are " + std::to_string(loaded->syntaxes.size()) +
                     " files, and convert writes one: geminga-ontology merge makes one of many");
  graph::Graph graph({.octets = std::numeric_limits<std::size_t>::max()});  // it holds what the files hold
  if (const auto problem = add_asserted(*loaded, graph)) return say_error(*problem);
  graph.sort();
  const auto text = graph.write(*format, prefixes_of(loaded->source));
  if (!text) return say_error(text.error());
  say_lost(*loaded);
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
  add_run_limits(*command, choice);
  command->footer(
      merges ? "\nThe result has the name and the header of the first file that has one, and imports what none of the\n"
               "files is.\n"
               "\nExample:\n  geminga-ontology merge team/ -o team.owl"
             : "\nFiles of triples are written triple by triple. Of OWL's own syntaxes all axioms and annotations are\n"
               "written, those of axioms as owl:Axiom; what they hold beside them, as rules, is named on standard "
               "error.\n"
               "\nExamples:\n  geminga-ontology convert oeo.omn -o oeo.ttl\n"
               "  geminga-ontology convert pizza.owl -o - --to ntriples");
  run_when_named(*command, choice, request, convert);
}

}  // namespace

void add_convert(CLI::App& program, Choice& choice) { add(program, choice, false); }

void add_merge(CLI::App& program, Choice& choice) { add(program, choice, true); }

}  // namespace geminga::ontology
