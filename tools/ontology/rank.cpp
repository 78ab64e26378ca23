// `geminga-ontology rank`: the services of a collection in the order in which they suit each request.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "base/text.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/ranking/rank_writer.hpp"
#include "ontology/ranking/ranked_collection.hpp"

namespace geminga::ontology {
namespace {

struct RankRequest {
  CollectionPaths paths;
  std::string format = "text";
  bool as_json = false;
  bool has_reasons = false;
  unsigned most = 0;
};

/// Says problems and remarks on standard error.
void say_all(const RankedCollection& collection) {
  constexpr std::size_t most_lines = 20;
  const std::vector<std::string>& problems = collection.problems();
  for (std::size_t at = 0; at < std::min(problems.size(), most_lines); ++at) say_error(problems[at]);
  if (problems.size() > most_lines)
    say_error(std::to_string(problems.size() - most_lines) + " more such problems: see --json");
  if (!problems.empty())
    say_error(counted(problems.size(), "file is", "files are") + " not right: all others are ranked");
  const std::vector<std::string>& remarks = collection.remarks();
  for (std::size_t at = 0; at < std::min(remarks.size(), most_lines); ++at) say_error(remarks[at]);
}

Exit rank(const RankRequest& request, const WorkLimits& limits) {
  const auto format = find_rank_format(request.as_json ? "json" : request.format);
  if (!format) return say_error(base::printable(request.format) + " is no format: write --format text, json or trec");
  const bool as_json = *format == RankFormat::json;
  const auto collection = RankedCollection::read(request.paths, limits);
  if (!collection) return say_failure(collection.error(), as_json);
  say_all(*collection);
  if (collection->services().empty() || collection->requests().empty())
    return say_failure(collection->services().empty() ? "there is no service that can be read behind --services"
                                                      : "there is no request that can be read behind --requests",
                       as_json);
  RankWriter writer(*collection, *format, request.has_reasons);
  const signature::Hierarchy hierarchy = collection->hierarchy();
  signature::Scorer scorer(hierarchy);
  bool is_written = print(writer.begin());
  for (const Described& described : collection->requests()) {
    std::vector<Ranked> ranked = rank_services(scorer, described, collection->services());
    if (request.most != 0 && ranked.size() > request.most) ranked.resize(request.most);
    is_written = is_written && print(writer.request(described, ranked));
  }
  return is_written ? print_or_say(writer.end()) : say_unwritten();
}

void add_folders(CLI::App& command, const std::string& flag, std::vector<std::string>& folders,
                 const std::string& description) {
  command.add_option(flag, folders, description)
      ->type_name("FOLDER")
      ->type_size(1)
      ->allow_extra_args(false)
      ->required();
}

}  // namespace

void add_rank(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<RankRequest>();
  CLI::App* command = program.add_subcommand("rank", "Rank OWL-S services for requests by their inputs and outputs");
  add_folders(*command, "--services", request->paths.services,
              "OWL-S files (.owls, or ontology files with a profile), or folders of them; may be given many times");
  add_folders(*command, "--requests", request->paths.requests, "requests in the same form; may be given many times");
  command
      ->add_option(
          "--ontologies", request->paths.ontologies,
          "ontologies with the types of parameters (default: folders called ontology or ontologies beside or above "
          "the others)")
      ->type_name("FOLDER...");
  command->add_option("--format", request->format, "text, json, or trec (a run for trec_eval)")
      ->type_name("text|json|trec");
  command->add_flag("--json", request->as_json, "the same as --format json, with reasons");
  command->add_flag("--reasons", request->has_reasons,
                    "in text: a fifth column, which says what suits and what does not");
  add_number(*command, "--limit", request->most, 1, 10'000'000, "the best N services of each request; default: all");
  add_memory_limit(*command, choice);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nA line is REQUEST<TAB>RANK<TAB>SERVICE<TAB>SCORE, best first; services and requests are called by their "
      "files.\n"
      "The score, in [0, 1], compares each wanted output with an offered one, and each input that a service needs "
      "with\n"
      "one that the request gives, by their places in the taxonomy alone. Its formula is in RANK.md of\n"
      "src/reasoning/signature. Nothing is fetched: an import is looked for by its IRI, in catalogues, and by the "
      "name\n"
      "of its file. A file that is broken is named and counted on standard error, and the others are ranked.\n"
      "Where a limit is reached, what was found by then counts, and that is said. Unless told, all ontologies "
      "together\n"
      "take 200000000 steps at most.\n"
      "Exit status: 0 ranked; 2 wrong usage, or nothing could be read; 4 the time was over before anything was "
      "ranked.\n"
      "\nExamples:\n"
      "  geminga-ontology rank --services services/ --requests queries/ --ontologies ontology/\n"
      "  geminga-ontology rank --services services/ --requests queries/ball.owls --limit 10 --reasons\n"
      "  geminga-ontology rank --services services/ --requests queries/ --format trec > geminga.run");
  command->callback([request, &choice] {
    if (request->paths.ontologies.empty()) {
      request->paths.guessed = guess_ontologies(request->paths);
      choice.readable = request->paths.guessed;
    }
    choice.run = [request, &choice] { return rank(*request, choice.limits); };
  });
}

}  // namespace geminga::ontology
