// `geminga-ontology serve`: the team's ontology offered to the team as a service.
#include <CLI/CLI.hpp>
#include <boost/json.hpp>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "ontology/command/client_exit.hpp"
#include "ontology/command/options.hpp"
#include "ontology/command/words.hpp"
#include "ontology/commands.hpp"
#include "ontology/loading/classified_files.hpp"
#include "ontology/travel/offering.hpp"
#include "ontology/travel/parcel.hpp"
#include "reasoning/owl/annotation.hpp"

namespace geminga::ontology {
namespace {

struct ServeRequest {
  std::vector<std::string> files;
  std::optional<std::uint64_t> version;
  std::string connect;
  bool is_open = false;
  bool as_json = false;
  bool is_lenient = false;
};

constexpr std::string_view version_property = "http://www.w3.org/2002/07/owl#versionInfo";

/// The whole number that exactly one owl:versionInfo of these files is; 0: none, or several.
std::uint64_t stated_version(const rdf::Loaded& loaded) {
  std::set<std::uint64_t> versions;
  for (const owl::Annotation& annotation : loaded.annotations) {
    if (annotation.of != owl::Annotation::Of::ontology || annotation.property != version_property) continue;
    const auto number = base::parse_number<std::uint64_t>(annotation.value);
    if (annotation.is_literal && number && *number <= max_travelling_version) versions.insert(*number);
  }
  return versions.size() == 1 ? *versions.begin() : 0;
}

/// The files as they travel; nothing after saying why they do not. What the reasoner needs is given back.
std::optional<Parcel> parcel_of(const ServeRequest& request, const WorkLimits& limits) {
  base::Budget budget = budget_of(limits);
  const auto classified = classify_or_say(request.files, {.as_json = request.as_json,
                                                          .annotations = KeptAnnotations::all,
                                                          .is_lenient = request.is_lenient,
                                                          .budget = &budget});
  if (!classified) return std::nullopt;
  if (!classified->classification.is_consistent) {
    say_failure("the ontology contradicts itself, and nobody could use it: geminga-ontology check says why",
                request.as_json);
    return std::nullopt;
  }
  const auto files = read_files(classified->loaded.listing.files);
  if (!files) {
    say_failure(files.error(), request.as_json);
    return std::nullopt;
  }
  auto parcel = Parcel::pack(*files, request.version.value_or(stated_version(classified->loaded)));
  if (!parcel) {
    say_failure(parcel.error(), request.as_json);
    return std::nullopt;
  }
  return std::move(*parcel);
}

Exit serve(const ServeRequest& request, const WorkLimits& limits) {
  const auto parcel = parcel_of(request, limits);
  if (!parcel) return Exit::usage;
  const Manifest& manifest = parcel->manifest();
  const auto begun = [&](const std::string& participant) {
    const std::string files = counted(manifest.files.size(), "file", "files");
    if (request.as_json) {
      const boost::json::object line{
          {"event", "offered"},          {"participant", participant},     {"digest", parcel->digest()},
          {"version", manifest.version}, {"files", manifest.files.size()}, {"octets", manifest.octets()}};
      if (!print(json_text(line) + '\n')) say_unwritten();
      return;
    }
    say_error("offering " + files + ", " +
                  (manifest.version == 0 ? "no version" : "version " + std::to_string(manifest.version)) + ", " +
                  parcel->digest(),
              Exit::yes);
  };
  const auto offered =
      offer(*parcel,
            {.connect = request.connect, .is_open = request.is_open, .begun = begun, .say = [](std::string_view line) {
               say_error(line);
             }});
  if (!offered) return say_failure(offered.error().text, request.as_json, exit_of_client(offered.error()));
  return Exit::yes;
}

}  // namespace

void add_serve(CLI::App& program, Choice& choice) {
  auto request = std::make_shared<ServeRequest>();
  CLI::App* command = program.add_subcommand("serve", "Offer an ontology to the team as a service");
  add_files(*command, request->files);
  command
      ->add_option_function<std::string>(
          "--version",
          [request](const std::string& text) {
            const auto number = base::parse_number<std::uint64_t>(text);
            if (!number || *number == 0 || *number > max_travelling_version)
              throw CLI::ValidationError("--version",
                                         base::printable(text) + " is not a whole number from 1 to 2^53-1");
            request->version = number;
          },
          "its version, a whole number that rises with each; by default the owl:versionInfo of the files where exactly "
          "one is such a number")
      ->type_name("N");
  command->add_flag("--open", request->is_open, "also where the team has no key, so that strangers may take it");
  add_connect(*command, request->connect);
  command->add_flag("--json", request->as_json, "print one JSON object when it is offered");
  add_lenient(*command, request->is_lenient);
  add_work_limits(*command, choice.limits);
  command->footer(
      "\nThe files are read once at the start, and offered until SIGTERM or Ctrl-C: start the command again for a\n"
      "new version. They must load and not contradict themselves; at most 256 files and 64 MiB. The service has\n"
      "the concept geminga:Ontology, the protocol tcp, and the attributes digest (BLAKE2b-256), version, files\n"
      "and octets.\n"
      "Exit status: 0 ended by a signal, 2 wrong usage, or files that cannot be offered, 3 no daemon.\n"
      "\nExamples:\n"
      "  geminga-ontology serve team/ --version 7\n"
      "  geminga-ontology serve team/ --open               in a team without a key");
  command->callback([request, &choice] {
    choice.may_talk = true;
    choice.run = [request, &choice] { return serve(*request, choice.limits); };
  });
}

}  // namespace geminga::ontology
