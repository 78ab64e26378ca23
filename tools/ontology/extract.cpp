// `geminga-ontology extract`: the part of an ontology that matters for some names, as an ontology of its own.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/format.hpp"
#include "ontology/graph/asserted.hpp"
#include "ontology/graph/excerpt_document.hpp"
#include "ontology/loading/classified_files.hpp"
#include "ontology/loading/entity_names.hpp"
#include "reasoning/modules/signature_module.hpp"
#include "reasoning/syntax/folders.hpp"

namespace geminga::ontology {
namespace {

struct ExtractRequest {
  std::vector<std::string> words;
  std::vector<std::string> names;
  std::string names_file;
  std::string kind = "star";
  std::string out;
  std::string format;
  bool is_lenient = false;
};

/// The most octets of a file of names.
constexpr std::uintmax_t max_names_octets = std::uintmax_t{16} * 1024 * 1024;

/// The names of a file, one a line; blank lines and those that begin with # say nothing. Says what is wrong with it.
std::optional<std::vector<std::string>> names_in(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error || size > max_names_octets) {
    say_error(path + (error ? ": cannot be read: " + error.message() : ": has more than 16 MiB of names"));
    return std::nullopt;
  }
  std::ifstream file(path);
  std::vector<std::string> names;
  for (std::string line; std::getline(file, line);) {
    const std::string_view word = base::trimmed(line);
    if (!word.empty() && !word.starts_with('#')) names.emplace_back(word);
  }
  return names;
}

modules::ModuleKind kind_of(std::string_view word) {
  if (word == "bottom") return modules::ModuleKind::bottom;
  return word == "top" ? modules::ModuleKind::top : modules::ModuleKind::star;
}

/// The entities with these names; nothing after saying which are none.
std::optional<std::vector<owl::TermId>> signature_of(const owl::Ontology& source,
                                                     const std::vector<std::string>& names) {
  const EntityNames entities(source);
  std::vector<owl::TermId> signature;
  bool are_known = true;
  for (const std::string& name : names) {
    const auto found = entities.find(name);
    if (!found) say_error(found.error());
    are_known = are_known && found.has_value();
    if (found) signature.insert(signature.end(), found->begin(), found->end());
  }
  if (!are_known) return std::nullopt;
  return signature;
}

Exit extract(const ExtractRequest& request, const WorkLimits&) {
  const auto format = chosen_document_format(request.format, request.out);
  if (!format) return say_error(format.error());
  std::vector<std::string> files;
  std::vector<std::string> names = request.names;
  for (const std::string& word : request.words) {
    const bool is_file = std::filesystem::exists(word) || syntax::is_ontology_name(word);  // perhaps a mistyped one
    (is_file ? files : names).push_back(word);
  }
  if (files.empty())
    return say_error("none of these words is a file or folder: name the files, and behind them the names");
  if (!request.names_file.empty()) {
    const auto more = names_in(request.names_file);
    if (!more) return Exit::usage;
    names.insert(names.end(), more->begin(), more->end());
  }
  if (names.empty()) return say_error("no name is given: name classes or properties behind the files");
  Progress progress(true);
  auto loaded = load(files, progress, {.annotations = KeptAnnotations::all, .is_lenient = request.is_lenient});
  progress.clear();
  if (!loaded) return say_error(loaded.error().text);
  if (would_destroy_source(request.out, files, loaded->source)) return Exit::usage;
  const auto signature = signature_of(loaded->source, names);
  if (!signature) return Exit::usage;
  const std::vector<std::uint32_t> module = modules::extract_module(loaded->source, *signature, kind_of(request.kind));
  if (!loaded->source.omissions().empty())
    say_error("something of the files was left out, and is not in the module: geminga-ontology check says what",
              Exit::yes);
  const ExcerptDocument excerpt(*loaded, module, *signature);
  if (const auto* const syntax = std::get_if<syntax::Syntax>(&*format))
    return put_document(request.out, excerpt.document(), *syntax);
  graph::Graph graph({.octets = std::numeric_limits<std::size_t>::max()});  // it holds less than the files do
  if (const auto problem = excerpt.add_to(graph)) return say_error(*problem);
  graph.sort();
  const auto text = graph.write(std::get<graph::Format>(*format), prefixes_of(loaded->source));
  if (!text) return say_error(text.error());
  return put(request.out, std::as_bytes(std::span(*text)));
}

}  // namespace

void add_extract(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<ExtractRequest>();
  CLI::App* command = program.add_subcommand(
      "extract", "Write the module of some names: the axioms that can matter for what follows about them");
  command
      ->add_option("FILES NAMES", request->words,
                   "ontology files, or folders of them, and names behind them: prefix:Name, <IRI>, or Name where it is "
                   "unique; a word that is no file is a name")
      ->required()
      ->type_name("");
  command->add_option("--name", request->names, "another name; may be given many times")->type_name("NAME");
  command->add_option("--names", request->names_file, "a file of more names, one a line")->type_name("FILE");
  command
      ->add_option("--kind", request->kind,
                   "star (default): what follows between the names; bottom: and all that is above them; top: and "
                   "all that is below them")
      ->check(CLI::IsMember({"star", "bottom", "top"}))
      ->type_name("star|bottom|top");
  add_output(*command, request->out, request->format);
  add_lenient(*command, request->is_lenient);
  add_run_limits(*command, choice);
  command->footer(
      "\nThe module entails every axiom over the names that the files entail, and nothing that they do not: syntactic\n"
      "locality (Cuenca Grau, Horrocks, Kazakov, Sattler 2008). It has the declarations and annotations of all names "
      "that\n"
      "its axioms use. Exit status: 0 done, 2 a name is unknown or a file cannot be loaded.\n"
      "\nExamples:\n"
      "  geminga-ontology extract team/ soccer:BallInfo --kind bottom -o ball.ttl\n"
      "  geminga-ontology extract team/ --names names.txt -o part.ofn");
  run_when_named(*command, choice, request, extract);
}

}  // namespace geminga::ontology
