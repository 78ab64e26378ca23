// `geminga-ontology fetch`: an ontology that somebody in the team offers, taken whole or not at all.
#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <filesystem>
#include <memory>
#include <string>

#include "base/text.hpp"
#include "ontology/command/client_exit.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/travel/folder.hpp"
#include "ontology/travel/taking.hpp"

namespace geminga::ontology {
namespace {

struct FetchRequest {
  std::string from;
  std::string digest;
  std::string folder;
  std::string connect;
  bool is_open = false;
  bool is_newest = false;
  bool as_json = false;
  unsigned timeout = 10;
  unsigned time_limit = 600;
};

Exit exit_of_taking(const TakingError& error) {
  switch (error.kind) {
    case TakingError::Kind::nobody:
    case TakingError::Kind::not_taken:
      return Exit::no;
    case TakingError::Kind::several:
      return Exit::usage;
    case TakingError::Kind::timed_out:
      return Exit::timed_out;
    case TakingError::Kind::of_the_daemon:
      break;
  }
  return error.client ? exit_of_client(*error.client) : Exit::usage;
}

boost::json::object taken_as_object(const FetchRequest& request, const Taken& taken, Written written) {
  const Manifest& manifest = *taken.arrival.manifest();
  boost::json::array files;
  for (const TravellingFile& file : manifest.files) files.push_back(boost::json::string(file.name));
  return {{"folder", request.folder},           {"is_new", written == Written::made},
          {"digest", taken.provider.digest},    {"version", manifest.version},
          {"octets", manifest.octets()},        {"files", std::move(files)},
          {"provider", taken.provider.service}, {"provider_name", taken.provider.participant_name}};
}

Exit fetch(const FetchRequest& request) {
  const auto warn = [](std::string_view line) { say_error(line); };
  const Wish wish{.participant = request.from,
                  .digest = request.digest,
                  .is_newest = request.is_newest,
                  .connect = request.connect,
                  .is_open = request.is_open,
                  .patience = std::chrono::seconds(request.timeout),
                  .time = std::chrono::seconds(request.time_limit)};
  const auto taken = take(wish, warn);
  if (!taken) return say_failure(taken.error().text, request.as_json, exit_of_taking(taken.error()));
  const Manifest& manifest = *taken->arrival.manifest();
  const auto written = write_folder(request.folder, manifest, taken->arrival.content(), random_tag());
  if (!written) return say_failure(written.error(), request.as_json);
  if (request.as_json) return print_or_say(json_text(taken_as_object(request, *taken, *written)) + '\n');
  std::string text;
  for (const TravellingFile& file : manifest.files)
    text += (std::filesystem::path(request.folder) / file.name).string() + '\n';
  return print_or_say(text);
}

}  // namespace

void add_fetch(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<FetchRequest>();
  CLI::App* command = program.add_subcommand("fetch", "Take an ontology that somebody in the team offers");
  command->add_option("--from", request->from, "only what this participant offers, by name or identifier")
      ->type_name("PARTICIPANT");
  command->add_option("--digest", request->digest, "only the ontology whose digest begins so")->type_name("DIGEST");
  command->add_flag("--newest", request->is_newest, "of several the one with the greatest version");
  command
      ->add_option("-o,--output", request->folder,
                   "the folder to make; it may be there where it is empty or holds the same")
      ->required()
      ->type_name("FOLDER");
  command->add_flag("--open", request->is_open, "also where the team has no key, so that strangers may listen");
  add_connect(*command, request->connect);
  add_number(*command, "--timeout", request->timeout, 0, 1'000'000, "seconds to wait for a provider; default: 10")
      ->type_name("SECONDS");
  add_number(*command, "--time-limit", request->time_limit, 1, 1'000'000, "seconds for all of it; default: 600")
      ->type_name("SECONDS");
  command->add_flag("--json", request->as_json, "print one JSON document");
  command->footer(
      "\nThe files are not read as ontologies. They are verified by the announced digest, written beside FOLDER,\n"
      "and renamed when all of them are on the disk. A provider that is lost, slow or sends something else is\n"
      "named, and another provider of the same ontology sends the rest. The daemon goes on with its own\n"
      "ontologies: look at the new one with geminga-ontology check and diff first. The output is the list of\n"
      "files.\n"
      "Exit status: 0 FOLDER holds the ontology, 1 nobody offers it, or nobody sent all of it, 2 wrong usage,\n"
      "several are offered, or FOLDER holds something else, 3 no daemon, 4 the time is over.\n"
      "\nExamples:\n"
      "  geminga-ontology fetch --from base -o theirs/\n"
      "  geminga-ontology fetch --newest -o /tmp/team --json");
  command->callback([request, &choice] {
    if (request->folder.find_first_not_of('/') == std::string::npos)
      throw CLI::ValidationError("-o", "names no folder that could be made");
    while (request->folder.ends_with('/')) request->folder.pop_back();
    choice.may_talk = true;
    choice.may_make_folders = true;
    choice.outputs.push_back(request->folder);
    choice.run = [request] { return fetch(*request); };
  });
}

}  // namespace geminga::ontology
