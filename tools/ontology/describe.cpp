// `geminga-ontology describe`: the facts about geminga:self as the class expression that a participant announces.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/description/description.hpp"
#include "ontology/loading/classified_files.hpp"
#include "reasoning/owl/loaded_file.hpp"

namespace geminga::ontology {
namespace {

struct DescribeRequest {
  std::string facts;
  std::vector<std::string> files;  ///< that say what the properties are
  bool is_lenient = false;
};

/// Lines about what is left out.
constexpr std::size_t max_dropped_lines = 20;

std::optional<owl::FileId> file_of(const owl::Ontology& source, const std::string& path) {
  const auto at = std::ranges::find(source.files(), path, &owl::LoadedFile::path);
  if (at == source.files().end()) return std::nullopt;
  return owl::FileId{static_cast<std::uint32_t>(at - source.files().begin())};
}

/// Adds the properties whose statements are no facts because no file says what they are.
void add_undeclared(const rdf::Loaded& loaded, owl::FileId file, const owl::ShortName& short_name,
                    std::vector<Dropped>& dropped) {
  for (const rdf::UsedName& one : loaded.undeclared_predicates) {
    if (owl::FileId{one.file} != file) continue;
    dropped.push_back({one.line, short_name(one.iri) +
                                     " is declared in no file, so what it says is no fact: name its ontology, too"});
  }
  std::ranges::stable_sort(dropped, {}, &Dropped::line);
}

void say_dropped(const std::string& facts, const std::vector<Dropped>& dropped) {
  const std::string place = base::printable(facts, 4096) + ':';
  for (std::size_t at = 0; at < std::min(dropped.size(), max_dropped_lines); ++at) {
    const Dropped& one = dropped[at];
    say_error(
        place + (one.line == 0 ? "" : std::to_string(one.line) + ':') + " left out: " + base::printable(one.text, 400),
        Exit::yes);
  }
  if (dropped.size() > max_dropped_lines)
    say_error(std::to_string(dropped.size() - max_dropped_lines) + " more are left out", Exit::yes);
}

Exit describe(const DescribeRequest& request, const WorkLimits&) {
  std::vector<std::string> files{request.facts};
  files.insert(files.end(), request.files.begin(), request.files.end());
  Progress progress(true);
  auto loaded =
      load(files, progress, {.says_files = false, .leaves_out_refused = true, .is_lenient = request.is_lenient});
  progress.clear();
  if (!loaded) return say_error(loaded.error().text);
  const auto file = file_of(loaded->source, request.facts);
  if (!file) return say_error(base::printable(request.facts, 4096) + ": is no file: name one with facts");
  const owl::ShortName short_name = short_names(loaded->source);
  auto description = describe_self(loaded->source, *file, short_name);
  if (!description) return say_error(base::printable(request.facts, 4096) + ": " + description.error());
  add_undeclared(*loaded, *file, short_name, description->dropped);
  say_dropped(request.facts, description->dropped);
  return print_or_say(description->expression + '\n');
}

}  // namespace

void add_describe(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<DescribeRequest>();
  CLI::App* command = program.add_subcommand(
      "describe", "Write the facts of a file about geminga:self as the class expression that a robot announces");
  command->add_option("FACTS", request->facts, "a file with facts about geminga:self, in any syntax")
      ->required()
      ->type_name("FILE");
  command->add_option("FILES", request->files, "ontology files, or folders of them, that declare the properties")
      ->type_name("");
  add_lenient(*command, request->is_lenient);
  add_run_limits(*command, choice);
  command->footer(
      "\ngeminga:self is <" + std::string(self_iri) +
      ">. Its classes are conjuncts; a fact with an\nindividual becomes 'property some (what is said of that)', "
      "nested, "
      "and one with a literal 'property value literal'.\nWhat such an expression cannot say is left out and named. It "
      "has at most " +
      std::to_string(max_described_bytes) +
      " octets, with full IRIs.\n"
      "gemingad --describe FILE and geminga-query describe FILE use it.\n"
      "\nExample:\n  geminga-ontology describe robot.ttl team/");
  run_when_named(*command, choice, request, describe);
}

}  // namespace geminga::ontology
