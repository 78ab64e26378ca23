// `geminga-ontology compile`: the one file that the daemon maps at start.

#include "reasoning/compiled/compile.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <memory>

#include "base/text.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/output.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/findings/collisions.hpp"
#include "ontology/findings/doubtful_names.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/compiled/similar.hpp"
#include "reasoning/owl/source_paths.hpp"

namespace geminga::ontology {
namespace {

struct CompileRequest {
  std::vector<std::string> files;
  std::vector<std::string> prefixes;  ///< NAME=IRI
  std::string out;
  bool leaves_out_refused = false;
  bool is_lenient = false;
};

/// Adds a line for each sort of doubtful names: their number, and the first.
void add_doubtful_names(const NameFindings& names, std::vector<std::string>& lines) {
  const auto add = [&](const std::vector<DoubtfulName>& found, std::string_view what) {
    if (found.empty()) return;
    const DoubtfulName& first = found.front();
    lines.push_back(counted(found.size(), "name", "names") + ' ' + std::string(what) + ", the first " + first.name +
                    " at " + first.file + ':' + std::to_string(first.line) + compiled::did_you_mean(first.similar));
  };
  add(names.unknown_words, "that RDF, RDFS, OWL and XSD do not have");
  add(names.undeclared, "used and nowhere declared");
}

/// Adds the prefixes of the command line to those of the files. Returns an error in one line.
std::optional<std::string> add_prefixes(const std::vector<std::string>& prefixes, owl::Ontology& source) {
  for (const std::string& prefix : prefixes) {
    const std::size_t equals = prefix.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == prefix.size())
      return base::printable(prefix) + " is no prefix: write --prefix NAME=IRI";
    source.add_prefix(prefix.substr(0, equals), prefix.substr(equals + 1));
  }
  return std::nullopt;
}

/// Lines for the log of a robot that starts with this ontology. `geminga-ontology check` says more.
std::vector<std::string> remarks(const ClassifiedFiles& classified, const compiled::Ontology& ontology) {
  std::vector<std::string> lines;
  if (!classified.classification.is_consistent)
    lines.push_back("the ontology contradicts itself: every class is empty");
  for (const rdf::UnresolvedImport& import : classified.loaded.unresolved)
    lines.push_back(import.file + ':' + std::to_string(import.line) + ": imports <" + import.iri +
                    ">, which no given file answers: name its file, too");
  for (const rdf::PrefixConflict& conflict : classified.loaded.conflicts)
    lines.push_back("the prefix " + conflict.prefix + ": means several IRIs, and <" + conflict.chosen + "> is taken");
  add_doubtful_names(find_doubtful_names(classified.loaded), lines);
  for (std::uint32_t number = 0; number < ontology.class_count() && classified.classification.is_consistent; ++number) {
    const taxonomy::ClassNumber named{number};
    if (named != classified.classification.nothing && is_unsatisfiable(classified.classification, named))
      lines.push_back(ontology.short_name(named) + " can have no instance");
  }
  for (const Collision& collision : find_collisions(ontology).found) {
    std::string line = "equal 32-bit identities 0x" + base::to_hex(collision.id, 8) + ':';
    for (const std::string& name : collision.names) line += ' ' + name;
    lines.push_back(std::move(line));
  }
  return lines;
}

Exit compile(const CompileRequest& request, const WorkLimits& limits) {
  constexpr std::size_t max_remarks = 20;
  base::Budget budget = budget_of(limits);
  // The daemon reads standard output, and logs each line on standard error as a warning.
  auto classified = classify_or_say(request.files, {.says_files = request.out != to_standard_output,
                                                    .leaves_out_refused = request.leaves_out_refused,
                                                    .is_lenient = request.is_lenient,
                                                    .budget = &budget});
  if (!classified) return Exit::usage;
  if (const auto problem = add_prefixes(request.prefixes, classified->loaded.source)) return say_error(*problem);
  if (would_destroy_source(request.out, request.files, classified->loaded.source)) return Exit::usage;
  const std::vector<std::string> gaps = gaps_of(*classified);
  const std::vector<std::byte> bytes =
      compiled::compile(classified->loaded.source, classified->classification,
                        {.gaps = gaps, .folder = request.out == to_standard_output ? "" : owl::folder_of(request.out)});
  // A form that cannot be read back is not written.
  const auto ontology = compiled::Ontology::from_bytes(bytes);
  if (!ontology) return say_error(ontology.error().text);
  if (const auto whole = ontology->check_whole(); !whole) return say_error(whole.error().text);
  const Exit exit = put(request.out, bytes);
  if (exit != Exit::yes) return exit;
  const auto lines = remarks(*classified, *ontology);
  for (std::size_t line = 0; line < std::min(lines.size(), max_remarks); ++line) say_error(lines[line]);
  if (lines.size() > max_remarks)
    say_error(std::to_string(lines.size() - max_remarks) + " more remarks: see geminga-ontology check");
  return exit_of(*classified, exit);
}

}  // namespace

void add_compile(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<CompileRequest>();
  CLI::App* command = program.add_subcommand("compile", "Write the compiled form that the daemon maps at start");
  add_files(*command, request->files);
  add_output(*command, request->out);
  command
      ->add_option("--prefix", request->prefixes,
                   "a prefix of names beside those of the files; may be given many times")
      ->type_name("NAME=IRI")
      ->type_size(1)
      ->allow_extra_args(false);
  add_lenient(*command, request->is_lenient);
  command->add_flag("--leave-out-refused", request->leaves_out_refused,
                    "leave out the files of folders that cannot be read, at most " +
                        std::to_string(syntax::max_left_out) + ", with a line on standard error for each");
  add_number(*command, "--memory-limit", choice.memory_limit_mib, min_memory_limit_mib, 1'000'000,
             "most address space to use, in MiB; more memory is a longer start, less refuses large ontologies");
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nExit status: 0 done, 2 a file cannot be loaded or written, 4 a limit was reached. Where a limit of the\n"
      "search was reached, OUT is still written, with what is decided, and states what is not.\n"
      "\nExample:\n  geminga-ontology compile team/ -o team.geminga --memory-limit 512 --time-limit 30");
  run_when_named(*command, choice, request, compile);
}

}  // namespace geminga::ontology
